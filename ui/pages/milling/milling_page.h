// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "ui/pages/milling/control_panel.h"
#include "ui/pages/milling/live_panel.h"
#include "ui/pages/milling/tool_panel.h"
#include "ui/pages/milling/wall_panel.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// The milling loop: force and feed as they run, the wall they leave, the tool's wear, and what may be told the loop.
///
/// Shows what Status and MillingService say and passes on what is touched; decides nothing.
///
/// Object names, stable for tests:
///   millingPage, millingNote (what could not be stored)
///   millingLive: millingForceChart, millingForce, millingRawForce, millingFeedChart, millingFeed
///   millingWall: millingWallChart, millingWaviness, millingLastCut
///   millingTool: millingWearChart, millingStiffness, millingWear
///   millingControl: millingState, millingLoopReason, millingReference, millingMargin, millingPeak, millingSaved,
///     millingAdvice, millingLawConstant, millingLawPi, millingLawModel, millingLawPreview, millingTeach, millingStart,
///     millingRelease, millingModeOff, millingModeAdvise, millingModeControl
///   millingSetup, millingBlank, millingLog, millingNewTool, millingTools; their sheets: MillingSetupForm,
///   MillingBlankForm, openMillingCutLog()
class MillingPage : public Page {
    Q_OBJECT
 public:
    explicit MillingPage(const PageContext& context, QWidget* parent = nullptr);
    ~MillingPage() override;

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void onServiceChanged();
    void onStatus(const Status& status);
    void onSamples(std::span<const Sample> samples);
    void askNewTool();
    [[nodiscard]] QString whyNotChange() const;

    MillingService* m_service;
    std::unique_ptr<Subscription> m_subscription;
    QLabel* m_missing{nullptr};
    MillingLivePanel* m_live{nullptr};
    MillingWallPanel* m_wall{nullptr};
    MillingToolPanel* m_tool{nullptr};
    MillingControlPanel* m_control{nullptr};
    QLabel* m_note{nullptr};
    ActionButton* m_setup{nullptr};
    ActionButton* m_blank{nullptr};
    ActionButton* m_log{nullptr};
    ActionButton* m_newTool{nullptr};
    ActionButton* m_tools{nullptr};
    QHBoxLayout* m_columns{nullptr};
    QVBoxLayout* m_left{nullptr};
    QHBoxLayout* m_lower{nullptr};
    QHBoxLayout* m_buttons{nullptr};
};

/// Its row in the navigation and its card on Overview.
[[nodiscard]] PageEntry millingPageEntry();

}  // namespace kerf::ui
