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

/// Finds a hand gauge among the keys: characters faster than any hand, ended by Enter or Tab, that make a gauge frame.
///
/// Install it on the application; it works whatever has the focus. A key that could begin a frame is held for at most
/// kGap_ms; when no gauge follows, all held keys go on, in order, to where they were meant to go. Nothing a person
/// types is lost, and a bar code reader or a fast test passes through unless it sends a length with a decimal mark.
class GaugeWedge : public QObject {
    Q_OBJECT
 public:
    static constexpr int kGap_ms = 30;       ///< longest pause inside a burst; hands need more than 50
    static constexpr int kRepeat_ms = 1500;  ///< the same frame again within this time is a bounce of the send button
    static constexpr int kLongestFrame = 24;

    explicit GaugeWedge(QObject* parent = nullptr);
    ~GaugeWedge() override;

    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Wall clock in ms for events that carry no time; tests set their own.
    void setClock(std::function<qint64()> clock_ms) { m_clock_ms = std::move(clock_ms); }

 signals:
    void reading(const kerf::ui::GaugeReading& reading);
    /// The same frame twice: left out. The operator is told.
    void repeated(const kerf::ui::GaugeReading& reading);

 private:
    struct Held {
        QPointer<QObject> target;
        std::unique_ptr<QKeyEvent> event;
    };
    bool onPress(QObject* target, QKeyEvent* event);
    void hold(QObject* target, const QKeyEvent& event);
    void release();  ///< give back everything held
    bool finish();   ///< the end key came; true: it was a gauge

    std::vector<Held> m_held;
    QString m_frame;
    QTimer m_timer;
    QElapsedTimer m_elapsed;
    std::function<qint64()> m_clock_ms;
    qint64 m_last_ms{0};
    qint64 m_lastReading_ms{0};
    QString m_lastFrame;
    int m_endKey{0};
    bool m_spoiled{false};  ///< this run of fast keys began with something else: a bar code, not a gauge
    bool m_giving{false};
};

}  // namespace kerf::ui
