// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/api/status.h"
#include "ui/services/thermal_service.h"

namespace kerf::test {

/// A service for GUI tests: a warm machine's course, a live model and one before it, training that ends when told.
class FakeThermalService : public ThermalService {
 public:
    static constexpr std::size_t kSensors = 64;

    FakeThermalService() {
        for (std::size_t k = 0; k < kSensors; ++k) {
            const double column = static_cast<double>(k % 8);
            const double row = static_cast<double>(k / 8);
            ThermalSensorView sensor;
            sensor.name = "T00";
            sensor.name[1] = static_cast<char>('0' + k / 10);
            sensor.name[2] = static_cast<char>('0' + k % 10);
            sensor.place = KERF_TEXT("front bearing");
            sensor.x = 0.1 + 0.1 * column;
            sensor.y = 0.1 + 0.1 * row;
            m_view.sensors.push_back(sensor);
        }
        for (int minute = 0; minute < 120; ++minute) {
            ThermalCoursePoint point;
            point.minutes = minute;
            point.predicted = true;
            point.measured = minute % 40 == 39;
            const auto grown = static_cast<float>(1.0 - std::exp(-minute / 45.0));
            point.drift_um = {3.0F * grown, -18.0F * grown, -9.0F * grown};
            point.half_um = {0.5F, 1.1F, 1.9F};
            point.shift_um = {-3.0F * grown, 18.0F * grown, 9.0F * grown};
            point.measured_um = {point.drift_um[0] + 0.3F, point.drift_um[1] - 0.6F, point.drift_um[2] + 0.8F};
            m_view.course.push_back(point);
            if (minute % 10 == 0) {
                m_view.shifts.push_back(
                    {1'700'000'000'000 + minute * 60'000LL, point.minutes, {-1, 5, 3}, {1.2, -5.2, -2.9}});
            }
        }
        std::ranges::reverse(m_view.shifts);
        m_view.live = card(2, "regression");
        m_view.canRollBack = true;
        m_view.gaps.push_back({1'700'000'000'000, {2.9, -16.8, -8.1}, {2.7, -16.2, -8.9}, {0.5, 1.1, 1.9}, true});
        m_view.days = {{"file:H0.csv", "H0.csv", 0},
                       {"session:1", "session 1, 240 rows", 240},
                       {"built-in:0", "random speeds", 360}};
        m_view.dayFolder = "/home/kerf/thermal";
        m_view.revision = 1;
    }
    static ThermalModelCard card(std::uint32_t revision, const std::string& kind) {
        ThermalModelCard card;
        card.revision = revision;
        card.judgement = {kind, 10, true, {0.15, 0.48, 0.66}, {0.6, 1.5, 2.1}, true};
        card.sensors = {"T00", "T04", "T05", "T08", "T11", "T13", "T15", "T29", "T44", "T56"};
        card.formula = {"x_um = + 0.033·T00 + 0.0338·T00~4", "y_um = - 0.173·T00", "z_um = - 0.68·T00"};
        card.trainedOn = {"H0.csv", "H1.csv", "H2.csv"};
        card.rows = 1080;
        card.createdUtc_ms = 1'700'000'000'000;
        card.author = "Kim";
        return card;
    }
    [[nodiscard]] ThermalServiceView& edit() { return m_view; }
    void announce() { ++m_view.revision; }
    /// What the worker would come to.
    void finishTraining() {
        m_view.training.state = TrainingState::Ready;
        m_view.training.progress = 1.0;
        m_view.training.compared = {card(0, "gmdh-paper").judgement, card(0, "gmdh").judgement,
                                    card(0, "regression").judgement};
        m_view.training.compared[0].chosen = false;
        m_view.training.compared[1].chosen = false;
        announce();
    }
    /// The status that goes with the course.
    static void fill(Status& status) {
        ThermalStatus& s = status.thermal;
        s.stage = ThermalStage::Following;
        s.model = 2;
        s.drift_um = {2.8, -16.7, -8.4};
        s.half_um = {0.5, 1.1, 1.9};
        s.target_um = {-3.0, 17.0, 8.0};
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            s.shifted_um[axis] = {s.target_um[axis], 1, Quality::Good};
        s.allowed_um = 4.0;
        s.warmUp = WarmUpState::Waiting;
        s.ready_min = 11.4;
        s.gapsReadable = true;
        s.gapZeroKnown = true;
        s.count = kSensors;
        s.inModel = 0x0011'2233;
        for (std::size_t k = 0; k < kSensors; ++k)
            s.temp_degC[k] = 23.0F + 0.1F * static_cast<float>(k);
        LoopStatus& loop = status.loops[static_cast<std::size_t>(ProcessId::Thermal)];
        loop.fitted = true;
        loop.mode = LoopMode::Control;
        loop.state = LoopState::Controlling;
        loop.reason = Sentence(KERF_TEXT("The work origin follows the predicted drift."));
    }

    std::vector<std::string> calls{};
    std::vector<std::string> trainedDays{};
    ThermalSetup setup{};
    std::array<std::optional<double>, kAxisCount> part{};
    Sentence failWith{};

    const ThermalServiceView& view() const override { return m_view; }
    std::vector<std::pair<double, double>> temperatures(std::size_t) const override {
        std::vector<std::pair<double, double>> out;
        for (int minute = 0; minute < 60; ++minute)
            out.emplace_back(minute, 23.0 + 0.05 * minute);
        return out;
    }
    ThermalErrorMap errorMap(double z_mm, bool) const override {
        ThermalErrorMap map;
        map.known = true;
        map.range_mm = {{{0.0, 760.0}, {0.0, 430.0}, {0.0, 500.0}}};
        map.columns = 8;
        map.rows = 6;
        for (int i = 0; i < 48; ++i)
            map.error_um.push_back({0.3 * (i % 8), -0.4 * (i / 8), 0.01 * z_mm});
        return map;
    }
    void findDays() override { calls.emplace_back("findDays"); }
    Result<void> train(const std::string& kind, const std::vector<std::string>& days) override {
        trainedDays = days;
        m_view.training = {};
        m_view.training.state = TrainingState::Running;
        m_view.training.progress = 0.4;
        announce();
        return called("train " + kind);
    }
    void cancelTraining() override {
        calls.emplace_back("cancel");
        m_view.training.state = TrainingState::Cancelled;
        announce();
    }
    void leaveOut(const std::string& dayId, bool out, const std::string& author, const std::string& reason,
                  RecipeHistory::Done done) override {
        const auto result = called((out ? "out " : "in ") + dayId + ' ' + author + ' ' + reason);
        const auto day = std::ranges::find(m_view.days, dayId, &ThermalDayView::id);
        if (result && day != m_view.days.end()) {
            day->leftOut = out;
            day->leftOutReason = reason;
            day->leftOutAuthor = author;
            announce();
        }
        done(result);
    }
    Result<void> goLive(const std::string& author) override { return called("goLive " + author); }
    Result<void> rollBack(const std::string& author) override { return called("rollBack " + author); }
    void changeSetup(const ThermalSetup& next, const std::string& author, const std::string&,
                     RecipeHistory::Done done) override {
        setup = next;
        keepSetup = [done = std::move(done), result = called("setup " + author)] { done(result); };
        if (!storeIsSlow) keepSetup();
    }
    bool storeIsSlow{false};  ///< the answer of the disk waits until keepSetup() is called
    std::function<void()> keepSetup{};
    Result<void> measureByPart(const std::array<std::optional<double>, kAxisCount>& deviation_um,
                               const std::string& author) override {
        part = deviation_um;
        return called("part " + author);
    }
    Result<void> beginSession(const std::string& author) override {
        m_view.session.recording = true;
        announce();
        return called("begin " + author);
    }
    Result<void> endSession(const std::string& author) override {
        m_view.session.recording = false;
        announce();
        return called("end " + author);
    }
    void poll() override {}

 private:
    Result<void> called(std::string what) {
        calls.push_back(std::move(what));
        if (!failWith.empty()) return tl::unexpected(failWith);
        return {};
    }
    ThermalServiceView m_view{};
};

}  // namespace kerf::test
