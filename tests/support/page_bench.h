// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QPixmap>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>
#include <memory>

#include "tests/support/fake_engine.h"
#include "ui/shell/page.h"

namespace kerf::test {

/// One page in a window of its own, with everything a page works with and no shell around it.
class PageBench {
 public:
    explicit PageBench(double dpi = 96.0) : look(dpi), client(engine), alarms(engine) {
        sheets = new ui::SheetHost(look, &window);
        session.signOn(QStringLiteral("Kim"));
    }

    template <class P>
    P* show(QSize size = {1083, 670}) {
        ui::Services& all = services;
        page = new P(ui::PageContext{look, all, client, session, alarms, *sheets,
                                     [this](const char* key) { shownPages.push_back(key); },
                                     [this](const QString& sentence) { notices.push_back(sentence); },
                                     [this](std::function<void()> action) {
                                         if (session.signedOn()) {
                                             action();
                                         } else {
                                             ++askedForName;
                                         }
                                     },
                                     [this](ui::Role least, std::function<void()> action) {
                                         if (session.may(least)) {
                                             action();
                                         } else if (!session.signedOn()) {
                                             ++askedForName;
                                         } else {
                                             notices.push_back(session.whyNot(least));
                                         }
                                     }},
                     sheets);
        auto* fill = new QVBoxLayout(sheets);
        fill->setContentsMargins(0, 0, 0, 0);
        fill->addWidget(page);
        auto* outer = new QVBoxLayout(&window);
        outer->setContentsMargins(0, 0, 0, 0);
        outer->addWidget(sheets);
        window.resize(size);
        window.show();
        client.tick();
        return static_cast<P*>(page);
    }
    template <class W>
    [[nodiscard]] W* find(const char* name) {
        return window.findChild<W*>(QLatin1String(name));
    }
    [[nodiscard]] bool press(const char* name) {
        QApplication::processEvents();  // what was just opened is laid out
        auto* button = find<QAbstractButton>(name);
        if (button == nullptr || !button->isVisible() || !button->isEnabled()) {
            return false;
        }
        QTest::mouseClick(button, Qt::LeftButton);
        return true;
    }
    void save(const QString& name) {
        QApplication::processEvents();
        window.grab().save(name);
    }

    ui::Look look;
    FakeEngine engine;
    ui::EngineClient client;
    ui::OperatorSession session;
    ui::AlarmList alarms;
    ui::Services services{engine};
    QWidget window;
    ui::SheetHost* sheets{};
    ui::Page* page{};
    std::vector<std::string> shownPages{};
    std::vector<QString> notices{};
    int askedForName{0};
};

}  // namespace kerf::test
