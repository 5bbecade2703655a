// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "engine/process/turning/overlap.h"
#include "engine/process/turning/turning_setup.h"
#include "ui/services/turning_service.h"

namespace kerf::test {

/// A service for GUI tests: a test writes its view and reads what it was asked.
class FakeTurningService : public TurningService {
 public:
    FakeTurningService() {
        fake.revision = 1;
        fake.setup.revision = 1;
        fake.overlap = 0.9556;
        fake.blind.spindleSpeed_rpm = fake.setup.spindleSpeed_rpm;
        fake.blind.tones = {{17.0, 0.070, false, false},
                            {52.0, 0.140, false, false},
                            {86.0, 0.032, true, false},
                            {113.0, 1.96, false, false},
                            {120.0, 0.148, false, false}};
        fake.blind.anyBlind = true;
        fake.blind.suggestedSpeed_rpm = 1119.4;
        fake.blind.suggestedVisibility = 0.4;
    }
    [[nodiscard]] const TurningServiceView& view() const override { return fake; }
    [[nodiscard]] std::span<const ParamSpec> setupSpecs() const override { return turning::setupSpecs(); }
    [[nodiscard]] const ParamSpec& toneSpec() const override { return turning::toneSpec(); }
    [[nodiscard]] double setupValue(const TurningSetup& setup, std::size_t field) const override {
        return turning::valueOf(setup, static_cast<turning::SetupField>(field));
    }
    void changeSetup(TurningSetup& setup, std::size_t field, double value) const override {
        turning::setValue(setup, static_cast<turning::SetupField>(field), value);
    }
    [[nodiscard]] std::optional<Sentence> whyUnusable(const TurningSetup& setup) const override {
        return turning::whyUnusable(setup);
    }
    [[nodiscard]] Result<double> overlap(double radius_um, double depth_um, double feed_umPerRev) const override {
        return turning::overlapFactor(radius_um, depth_um, feed_umPerRev);
    }
    void loadSetup(const TurningSetup& setup, const std::string& author, const std::string&, Done done) override {
        authors.push_back(author);
        if (failWith.empty()) {
            fake.setup = setup;
            fake.setup.revision = ++m_revision;
            change();
        }
        answer(done);
    }
    void setController(TurningController controller, const std::string& author, Done done) override {
        authors.push_back(author);
        if (failWith.empty()) {
            fake.controller = controller;
            change();
        }
        answer(done);
    }
    void leaveOut(std::int64_t part, bool out, const std::string& author, const std::string& reason,
                  Done done) override {
        authors.push_back(author);
        if (failWith.empty()) {
            for (TurningPartView& one : fake.parts) {
                if (one.id == part) {
                    one.leftOut = out;
                    one.leftOutReason = reason;
                    one.leftOutAuthor = author;
                }
            }
            change();
        }
        answer(done);
    }
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        m_changed = std::move(changed);
        return std::make_unique<Subscription>();
    }
    void change() {
        ++fake.revision;
        if (m_changed) {
            m_changed();
        }
    }

    /// A spectrum with peaks at the known tones.
    [[nodiscard]] static TurningSpectrum spectrum(double treatedShare = 0.05) {
        TurningSpectrum out;
        out.step_Hz = 0.6104;
        const std::array<std::pair<double, double>, 5> tones{
            {{17.0, 0.5}, {52.0, 0.4}, {86.0, 0.25}, {113.0, 0.25}, {120.0, 0.6}}};
        for (int i = 0; i < 680; ++i) {
            const double f_Hz = i * out.step_Hz;
            double sum = 0.004 + 0.002 * std::sin(f_Hz * 3.1);
            for (const auto& [tone_Hz, amplitude] : tones) {
                sum += amplitude * std::exp(-std::pow((f_Hz - tone_Hz) / 0.8, 2));
            }
            out.untreated_um.push_back(static_cast<float>(sum));
            out.treated_um.push_back(static_cast<float>(0.005 + treatedShare * (sum - 0.004)));
        }
        return out;
    }
    [[nodiscard]] static TurningTone tone(double frequency_Hz, double amplitude_um, bool blind = false) {
        return {frequency_Hz, amplitude_um, blind ? 0.03 : 0.15, blind, 0.005};
    }
    /// A finished part; not controlled: one without the loop.
    [[nodiscard]] TurningPartView part(std::uint32_t number, bool controlled) const {
        TurningPartView p;
        p.id = number;
        p.number = number;
        p.endedUtc_ms = 1'790'000'000'000 + 60'000LL * number;
        p.complete = true;
        p.forceMean_N = 1.441;
        p.forcePeak_N = 2.2;
        TurningRecord& r = p.record;
        r.valid = true;
        r.setup = fake.setup;
        r.controlled = controlled;
        r.steadyRms_um = controlled ? 0.053 : 0.668;
        r.steadyPv_um = controlled ? 0.42 : 3.71;
        r.steadyForce_N = controlled ? 1.4412 : 1.4405;
        r.openSteadyRms_um = 0.668;
        r.openSteadyPv_um = 3.71;
        r.surfaceRms_um = controlled ? 0.12 : 0.668;
        r.untreatedRms_um = 0.668;
        r.forceTarget_N = 1.44;
        r.forceZero_N = 0.0805;
        r.trimPeak_um = controlled ? 1.61 : 0.0;
        r.identification.available = true;
        r.identification.value = {0.8725, 0.747, -0.7164};
        r.identification.half95 = {0.005, 0.003, 0.003};
        r.tones = {tone(17.0, 0.5), tone(52.0, 0.4), tone(86.0, 0.25, true), tone(113.0, 0.25), tone(120.0, 0.6)};
        r.toneCount = 5;
        p.spectrum = spectrum(controlled ? 0.05 : 1.0);
        for (int i = 0; i < 200; ++i) {
            const double middle_N = 1.44 + 0.01 * std::sin(i * 0.2);
            p.force.push_back({(i + 0.5) / 200.0, middle_N - 0.3, middle_N, middle_N + 0.3});
        }
        return p;
    }
    void archiveTwo() {
        fake.parts = {part(1, false), part(2, true)};
        fake.comparison = TurningComparison{1, 2, TurningController::Tones, 0.668, 0.053, 3.71, 0.42, 1.4405, 1.4412};
        fake.live = fake.parts.back().spectrum;
        fake.margins = {true, true, 74.5, 83.0, 9.64, 0.98};
        change();
    }

    TurningServiceView fake{};
    Sentence failWith{};
    std::vector<std::string> authors{};

 private:
    void answer(const Done& done) const {
        if (done) {
            done(failWith.empty() ? Result<void>{} : Result<void>(tl::unexpected(failWith)));
        }
    }
    std::function<void()> m_changed{};
    std::uint32_t m_revision{1};
};

}  // namespace kerf::test
