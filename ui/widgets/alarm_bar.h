// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

#include "ui/widgets/clamp_label.h"
#include "ui/widgets/face_widget.h"
#include "ui/widgets/sign.h"

namespace kerf::ui {

/// The bottom line: the first unacknowledged alarm in words, or a short notice (a refused command), or nothing.
class AlarmBar : public FaceWidget {
    Q_OBJECT
 public:
    explicit AlarmBar(Look& look, QWidget* parent = nullptr);

    /// @param more how many other unacknowledged alarms wait behind this one
    void setAlarm(int priority, const QString& words, int more);
    void clearAlarm();
    /// A sentence for the operator that is no alarm; it goes after some seconds.
    void notify(const QString& sentence);
    [[nodiscard]] QString text() const { return m_text->text(); }

 signals:
    void showRequested();

 protected:
    void refresh() override;

 private:
    class SignBox;
    void rebuild();

    SignBox* m_sign;
    ClampLabel* m_text;
    QPushButton* m_show;
    int m_priority{0};
    QString m_words;
    int m_more{0};
    QString m_notice;
};

}  // namespace kerf::ui
