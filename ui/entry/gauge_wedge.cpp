// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/gauge_wedge.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QInputMethodEvent>
#include <QWidget>
#include <algorithm>

#include "ui/entry/hangul.h"

namespace kerf::ui {
namespace {

constexpr const char* kForDiameters = "gaugeTarget";  ///< property of a field that takes diameters
constexpr qsizetype kLeastPart = 3;                   ///< keys; fewer may be two fingers

bool isEndKey(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab;
}

/// The first character of a frame: anything else is let through at once.
bool mayBegin(QChar c) {
    return c.isDigit() || QStringLiteral("+-., #").contains(c) || (c >= u'A' && c <= u'Z');
}

bool hasFigure(const QString& text) {
    return std::any_of(text.cbegin(), text.cend(), [](QChar c) { return c.isDigit(); });
}

/// Small letters belong to a label in front of the figures, or to mm, in, inch behind them.
bool mayFollow(const QString& frame, QChar c) {
    const bool letter = c >= u'a' && c <= u'z';
    return mayBegin(c) || QStringLiteral("\"':;=<>").contains(c) ||
           (letter && (!hasFigure(frame) || QStringLiteral("minch").contains(c)));
}

/// What a key of the keypad would have been with Num Lock on.
QChar keypadFigure(int key) {
    switch (key) {
        case Qt::Key_Insert:
            return u'0';
        case Qt::Key_End:
            return u'1';
        case Qt::Key_Down:
            return u'2';
        case Qt::Key_PageDown:
            return u'3';
        case Qt::Key_Left:
            return u'4';
        case Qt::Key_Clear:
            return u'5';
        case Qt::Key_Right:
            return u'6';
        case Qt::Key_Home:
            return u'7';
        case Qt::Key_Up:
            return u'8';
        case Qt::Key_PageUp:
            return u'9';
        case Qt::Key_Delete:
            return u'.';
        default:
            return {};
    }
}

/// A field for text, as opposed to a button or a page, on which a key does something.
bool takesText(const QObject* target) {
    const auto* widget = qobject_cast<const QWidget*>(target);
    return widget != nullptr &&
           (widget->inherits("QLineEdit") || widget->inherits("QTextEdit") || widget->inherits("QPlainTextEdit") ||
            widget->testAttribute(Qt::WA_InputMethodEnabled));
}

bool forDiameters(const QObject* target) {
    return target != nullptr && target->property(kForDiameters).toBool();
}

}  // namespace

GaugeWedge::GaugeWedge(QObject* parent) : QObject(parent) {
    m_elapsed.start();
    m_clock_ms = [this] { return m_elapsed.elapsed(); };
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kPause_ms);
    connect(&m_timer, &QTimer::timeout, this, &GaugeWedge::timedOut);
}

GaugeWedge::~GaugeWedge() = default;

