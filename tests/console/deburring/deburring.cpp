// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/console/deburring/deburring.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "engine/cycle/event_sink.h"
#include "ui/link/texts.h"
#include "ui/shell/page.h"

namespace kerf::test {
namespace {

constexpr double kForcePerFeed = 1.5;
constexpr double kBurrFrom_mm = 30.0;
constexpr double kBurrTo_mm = 60.0;

constexpr std::array kPartResults{
    PartResultRow{{"force_mean_N", "Mean force", "N", 1},
                  [](const PartRecord& part) { return std::optional(part.forceMean_N); }},
    PartResultRow{{"force_peak_N", "Peak force", "N", 1},
                  [](const PartRecord& part) { return std::optional(part.forcePeak_N); }},
};

/// State of the loop in words, and a button.
class DeburringPage final : public ui::Page {
 public:
    explicit DeburringPage(const ui::PageContext& context)
        : Page(context), m_state(new QLabel(this)), m_start(new ui::ActionButton(context.look, this)) {
        setObjectName(QStringLiteral("deburringPage"));
        m_state->setObjectName(QStringLiteral("deburringState"));
        m_start->setObjectName(QStringLiteral("deburringStart"));
        m_start->setText(QStringLiteral("Start part"));
        auto* rows = new QVBoxLayout(this);
        rows->addWidget(m_state);
        rows->addWidget(m_start);
        connect(m_start, &QPushButton::clicked, this, [this] { this->context().client.startPart(kDeburring); });
        connect(&context.client, &ui::EngineClient::statusChanged, this, [this](const Status& status) {
            const LoopStatus& loop = status.loops[static_cast<std::size_t>(kDeburring)];
            m_state->setText(ui::stateName(loop.state) + QStringLiteral(": ") +
                             ui::sentenceText(loop.reason, look().units()));
        });
    }

 private:
    QLabel* m_state;
    ui::ActionButton* m_start;
};

}  // namespace

constinit const ProcessDescriptor kDeburringProcess{
    .id = kDeburring,
    .key = "deburring",
    .name = "Deburring",
    .may = {.feedScale = true},
    .partResults = kPartResults,
};

Result<void> SimulatedDeburring::begin(const StartProgram& program, std::uint32_t) noexcept {
    m_at_mm = 0.0;
    m_programmed_mmPerS = program.programmedFeed_mmPerRev * program.spindleSpeed_rpm / 60.0;
    m_running = m_programmed_mmPerS > 0.0;
    return m_running ? Result<void>() : fail("Deburring needs a feed above zero.");
}

bool SimulatedDeburring::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    if (!m_running) {
        return false;
    }
    const double feed_mmPerS = m_programmed_mmPerS * step.feedFactor;
    m_at_mm += feed_mmPerS * step.dt_s;
    m_running = m_at_mm < kEdge_mm;
    const double burr = m_at_mm > kBurrFrom_mm && m_at_mm < kBurrTo_mm ? 3.0 : 1.0;
    inputs.programmedFeed_mmPerS = {m_programmed_mmPerS, step.now_ns, Quality::Good};
    inputs.actualFeed_mmPerS = {feed_mmPerS, step.now_ns, Quality::Good};
    inputs.fast[0] = {step.now_ns, inputs.spindleAngle_rev.value, kForcePerFeed * burr * feed_mmPerS, Quality::Good};
    inputs.fastCount = 1;
    return m_running;
}

CommandResult DeburringLoop::handle(const Command& command) noexcept {
    m_startWanted = std::holds_alternative<StartPart>(command.action);
    return m_startWanted ? CommandResult::ok() : CommandResult::refused(Sentence("Deburring does not know this."));
}

LoopVerdict DeburringLoop::step(const MachineInputs& inputs, const Capabilities&, LoopOutputs& outputs,
                                EventSink& events) noexcept {
    if (std::exchange(m_startWanted, false)) {
        StartProgram program;
        program.process = kDeburring;
        program.programmedFeed_mmPerRev = kFeed_mmPerRev;
        program.spindleSpeed_rpm = kFeed_mmPerS / kFeed_mmPerRev * 60.0;
        outputs.request = {m_program.nextRequest(), program};
    }
    const ProgramTurn turn = m_program.follow(inputs);
    if (turn.begins) {
        m_part = beginRecord(inputs);
        m_sum_N = 0.0;
        m_samples = 0;
        m_scale = 1.0;
    }
    if (turn.ends) {
        m_part.forceMean_N = m_samples > 0 ? m_sum_N / m_samples : 0.0;
        finishRecord(m_part, inputs.time_ns, turn.finished, events);
    }
    if (!turn.running || inputs.fastCount == 0) {
        return {m_mode == LoopMode::Control ? LoopState::Controlling : LoopState::Advising,
                Sentence("Ready for the next edge.")};
    }
    m_force_N = inputs.fast[0].force_N;
    m_part.forcePeak_N = std::max(m_part.forcePeak_N, m_force_N);
    m_sum_N += m_force_N;
    ++m_samples;
    if (m_force_N > 0.0) {
        m_scale = std::min(1.0, inputs.appliedFeedScale.value * kForceLimit_N / m_force_N);
    }
    outputs.feedScale = m_scale;
    return {m_mode == LoopMode::Control ? LoopState::Controlling : LoopState::Advising,
            Sentence("The feed keeps the force at %1 N or below.", SentenceArg(kForceLimit_N, 0))};
}

void DeburringLoop::sample(Sample& sample) const noexcept {
    sample.force_N = m_program.inPart() ? static_cast<float>(m_force_N) : sample.force_N;
}

ui::PageEntry DeburringRoom::page() const {
    ui::PageEntry entry;
    entry.key = kDeburringProcess.key;
    entry.title = [] { return ui::processName(kDeburring); };
    entry.process = kDeburring;
    entry.make = [](const ui::PageContext& context) -> ui::Page* { return new DeburringPage(context); };
    entry.keyFigure = [](const ui::Services&, const Status& status) {
        ui::KeyFigure figure{QStringLiteral("Feed"), "mm/s", 1};
        if (status.programProcess == kDeburring && status.actualFeed_mmPerS.good()) {
            figure.value = status.actualFeed_mmPerS.value;
        }
        return figure;
    };
    return entry;
}

}  // namespace kerf::test
