// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <memory>
#include <optional>

#include "ui/dialogs/measurement_sheet.h"
#include "ui/entry/gauge_wedge.h"
#include "ui/pages/boring/bore_chart.h"
#include "ui/pages/boring/entry_panel.h"
#include "ui/pages/boring/estimate_panel.h"
#include "ui/pages/boring/feed_panel.h"
#include "ui/pages/boring/gauges_at_hand.h"
#include "ui/pages/boring/next_part_panel.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// The boring loop: bore against tolerance, feed along the bore, next part, estimated law, entry of diameters.
///
/// Shows what BoringService and Status say and passes on what is touched; decides nothing.
///
/// Object names, stable for tests:
///   boringPage
///   boringBoreChart, boringCapability, boringNote (words on the touched part, or why nothing can be stored)
///   boringFeedChart, boringLiveFeed
///   boringNextPart: boringNextDiameter0…, boringNextFeed, boringNextReason, boringNextLimited, boringAccept,
///     boringNextLot (in its place when the lot is full or closed), boringLoopReason, boringModeOff, boringModeAdvise,
///     boringModeControl
///     boringNextRests (what the expected diameters rest on), boringChange (two touches announce a change; its sheet:
///     boringChangeInsert, boringChangeReground, boringChangeMaterial, boringChangeNone, boringChangeCancel)
///   boringEstimates
///   boringEntry: boringEntryPrompt, boringDiameterField, boringEntryUnit, boringGaugeDue, boringEntryMessage,
///     boringChannels (which gauge is at hand, what channel of its switch measures where; its sheet: boringGauge0 …,
///     boringChannel1Depth0 …,
///     boringChannelsClose, boringChannelsForget), boringKeypad (key0…key9, keyPoint, keyBack, keyClear, keyEnter),
///     boringGauge, boringCorrect, boringUndo, boringMeasureAgain, boringConfirm (the two answers to a plausibility
///     question)
///   sheet of boringCorrect: boringMeasurementList (column 0 part, then one per depth), measurementListClose,
///     measurementListImport (see ImportForm)
///   sheet of correct / undo: see MeasurementForm
class BoringPage : public Page {
    Q_OBJECT
 public:
    explicit BoringPage(const PageContext& context, QWidget* parent = nullptr);
    ~BoringPage() override;

    /// Text for another language or look of the touched part (tests).
    [[nodiscard]] EntryPanel* entry() const { return m_entry; }

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void onServiceChanged();
    /// An overdue gauge is said where its readings are entered; which one is at hand stands beside.
    void showGaugeDue();
    void onStatus(const Status& status);
    void showNote();
    void undoLast();
    void openList();
    void openForm(PartId part, std::uint8_t depth, MeasurementId id, MeasurementForm::Start start);
    /// The identity, where a gauge of it is in the register; else empty.
    [[nodiscard]] std::string registered(const std::string& identity) const;
    /// Some gauge on a serial line can be asked; and it is, for a diameter: each that says its depth, and one of the
    /// others, which a person chooses where more than one could be meant.
    bool askGauges(bool really);
    /// Of these, the one at hand; where none is said to be, those that are made for this diameter.
    [[nodiscard]] std::vector<std::size_t> atHandOf(std::vector<std::size_t> gauges) const;
    void chooseGaugeToAsk(const std::vector<std::size_t>& gauges);
    void onGauge(const GaugeReading& reading);
    void takeUnsigned();
    void tellElsewhere(const QString& sentence);
    void openChannels();
    [[nodiscard]] std::string gaugeOn(int channel) const;
    void keepGauge(int channel, const std::string& identity);
    /// Gauges of the register that can measure this bore.
    [[nodiscard]] std::vector<Gauge> suitable() const;
    void keepChannels(const GaugeChannels& channels);
    void saveChannels();
    void acceptSchedule();
    void openChange();
    void tellChange(std::optional<BoringChange> change);
    void setMode(LoopMode mode);

    BoringService* m_service;
    std::unique_ptr<Subscription> m_subscription;
    GaugeWedge* m_wedge{nullptr};
    Card* m_boreCard{nullptr};
    BoreChart* m_bore{nullptr};
    QLabel* m_capability{nullptr};
    QLabel* m_key{nullptr};
    QLabel* m_note{nullptr};
    FeedPanel* m_feed{nullptr};
    NextPartPanel* m_next{nullptr};
    EstimatePanel* m_estimates{nullptr};
    EntryPanel* m_entry{nullptr};
    bool m_gaugeThere{false};  ///< one on a serial line can be asked
    GaugesAtHand m_gauges{};
    QLabel* m_missing{nullptr};
    QVBoxLayout* m_rows{nullptr};
    QHBoxLayout* m_top{nullptr};
    QHBoxLayout* m_bottom{nullptr};
    QVBoxLayout* m_charts{nullptr};
    struct Unsigned {
        GaugeReading reading;
        QElapsedTimer since;
    };
    std::vector<Unsigned> m_unsigned;  ///< readings that came while nobody was signed on
    std::uint32_t m_touched{0};
    std::uint64_t m_shownRevision{0};
    bool m_behind{true};
};

/// Its row in the navigation and its card on Overview.
[[nodiscard]] PageEntry boringPageEntry();

}  // namespace kerf::ui
