// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_application.h"

#include <spdlog/spdlog.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStorageInfo>
#include <algorithm>
#include <functional>
#include <memory>

#include "app/console/part_report.h"
#include "app/console/preferences.h"
#include "app/service/boring/bore_file.h"
#include "app/service/quality/gauge_records.h"
#include "app/service/quality/part_judge.h"

namespace kerf::console {

ui::Services ConsoleApplication::services() {
    if (!m_gate) {
        m_gate = std::make_unique<EngineGate>(EngineGate::Links{
            *m_engine, [this] { return m_window ? m_window->session().author() : std::string(); }, rights(),
            [this](const std::string& who, const char* key, const std::string& what) { audit(who, what, key, {}); },
            [this](const Sentence& why) {
                if (m_window) emit m_window->client().refused(why);
            }});
    }
    ui::Services services{*m_gate};
    if (m_sensorService && !m_sensors->file().gauges.empty()) {
        services.nextGaugeFrame = [this]() -> std::optional<ui::GaugeLineFrame> {
            const auto seen = m_sensorService->nextReading();
            if (!seen) {
                return std::nullopt;
            }
            ui::GaugeLineFrame out{QString::fromStdString(seen->frame), {}, m_sensors->file().gauges[seen->gauge].name};
            if (seen->depth) {
                out.depth = static_cast<std::uint8_t>(*seen->depth - 1);
            }
            return out;
        };
    }
    services.sensorService = m_sensorService.get();
    services.sensorSetup = m_sensorChoice.get();
    services.parts = m_reader.get();
    services.openParts = [path = m_databasePath]() -> std::unique_ptr<PartReader> {
        auto reader = db::DatabaseReader::open(path);
        return reader ? std::move(*reader) : nullptr;
    };
    services.lots = m_reader.get();
    services.alarms = m_reader.get();
    services.audit = m_reader.get();
    services.settings = m_reader.get();
    m_savedSignOn = storedSignOn(*m_reader, *m_reader);
    m_savedSignOn.demonstration = m_simulator != nullptr;
    wrapOldSeals();
    services.signOn = m_savedSignOn;
    if (!m_keeper) {
        m_keeper = std::make_unique<DataKeeper>(
            DataKeeper::Links{*m_writer, m_databasePath,
                              [this](std::function<Result<void>()> work, DataKeeper::Done done) {
                                  m_background.run(std::move(work), std::move(done));
                              },
                              rights()});
    }
    services.savePreferences = [this](const ui::Preferences& now) {
        savePreferences(m_savedPreferences, now,
                        [this](const std::string& key, const std::string& value) { saveSetting(key, value); });
        m_savedPreferences = now;
    };
    services.saveSetting = [this](const QString& key, const QString& value) {
        saveSetting(key.toStdString(), value.toStdString());
    };
    services.saveSignOn = [this](const ui::SignOnSettings& now) {
        saveSignOn(
            m_savedSignOn, now, [this](const std::string& key, const std::string& value) { saveSetting(key, value); },
            [this](SaveAccount account) {
                account.author = author() == kAuthor ? account.name : author();
                m_writer->submit(std::move(account), {});
            },
            [this](const std::string& name) {
                m_keeper->removePerson(name, author(), [this, name](const Result<void>& done) {
                    if (!done) {
                        spdlog::error("{} stays on the list: {}", name, done.error().english());
                    }
                });
            });
        m_savedSignOn = now;
    };
    services.saveWrongPins = [this](const QString& name, unsigned tries, qint64 last_ms) {
        m_writer->submit(NoteWrongPin{name.toStdString(), tries, last_ms}, {});
    };
    services.partsWaiting = [this] { return m_writer->partsWaiting(); };
    services.startFindings = startFindings();
    services.recordSession = [this](const QString& author, const QString& action, const QString& detail) {
        AddAudit audit;
        audit.author = author.toStdString();
        audit.action = action.toStdString();
        audit.object = "session";
        audit.newValue = detail.toStdString();
        m_writer->submit(audit, {});
    };
    services.acknowledgeAlarm = [this](AlarmCode code, const QString& author) { acknowledgeAlarm(code, author); };
    serveFiles(services);
    if (!m_quality) {  // pages hold on to it
        QualityDesk::Links links{*m_writer, *m_reader, m_databasePath, m_background, *m_look};
        links.raise = [this](const AlarmEvent& event) { emit m_window->client().alarmArrived(event); };
        links.specOf = [this](AlarmCode code) { return m_engine->alarmSpec(code); };
        links.rights = rights();
        for (const auto& known : m_rooms) {
            links.processes.push_back(known->process());
        }
        links.recipe = [this](ProcessId process) {
            Room* const known = room(process);
            return known != nullptr ? known->recipe() : RecipeHeld{};
        };
        links.revised = [this](ProcessId process, RecipeRevisionId revision) {
            if (Room* const known = room(process); known != nullptr) {
                known->recipeRevised(revision);
            }
        };
        m_quality = std::make_unique<QualityDesk>(std::move(links));
    }
    services.qualityService = &m_quality->service();
    services.underWay = [this](ProcessId process) {
        Room* const known = room(process);
        return known != nullptr && known->underWay();
    };
    services.shop = [this]() -> std::optional<ui::ShopView> { return m_shop ? m_shop->view() : std::nullopt; };
    for (const auto& room : m_rooms) {
        room->serve(services);
    }
    serveShift(services);
    return services;
}

void ConsoleApplication::serveShift(ui::Services& services) {
    if (!m_shiftDesk) {
        ShiftDesk::Links links{*m_writer, *m_reader, *m_reader, m_databasePath, m_background, *m_look};
        links.rights = rights();
        links.specOf = [this](AlarmCode code) { return m_engine->alarmSpec(code); };
        links.raise = [this](const AlarmEvent& event) { emit m_window->client().alarmArrived(event); };
        links.toolIsNew = [this](ProcessId process, const std::string& author) {
            if (Room* known = room(process)) {
                known->toolIsNew(author);
            }
        };
        m_shiftDesk = std::make_unique<ShiftDesk>(std::move(links));
    }
    services.shiftService = m_shiftDesk.get();
}

namespace {

/// On removable drives, also those that cannot be written, among the documents and in `also`; one folder deep, newest
/// first.
QStringList filesOf(const QString& ending, const QString& also) {
    QStringList roots{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                      QStandardPaths::writableLocation(QStandardPaths::DownloadLocation), also};
    for (const QStorageInfo& drive : QStorageInfo::mountedVolumes()) {
        const QString root = drive.rootPath();
        if (drive.isReady() && (root.startsWith(QLatin1String("/media/")) || root.startsWith(QLatin1String("/mnt/")) ||
                                root.startsWith(QLatin1String("/run/media/")))) {
            roots.prepend(root);
        }
    }
    roots.removeDuplicates();
    QFileInfoList found;
    const QStringList names{QStringLiteral("*.") + ending};
    for (const QString& root : roots) {
        const QDir folder(root);
        found << folder.entryInfoList(names, QDir::Files | QDir::Readable, QDir::Time);
        for (const QString& inside : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name).mid(0, 50)) {
            found << QDir(folder.filePath(inside)).entryInfoList(names, QDir::Files | QDir::Readable, QDir::Time);
        }
    }
    std::ranges::stable_sort(found, std::greater{}, [](const QFileInfo& info) { return info.lastModified(); });
    QStringList files;
    for (const QFileInfo& info : found.mid(0, 50)) {
        files << info.absoluteFilePath();
    }
    return files;
}

}  // namespace

