// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QTableWidget>
#include <QTcpServer>
#include <algorithm>
#include <cmath>

#include "app/service/boring/boring_recipe.h"
#include "tests/support/console_bench.h"
#include "ui/widgets/value_field.h"

using namespace kerf;

/// A running console whose recipe tells it to draw on the shop's lots of other machines. Run by memory_check.py, which
/// has made a shop with lots of "Sleeve 50" on other machines, three of them on VB-3:
///   KERF_SHOP_READER    connection that may read    KERF_SHOP_SENDER  connection that may push
///   KERF_SHOP_STRANGER  connection that may neither
///   KERF_SHOP_LOTS      lots that there are to draw on, one of them left out by its own console
///   KERF_SHOP_KEEP      folder that the console's data file is copied to at the end
class TestConsoleDraws : public QObject {
    Q_OBJECT

    static constexpr const char* kPartType = "Sleeve 50";

    void setting(const char* name, const QByteArray& line) {
        QVERIFY(QDir(m_bench.folder()).mkpath(QStringLiteral("shop")));
        QFile file(m_bench.folder() + QStringLiteral("/shop/") + QLatin1String(name));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(line + '\n');
    }
    void start() { m_bench.startQuietly(); }
    /// By the operator's hands: the lots' sheet, its part type, its button.
    void openLot(const QString& partType, const QString& name) {
        QVERIFY(m_bench.press("lots"));
        QTRY_VERIFY(m_bench.find<QComboBox>("lotPartType") != nullptr);
        m_bench.find<QComboBox>("lotPartType")->setCurrentText(partType);
        auto* field = m_bench.find<QLineEdit>("lotName");
        field->setText(name);
        emit field->textEdited(name);
        QVERIFY(m_bench.press("lotOpen"));
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.service().lot, name.toStdString(), 30'000);
        QCOMPARE(m_bench.service().partType, partType.toStdString());
    }
    void makePartType(const char* name, double drawOnShop) {
        QVERIFY(m_bench.press("lots"));
        QVERIFY(m_bench.press("lotNewPartType"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("recipeName") != nullptr);
        m_bench.find<QLineEdit>("recipeName")->setText(QLatin1String(name));
        const auto specs = boringRecipeSpecs();
        const auto at = std::ranges::find(specs, std::string("boring.shop_memory"), &ParamSpec::key);
        QVERIFY(at != specs.end());
        const QByteArray field = "recipeField" + QByteArray::number(static_cast<int>(at - specs.begin()));
        auto* value = m_bench.find<ui::ValueField>(field.constData());
        QVERIFY(value != nullptr && value->value() == 0.0);  // off by default
        value->setValue(drawOnShop);
        emit value->edited();
        QVERIFY(m_bench.press("recipeSave"));
        QTRY_VERIFY(m_bench.find<QComboBox>("lotPartType") != nullptr);
        QVERIFY(m_bench.press("lotCancel"));
    }
    [[nodiscard]] QString restsOn() { return QString::fromStdString(m_bench.service().nextRestsOn.english()); }
    [[nodiscard]] QString answer() {
        return QString::fromStdString(m_bench.console().boringLots().shopAnswer().english());
    }
    [[nodiscard]] int othersDrawnOn() {
        const auto memory = m_bench.console().boringLots().memory();
        return memory ? static_cast<int>(std::ranges::count_if(
                            *memory, [](const BoringMemoryLotView& lot) { return !lot.console.empty(); }))
                      : -1;
    }
    /// The part of the lot in the machine is bored and its two diameters are entered.
    void boreAndMeasure() {
        m_bench.console().window()->showPage("overview");
        if (!m_bench.service().awaiting) {
            QVERIFY(m_bench.press("startPart"));
        }
        m_bench.console().window()->showPage("boring");
        for (std::uint8_t depth = 0; depth < 2; ++depth) {
            QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting && m_bench.service().awaitingDepth == depth, 60'000);
            const auto gauged = m_bench.console().boringService().gaugeReading_mm(*m_bench.service().awaiting, depth);
            QVERIFY(gauged.has_value());
            QVERIFY(m_bench.keyIn(QString::number(*gauged, 'f', 3)));
            const auto taken = [&] {
                const BoringServiceView& view = m_bench.service();
                return view.parts.back().complete || (view.awaiting && view.awaitingDepth != depth);
            };
            QTRY_VERIFY_WITH_TIMEOUT(taken() || m_bench.find("boringConfirm") != nullptr, 20'000);
            if (!taken()) {  // far from what others' lots let expect: Kerf asks, and it is true
                QVERIFY(m_bench.press("boringConfirm"));
                QTRY_VERIFY_WITH_TIMEOUT(taken(), 20'000);
            }
        }
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().parts.back().complete, 20'000);
    }

 private slots:
    void initTestCase() {
        for (const char* name :
             {"KERF_SHOP_READER", "KERF_SHOP_SENDER", "KERF_SHOP_STRANGER", "KERF_SHOP_LOTS", "KERF_SHOP_KEEP"}) {
            QVERIFY2(qEnvironmentVariableIsSet(name), name);
        }
        m_lots = qEnvironmentVariableIntValue("KERF_SHOP_LOTS");
        setting("memory", qgetenv("KERF_SHOP_READER"));
        setting("database", qgetenv("KERF_SHOP_SENDER"));
        start();
        makePartType("Alone", 0.0);
        makePartType(kPartType, 1.0);
    }
    void aLotThatIsNotToldBeginsAlone() {
        openLot(QStringLiteral("Alone"), QStringLiteral("a1"));
        QVERIFY(answer().isEmpty());
        QCOMPARE(othersDrawnOn(), 0);
    }
    void aLotThatIsToldBeginsFromTheOtherMachines() {
        openLot(QLatin1String(kPartType), QStringLiteral("s1"));
        QTRY_COMPARE_WITH_TIMEOUT(othersDrawnOn(), m_lots, 30'000);
        QTRY_VERIFY2_WITH_TIMEOUT(restsOn().contains(QStringLiteral("0 earlier lots and %1 of other").arg(m_lots - 1)),
                                  qPrintable(restsOn()), 10'000);
        QVERIFY2(answer().isEmpty(), qPrintable(answer()));
        QVERIFY(m_bench.press("lots"));
        int others = 0;
        auto* table = m_bench.find<QTableWidget>("lotTable");
        QVERIFY(table != nullptr);
        for (int row = 0; row < table->rowCount(); ++row) {
            for (int column = 0; column < table->columnCount(); ++column) {
                const auto* cell = table->item(row, column);
                others += cell != nullptr && cell->text().contains(QStringLiteral("VB-3")) ? 1 : 0;
            }
        }
        QCOMPARE(others, 3);  // the lots of VB-3 stand on the screen
        QVERIFY(m_bench.press("lotCancel"));
        boreAndMeasure();
        QVERIFY2(restsOn().contains(QStringLiteral("1 measured part")), qPrintable(restsOn()));
    }
    /// What the shop had is kept with the lot: the same start, whether the shop is there or not.
    void aRestartWithoutTheShopChangesNothing() {
        const BoringServiceView before = m_bench.service();
        m_bench.stop();
        setting("memory", "dbname=nobody host=127.0.0.1 port=1 user=nobody sslmode=disable");
        start();
        QCOMPARE(m_bench.service().lot, before.lot);
        QCOMPARE(m_bench.service().nextSchedule.lnC, before.nextSchedule.lnC);
        QCOMPARE(m_bench.service().nextSchedule.alpha, before.nextSchedule.alpha);
        QCOMPARE(m_bench.service().nextSchedule.beta, before.nextSchedule.beta);
        QCOMPARE(othersDrawnOn(), m_lots);
        QVERIFY(m_bench.console().boringService().restartFinding().empty());
    }
    void aShopOutOfReachIsSaidAndTheLotGoesOn() {
        openLot(QLatin1String(kPartType), QStringLiteral("s2"));
        QTRY_VERIFY2_WITH_TIMEOUT(answer().contains(QStringLiteral("out of reach")), qPrintable(answer()), 30'000);
        QVERIFY(m_bench.press("lots"));
        QTRY_VERIFY2(m_bench.text("lotMessage").contains(QStringLiteral("out of reach")),
                     qPrintable(m_bench.text("lotMessage")));
        QVERIFY(m_bench.press("lotCancel"));
        QCOMPARE(othersDrawnOn(), 0);
        boreAndMeasure();
    }
    /// A server that takes the connection and never answers: the lot is open, its first part is bored and measured.
    void aShopThatHangsHoldsNothing() {
        QTcpServer silent;
        QVERIFY(silent.listen(QHostAddress::LocalHost));
        setting("memory", "dbname=nobody host=127.0.0.1 user=nobody sslmode=disable port=" +
                              QByteArray::number(silent.serverPort()));
        openLot(QLatin1String(kPartType), QStringLiteral("s3"));
        QVERIFY2(answer().contains(QStringLiteral("is asked")), qPrintable(answer()));
        boreAndMeasure();
        QTRY_VERIFY2_WITH_TIMEOUT(answer().contains(QStringLiteral("out of reach")), qPrintable(answer()), 60'000);
        QCOMPARE(othersDrawnOn(), 0);
    }
    void aReaderWithoutTheRightIsSaid() {
        setting("memory", qgetenv("KERF_SHOP_STRANGER"));
        openLot(QLatin1String(kPartType), QStringLiteral("s4"));
        QTRY_VERIFY2_WITH_TIMEOUT(answer().contains(QStringLiteral("does not let this console read")),
                                  qPrintable(answer()), 30'000);
    }
    void withTheShopBackTheNextLotDrawsAgain() {
        setting("memory", qgetenv("KERF_SHOP_READER"));
        openLot(QLatin1String(kPartType), QStringLiteral("s5"));
        QTRY_COMPARE_WITH_TIMEOUT(othersDrawnOn(), m_lots, 30'000);
        const QString both = QStringLiteral("3 earlier lots and %1 of other").arg(m_lots - 1);
        QTRY_VERIFY2_WITH_TIMEOUT(restsOn().contains(both), qPrintable(restsOn()), 10'000);
    }
    /// And all of it has gone to the shop meanwhile.
    void everythingIsSent() {
        // What the sender said before it looked again says nothing of the newest lot.
        const qint64 looked_ms = QDateTime::currentMSecsSinceEpoch() + 2000;
        QTRY_VERIFY_WITH_TIMEOUT(
            [&] {
                const auto shop = m_bench.console().services().shop();
                return shop && shop->trouble == ui::ShopView::Trouble::None && shop->unsent == 0 &&
                       shop->setAside == 0 && shop->lastContactUtc_ms > looked_ms;
            }(),
            60'000);
        m_bench.stop();
        const QDir from(m_bench.folder());
        const QString to = qEnvironmentVariable("KERF_SHOP_KEEP");
        QVERIFY(QDir().mkpath(to));
        for (const QString& file : from.entryList({QStringLiteral("kerf.db*")}, QDir::Files)) {
            QVERIFY(QFile::copy(from.filePath(file), to + u'/' + file));
        }
    }

 private:
    test::ConsoleBench m_bench;
    int m_lots{0};
};

QTEST_MAIN(TestConsoleDraws)
#include "console_draws.moc"
