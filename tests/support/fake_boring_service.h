// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "ui/services/boring_service.h"

namespace kerf::test {

/// A service for GUI tests: one small lot on a process that behaves like the built-in machine, a store that fails on
/// demand, and answers that can be kept back. Its estimator is a stand-in: it closes in on the truth part by part.
class FakeBoringService : public BoringService {
 public:
    static constexpr double kTarget_mm = 50.010;
    static constexpr double kTolerance_mm = 0.030;
    static constexpr double kDeflection_mm = 0.1165;
    static constexpr double kGate = 1.2;  ///< |ln(d/d_predicted)| above it asks
    static constexpr std::size_t kShownParts = 25;
    static constexpr PartId kFirstId = 101;

    explicit FakeBoringService(std::uint32_t lotSize = 30,
                               std::vector<DepthView> depths = {{"top", 40.0}, {"bottom", 310.0}})
        : m_random(12) {
        m_view.partType = "Bearing bracket 50 H7";
        m_view.lot = "12";
        m_view.lotSize = lotSize;
        m_view.targetDiameter_mm = kTarget_mm;
        m_view.lowerTolerance_mm = kTarget_mm - kTolerance_mm;
        m_view.upperTolerance_mm = kTarget_mm + kTolerance_mm;
        m_view.depths = std::move(depths);
        m_view.estimator = "kalman";
        rebuild();
    }

    // What a test does to the lot.
    void cutPart() {
        BorePartView part;
        part.number = static_cast<std::uint32_t>(m_parts.size() + 1);
        part.id = kFirstId + part.number - 1;
        part.cut = true;
        part.schedule = m_view.nextSchedule;
        part.predicted = m_view.nextPrediction;
        const double from_mm = part.schedule.overhangFrom_mm;
        const double length_mm = part.schedule.overhangTo_mm - from_mm;
        part.feed.count = kFeedTracePoints;
        for (std::size_t i = 0; i < kFeedTracePoints; ++i) {
            const double overhang_mm = from_mm + length_mm * static_cast<double>(i) / (kFeedTracePoints - 1);
            part.feed.overhang_mm[i] = static_cast<float>(overhang_mm);
            part.feed.feed_mmPerRev[i] =
                static_cast<float>(part.schedule.feed_mmPerRev(overhang_mm) * (1.0 + 0.004 * m_random.gauss()));
        }
        m_parts.push_back(part);
        rebuild();
    }
    /// What a good gauge shows at that depth of that part.
    [[nodiscard]] double trueDiameter_mm(PartId part, std::uint8_t depth) const {
        const BorePartView& cut = m_parts.at(static_cast<std::size_t>(part - kFirstId));
        const auto& [alpha, beta, c] = truth(cut.number);
        const double overhang_mm = m_view.depths[depth].overhang_mm;
        const double deflection_mm =
            c * std::pow(cut.schedule.feed_mmPerRev(overhang_mm), alpha) * std::pow(overhang_mm, beta);
        Random noise(static_cast<std::uint64_t>(part) * 31U + depth);
        return std::round((kTarget_mm + kDeflection_mm - deflection_mm + 0.003 * noise.gauss()) * 1000.0) / 1000.0;
    }
    void measure(PartId part) {
        for (std::uint8_t depth = 0; depth < m_view.depths.size(); ++depth) {
            accept({part, depth, trueDiameter_mm(part, depth), "Kim", false, false});
        }
    }
    /// Cut and measure that many parts.
    void runParts(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            cutPart();
            measure(m_parts.back().id);
        }
    }
    void answerAll() {
        std::vector<std::function<void()>> answers;
        answers.swap(m_kept);
        for (const auto& answer : answers) {
            answer();
        }
    }
    void setStoreProblem(const Sentence& problem) {
        failWith = problem;
        m_view.storeProblem = problem;
        announce();
    }
    [[nodiscard]] BoringServiceView& edit() { return m_view; }
    void announce() {
        ++m_view.revision;
        for (const auto& [key, changed] : m_changed) {
            changed();
        }
    }