void ConsoleApplication::serveFiles(ui::Services& services) {
    using Done = ui::Services::Done;
    services.setSerial = [this](PartId part, const QString& serial, const QString& author, const Done& done) {
        m_writer->submit(SetPartSerial{part, serial.toStdString(), author.toStdString(), {}},
                         [done](const Result<Receipt>& stored) {
                             done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
                         });
    };
    services.writeReport = [this](PartId part, const QString& file, const Done& done) {
        m_background.run(
            [path = m_databasePath, units = m_look->units(), part, file]() -> Result<void> {
                const auto reader = db::DatabaseReader::open(path);
                const auto detail =
                    reader ? (*reader)->part(part) : Result<std::optional<PartDetail>>(tl::unexpected(reader.error()));
                if (!detail) {
                    return tl::unexpected(detail.error());
                }
                if (!*detail) {
                    return fail(KERF_TEXT("There is no such part."));
                }
                PartJudge judge(**reader, **reader);
                const auto decided = dispositionsIn(**reader);
                const auto found = decided.find(part);
                return writePartReport(**detail, judge.characteristics((*detail)->part),
                                       found == decided.end() ? std::nullopt : std::optional(found->second), units,
                                       file);
            },
            done);
    };
    services.backupFolders = [] {
        QStringList folders;
        for (const QStorageInfo& drive : QStorageInfo::mountedVolumes()) {
            const QString root = drive.rootPath();
            const bool removable = root.startsWith(QLatin1String("/media/")) ||
                                   root.startsWith(QLatin1String("/run/media/")) ||
                                   root.startsWith(QLatin1String("/mnt/"));
            if (removable && drive.isReady() && !drive.isReadOnly()) {
                folders << root;
            }
        }
        folders << QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        return folders;
    };
    services.filesThere = [data =
                               QFileInfo(QString::fromStdString(m_databasePath)).absoluteDir()](const QString& ending) {
        return filesOf(ending, data.filePath(QStringLiteral("backups")));
    };
    services.restore = [this](const QString& file, const QString& who, const QString& reason, const Done& done) {
        m_keeper->restore(file.toStdString(), who.toStdString(), reason.toStdString(), done);
    };
    services.readBores = [this](const QString& file, const std::function<void(const ReadBores&)>& done) {
        const auto read = std::make_shared<ReadBores>();
        m_background.run(
            [file, read]() -> Result<void> {
                *read = readBores(QFile::encodeName(file).toStdString());
                read->file = QFileInfo(file).fileName().toStdString();
                return {};
            },
            [read, done](const Result<void>&) { done(*read); });
    };
    services.backUp = [this](const QString& file, const Done& done) {
        m_background.run(
            [path = m_databasePath, file] {
                QDir().mkpath(QFileInfo(file).absolutePath());
                return db::backupDatabase(path, file.toStdString());
            },
            done);
    };
}

}  // namespace kerf::console
