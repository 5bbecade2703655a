// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/core/result.h"

/// What a shift leaves to the next one. Plain values; instants are milliseconds since 1970-01-01 UTC.
namespace kerf {

/// Parts of one process that ended within the shift.
struct ShiftParts {
    ProcessId process{ProcessId::Boring};
    std::uint32_t made{0};
    std::uint32_t good{0};
    std::uint32_t rework{0};
    std::uint32_t scrap{0};
    std::uint32_t notJudged{0};
    std::uint32_t aborted{0};
    double cutting_s{0.0};  ///< machine time
};

/// Nothing was cut between two parts for longer than ShiftService::kShortestStop_ms.
struct ShiftStop {
    std::int64_t fromUtc_ms{0};
    std::int64_t toUtc_ms{0};
    bool goesOn{false};
    std::string reason{};  ///< a key (stopReasons()); empty: nobody has said why
    std::string author{};
};

struct ShiftChange {
    std::int64_t utc_ms{0};
    std::string author{};
    std::string action{};
    std::string object{};
    std::string oldValue{};
    std::string newValue{};
    std::string reason{};
};

struct ShiftAlarm {
    AlarmCode code{0};
    std::uint8_t priority{3};
    std::uint32_t times{0};
    std::int64_t lastUtc_ms{0};
    bool stands{false};
};

struct ShiftNote {
    std::int64_t utc_ms{0};
    std::string author{};
    std::string text{};
    bool handover{false};  ///< with this one the shift ended
};

/// What the loops have brought against a machine that does nothing.
struct ShiftSaving {
    double saved_s{0.0};         ///< cutting time, of milled parts: from the planned feed run beside every cut
    std::uint32_t cuts{0};       ///< that this is known of
    std::uint32_t partsKept{0};  ///< bores inside the tolerance that the feed of the recipe would have put outside
    std::uint32_t bores{0};      ///< that this is known of
};

struct ShiftView {
    std::int64_t fromUtc_ms{0};
    std::int64_t toUtc_ms{0};
    bool current{true};       ///< it goes on
    std::string takenFrom{};  ///< who handed over; empty: nobody did, the last twelve hours are shown
    std::vector<ShiftParts> parts{};
    std::vector<ShiftStop> stops{};      ///< oldest first
    std::vector<ShiftChange> changes{};  ///< newest first
    std::vector<ShiftAlarm> alarms{};    ///< newest first
    std::vector<ShiftNote> notes{};      ///< oldest first
    ShiftSaving saving{};
};

/// Parts made with the tool that is in.
struct ToolLife {
    ProcessId process{ProcessId::Boring};
    std::uint32_t parts{0};
    std::uint32_t life{0};        ///< parts a tool is used for; 0: none is set
    std::int64_t sinceUtc_ms{0};  ///< 0: since the data file began
    std::string changedBy{};
};

/// GUI thread; files are read on a worker.
class ShiftService {
 public:
    static constexpr std::int64_t kShortestStop_ms = 180'000;
    static constexpr std::int64_t kLongest_ms = 43'200'000;  ///< looked at when nobody has handed over: 12 h
    /// From this share of its life on a tool is announced.
    static constexpr double kToolWarning = 0.9;

    ShiftService() = default;
    ShiftService(const ShiftService&) = delete;
    ShiftService& operator=(const ShiftService&) = delete;
    virtual ~ShiftService() = default;

    using Done = std::function<void(const Result<void>&)>;
    using Read = std::function<void(const Result<ShiftView>&)>;
    /// The shift that goes on (0), or the one that ended so many handovers ago.
    virtual void read(int back, Read done) = 0;
    /// `reason`: a key, translated by the page.
    virtual void nameStop(std::int64_t fromUtc_ms, const std::string& reason, const std::string& author, Done done) = 0;
    virtual void note(const std::string& text, const std::string& author, Done done) = 0;
    /// Signs the shift; the next one begins.
    virtual void handOver(const std::string& text, const std::string& author, Done done) = 0;
    /// One page.
    virtual void writePdf(const ShiftView& shift, const std::string& file, Done done) = 0;

    [[nodiscard]] virtual const std::vector<ToolLife>& tools() const = 0;
    virtual void newTool(ProcessId process, const std::string& author, Done done) = 0;
    /// 0: none.
    virtual void setToolLife(ProcessId process, std::uint32_t parts, const std::string& author, Done done) = 0;
};

}  // namespace kerf
