// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/feed_keeper.h"

#include <algorithm>
#include <cmath>

#include "engine/machine/linuxcnc/link_memory.h"

namespace kerf::linuxcnc {
namespace {

/// What is no number is no feed.
double sane(double scale) {
    return std::isfinite(scale) ? std::max(scale, 0.0) : 0.0;
}

/// What is left of `scale` when nobody scales it.
double left(double scale, double loss, double planned) {
    return planned > 0.0 ? std::min({scale, loss, planned}) : std::min(scale, loss);
}

}  // namespace

void FeedKeeper::hear(const ToControl* wish) noexcept {
    m_obeyed = false;
    if (wish == nullptr || wish->beat != wish->beatAgain) {
        return;
    }
    m_hold = wish->feedHold;
    if (wish->beat == m_beat || wish->feedEpoch != m_epoch) {
        return;
    }
    m_beat = wish->beat;
    m_obeyed = m_ever = true;
    m_waits = m_ended = false;
    m_silent_s = 0.0;
    m_scale = sane(wish->feedScale);
    m_loss = std::min(sane(wish->lossScale), 1.0);
    m_planned = sane(wish->plannedScale);
}

FeedKeeper::Pins FeedKeeper::told(const Round& round, const Pins& standing) const noexcept {
    Pins pins = standing;
    if (!round.mayScale) {
        pins.hold = round.stopHolds;
        return pins;
    }
    pins.scale = m_scale;
    pins.lossScale = left(m_scale, m_loss, m_planned);
    pins.hold = m_hold || round.stopHolds;
    return pins;
}

FeedKeeper::Pins FeedKeeper::leftAlone(const Round& round, const Pins& standing) noexcept {
    if (!round.mayScale) {
        Pins pins = standing;
        pins.hold = round.stopHolds || (m_lost && round.holdOnLoss);
        return pins;
    }
    if (m_ended) {  // an operator's own program runs at its own feed
        m_ever = true;
        m_ended = false;
        m_loss = 1.0;
        m_planned = 0.0;
        m_hold = false;
        m_scale = 1.0;
    }
    Pins pins = standing;
    // A bridge that knows nothing of what runs takes what the one before has left for this case.
    const double loss = m_ever ? left(1.0, m_loss, m_planned) : standing.lossScale;
    if (round.running) {
        pins.scale = std::min(standing.scale, loss);
        pins.hold = standing.hold || m_hold || pins.scale <= 0.0;
    } else if (m_ever) {
        pins.scale = loss;  // a start that is under way begins at its planned feed
        pins.hold = loss <= 0.0;
    }
    pins.lossScale = std::min(pins.scale, loss);
    pins.hold = pins.hold || round.stopHolds || (m_lost && round.holdOnLoss);
    return pins;
}

FeedKeeper::Pins FeedKeeper::next(const Round& round, const ToControl* wish, const Pins& standing) noexcept {
    if (round.passed_ns > kAliveWidth_ns) {  // HAL has counted us out meanwhile
        m_waits = true;
        ++m_epoch;
    }
    m_ended = m_ended || (m_ran && !round.running);
    m_ran = round.running;
    m_silent_s += static_cast<double>(std::min(round.passed_ns, kOwnStall_ns)) * 1e-9;
    hear(wish);
    const bool lost = m_silent_s > round.timeout_s;
    if (lost && !m_lost) {
        m_waits = true;
        ++m_epoch;
    }
    m_lost = lost;
    Pins pins = standing;
    if (m_obeyed) {
        pins = told(round, standing);
    } else if (m_lost || m_waits) {
        pins = leftAlone(round, standing);
    } else {
        pins.hold = standing.hold || m_hold || round.stopHolds;
    }
    pins.holdIfGone = round.holdOnLoss;
    return pins;
}

}  // namespace kerf::linuxcnc
