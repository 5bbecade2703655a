// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/shop_text.h"

#include <QCoreApplication>
#include <algorithm>

namespace kerf::ui {
namespace {

struct ShopText {
    Q_DECLARE_TR_FUNCTIONS(ShopText)
};

constexpr qint64 kMinute_ms = 60'000;
constexpr qint64 kHour_ms = 60 * kMinute_ms;

QString ageText(qint64 age_ms) {
    if (age_ms < kMinute_ms) {
        return ShopText::tr("%1 s ago").arg(age_ms / 1000);
    }
    return age_ms < 2 * kHour_ms ? ShopText::tr("%1 min ago").arg(age_ms / kMinute_ms)
                                 : ShopText::tr("%1 h ago").arg(age_ms / kHour_ms);
}

QString troubleText(ShopView::Trouble trouble) {
    switch (trouble) {
        case ShopView::Trouble::NotPrepared:
            return ShopText::tr("The shop's database is not prepared for consoles.");
        case ShopView::Trouble::NotAllowed:
            return ShopText::tr("The shop does not let this console in: enrol it.");
        case ShopView::Trouble::NewerConsole:
            return ShopText::tr("This console is newer than the shop: bring the shop up to date.");
        case ShopView::Trouble::DataFile:
            return ShopText::tr("The data file cannot be read for the shop.");
        case ShopView::Trouble::WrongSetting:
            return ShopText::tr("The shop's address cannot be used.");
        case ShopView::Trouble::Unreachable:
            return ShopText::tr("The shop is out of reach.");
        case ShopView::Trouble::None:
            break;
    }
    return {};
}

}  // namespace

QString shopText(const ShopView& shop, std::int64_t nowUtc_ms) {
    QStringList words;
    if (shop.trouble != ShopView::Trouble::None) {
        words << troubleText(shop.trouble);
    }
    if (shop.unsent > 0) {
        words << ShopText::tr("%1 entries wait here; nothing is lost.").arg(shop.unsent);
    } else if (shop.trouble == ShopView::Trouble::None) {
        words << (shop.lastContactUtc_ms > 0 ? ShopText::tr("Everything is in the shop.")
                                             : ShopText::tr("The shop is being called."));
    }
    if (shop.setAside > 0) {
        words << ShopText::tr("%1 entries were put aside there: have them looked at.").arg(shop.setAside);
    }
    if (shop.lastContactUtc_ms > 0) {
        words << ShopText::tr("Last contact %1.", "an age")
                     .arg(ageText(std::max<std::int64_t>(0, nowUtc_ms - shop.lastContactUtc_ms)));
    }
    if (!shop.detail.empty() && shop.trouble != ShopView::Trouble::None) {
        words << QStringLiteral("(%1)").arg(QString::fromStdString(shop.detail).simplified());
    }
    return words.join(u' ');
}

}  // namespace kerf::ui
