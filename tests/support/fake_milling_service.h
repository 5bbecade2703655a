// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/listeners.h"
#include "engine/process/milling/milling_setup.h"
#include "ui/services/milling_service.h"

namespace kerf::test {

/// A milling service without a database: what the page asks for happens at once and is noted.
class FakeMillingService final : public MillingService {
 public:
    struct Call {
        std::string what{};
        std::string author{};
        std::string text{};
        MillingSetup setup{};
        MillingBlank blank{};
    };

    FakeMillingService() {
        m_view.partType = "Rail";
        m_view.partTypes = {"Housing", "Rail"};
        m_view.setup.revision = 1;
        m_view.revision = 1;
    }

    [[nodiscard]] const MillingServiceView& view() const override { return m_view; }
    [[nodiscard]] std::span<const MillingField> fields() const override { return milling::setupFields(); }
    [[nodiscard]] std::optional<Sentence> whyUnusable(const MillingSetup& setup) const override {
        return milling::whyUnusable(setup);
    }
    [[nodiscard]] Result<MillingBlank> blankOf(std::span<const MillingBlankStep> steps, double end_mm) const override {
        MillingBlank blank;
        blank.count = static_cast<std::uint16_t>(std::min<std::size_t>(steps.size(), MillingBlank::kMaxSteps));
        for (std::size_t i = 0; i < blank.count; ++i) {
            blank.begin_mm[i] = steps[i].begin_mm;
            blank.height_mm[i] = steps[i].height_mm;
        }
        blank.end_mm = end_mm;
        if (const auto why = milling::whyUnusable(blank)) {
            return tl::unexpected(*why);
        }
        return blank;
    }
    [[nodiscard]] Result<MillingBlank> readBlank(const std::string& file) const override {
        if (const auto found = files.find(file); found != files.end()) {
            return found->second;
        }
        return fail(KERF_TEXT("Line %1, column %2: “%3” is not a number."), SentenceArg(4, 0),
                    SentenceArg(std::string_view("height_mm")), SentenceArg(std::string_view("two")));
    }
    void saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason,
                   Done done) override {
        note({"setup", author, reason, setup, {}}, done, [this, setup] { m_view.setup = setup; });
    }
    void saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author,
                   Done done) override {
        note({"blank", author, source, {}, blank}, done, [this, blank, source] {
            m_view.blank = blank;
            m_view.blankSource = source;
        });
    }
    void choosePartType(const std::string& name, const std::string& author, Done done) override {
        note({"part type", author, name, {}, {}}, done, [this, name] { m_view.partType = name; });
    }
    void newTool(const std::string& author, Done done) override {
        note({"new tool", author, {}, {}, {}}, done, [] {});
    }
    void leaveOut(std::int64_t since, bool out, const std::string& author, const std::string& reason,
                  Done done) override {
        note({out ? "leave out" : "take in", author, reason, {}, {}}, done, [this, since, out] {
            for (MillingToolView& tool : m_view.memory.tools) {
                tool.leftOut = tool.since == since ? out : tool.leftOut;
            }
        });
    }
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        return m_listeners.add(std::move(changed));
    }

    /// `count` cuts with a slowly wearing tool, every third one advised.
    void cutParts(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            MillingCutView cut;
            cut.number = static_cast<std::uint32_t>(m_view.cuts.size()) + 1;
            cut.complete = true;
            cut.withThisTool = true;
            cut.cut.advised = i % 3 == 2;
            cut.cut.law = cut.cut.advised ? MillingLaw::Constant : MillingLaw::Model;
            cut.cut.reference_N = 392.0;
            cut.cut.plannedTime_s = 76.7;
            cut.cut.cutTime_s = cut.cut.advised ? 76.7 : 73.2;
            cut.cut.controlledTime_s = 73.2;
            cut.cut.peakForce_N = cut.cut.advised ? 634.0 : 425.0;
            cut.cut.peakAt_mm = 44.3;
            cut.cut.meanForce_N = 388.0;
            cut.cut.waviness_um = cut.cut.advised ? 287.0 : 9.4;
            cut.cut.stiffnessMean = 7.9 + 0.015 * i + 0.004 * std::sin(3.0 * i);
            cut.cut.stiffnessHalf95 = 0.06;
            m_view.cuts.push_back(cut);
        }
        announce();
    }
    [[nodiscard]] MillingServiceView& edit() { return m_view; }
    void announce() {
        ++m_view.revision;
        m_listeners.tell();
    }

    std::map<std::string, MillingBlank> files{};
    std::vector<Call> calls{};
    Sentence storeFails{};    ///< not empty: nothing can be stored, and why
    bool keepAnswers{false};  ///< answers wait for answerAll()
    void answerAll() {
        for (const auto& answer : std::exchange(m_kept, {})) {
            answer();
        }
    }

 private:
    template <class Change>
    void note(Call call, const Done& done, Change change) {
        calls.push_back(std::move(call));
        if (keepAnswers) {
            m_kept.push_back([this, done, change] { answer(done, change); });
            return;
        }
        answer(done, change);
    }
    template <class Change>
    void answer(const Done& done, Change change) {
        if (!storeFails.empty()) {
            done(tl::unexpected(storeFails));
            return;
        }
        change();
        announce();
        done({});
    }

    MillingServiceView m_view{};
    Listeners<> m_listeners;
    std::vector<std::function<void()>> m_kept{};
};

}  // namespace kerf::test
