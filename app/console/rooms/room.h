// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/console/options.h"
#include "app/service/rights.h"
#include "db/api/store_writer.h"
#include "db/readers/database_reader.h"
#include "engine/api/engine_api.h"
#include "engine/cycle/process_loop.h"
#include "engine/machine/simulated/simulated_process.h"
#include "ui/services/quality_service.h"
#include "ui/services/thermal_service.h"
#include "ui/shell/page.h"
#include "ui/shell/services.h"

namespace kerf::console {

class Simulator;

/// One process on the console: what it brings to the simulated machine and to the engine, and its service and its
/// page. GUI thread.
///
/// Order of the calls: makePlant (simulated machines only), makeLoop, open, whenOpen, serve, then poll a few times per
/// second.
/// The engine is stopped before a room is destroyed.
class Room {
 public:
    struct Context {
        EngineApi& engine;  ///< made, not yet started
        StoreWriter& writer;
        db::DatabaseReader& reader;
        const Options& options;
        const std::string& databasePath;      ///< for connections of a worker's own
        std::function<std::string()> author;  ///< who is signed on; "Kerf" when nobody is
        Rights rights;
        Simulator* simulator{nullptr};                        ///< null: a real machine
        std::string nobody{};                                 ///< who acts where nobody has signed on
        std::function<void(const QString& line)> accepted{};  ///< a measurement is accepted (--print-acceptances)
        std::vector<ThermalSensorView> temperatures{};  ///< of the sensor file; empty: those of the machine itself
    };

    Room() = default;
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    virtual ~Room() = default;

    [[nodiscard]] virtual ProcessId process() const noexcept = 0;
    [[nodiscard]] virtual ui::PageEntry page() const = 0;
    /// Whether a machine of this kind (--machine) can have this process at all.
    [[nodiscard]] virtual bool fits(const std::string& machineKind) const = 0;
    /// May be null.
    [[nodiscard]] virtual std::unique_ptr<SimulatedProcess> makePlant(const Options& options) = 0;
    [[nodiscard]] virtual std::unique_ptr<ProcessLoop> makeLoop() = 0;
    /// Make the service, load what was kept, send the loop its first setup.
    virtual void open(const Context&) {}
    using Opened = std::function<void(const Result<void>&)>;
    /// `then` is called once, when what open() has begun is done, at once or from the event loop.
    virtual void whenOpen(Opened then) { then({}); }
    /// Hand the service to the pages.
    virtual void serve(ui::Services&) {}
    virtual void poll() {}
    /// What the next part is made with, or whose it is, is on its way to the disk or to the engine: a start now would
    /// be of something else than what was stored last.
    [[nodiscard]] virtual bool underWay() { return false; }
    /// What parts of no lot are made under now; empty: parts of this process have lots, or it makes none.
    [[nodiscard]] virtual RecipeHeld recipe() { return {}; }
    /// Limits have made this revision of it.
    virtual void recipeRevised(RecipeRevisionId /*revision*/) {}
    /// A person has said that a new tool is in.
    virtual void toolIsNew(const std::string& /*author*/) {}
    /// The simulated day before the operator comes: so that no page is empty. Called again and again, with the
    /// machine's state, until it says true.
    [[nodiscard]] virtual bool prepared(EngineApi&) { return true; }
};

/// Has this process of the simulated machine cut `wanted` parts? Starts the next one when the machine is free.
[[nodiscard]] bool cutBeforehand(EngineApi& engine, ProcessId process, std::uint32_t cut, std::uint32_t wanted);

/// Parts of that process ever made, up to and with `last` (all when empty).
[[nodiscard]] std::uint32_t madeUpTo(PartReader& reader, ProcessId process, std::optional<PartId> last);

/// All processes of the console. The one list to add a process to.
[[nodiscard]] std::vector<std::unique_ptr<Room>> standardRooms();

}  // namespace kerf::console
