// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "ui/entry/gauge_reading.h"

namespace kerf::ui {

/// Finds a hand gauge among the keys: characters at a sender's pace, ended by Enter or Tab, that make a gauge frame.
///
/// A cable sends a key every few ms, a radio base every 35 to 90 ms and now and then after 150; hands need more than
/// 100 from key to key. Install it on the application; it works whatever has the focus. A key that could begin a frame
/// is held for at most kPause_ms; when no gauge follows, all held keys go on, in order, to where they were meant to go.
/// What came at a sender's pace and is no whole frame (the radio lost a part) presses no button, and the rest of such a
/// frame goes into no field for diameters; it is told. Nothing a person types is lost, and a bar code reader passes
/// through unless it sends a length with a decimal mark.
class GaugeWedge : public QObject {
    Q_OBJECT
 public:
    static constexpr int kGap_ms = 95;     ///< a sender's pace; hands are slower
    static constexpr int kPause_ms = 170;  ///< longest pause inside a frame; two of them, in a long one more
    static constexpr int kKeysPerPause = 6;
    static constexpr int kRepeat_ms = 1500;  ///< the same frame again within this time is a bounce of the send button
    static constexpr int kChannelRepeat_ms = 5000;  ///< of a multiplexer: nobody changes the part in this time
    static constexpr int kEndEcho_ms = 300;         ///< a second end key (CR LF, Tab CR) belongs to the frame
    static constexpr int kHalf_ms = 2000;  ///< what follows a lost part within this time is the rest of its frame
    static constexpr int kLongestFrame = 40;
    static constexpr int kLongestLabel = 9;  ///< letters in front of the first figure

    explicit GaugeWedge(QObject* parent = nullptr);
    ~GaugeWedge() override;

    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Wall clock in ms for events that carry no time; tests set their own.
    void setClock(std::function<qint64()> clock_ms) { m_clock_ms = std::move(clock_ms); }

 signals:
    void reading(const kerf::ui::GaugeReading& reading);
    /// The same frame twice: left out. The operator is told.
    void repeated(const kerf::ui::GaugeReading& reading);
    /// A part of a frame, nothing to store. The operator is told; what stands in a field for diameters is no diameter.
    void halved(const QString& part);
    /// A frame in keys of the keypad with Num Lock off: left out. The operator is told.
    void numLockOff();

 private:
    struct Held {
        QPointer<QObject> target;
        std::unique_ptr<QEvent> event;
    };
    bool onPress(QObject* target, QKeyEvent* event);
    bool onInputMethod(QObject* target, const QEvent& event);
    bool take(QObject* target, const QEvent& event, QChar c, int key);
    bool atEndKey(QObject* target, int key);
    void hold(QObject* target, const QEvent& event);
    void pause(qint64 now_ms);
    void timedOut();
    void release();  ///< give back everything held
    void drop();     ///< forget everything held
    [[nodiscard]] bool senderPace() const;
    bool finish(bool continued);  ///< the end key came; true: it was a gauge

    std::vector<Held> m_held;
    QString m_frame;
    int m_pauses{0};       ///< gaps of this run longer than a sender's pace
    bool m_keypad{false};  ///< this run has keys of the keypad without Num Lock
    QTimer m_timer;
    QElapsedTimer m_elapsed;
    std::function<qint64()> m_clock_ms;
    qint64 m_last_ms{0};
    qint64 m_begin_ms{0};              ///< first key of this run
    qint64 m_lastPart_ms{-1'000'000};  ///< when something like the begin of a frame was left without its end
    qint64 m_ended_ms{-1'000'000};
    struct Seen {
        QString frame;
        qint64 at_ms;
    };
    std::vector<Seen> m_seen;  ///< the last frame of every channel
    int m_endKey{0};
    bool m_spoiled{false};  ///< this run of keys began with something else: a bar code, not a gauge
    bool m_giving{false};
};

}  // namespace kerf::ui
