// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/gauge_wedge.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

bool isEndKey(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab;
}

/// The first character of a frame: anything else is let through at once.
bool mayBegin(QChar c) {
    return c.isDigit() || c == u'+' || c == u'-' || c == u'.' || c == u',' || c == u'F';
}

bool mayFollow(QChar c) {
    return mayBegin(c) || c == u' ' || c == u'"' || c == u'\'' || (c >= u'A' && c <= u'Z') ||
           QStringLiteral("mich n").contains(c);
}

}  // namespace

GaugeWedge::GaugeWedge(QObject* parent) : QObject(parent) {
    m_elapsed.start();
    m_clock_ms = [this] { return m_elapsed.elapsed(); };
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kGap_ms);
    connect(&m_timer, &QTimer::timeout, this, &GaugeWedge::release);
}

GaugeWedge::~GaugeWedge() = default;

bool GaugeWedge::eventFilter(QObject* watched, QEvent* event) {
    // The window hands a key on to a widget: there it is looked at, once. What the program itself sends (a keypad on
    // the screen) comes from no keyboard.
    if (m_giving || !watched->isWidgetType() || !event->spontaneous()) {
        return false;
    }
    switch (event->type()) {
        case QEvent::KeyPress:
            return onPress(watched, static_cast<QKeyEvent*>(event));
        case QEvent::KeyRelease: {
            auto* key = static_cast<QKeyEvent*>(event);
            if (m_endKey != 0 && key->key() == m_endKey) {
                m_endKey = 0;
                return true;
            }
            if (!m_held.empty()) {
                hold(watched, *key);
                return true;
            }
            return false;
        }
        case QEvent::MouseButtonPress:
        case QEvent::TouchBegin:
            release();
            return false;
        default:
            return false;
    }
}

bool GaugeWedge::onPress(QObject* target, QKeyEvent* event) {
    m_endKey = 0;
    // The event's own time, where it has one: keys that queued up behind a busy screen are not a burst.
    const qint64 now_ms = event->timestamp() != 0 ? static_cast<qint64>(event->timestamp()) : m_clock_ms();
    const bool close = now_ms >= m_last_ms && now_ms - m_last_ms <= kGap_ms;
    const bool fast = !m_frame.isEmpty() && close;
    m_spoiled = m_spoiled && close;
    if (!m_frame.isEmpty() && !fast) {
        release();
    }
    m_last_ms = now_ms;
    const bool command = (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
    if (event->isAutoRepeat() || command) {
        release();
        return false;
    }
    if (fast && isEndKey(event->key()) && finish()) {
        m_endKey = event->key();
        return true;
    }
    const QString text = event->text();
    const QChar c = text.size() == 1 ? text[0] : QChar();
    const bool taken = !c.isNull() && !m_spoiled && (m_frame.isEmpty() ? mayBegin(c) : mayFollow(c));
    if (event->key() == Qt::Key_Shift && !m_frame.isEmpty()) {
        hold(target, *event);  // part of typing '+' or a letter
        return true;
    }
    if (!taken || m_frame.size() >= kLongestFrame) {
        m_spoiled = c.isPrint();
        release();
        return false;
    }
    m_frame += c;
    hold(target, *event);
    m_timer.start();
    return true;
}

void GaugeWedge::hold(QObject* target, const QKeyEvent& event) {
    m_held.push_back({target, std::unique_ptr<QKeyEvent>(event.clone())});
}

void GaugeWedge::release() {
    m_timer.stop();
    m_frame.clear();
    std::vector<Held> held;
    held.swap(m_held);
    m_giving = true;
    for (const Held& key : held) {
        if (key.target) {
            QCoreApplication::sendEvent(key.target, key.event.get());
        }
    }
    m_giving = false;
}

bool GaugeWedge::finish() {
    std::optional<GaugeReading> found = parseGaugeFrame(m_frame);
    if (!found) {
        return false;
    }
    m_timer.stop();
    m_held.clear();
    m_frame.clear();
    const bool again = found->frame == m_lastFrame && m_last_ms - m_lastReading_ms <= kRepeat_ms;
    m_lastFrame = found->frame;
    m_lastReading_ms = m_last_ms;
    if (again) {
        emit repeated(*found);
    } else {
        emit reading(*found);
    }
    return true;
}

}  // namespace kerf::ui
