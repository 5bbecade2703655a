// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <optional>
#include <vector>

#include "engine/api/status.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// One figure of the machine strip.
struct StripFigure {
    QString label{};
    QString value{};
    bool stale{false};  ///< no fresh value: shown dim
};

/// What is known of the tool in the spindle beside the engine's status.
struct StripTool {
    std::uint32_t parts{0};                    ///< made with it
    std::optional<std::uint32_t> partsLeft{};  ///< until its life ends; empty: no life is set
    bool known{false};
};

/// The machine at a glance under the header, on every page: program, spindle speed, feed, override, force, tool, time
/// to go. One line, grey; what does not fit is left out from the right, the time to go last.
class MachineStrip : public FaceWidget {
    Q_OBJECT
 public:
    explicit MachineStrip(Look& look, QWidget* parent = nullptr);

    /// Shown at most five times a second.
    void setStatus(const Status& status, const StripTool& tool);
    [[nodiscard]] const std::vector<StripFigure>& figures() const { return m_figures; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
    void touched();

 protected:
    void mouseReleaseEvent(QMouseEvent*) override { emit touched(); }
    void paintEvent(QPaintEvent* event) override;
    void refresh() override;

 private:
    [[nodiscard]] std::vector<StripFigure> figuresOf(const Status& status, const StripTool& tool) const;
    [[nodiscard]] StripFigure load(const Status& status) const;

    QElapsedTimer m_since{};  ///< figures were made; not running: they are wanted at once
    Status m_status{};
    StripTool m_tool{};
    std::vector<StripFigure> m_figures{};
};

}  // namespace kerf::ui
