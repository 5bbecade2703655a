// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLabel>
#include <optional>

#include "engine/api/status.h"
#include "ui/link/engine_client.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/clamp_label.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// Across the frame, on every page, as long as something is held or stopped: what, why, since when, by whom, and the
/// way out of it. Nothing is shown, and no room taken, while nothing is.
class HeldBand : public FaceWidget {
    Q_OBJECT
 public:
    HeldBand(Look& look, EngineClient& client, QWidget* parent = nullptr);

    void setStatus(const Status& status);
    /// Somebody has pressed HOLD ALL here; empty: nobody is signed on.
    void pressedBy(const QString& who) { m_pressedBy = who; }

 signals:
    /// The hold is to end, as shown.
    void releaseHoldRequested(const Status& shown);
    /// The stop of that process is to end, as shown.
    void releaseStopRequested(const Status& shown, ProcessId process);
    /// A tap stands in the hole: its page turns it out, or asks whether it is gone.
    void showRequested(ProcessId process);

 protected:
    void refresh() override;
    void paintEvent(QPaintEvent* event) override;

 private:
    void say();
    [[nodiscard]] QString what() const;
    [[nodiscard]] QString why() const;

    EngineClient& m_client;
    QLabel* m_what;
    ClampLabel* m_why;
    ActionButton* m_release;
    Status m_status{};
    std::optional<ProcessId> m_stopped{};  ///< of the stop that is shown
    QDateTime m_since{};
    QString m_pressedBy{};
};

}  // namespace kerf::ui
