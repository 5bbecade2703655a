// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <functional>

#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"

using kerf::test::fixture;
using kerf::test::KerfRun;
using kerf::test::runKerf;

/// Whole columns that cannot be meant: another unit, another decade, another clock. Refused with line and column;
/// --accept-implausible takes them and says so.
class TestSlips : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] static QString caseFile(const char* name) {
        return QString::fromStdString(fixture(std::string("cases/30-whole-column-unit/") + name));
    }
    /// A day of the fixtures with its cells changed: column by name, text before, text after.
    using Change = std::function<QString(const QString& column, const QString& cell)>;
    [[nodiscard]] QString day(const char* name, const Change& change, int everyRow = 1) {
        QFile in(QString::fromStdString(fixture("thermal/H0_train.csv")));
        QFile out(m_folder.filePath(QLatin1String(name)));
        if (!in.open(QIODevice::ReadOnly) || !out.open(QIODevice::WriteOnly)) {
            return {};
        }
        const QStringList lines = QString::fromUtf8(in.readAll()).split(u'\n', Qt::SkipEmptyParts);
        const QStringList columns = lines.first().split(u',');
        out.write(lines.first().toUtf8() + '\n');
        for (int row = 1; row < lines.size(); row += everyRow) {
            QStringList cells = lines[row].split(u',');
            for (int i = 0; i < cells.size(); ++i) {
                cells[i] = change(columns[i], cells[i]);
            }
            out.write(cells.join(u',').toUtf8() + '\n');
        }
        return out.fileName();
    }
    [[nodiscard]] static Change times(double factor, const QString& what) {
        return [factor, what](const QString& column, const QString& cell) {
            const bool hit = what == QStringLiteral("T") ? column.startsWith(u'T') : column == what;
            return hit ? QString::number(cell.toDouble() * factor, 'g', 8) : cell;
        };
    }
    void refusedUnlessAccepted(QStringList command, const QString& column, const QString& words) {
        const KerfRun refused = runKerf(command);
        QVERIFY2(refused.exitCode == 3, qPrintable(command.join(u' ') + u'\n' + refused.err));
        QVERIFY2(refused.err.contains(column) && refused.err.contains(words) && refused.err.contains(u"line"),
                 qPrintable(refused.err));
        QVERIFY(refused.out.isEmpty());
        const KerfRun taken = runKerf(command << QStringLiteral("--accept-implausible"));
        QVERIFY2(taken.exitCode == 0, qPrintable(taken.err));
        QVERIFY2(taken.err.contains(words), qPrintable(taken.err));
    }

 private slots:
    void initTestCase() {
        const KerfRun run =
            runKerf({"thermal", "train", "--history", QString::fromStdString(fixture("thermal/H0_train.csv")),
                     "--model", "regression", "-o", m_folder.filePath("model.json")});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    }
    void overhangs() {
        QCOMPARE(runKerf({"boring", "replay", caseFile("good.csv"), "--target-diameter-mm", "50"}).exitCode, 0);
        for (const auto& [name, words] :
             {std::pair("inch.csv", "inch?"), std::pair("cm.csv", "cm?"), std::pair("metres.csv", "metres?")}) {
            refusedUnlessAccepted({"boring", "replay", caseFile(name), "--target-diameter-mm", "50"}, "overhang_mm",
                                  QLatin1String(words));
        }
    }
    void overhangsOnTheCharts() {
        const auto file = [&](double factor) {
            QString text = QStringLiteral("part,overhang_mm,feed_mm_per_rev,deflection_mm\n");
            for (int part = 1; part <= 12; ++part) {
                for (const double overhang : {40.0, 310.0}) {
                    text += QStringLiteral("%1,%2,0.2,%3\n")
                                .arg(part)
                                .arg(overhang * factor)
                                .arg(0.1 + 0.001 * (part % 3), 0, 'f', 4);
                }
            }
            QFile out(m_folder.filePath("bores.csv"));
            return out.open(QIODevice::WriteOnly) && out.write(text.toUtf8()) > 0 ? out.fileName() : QString();
        };
        QCOMPARE(runKerf({"quality", "charts", file(1.0)}).exitCode, 0);
        refusedUnlessAccepted({"quality", "charts", file(1.0 / 25.4)}, "overhang_mm", "inch?");
        refusedUnlessAccepted({"quality", "charts", file(0.1)}, "overhang_mm", "cm?");
    }
    void temperaturesADigitTooLow_data() {
        QTest::addColumn<QStringList>("command");
        QTest::newRow("train") << QStringList{"thermal", "train", "--model", "regression", "-o", "x.json"};
        QTest::newRow("predict") << QStringList{"thermal", "predict"};
        QTest::newRow("compensate") << QStringList{"thermal", "compensate"};
    }
    void temperaturesADigitTooLow() {
        QFETCH(QStringList, command);
        if (command[1] != QStringLiteral("train")) {
            command << "--model" << m_folder.filePath("model.json");
        } else {
            command[5] = m_folder.filePath("x.json");
        }
        command << "--history";
        refusedUnlessAccepted(command + QStringList{day("low.csv", times(0.1, "T"))}, "T", "a digit too few?");
        refusedUnlessAccepted(command + QStringList{day("hours.csv", times(1.0 / 60.0, "t_min"))}, "t_min",
                              "not hours");
        refusedUnlessAccepted(command + QStringList{day("days.csv", times(1.0 / 1440.0, "t_min"))}, "t_min",
                              "not days");
    }
    /// The machine stood all day and nothing says hours but the length; who has a record by the second says so.
    void aQuietDayInHours() {
        const auto quiet = [](const QString& name, const QString& cell) {
            const double value = cell.toDouble();
            return name == QStringLiteral("t_min")     ? QString::number(value / 60.0, 'g', 12)
                   : name.startsWith(QLatin1Char('T')) ? QString::number(22.0 + 0.02 * (value - 22.0), 'f', 3)
                                                       : cell;
        };
        for (const char* verb : {"predict", "compensate"}) {
            refusedUnlessAccepted(
                {"thermal", verb, "--model", m_folder.filePath("model.json"), "--history", day("quiet.csv", quiet)},
                "t_min", "not hours");
        }
    }
    void oneSensorADigitTooLow() {
        const QString file = day("one.csv", times(0.1, "T07"));
        const KerfRun refused = runKerf(
            {"thermal", "train", "--history", file, "--model", "regression", "-o", m_folder.filePath("x.json")});
        QCOMPARE(refused.exitCode, 3);
        QVERIFY2(refused.err.contains("T07"), qPrintable(refused.err));
    }
    void aShortRecordIsPredicted() {
        const KerfRun run = runKerf({"thermal", "predict", "--model", m_folder.filePath("model.json"), "--history",
                                     day(
                                         "few.csv", [](const QString&, const QString& cell) { return cell; }, 20)});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    }
};

QTEST_GUILESS_MAIN(TestSlips)
#include "tst_slips.moc"
