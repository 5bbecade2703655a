// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <optional>

#include "engine/core/param_spec.h"
#include "engine/core/reading.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// One number with its label, unit and quality. Values come in stored units; the display converts.
///
/// Quality: stale or missing is dim with a dash or its age, estimated shows ± half width, limited carries a bar and the
/// word. Repaints at most five times a second with fixed decimals, so that nothing jitters.
class NumberDisplay : public FaceWidget {
    Q_OBJECT
 public:
    /// @param unit stored unit ("mm", "um", "mm/rev" …, see UnitSystem); @param decimals those of the stored unit
    NumberDisplay(Look& look, const char* unit, int decimals, TextSize size = TextSize::Card,
                  QWidget* parent = nullptr);
    /// Unit and decimals of a parameter.
    NumberDisplay(Look& look, const ParamSpec& spec, TextSize size = TextSize::Card, QWidget* parent = nullptr);

    void setLabel(const QString& label);
    void setValue(double stored);
    void setNothing();
    /// Good shows the value; Stale shows it dim with its age against `now_ns`; anything else a dash.
    void setReading(const Reading& reading, std::int64_t now_ns);
    /// Half width of the 95 % interval in stored units; nothing hides it.
    void setHalf95(std::optional<double> half);
    void setLimited(bool limited);
    /// Value the width is reserved for, so that neighbours do not move (default 8888).
    void setWidest(double stored);

    /// The number as shown (tests, screen readers).
    [[nodiscard]] QString text() const;
    [[nodiscard]] QSize sizeHint() const override;
    /// What the present number needs; sizeHint() leaves room for the widest.
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;
    void refresh() override;

 private:
    struct Content {
        std::optional<double> value{};
        std::optional<double> half95{};
        std::optional<int> age_s{};
        bool limited{false};
        friend bool operator==(const Content&, const Content&) = default;
    };
    void changed();
    [[nodiscard]] QSize sizeFor(const QString& digits) const;
    [[nodiscard]] QString remark() const;  ///< interval, age or "limited"

    const char* m_unit;
    int m_decimals;
    TextSize m_size;
    QString m_label;
    double m_widest{8888.0};
    Content m_content;
    Content m_shown;
    QElapsedTimer m_since;
    QTimer m_later;
};

}  // namespace kerf::ui
