// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/process/thermal/training.h"

namespace kerf {

/// Trains a thermal model on a worker thread. One job at a time; progress and cancel at any time. Destroying it
/// cancels.
class ThermalTrainer {
 public:
    struct Problem {
        Sentence sentence{};
        std::string detail{};  ///< file, line, column of a history that cannot be read
    };
    struct Outcome {
        bool cancelled{false};
        std::optional<Problem> problem{};
        std::optional<thermal::AutoTraining> trained{};
    };
    /// Reads or makes the days; runs on the worker. May throw std::exception with the file's complaint.
    using Days = std::function<std::vector<thermal::ThermalHistory>()>;

    ThermalTrainer() = default;
    ThermalTrainer(const ThermalTrainer&) = delete;
    ThermalTrainer& operator=(const ThermalTrainer&) = delete;
    ~ThermalTrainer();

    /// @param kind "auto", "hierarchical", "regression" or "gmdh". @pre !running()
    void start(const std::string& kind, Days days);
    void cancel() { m_cancel = true; }
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double progress() const { return m_progress; }
    /// Once, after the end.
    [[nodiscard]] std::optional<Outcome> takeOutcome();

 private:
    void run(const std::string& kind, const Days& days);

    std::thread m_worker;
    std::atomic<bool> m_cancel{false};
    std::atomic<bool> m_running{false};
    std::atomic<double> m_progress{0.0};
    std::mutex m_mutex;
    std::optional<Outcome> m_outcome;
};

}  // namespace kerf