bool GaugeWedge::eventFilter(QObject* watched, QEvent* event) {
    if (m_giving || !watched->isWidgetType()) {
        return false;
    }
    if (event->type() == QEvent::InputMethod) {  // an input method sends these itself, they are never spontaneous
        return onInputMethod(watched, *event);
    }
    // The window hands a key on to a widget: there it is looked at, once. What the program itself sends (a keypad on
    // the screen) comes from no keyboard.
    if (!event->spontaneous()) {
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

/// Between two keys: what goes on as one run, and what is over.
void GaugeWedge::pause(qint64 now_ms) {
    const qint64 gap_ms = now_ms - m_last_ms;
    const bool run = gap_ms >= 0 && gap_ms <= kPause_ms;
    m_spoiled = m_spoiled && run;
    if (!m_frame.isEmpty()) {
        m_pauses += gap_ms > kGap_ms ? 1 : 0;
        if (!run) {
            timedOut();
        } else if (!senderPace()) {
            m_spoiled = true;  // a hand
            release();
        }
    }
    m_last_ms = now_ms;
}

bool GaugeWedge::onPress(QObject* target, QKeyEvent* event) {
    m_endKey = 0;
    // The event's own time, where it has one: keys that queued up behind a busy screen are not a burst.
    const qint64 now_ms = event->timestamp() != 0 ? static_cast<qint64>(event->timestamp()) : m_clock_ms();
    pause(now_ms);
    const QString text = event->text();
    const bool lineFeed = text == QLatin1String("\n");  // Ctrl+J of some senders
    const bool command = (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
    if (event->isAutoRepeat() || (command && !lineFeed)) {
        release();
        return false;
    }
    if (isEndKey(event->key()) || lineFeed) {
        if (atEndKey(target, event->key())) {
            m_endKey = event->key();
            return true;
        }
        return false;
    }
    if (event->key() == Qt::Key_Shift && !m_frame.isEmpty()) {
        hold(target, *event);  // part of typing '+' or a letter
        return true;
    }
    if (m_spoiled && event->key() == Qt::Key_Space && !takesText(target)) {
        m_endKey = event->key();
        return true;  // in the middle of a run of keys: padding, no press
    }
    QChar c = text.size() == 1 ? text[0] : QChar();
    if ((event->modifiers() & Qt::KeypadModifier) != 0 && text.isEmpty()) {
        c = keypadFigure(event->key());
        m_keypad = m_keypad || !c.isNull();
    } else if (c.unicode() >= 0x3131 && c.unicode() <= 0x3163) {
        c = latinKeys(text).toUpper().front();  // a Korean layout without an input method
    }
    return take(target, *event, c, event->key());
}

bool GaugeWedge::onInputMethod(QObject* target, const QEvent& event) {
    const auto& input = static_cast<const QInputMethodEvent&>(event);
    if (m_frame.isEmpty()) {
        return false;
    }
    if (input.commitString().isEmpty()) {  // still composing
        hold(target, event);
        return true;
    }
    pause(m_clock_ms());
    if (m_frame.isEmpty()) {
        return false;
    }
    const QString keys = latinKeys(input.commitString()).toUpper();
    const bool fits = m_frame.size() + keys.size() <= kLongestFrame &&
                      std::all_of(keys.cbegin(), keys.cend(), [this](QChar key) { return mayFollow(m_frame, key); });
    if (!fits) {
        release();
        return false;
    }
    m_frame += keys;
    hold(target, event);
    m_timer.start();
    return true;
}

bool GaugeWedge::take(QObject* target, const QEvent& event, QChar c, int key) {
    const bool label = !hasFigure(m_frame) && m_frame.trimmed().size() >= kLongestLabel && !c.isDigit();
    const bool taken = !c.isNull() && !m_spoiled && !label && (m_frame.isEmpty() ? mayBegin(c) : mayFollow(m_frame, c));
    if (!taken || m_frame.size() >= kLongestFrame) {
        m_spoiled = c.isPrint();
        const bool deletes = key == Qt::Key_Backspace || key == Qt::Key_Delete;
        if (!m_frame.isEmpty() || deletes) {
            m_lastPart_ms = m_last_ms - kHalf_ms - 1;  // a person at work, no lost part
        }
        release();
        return false;
    }
    if (m_frame.isEmpty()) {
        m_begin_ms = m_last_ms;
    }
    m_frame += c;
    hold(target, event);
    m_timer.start();
    return true;
}

/// True: the end key belongs to a gauge, or to what is left of a frame.
bool GaugeWedge::atEndKey(QObject* target, int key) {
    if (m_last_ms - m_ended_ms >= 0 && m_last_ms - m_ended_ms <= kEndEcho_ms && m_frame.isEmpty()) {
        m_ended_ms = m_last_ms;
        return true;  // CR LF, Tab CR
    }
    if (m_frame.isEmpty()) {
        m_lastPart_ms = m_last_ms - kHalf_ms - 1;  // whatever was begun is ended
        return false;
    }
    const bool continued = m_begin_ms - m_lastPart_ms <= kHalf_ms;
    if (m_keypad) {
        if (senderPace() && parseGaugeFrame(m_frame)) {
            m_ended_ms = m_last_ms;
            drop();
            emit numLockOff();
            return true;
        }
        release();
        return false;
    }
    if (finish(continued)) {
        m_ended_ms = m_last_ms;
        return true;
    }
    const bool part = senderPace() && hasFigure(m_frame) && (continued || m_frame.size() >= 2);
    const bool presses = key != Qt::Key_Tab && !takesText(target);
    if (part && (presses || (continued && forDiameters(target)))) {
        const QString lost = m_frame;
        m_ended_ms = m_last_ms;
        drop();
        emit halved(lost);
        return true;
    }
    release();
    return false;
}

bool GaugeWedge::senderPace() const {
    return m_pauses <= std::max<qsizetype>(2, 1 + m_frame.size() / kKeysPerPause);
}

void GaugeWedge::hold(QObject* target, const QEvent& event) {
    m_held.push_back({target, std::unique_ptr<QEvent>(event.clone())});
}

/// No key followed the held ones.
void GaugeWedge::timedOut() {
    const bool part = m_frame.size() >= kLeastPart && senderPace() && hasFigure(m_frame) && !m_keypad;
    if (!m_frame.isEmpty() && hasFigure(m_frame)) {
        m_lastPart_ms = m_last_ms;
    }
    const bool decimals = m_frame.contains(u'.') || m_frame.contains(u',');
    const QObject* target = m_held.empty() ? nullptr : m_held.front().target.data();
    const QString lost = m_frame;
    if (part && !takesText(target)) {
        drop();
        emit halved(lost);
        return;
    }
    release();
    if (part && decimals && forDiameters(target)) {
        emit halved(lost);
    }
}

void GaugeWedge::drop() {
    m_timer.stop();
    m_frame.clear();
    m_held.clear();
    m_pauses = 0;
    m_keypad = false;
}

void GaugeWedge::release() {
    std::vector<Held> held;
    held.swap(m_held);
    drop();
    m_giving = true;
    for (const Held& key : held) {
        if (key.target) {
            QCoreApplication::sendEvent(key.target, key.event.get());
        }
    }
    m_giving = false;
}

bool GaugeWedge::finish(bool continued) {
    std::optional<GaugeReading> found = senderPace() ? parseGaugeFrame(m_frame) : std::nullopt;
    if (!found) {
        return false;
    }
    drop();
    if (continued) {  // 5, a pause, 0.011: the rest of a frame whose begin was lost
        m_lastPart_ms = m_last_ms - kHalf_ms - 1;
        emit halved(found->frame);
        return true;
    }
    const int within_ms = found->channel ? kChannelRepeat_ms : kRepeat_ms;
    std::erase_if(m_seen, [&](const Seen& seen) { return m_last_ms - seen.at_ms > kChannelRepeat_ms; });
    const auto same = std::find_if(m_seen.begin(), m_seen.end(), [&](const Seen& seen) {
        return seen.frame == found->frame && m_last_ms - seen.at_ms <= within_ms;
    });
    const bool again = same != m_seen.end();
    if (!found->channel) {
        m_seen.clear();  // another reading in between: no bounce
    }
    std::erase_if(m_seen, [&](const Seen& seen) { return seen.frame == found->frame; });
    m_seen.push_back({found->frame, m_last_ms});
    if (again) {
        emit repeated(*found);
    } else {
        emit reading(*found);
    }
    return true;
}

}  // namespace kerf::ui
