// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/shift_desk.h"

#include <spdlog/spdlog.h>

#include <QDateTime>
#include <algorithm>

#include "app/console/shift_report.h"
#include "app/service/shift/shift_records.h"
#include "db/readers/database_reader.h"
#include "engine/api/quality_alarms.h"

namespace kerf::console {
namespace {

constexpr ProcessId kHome = ProcessId::Boring;

Sentence lifeSentence(const ToolLife& tool) {
    const SentenceArg parts(static_cast<double>(tool.parts), 0);
    const SentenceArg life(static_cast<double>(tool.life), 0);
    switch (tool.process) {
        case ProcessId::Boring:
            return Sentence(KERF_TEXT("The insert of the boring bar has made %1 of %2 parts."), parts, life);
        case ProcessId::Milling:
            return Sentence(KERF_TEXT("The milling tool has made %1 of %2 parts."), parts, life);
        case ProcessId::Turning:
            return Sentence(KERF_TEXT("The turning tool has made %1 of %2 parts."), parts, life);
        case ProcessId::Tapping:
            return Sentence(KERF_TEXT("The tap has cut %1 of %2 threads."), parts, life);
        case ProcessId::Thermal:  // has no tool
            return {};
    }
    return Sentence(KERF_TEXT("The tool has made %1 of %2 parts."), parts, life);
}

}  // namespace

ShiftDesk::ShiftDesk(Links links) : m_links(std::move(links)) {}

void ShiftDesk::poll() {
    PartQuery query;
    query.limit = 1;
    const auto newest = m_links.parts.parts(query);
    const PartId id = newest && !newest->empty() ? newest->front().id : 0;
    if (id != m_newest) {
        m_newest = id;
        countTools();
    }
}

void ShiftDesk::countTools() {
    auto tools = readTools(m_links.parts, m_links.records);
    if (!tools) {
        spdlog::error("tools: {}", tools.error().english());
        return;
    }
    m_tools = std::move(*tools);
    warn();
}

void ShiftDesk::warn() {
    bool any = false;
    for (const ToolLife& tool : m_tools) {
        const bool ends = tool.life > 0 && tool.parts >= kToolWarning * tool.life;
        if (!ends) {
            m_warned.erase(tool.process);
            continue;
        }
        any = true;
        if (m_warned.insert(tool.process).second) {
            AlarmEvent event;
            event.code = quality_alarm::kToolLife;
            event.raised = true;
            event.detail = lifeSentence(tool);
            m_links.raise(event);
        }
    }
    if (!any && m_raised) {
        AlarmEvent event;
        event.code = quality_alarm::kToolLife;
        event.raised = false;
        m_links.raise(event);
    }
    m_raised = any;
}

void ShiftDesk::read(int back, Read done) {
    auto view = std::make_shared<ShiftView>();
    m_links.background.run(
        [path = m_links.databasePath, view, back]() -> Result<void> {
            const auto reader = db::DatabaseReader::open(path);
            if (!reader) {
                return tl::unexpected(reader.error());
            }
            db::DatabaseReader& file = **reader;
            auto shift = readShift({file, file, file, file, file}, back, QDateTime::currentMSecsSinceEpoch());
            if (!shift) {
                return tl::unexpected(shift.error());
            }
            *view = std::move(*shift);
            return {};
        },
        [view, done = std::move(done), alive = std::weak_ptr(m_alive)](const Result<void>& result) {
            if (alive.lock()) {
                done(result ? Result<ShiftView>(*view) : tl::unexpected(result.error()));
            }
        });
}

void ShiftDesk::add(AddRoomRecord record, Deed deed, Done done) {
    if (const auto may = permitted(m_links.rights, record.author, deed); !may) {
        done(may);
        return;
    }
    m_links.writer.submit(std::move(record), [this, done = std::move(done),
                                              alive = std::weak_ptr(m_alive)](const Result<Receipt>& stored) {
        if (!alive.lock()) {
            return;
        }
        countTools();
        done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
    });
}

void ShiftDesk::nameStop(std::int64_t fromUtc_ms, const std::string& reason, const std::string& author, Done done) {
    add({kHome, kShiftStopReason, std::to_string(fromUtc_ms), stopReasonJson(reason), author, {}}, Deed::ShiftWords,
        std::move(done));
}

void ShiftDesk::note(const std::string& text, const std::string& author, Done done) {
    add({kHome, kShiftNote, {}, noteJson(text, false), author, {}}, Deed::ShiftWords, std::move(done));
}

void ShiftDesk::handOver(const std::string& text, const std::string& author, Done done) {
    add({kHome, kShiftNote, {}, noteJson(text, true), author, {}}, Deed::ShiftWords, std::move(done));
}

void ShiftDesk::newTool(ProcessId process, const std::string& author, Done done) {
    add({process, kToolChange, processKey(process), toolChangeJson(std::max<PartId>(m_newest, 0)), author, {}},
        Deed::ToolChange, [this, process, author, done = std::move(done)](const Result<void>& stored) {
            if (stored && m_links.toolIsNew) {
                m_links.toolIsNew(process, author);
            }
            done(stored);
        });
}

void ShiftDesk::setToolLife(ProcessId process, std::uint32_t parts, const std::string& author, Done done) {
    add({process, kToolLife, processKey(process), toolLifeJson(parts), author, {}}, Deed::ToolLife, std::move(done));
}

void ShiftDesk::writePdf(const ShiftView& shift, const std::string& file, Done done) {
    m_links.background.run(
        [shift, file, units = m_links.look.units(), specOf = m_links.specOf] {
            return writeShiftReport(shift, units, specOf, QString::fromStdString(file));
        },
        std::move(done));
}

}  // namespace kerf::console