    Sentence failWith{};      ///< not empty: nothing can be stored, for this reason
    bool keepAnswers{false};  ///< answers wait for answerAll()
    bool adviseMode{false};   ///< a new schedule waits to be accepted
    bool gaugeFitted{false};
    std::uint32_t changeAt{11};  ///< first part of the changed process
    struct Call {
        std::string what;
        std::int64_t id{0};
        double value_mm{0.0};
        std::string author;
        std::string reason;
    };
    std::vector<Call> calls{};         ///< corrections, voids, undos, accepts
    std::vector<BoreEntry> entries{};  ///< accepted
    std::vector<BoreCorrection> corrections{};
    mutable std::vector<BoreEntry> checked{};

    // BoringService
    const BoringServiceView& view() const override { return m_view; }
    EntryCheck check(const BoreEntry& entry) const override {
        checked.push_back(entry);
        const BorePartView* part = find(entry.part);
        if (part == nullptr || entry.depth >= m_view.depths.size()) {
            return {EntryVerdict::Refuse, Sentence(KERF_TEXT("This part is not in the lot."))};
        }
        const double deflection_mm = kDeflection_mm + kTarget_mm - entry.diameter_mm;
        if (!std::isfinite(entry.diameter_mm) || entry.diameter_mm <= 0.0 || deflection_mm <= 0.0) {
            return {
                EntryVerdict::Refuse,
                Sentence(KERF_TEXT("A bore of %1 mm cannot come from this cut. Possible is more than %2 mm and less "
                                   "than %3 mm."),
                         {entry.diameter_mm, 3}, {0.0, 3}, {kTarget_mm + kDeflection_mm, 3})};
        }
        const auto& predicted = part->predicted[entry.depth];
        const double expected_mm = predicted ? predicted->diameter_mm : kTarget_mm;
        const double expectedDeflection_mm = kDeflection_mm + kTarget_mm - expected_mm;
        if (!entry.confirmed && std::abs(std::log(deflection_mm / expectedDeflection_mm)) > kGate) {
            return {EntryVerdict::Ask, Sentence(KERF_TEXT("%1 mm is far from the %2 mm expected here."),
                                                {entry.diameter_mm, 3}, {expected_mm, 3})};
        }
        return {EntryVerdict::Accept, {}};
    }
    void enter(const BoreEntry& entry, Done done) override {
        reply(std::move(done), [this, entry]() -> Result<void> {
            if (const EntryCheck verdict = check(entry); verdict.verdict != EntryVerdict::Accept) {
                return tl::unexpected<Sentence>(verdict.reason);
            }
            accept(entry);
            return {};
        });
    }
    void correct(MeasurementId id, double diameter_mm, const std::string& author, const std::string& reason,
                 Done done) override {
        calls.push_back({"correct", id, diameter_mm, author, reason});
        reply(std::move(done), [this, id, diameter_mm]() -> Result<void> {
            BoreMeasurementView* measurement = findMeasurement(id);
            if (measurement == nullptr) {
                return fail(KERF_TEXT("This measurement is not in the lot."));
            }
            measurement->diameter_mm = diameter_mm;
            measurement->corrected = true;
            measurement->voided = false;
            rebuild();
            return {};
        });
    }
    EntryCheck checkCorrection(MeasurementId id, double diameter_mm) const override {
        for (const BorePartView& part : m_parts) {
            for (const BoreMeasurementView& m : part.measurements) {
                const double deflection_mm = kDeflection_mm + kTarget_mm - diameter_mm;
                const double expected_mm = kDeflection_mm + kTarget_mm - m.diameter_mm;
                if (m.id == id && (deflection_mm <= 0.0 || std::abs(std::log(deflection_mm / expected_mm)) > kGate)) {
                    return {EntryVerdict::Ask, Sentence(KERF_TEXT("%1 mm is far from the %2 mm expected here."),
                                                        {diameter_mm, 3}, {m.diameter_mm, 3})};
                }
            }
        }
        return {EntryVerdict::Accept, {}};
    }
    void correctValue(const BoreCorrection& correction, Done done) override {
        corrections.push_back(correction);
        correct(correction.id, correction.diameter_mm, correction.author, correction.reason, std::move(done));
    }
    void voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason, Done done) override {
        calls.push_back({"void", id, 0.0, author, reason});
        reply(std::move(done), [this, id]() -> Result<void> { return takeOut(id); });
    }
    void undoLast(const std::string& author, Done done) override {
        calls.push_back({"undo", m_nextMeasurement - 1, 0.0, author, {}});
        reply(std::move(done), [this]() -> Result<void> {
            for (MeasurementId id = m_nextMeasurement - 1; id > 0; --id) {
                const BoreMeasurementView* measurement = findMeasurement(id);
                if (measurement != nullptr && !measurement->voided) {
                    return takeOut(id);
                }
            }
            return fail(KERF_TEXT("There is no measurement to take back."));
        });
    }
    void acceptSchedule(const std::string& author, Done done) override {
        calls.push_back({"accept", 0, 0.0, author, {}});
        reply(std::move(done), [this]() -> Result<void> {
            m_view.scheduleAccepted = true;
            announce();
            return {};
        });
    }
    void announceChange(BoringChange change, const std::string& author, Done done) override {
        calls.push_back({"announce", static_cast<MeasurementId>(change), 0.0, author, {}});
        reply(std::move(done), [this, change]() -> Result<void> {
            m_view.announced = change;
            announce();
            return {};
        });
    }
    /// What the page says the expected diameters rest on.
    void restOn(const Sentence& sentence) {
        m_view.nextRestsOn = sentence;
        announce();
    }
    void withdrawChange(const std::string& author, Done done) override {
        calls.push_back({"withdraw", 0, 0.0, author, {}});
        reply(std::move(done), [this]() -> Result<void> {
            m_view.announced.reset();
            announce();
            return {};
        });
    }
    std::optional<double> gaugeReading_mm(PartId part, std::uint8_t depth) override {
        return gaugeFitted ? std::optional(trueDiameter_mm(part, depth) + 0.00037) : std::nullopt;
    }
    std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        const int key = ++m_lastKey;
        m_changed[key] = std::move(changed);
        return std::make_unique<Handle>(*this, key);
    }

 private:
    class Handle : public Subscription {
     public:
        Handle(FakeBoringService& service, int key) : m_service(service), m_key(key) {}
        ~Handle() override { m_service.m_changed.erase(m_key); }

     private:
        FakeBoringService& m_service;
        int m_key;
    };

    [[nodiscard]] std::array<double, 3> truth(std::uint32_t number) const {
        return number < changeAt ? std::array{0.5025, 0.2676, 0.0871} : std::array{0.7, 0.4, 0.15};
    }
    const BorePartView* find(PartId id) const {
        const auto found = std::find_if(m_parts.begin(), m_parts.end(), [id](const auto& p) { return p.id == id; });
        return found == m_parts.end() ? nullptr : &*found;
    }
    BoreMeasurementView* findMeasurement(MeasurementId id) {
        for (BorePartView& part : m_parts) {
            for (BoreMeasurementView& measurement : part.measurements) {
                if (measurement.id == id) {
                    return &measurement;
                }
            }
        }
        return nullptr;
    }
    void reply(Done done, std::function<Result<void>()> act) {
        auto answer = [this, done = std::move(done), act = std::move(act)] {
            const Result<void> result = failWith.empty() ? act() : tl::unexpected<Sentence>(failWith);
            if (done) {
                done(result);
            }
        };
        if (keepAnswers) {
            m_kept.push_back(std::move(answer));
        } else {
            answer();
        }
    }
    void accept(const BoreEntry& entry) {
        entries.push_back(entry);
        m_parts.at(static_cast<std::size_t>(entry.part - kFirstId))
            .measurements.push_back({m_nextMeasurement++, entry.depth, entry.diameter_mm, false, false});
        rebuild();
    }
    Result<void> takeOut(MeasurementId id) {
        BoreMeasurementView* measurement = findMeasurement(id);
        if (measurement == nullptr) {
            return fail(KERF_TEXT("This measurement is not in the lot."));
        }
        measurement->voided = true;
        rebuild();
        return {};
    }
    [[nodiscard]] bool measured(const BorePartView& part, std::size_t depth) const {
        return std::any_of(part.measurements.begin(), part.measurements.end(),
                           [depth](const auto& m) { return m.depth == depth && !m.voided; });
    }

    /// The lot once more from its first part: what the real service does after a correction.
    void rebuild() {
        m_view.awaiting.reset();
        m_view.estimates.clear();
        std::array<double, 3> theta{std::log(0.05), 0.55, 0.15};
        std::array<double, 3> half95{0.9, 0.3, 0.3};
        std::uint32_t complete = 0;
        Sentence why(KERF_TEXT("First part: constant feed."));
        for (BorePartView& part : m_parts) {
            part.complete = true;
            for (std::uint8_t depth = 0; depth < m_view.depths.size(); ++depth) {
                if (!measured(part, depth)) {
                    part.complete = false;
                    if (!m_view.awaiting) {
                        m_view.awaiting = part.id;
                        m_view.awaitingDepth = depth;
                    }
                }
            }
            if (!part.complete) {
                continue;
            }
            ++complete;
            part.perturbed = part.number == changeAt;
            const auto [alpha, beta, c] = truth(part.number);
            const std::array<double, 3> goal{std::log(c), alpha, beta};
            for (std::size_t i = 0; i < 3; ++i) {
                half95[i] = part.perturbed ? std::max(half95[i], 0.25) : std::max(0.04, half95[i] * 0.75);
                theta[i] += (goal[i] - theta[i]) * (part.perturbed ? 0.5 : 0.45);
            }
            why = Sentence(KERF_TEXT("The last part came out %1 mm small at the bottom."), {0.006, 3});
            if (part.perturbed) {
                part.perturbedReason =
                    Sentence(KERF_TEXT("Part %1 fits the earlier parts no longer: the process has changed."),
                             {static_cast<double>(part.number), 0});
                why = part.perturbedReason;
            }
            m_view.estimates.push_back({part.number, theta, half95});
        }
        BoringSchedule& next = m_view.nextSchedule;
        next.revision = complete + 1;
        next.lnC = theta[0];
        next.alpha = theta[1];
        next.beta = theta[2];
        next.targetDeflection_mm = kDeflection_mm;
        next.constantFeed_mmPerRev = complete == 0 ? 0.2 : 0.0;
        m_view.nextReason = why;
        m_view.nextPrediction.clear();
        for (std::size_t depth = 0; depth < m_view.depths.size(); ++depth) {
            m_view.nextPrediction.push_back(
                complete == 0 ? std::nullopt
                              : std::optional(DiameterPrediction{kTarget_mm - 0.001 * static_cast<double>(depth),
                                                                 0.004 + 0.02 * half95[1]}));
        }
        m_view.scheduleAccepted = !adviseMode || complete == 0;
        const std::size_t from = m_parts.size() > kShownParts ? m_parts.size() - kShownParts : 0;
        m_view.parts.assign(m_parts.begin() + static_cast<std::ptrdiff_t>(from), m_parts.end());
        announce();
    }

    Random m_random;
    BoringServiceView m_view{};
    std::vector<BorePartView> m_parts{};
    MeasurementId m_nextMeasurement{1};
    std::map<int, std::function<void()>> m_changed{};
    int m_lastKey{0};
    std::vector<std::function<void()>> m_kept{};
};

}  // namespace kerf::test
