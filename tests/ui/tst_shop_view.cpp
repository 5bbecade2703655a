// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QTest>

#include "tests/support/page_bench.h"
#include "ui/link/shop_text.h"
#include "ui/pages/diagnostics/diagnostics_page.h"
#include "ui/pages/overview/overview_page.h"

using namespace kerf;
using ui::ShopView;

/// What a screen says of the way to the shop.
class TestShopView : public QObject {
    Q_OBJECT
 private slots:
    void sentences() {
        constexpr std::int64_t kNow_ms = 1'800'000'000'000;
        QCOMPARE(ui::shopText({}, kNow_ms), QStringLiteral("The shop is being called."));
        QCOMPARE(ui::shopText({.lastContactUtc_ms = kNow_ms - 3'000}, kNow_ms),
                 QStringLiteral("Everything is in the shop. Last contact 3 s ago."));
        QCOMPARE(
            ui::shopText({.trouble = ShopView::Trouble::Unreachable,
                          .detail = "no route to host",
                          .unsent = 420,
                          .lastContactUtc_ms = kNow_ms - 17 * 60'000},
                         kNow_ms),
            QStringLiteral("The shop is out of reach. 420 entries wait here; nothing is lost. Last contact 17 min ago. "
                           "(no route to host)"));
        QVERIFY(ui::shopText({.setAside = 2, .lastContactUtc_ms = kNow_ms}, kNow_ms)
                    .contains(QStringLiteral("2 entries were put aside")));
    }
    void overviewAndDiagnosticsShowIt() {
        std::optional<ShopView> shop;
        {
            test::PageBench bench;
            bench.services.shop = [&] { return shop; };
            bench.show<ui::OverviewPage>();
            QVERIFY(bench.find<QLabel>("overviewShop")->isHidden());  // none is wanted
        }
        shop = ShopView{.trouble = ShopView::Trouble::Unreachable, .detail = "timeout", .unsent = 7};
        {
            test::PageBench bench;
            bench.services.shop = [&] { return shop; };
            bench.show<ui::OverviewPage>();
            auto* words = bench.find<QLabel>("overviewShop");
            QVERIFY(!words->isHidden());
            QVERIFY2(words->text().contains(QStringLiteral("7 entries wait")), qPrintable(words->text()));
            QVERIFY(!words->text().contains(QStringLiteral("timeout")));
        }
        test::PageBench bench;
        bench.services.shop = [&] { return shop; };
        bench.show<ui::DiagnosticsPage>();
        auto* fact = bench.find<QLabel>("shopState");
        QVERIFY2(
            fact->text().contains(QStringLiteral("7 entries wait")) && fact->text().contains(QStringLiteral("timeout")),
            qPrintable(fact->text()));
    }
};

QTEST_MAIN(TestShopView)
#include "tst_shop_view.moc"
