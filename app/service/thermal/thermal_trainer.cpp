// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/thermal/thermal_trainer.h"

#include <exception>
#include <utility>

namespace kerf {
namespace {

Result<thermal::AutoTraining> trainOne(const std::string& kind, const std::vector<thermal::ThermalHistory>& days,
                                       const thermal::TrainingProgress& progress) {
    if (kind == "auto") {
        return thermal::trainAuto(days, {}, progress);
    }
    auto model = kind == "gmdh"           ? thermal::trainNetwork(thermal::ModelKind::Gmdh, days, {}, progress)
                 : kind == "hierarchical" ? thermal::trainHierarchical(days, {}, progress)
                                          : thermal::trainRegression(days, {}, progress);
    if (!model) {
        return tl::unexpected(model.error());
    }
    thermal::AutoTraining out;
    out.compared.push_back({model->kind, model->judgement, model->sensors.size()});
    out.best = std::move(*model);
    return out;
}

}  // namespace

ThermalTrainer::~ThermalTrainer() {
    m_cancel = true;
    if (m_worker.joinable()) {
        m_worker.join();
    }
}

void ThermalTrainer::start(const std::string& kind, Days days) {
    if (m_worker.joinable()) {
        m_worker.join();
    }
    m_cancel = false;
    m_progress = 0.0;
    m_running = true;
    m_worker = std::thread([this, kind, days = std::move(days)] {
        run(kind, days);
        m_running = false;
    });
}

void ThermalTrainer::run(const std::string& kind, const Days& days) {
    Outcome outcome;
    try {
        auto trained = trainOne(kind, days(), [this](double share) {
            m_progress = share;
            return !m_cancel;
        });
        if (m_cancel) {
            outcome.cancelled = true;
        } else if (trained) {
            outcome.trained = std::move(*trained);
        } else {
            outcome.problem = Problem{trained.error(), {}};
        }
    } catch (const std::exception& complaint) {
        outcome.problem =
            Problem{Sentence(KERF_TEXT("A day cannot be used; nothing has changed.")), std::string(complaint.what())};
    }
    const std::scoped_lock lock(m_mutex);
    m_outcome = std::move(outcome);
}

std::optional<ThermalTrainer::Outcome> ThermalTrainer::takeOutcome() {
    if (m_running) {
        return std::nullopt;
    }
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_outcome, std::nullopt);
}

}  // namespace kerf
