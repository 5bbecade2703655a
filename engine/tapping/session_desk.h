// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/api/engine_api.h"
#include "engine/api/tapping_desk.h"
#include "engine/tapping/tuning_session.h"

namespace kerf {

/// The tapping desk over tuning sessions on one engine. GUI thread; asking the tuner takes some milliseconds.
class SessionTappingDesk final : public TappingDesk {
 public:
    /// `assumed`: servo constants the tuner starts from, and the drive's ramp. Engine and exchange outlive the desk.
    SessionTappingDesk(EngineApi& engine, TapExchange& exchange, const tapping::DriveParams& assumed);

    [[nodiscard]] const TappingDeskView& view() const override { return m_view; }
    [[nodiscard]] const std::vector<TapThreadView>& threads() const override { return m_threads; }
    [[nodiscard]] Result<void> begin(const std::string& thread, double speed_rpm, double depth_rev) override;
    void oneMore() override;
    void accept() override;
    void rollBack() override;
    void abort() override;
    void recover() override;
    void poll() override;

 private:
    void rebuild();

    EngineApi& m_engine;
    TapExchange& m_exchange;
    tapping::DriveParams m_assumed;
    std::vector<TapThreadView> m_threads{};
    std::unique_ptr<TuningSession> m_session{};
    TuningSession::State m_shownState{TuningSession::State::Air};
    std::size_t m_shownTrials{0};
    std::uint32_t m_jobs{0};
    TappingDeskView m_view{};
};

}  // namespace kerf
