// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QPointer>
#include <QTest>
#include <algorithm>

#include "tests/support/console_bench.h"
#include "ui/dialogs/sheet.h"

namespace kerf::test {

/// Goes over the pages of a console and the sheets behind their buttons, by touch. A test is one, beside being a
/// QObject.
class ConsoleWalk {
 protected:
    ConsoleWalk() = default;
    ~ConsoleWalk() = default;

    /// A console with a few parts made, a bore that waits, and an operator and an engineer who are known; the machine
    /// stands still.
    void begin(const char* language, bool painted) {
        console::Options options;
        options.preparedParts = 3;
        options.simulationSpeed = 400.0;
        options.language = language;
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.console().shift()->prepared(), 240'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 120'000);
        m_bench.pause();
        window()->setUpdatesEnabled(painted);  // painting is half of the walk's time
        QVERIFY(window()->session().signOn(QStringLiteral("Lee"), ui::Role::Operator));
        QVERIFY(window()->session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
    }
    [[nodiscard]] ui::MainWindow* window() { return m_bench.console().window(); }
    [[nodiscard]] ui::SheetHost* host() { return &window()->sheets(); }
    static void settle() {
        for (int i = 0; i < 2; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    /// Of the buttons in it those that may open something.
    [[nodiscard]] QStringList buttonsIn(const QWidget* place) {
        QStringList names;
        for (const auto* button : place->findChildren<QAbstractButton*>()) {
            if (button->isVisibleTo(window()) && button->isEnabled() && !button->isCheckable() &&
                !leftAlone(button->objectName()) && !names.contains(button->objectName())) {
                names << button->objectName();
            }
        }
        return names;
    }
    /// A save on its way rests its button, and once taken it closes the sheet: who has touched one looks what came of
    /// it before touching anything else.
    void pressNow(const QString& name) {
        for (auto* button : window()->findChildren<QAbstractButton*>(name)) {
            if (button->isVisibleTo(window()) && button->isEnabled()) {
                const QPointer<QAbstractButton> touched(button);
                QTest::mouseClick(button, Qt::LeftButton);
                (void)QTest::qWaitFor(
                    [&] {
                        const QAbstractButton* still = touched.data();
                        return still == nullptr || still->isHidden() || still->isEnabled();
                    },
                    1000);
                settle();
                return;
            }
        }
    }
    /// Page and buttons, from a page without a sheet, with the engineer who began.
    void goTo(const QString& page, const QStringList& path) {
        while (ui::Sheet* sheet = host()->current()) {  // one may lie over others
            sheet->close();
        }
        (void)window()->session().signOn(QStringLiteral("Kim"), ui::Role::Engineer);
        window()->showPage(page.toLatin1().constData());
        settle();
        for (const QString& name : path) {
            pressNow(name);
        }
    }

    /// A row of data for each page.
    void pageRows() {
        QTest::addColumn<QString>("page");
        for (const ui::PageEntry& page : window()->pages()) {
            QTest::newRow(page.key) << QString::fromLatin1(page.key);
        }
    }
    /// Where to look on a page: in the frame as well, once, with the first one.
    [[nodiscard]] QWidget* placeOf(const QString& page) {
        const bool first = page == QLatin1String(window()->pages().front().key);
        return first ? static_cast<QWidget*>(window()) : window()->page(page.toLatin1().constData());
    }
    static constexpr int kDeepest = 4;  ///< sheets behind a page

    ConsoleBench m_bench;

 private:
    /// What starts or ends something outside the pages, leads away, changes whose walk this is and how it looks, or
    /// only types. Choices open nothing either (buttonsIn).
    [[nodiscard]] static bool leftAlone(const QString& name) {
        static const QStringList kBegins{"nav_", "key", "touch", "holdAll", "band", "help", "qt_", "theme", "scale"};
        static const QStringList kNames{"quit",      "restart",  "millingStart",    "tappingStart", "turningStart",
                                        "startPart", "language", "languageEnglish", "signOff",      "languageKorean"};
        return name.isEmpty() || kNames.contains(name) ||
               std::ranges::any_of(kBegins, [&](const QString& begin) { return name.startsWith(begin); });
    }
};

}  // namespace kerf::test
