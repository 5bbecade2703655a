// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "ui/entry/diameter_field.h"
#include "ui/entry/gauge_channels.h"
#include "ui/entry/gauge_reading.h"
#include "ui/services/boring_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/keypad.h"

class QHBoxLayout;
class QLabel;
class QStackedWidget;

namespace kerf::ui {

/// Where a diameter enters: keypad, gauge button, keyboard, or a gauge's keyboard wedge.
///
/// The oldest part that waits is preselected; two figures and Enter are an entry. What is typed stays with the part
/// and depth it was begun for. An implausible value becomes a question in place of the buttons, a refused one keeps
/// its text and says what, where and which range; a value that could not be stored stays and can be tried again.
class EntryPanel : public Card {
    Q_OBJECT
 public:
    /// Who signs, and how to ask for a name before an action that needs one.
    struct Signing {
        std::function<std::string()> author;
        std::function<void(std::function<void()> action)> withOperator;
        /// Which gauge sends on this channel (GaugesAtHand::kNoChannel: none, or the machine's own); may be empty.
        std::function<std::string(int channel)> gauge{};
    };

    EntryPanel(Look& look, BoringService& service, Signing signing, QWidget* parent = nullptr);

    /// The service has a new view.
    void refreshView();
    /// Enter this part and depth next, instead of the oldest that waits.
    void choose(PartId part, std::uint8_t depth);
    /// A reading of a hand gauge: entered at once when it is plausible. One that comes while another is being stored or
    /// asked about waits for it; a burst of readings (a multiplexer, a foot switch) belongs to one part.
    void takeGauge(const GaugeReading& reading);
    void tellRepeated(const GaugeReading& reading);
    /// Something like a part of a frame came; what it left in the field is no diameter.
    void tellHalved(const QString& part);
    void tellNumLockOff();
    /// A reading that nothing is done with, and why.
    void tellLeftOut(const QString& sentence);
    /// Said beside the field for as long as it holds; empty: nothing to say.
    void setGaugeNote(const QString& note);
    [[nodiscard]] const GaugeChannels& channels() const { return m_channels; }
    void setChannels(GaugeChannels channels);
    /// Another gauge is at hand, or the register has changed.
    void showChannels();
    [[nodiscard]] std::string gaugeOn(int channel) const;
    /// Which gauge of the register has sent it.
    [[nodiscard]] std::string gaugeOf(const GaugeReading& reading) const;
    /// Whether a gauge on a serial line can be asked; told so, it is. Its reading comes by takeGauge().
    void setAskGauges(std::function<bool(bool really)> ask) { m_askGauges = std::move(ask); }
    /// Gauges come and go while the console runs.
    void reconsiderGauge();
    /// There are gauges in the register for this bore: one of them may be named.
    void setGaugesThere(bool there);
    [[nodiscard]] DiameterField* field() const { return m_field; }
    /// What is said under the field.
    [[nodiscard]] QString message() const;
    /// A question waits for an answer.
    [[nodiscard]] bool asking() const { return m_question.has_value(); }

 signals:
    void undoRequested();
    void measurementsRequested();
    /// The operator must look here: a question or a refusal came from a gauge.
    void attentionNeeded();
    /// What became of a gauge's reading.
    void gaugeTold(const QString& sentence);
    void channelsRequested();
    void channelLearnt();

 private:
    struct Target {
        PartId part{0};
        std::uint8_t depth{0};
        friend bool operator==(const Target&, const Target&) = default;
    };
    /// What is said under the field. Kept as a function, so that it can be said again in another language or unit.
    using Words = std::function<QString()>;

    void retranslate() override;
    void showTarget();
    void say(Words words, bool wrong = false);
    void showWords();
    void onTyped();
    void commit();
    void submit(const BoreEntry& entry);
    void ask(const BoreEntry& entry, Words words, Words confirm);
    void store(const BoreEntry& entry);
    void stored(const BoreEntry& entry, const Result<void>& result);
    void tryKeptAgain();
    void measureAgain();
    void confirm();
    void readGauge();
    void takeNextWaiting();
    void judgeAndSubmit(const GaugeReading& reading, const Target& target);
    void told();
    [[nodiscard]] bool inBurst() const;
    [[nodiscard]] std::optional<Target> targetOf(const GaugeReading& reading, QString& why);
    [[nodiscard]] std::optional<Target> nextTarget() const;
    [[nodiscard]] QString place(const BoreEntry& entry) const;
    [[nodiscard]] QString whyNoTarget() const;
    [[nodiscard]] double expected_mm(const Target& target) const;

    Look& m_look;
    BoringService& m_service;
    Signing m_signing;
    std::function<bool(bool really)> m_askGauges{};
    QLabel* m_prompt;
    QLabel* m_gaugeDue;
    DiameterField* m_field;
    QLabel* m_unit;
    QLabel* m_message;
    QStackedWidget* m_rows;
    QHBoxLayout* m_buttons;
    QHBoxLayout* m_answers;
    ActionButton* m_gauge;
    ActionButton* m_undo;
    QPushButton* m_channelsButton;
    QPushButton* m_correct;
    QPushButton* m_again;
    QPushButton* m_confirm;
    Keypad* m_keypad;
    QHBoxLayout* m_columns;
    QHBoxLayout* m_fieldRow;
    QVBoxLayout* m_left;

    std::optional<Target> m_target;
    std::optional<Target> m_chosen;
    std::optional<BoreEntry> m_question;
    std::optional<BoreEntry> m_kept;  ///< the store had no room for it: tried again by itself while the field shows it
    bool m_pending{false};
    bool m_typedMeanwhile{false};  ///< while an entry was being stored: the next bore's figures
    bool m_enterMeanwhile{false};
    bool m_fromGauge{false};       ///< the field holds a reading of a gauge …
    std::string m_gaugeOfField{};  ///< … of this one; empty: not known
    bool m_askGauge{false};
    Words m_words;
    Words m_confirmWords;
    GaugeChannels m_channels{};
    std::deque<GaugeReading> m_waiting{};  ///< readings that came while another was stored or asked about
    std::optional<PartId> m_burstPart{};   ///< the part that the readings of this burst belong to
    QElapsedTimer m_sinceReading{};
    QElapsedTimer m_sinceStored{};
};

}  // namespace kerf::ui
