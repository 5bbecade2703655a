// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "engine/api/engine_api.h"
#include "ui/services/boring_service.h"
#include "ui/shell/operator_session.h"

namespace kerf {
class AlarmReader;
class AuditReader;
class BoringLots;
class LotReader;
class MillingService;
class PartReader;
class SensorService;
class SensorSetup;
class QualityService;
class SettingsReader;
class ShiftService;
class TappingService;
class ThermalService;
class TurningService;
}  // namespace kerf

namespace kerf::ui {

struct Preferences;
struct ShopView;

/// A reading of a gauge on a serial line.
struct GaugeLineFrame {
    QString frame{};                      ///< as a keyboard wedge would type it
    std::optional<std::uint8_t> depth{};  ///< measured depth, from 0, where the sensor file says which; else learnt
    std::string gauge{};                  ///< which gauge, by the sensor file
};

/// Everything the console's face may use, handed to it by the application. Only `engine` must be there; a page says
/// what is missing when a pointer it needs is null. All of them outlive the main window and are used on the GUI thread.
struct Services {
    EngineApi& engine;
    BoringService* boringService{nullptr};
    BoringLots* boringLots{nullptr};
    MillingService* millingService{nullptr};
    TurningService* turningService{nullptr};
    ThermalService* thermalService{nullptr};
    TappingService* tappingService{nullptr};
    SensorService* sensorService{nullptr};  ///< null: no sensor file
    SensorSetup* sensorSetup{nullptr};      ///< which sensor file; null: not on this console
    QualityService* qualityService{nullptr};
    ShiftService* shiftService{nullptr};
    PartReader* parts{nullptr};
    LotReader* lots{nullptr};
    AlarmReader* alarms{nullptr};
    AuditReader* audit{nullptr};
    SettingsReader* settings{nullptr};
    SignOnSettings signOn{};  ///< who is known, as stored

    /// Readings of gauges on serial lines, one by one; empty: no such gauge.
    std::function<std::optional<GaugeLineFrame>()> nextGaugeFrame{};
    /// A part reader of its own for a worker thread (export), called on that thread; empty: no export.
    std::function<std::unique_ptr<PartReader>()> openParts{};

    /// Called when the operator has changed language, unit, theme or scale; the application stores it.
    std::function<void(const Preferences&)> savePreferences{};
    /// A setting of a page, by its key; written to the audit log as every setting is.
    std::function<void(const QString& key, const QString& value)> saveSetting{};
    /// Called when somebody new has signed on, or a role or PIN is another one; the application stores it.
    std::function<void(const SignOnSettings&)> saveSignOn{};
    /// A wrong PIN, or the right one after wrong ones: kept over a restart.
    std::function<void(const QString& name, unsigned tries, qint64 last_ms)> saveWrongPins{};
    /// What the next part of a process is made with, or whose it is, is on its way to the disk or to the engine. Empty:
    /// nothing ever is.
    std::function<bool(ProcessId)> underWay{};
    /// Finished parts that wait because the store does not take them.
    std::function<std::size_t()> partsWaiting{};
    /// State of the way to the shop, cheap to ask; empty optional or empty function: none is wanted.
    std::function<std::optional<ShopView>()> shop{};
    /// What was found when the data file was opened; said once.
    std::vector<Sentence> startFindings{};
    /// Who signed on or off, who changed a role: for the audit log.
    std::function<void(const QString& author, const QString& action, const QString& detail)> recordSession{};
    /// Called on the GUI thread when it is done, or has failed and why.
    using Done = std::function<void(const Result<void>&)>;
    /// Give a finished part its serial number. Empty: not possible here.
    std::function<void(std::int64_t part, const QString& serial, const QString& author, Done)> setSerial{};
    /// One page about a part as PDF into `file`, on a worker.
    std::function<void(std::int64_t part, const QString& file, Done)> writeReport{};
    /// Where a backup can go: removable drives first, then the documents.
    std::function<QStringList()> backupFolders{};
    /// A checked copy of the whole data file into `file`, on a worker, while everything goes on.
    std::function<void(const QString& file, Done)> backUp{};
    /// Checks that `file` is a whole backup and keeps it for the next start, which takes its place; what is there now
    /// is kept beside it. Empty: not possible here.
    std::function<void(const QString& file, const QString& author, const QString& reason, Done)> restore{};
    /// Files of that ending on removable drives and among the documents, newest first.
    std::function<QStringList(const QString& ending)> filesThere{};
    /// Reads a table of diameters on a worker; `done` on the GUI thread. Empty: no import.
    std::function<void(const QString& file, std::function<void(const ReadBores&)> done)> readBores{};
    /// Called when alarms have been acknowledged by code; the application writes it to the history.
    std::function<void(AlarmCode, const QString& author)> acknowledgeAlarm{};
};

}  // namespace kerf::ui
