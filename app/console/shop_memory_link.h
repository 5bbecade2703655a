// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/console/background.h"
#include "app/service/boring/boring_lots.h"
#include "db/shop/pg_connection.h"

namespace kerf::console {

/// Asks the shop for lots of other machines, on a worker with low priority. The data folder names a reader's connection
/// in shop/memory; the console's own role may only push. Nothing waits for it, and its end takes no longer than a cut
/// of its own connection. GUI thread.
class ShopMemoryLink {
 public:
    ShopMemoryLink(const std::string& dataFolder, std::string dataFile, bool simulated);
    ~ShopMemoryLink() { m_interrupt.trigger(); }
    ShopMemoryLink(const ShopMemoryLink&) = delete;
    ShopMemoryLink& operator=(const ShopMemoryLink&) = delete;

    /// `told` comes later on this thread; never after the end.
    void ask(const std::string& partType, StoredBoringLots::ShopLotsTold told);

 private:
    std::string m_setting;
    std::string m_dataFile;
    bool m_simulated;
    db::Interrupt m_interrupt;
    Background m_background;  ///< ended before the interrupt goes
};

}  // namespace kerf::console
