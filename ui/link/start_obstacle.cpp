// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/start_obstacle.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

struct StartObstacle {
    Q_DECLARE_TR_FUNCTIONS(StartObstacle)
};

}  // namespace

QString machineObstacle(const Status& status) {
    if (status.link != LinkState::Up) {
        return StartObstacle::tr("No link to the machine.");
    }
    if (status.emergencyStop) {
        return StartObstacle::tr("Emergency stop is pressed.");
    }
    if (!status.machineOn) {
        return StartObstacle::tr("The machine is off.");
    }
    if (status.held) {
        return StartObstacle::tr("Hold is in force.");
    }
    return {};
}

QString standingObstacle(const Status& status) {
    if (const QString why = machineObstacle(status); !why.isEmpty()) {
        return why;
    }
    if (std::ranges::any_of(status.stops, [](const StopStatus& stop) { return stop.slot.active(); })) {
        return StartObstacle::tr("A stop stands: look at the machine, then release it.");
    }
    return {};
}

QString startObstacle(const Status& status, const Capability& cycleStart, ProcessId process, const UnitSystem& units) {
    if (!cycleStart.fitted) {
        return cycleStart.why.empty() ? StartObstacle::tr("Start the program at the control.")
                                      : sentenceText(cycleStart.why, units);
    }
    if (const QString why = standingObstacle(status); !why.isEmpty()) {
        return why;
    }
    if (status.partsBlocked) {
        return StartObstacle::tr("Finished parts are not stored yet.");
    }
    if (status.program == ProgramState::Running || status.program == ProgramState::Paused) {
        return status.programProcess == process
                   ? StartObstacle::tr("A part is being cut.")
                   : StartObstacle::tr("The machine is busy: %1.").arg(processName(status.programProcess));
    }
    return {};
}

}  // namespace kerf::ui
