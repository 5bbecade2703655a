// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPointer>

#include "ui/services/quality_service.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// The register of gauges and the guided studies, as sheets over the page. Every reading ends with Enter, as a hand
/// gauge on the keyboard line sends it; what was read last can be taken back.
///
/// Object names: gaugeList; gaugeIdentity, gaugeFrom, gaugeTo, gaugeResolution, gaugeRing, gaugeDue, gaugeSave;
/// studyTypeOne, studyCrossed, gaugeUse; studyTolerance, studyPrompt, studyReading, studyUndo, studySave
class GaugeSheets : public QObject {
    Q_OBJECT
 public:
    GaugeSheets(const PageContext& context, QualityService& service, QObject* parent);

    void openRegister();

 private:
    struct Plan {
        std::uint32_t parts{1};
        std::uint32_t persons{1};
        std::uint32_t trials{25};
        [[nodiscard]] std::size_t readings() const { return std::size_t{parts} * persons * trials; }
    };
    void openGauge(const Gauge& gauge);
    void openStudy(const Gauge& gauge, bool crossed);
    void useInRecipe(const Gauge& gauge, const QPointer<QLabel>& why);
    [[nodiscard]] QString promptFor(const GaugeStudyRecord& study, const Plan& plan, bool crossed) const;

    PageContext m_context;
    QualityService& m_service;
};

/// "due since 3 days", "due on 2026-12-01", "no date".
[[nodiscard]] QString dueText(const Gauge& gauge, std::int64_t nowUtc_ms);
/// "σ 0.0012 mm (0.0010 to 0.0015), from a study: good enough"; "no study yet".
[[nodiscard]] QString studyText(const Gauge& gauge, const UnitSystem& units);
/// What the newest study found, with its date and author; empty: no study, or one of an older version.
[[nodiscard]] QString studyFigures(const Gauge& gauge, const UnitSystem& units);
[[nodiscard]] bool isOverdue(const Gauge& gauge, std::int64_t nowUtc_ms);

}  // namespace kerf::ui
