// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTextBrowser>
#include <algorithm>

#include "tests/support/shell_bench.h"
#include "ui/help/help_texts.h"
#include "ui/shell/machine_strip.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::ShellBench;

/// What the frame has beside pages: the strip of the machine, and help.
class TestFrame : public QObject {
    Q_OBJECT

    static QString valueOf(const MachineStrip& strip, const QString& label) {
        for (const StripFigure& figure : strip.figures()) {
            if (figure.label == label) {
                return figure.stale ? figure.value + QStringLiteral(" stale") : figure.value;
            }
        }
        return QStringLiteral("not there");
    }

 private slots:
    void theStripSaysWhatTheMachineDoesOnEveryPage() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().stop();
        bench.engine.fake.operatorOverride = 0.8;
        bench.window->client().tick();
        auto* strip = bench.window->findChild<MachineStrip*>(QStringLiteral("machineStrip"));
        for (const PageEntry& entry : bench.window->pages()) {
            bench.window->showPage(entry.key);
            QVERIFY(strip->isVisible());
        }
        QCOMPARE(valueOf(*strip, QStringLiteral("Program")), QStringLiteral("Boring"));
        QCOMPARE(valueOf(*strip, QStringLiteral("S")), QStringLiteral("400\u00a0rpm"));
        QCOMPARE(valueOf(*strip, QStringLiteral("F")), QStringLiteral("92\u00a0mm/min"));
        const auto knob = [&] {
            bench.window->client().tick();
            return valueOf(*strip, QStringLiteral("Knob"));
        };
        QTRY_COMPARE(knob(), QStringLiteral("80 %"));  // shown five times a second
        QCOMPARE(valueOf(*strip, QStringLiteral("To go")), QStringLiteral("1:24"));
        QVERIFY(valueOf(*strip, QStringLiteral("Force")).endsWith(QStringLiteral("stale")));  // boring measures none
        bench.engine.fake.link = LinkState::Down;
        bench.window->client().tick();
        QVERIFY(valueOf(*strip, QStringLiteral("S")).endsWith(QStringLiteral("stale")));
        bench.engine.fake.program = ProgramState::Idle;
        bench.window->client().tick();
        QVERIFY(valueOf(*strip, QStringLiteral("Program")).endsWith(QStringLiteral("stale")));
        Preferences inch;
        inch.length = LengthUnit::Inch;
        bench.engine.fake.link = LinkState::Up;
        bench.look.apply(inch);
        bench.window->client().tick();
        QVERIFY2(valueOf(*strip, QStringLiteral("F")).contains(QStringLiteral("in/min")),
                 qPrintable(valueOf(*strip, QStringLiteral("F"))));
    }
    void whatTheMachineHasNotNeedsNoPlaceInTheNavigation() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().tick();
        QVERIFY(bench.window->findChild<QWidget*>(QStringLiteral("nav_boring"))->isVisible());
        QVERIFY(!bench.window->findChild<QWidget*>(QStringLiteral("nav_turning"))->isVisible());
        bench.engine.loop(ProcessId::Turning).fitted = true;
        bench.window->client().tick();
        QVERIFY(bench.window->findChild<QWidget*>(QStringLiteral("nav_turning"))->isVisible());
    }
    void aTouchAfterTheQuestionMarkExplains() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().tick();
        bench.window->client().stop();
        const auto press = [&](const char* name) {
            auto* button = bench.window->findChild<QWidget*>(QLatin1String(name));
            QVERIFY2(button != nullptr, name);
            QTest::mouseClick(button, Qt::LeftButton);
        };
        bench.window->showPage("boring");
        press("help");
        const std::size_t before = bench.engine.commands.size();
        press("boringAccept");  // explained, not done
        QCOMPARE(bench.engine.commands.size(), before);
        auto* sheet = bench.window->sheets().current();
        QVERIFY(sheet != nullptr);
        QVERIFY(sheet->findChild<QLabel*>(QStringLiteral("helpWords"))->text().contains(QStringLiteral("95 %")));
        QVERIFY(!bench.window->findChild<QPushButton*>(QStringLiteral("help"))->isChecked());
        QTest::mouseClick(sheet->findChild<QPushButton*>(QStringLiteral("helpFormula")), Qt::LeftButton);
        QVERIFY(bench.window->sheets().current() == sheet);
        QTest::mouseClick(sheet->findChild<QPushButton*>(QStringLiteral("helpGuide")), Qt::LeftButton);
        const auto* guide = bench.window->sheets().current()->findChild<QTextBrowser*>(QStringLiteral("helpGuideText"));
        QVERIFY(guide != nullptr && guide->toPlainText().contains(QStringLiteral("HOLD ALL")));
        bench.window->sheets().current()->close();
        press("help");
        press("holdAll");  // does what it does, always
        QCOMPARE(bench.engine.holds.load(), 1);
    }
    void everyPageIsExplained() {
        const std::vector<HelpText> texts = helpTexts();
        for (const PageEntry& entry : kerf::test::allPages()) {
            const QString key = QStringLiteral("page:") + QLatin1String(entry.key);
            QVERIFY2(std::ranges::any_of(texts, [&](const HelpText& text) { return key == QLatin1String(text.key); }),
                     qPrintable(key));
        }
    }
};

QTEST_MAIN(TestFrame)
#include "tst_frame.moc"
