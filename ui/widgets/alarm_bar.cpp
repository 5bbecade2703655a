// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/alarm_bar.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QTimer>

#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kNotice_ms = 10'000;
constexpr int kLines = 3;  // as many as beside a button
}  // namespace

class AlarmBar::SignBox : public QWidget {
 public:
    explicit SignBox(Look& look, QWidget* parent) : QWidget(parent), m_look(look) {}
    void set(Sign sign) {
        m_sign = sign;
        setVisible(sign != Sign::None);
        const int side = m_look.metrics().touch() / 2;
        setFixedSize(side, side);
        update();
    }

 protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        paintSign(painter, QRectF(rect()).adjusted(1, 1, -1, -1), m_sign, m_look);
    }

 private:
    Look& m_look;
    Sign m_sign{Sign::None};
};

AlarmBar::AlarmBar(Look& look, QWidget* parent)
    : FaceWidget(look, parent),
      m_sign(new SignBox(look, this)),
      m_text(new ClampLabel(kLines, this)),
      m_show(new QPushButton(this)) {
    setObjectName(QStringLiteral("alarmBar"));
    m_text->setObjectName(QStringLiteral("alarmText"));
    m_show->setObjectName(QStringLiteral("alarmShow"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(m_show);
    connect(m_show, &QPushButton::clicked, this, &AlarmBar::showRequested);
    refresh();
}

void AlarmBar::setAlarm(int priority, const QString& words, int more) {
    if (priority == m_priority && words == m_words && more == m_more) {
        return;
    }
    m_priority = priority;
    m_words = words;
    m_more = more;
    rebuild();
}

void AlarmBar::clearAlarm() {
    setAlarm(0, {}, 0);
}

void AlarmBar::notify(const QString& words) {
    const QString sentence = withParticles(words);
    m_notice = sentence;
    rebuild();
    QTimer::singleShot(kNotice_ms, this, [this, sentence] {
        if (m_notice == sentence) {
            m_notice.clear();
            rebuild();
        }
    });
}

// An alarm of priority 1 stays in front of a notice; any other gives way to the answer the operator waits for.
void AlarmBar::rebuild() {
    const bool notice = !m_notice.isEmpty() && m_priority != 1;
    m_sign->set(notice || m_priority == 0 ? Sign::None : signOfAlarm(m_priority));
    if (notice) {
        m_text->say(m_notice);
    } else if (m_priority == 0) {
        m_text->say(tr("No alarms."));
    } else if (m_more > 0) {
        m_text->say(tr("%1  (and %n more)", nullptr, m_more).arg(m_words));
    } else {
        m_text->say(m_words);
    }
    setTextRole(m_text, notice || m_priority > 0 ? TextRole::Body : TextRole::Dim);
    m_show->setVisible(m_priority > 0);
}

void AlarmBar::refresh() {
    m_show->setText(tr("Show"));
    layout()->setSpacing(look().space(Space::Medium));
    rebuild();
    FaceWidget::refresh();
}

}  // namespace kerf::ui
