// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/parts/part_detail_panel.h"

#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QScroller>
#include <algorithm>

#include "ui/link/reason_text.h"
#include "ui/link/texts.h"
#include "ui/link/verdict_text.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kDecimals = 3;
constexpr int kCurvePoints = 48;

/// The row counts: it is a diameter that nothing has replaced.
bool holds(const std::vector<MeasurementRow>& rows, const MeasurementRow& row) {
    return row.kind != MeasurementKind::Void &&
           std::none_of(rows.begin(), rows.end(), [&row](const MeasurementRow& r) { return r.replaces == row.id; });
}

}  // namespace

PartDetailPanel::PartDetailPanel(Look& look, std::function<QString()> whyNoChange, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_whyNoChange(std::move(whyNoChange)),
      m_facts(makeLabel(TextRole::Body, this, true)),
      m_feedTitle(makeLabel(TextRole::Small, this)),
      m_chart(new Chart(look, this)),
      m_schedule(m_chart->addCurve({Token::Wanted, Chart::Kind::Dashed, Chart::Marker::Disc, Stroke::Normal})),
      m_cut(m_chart->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_history(new QTableWidget(this)),
      m_correct(new ActionButton(look, this)),
      m_void(new ActionButton(look, this)),
      m_serial(new ActionButton(look, this)),
      m_report(new ActionButton(look, this)),
      m_buttons(new QHBoxLayout) {
    setObjectName(QStringLiteral("partDetail"));
    m_facts->setObjectName(QStringLiteral("partFacts"));
    m_chart->setObjectName(QStringLiteral("partFeedChart"));
    m_history->setObjectName(QStringLiteral("partMeasurements"));
    m_correct->setObjectName(QStringLiteral("partCorrect"));
    m_void->setObjectName(QStringLiteral("partVoid"));
    m_chart->setLowTitles(true);
    m_chart->setYIncludes({0.0});
    m_history->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_history->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_history->setSelectionMode(QAbstractItemView::SingleSelection);
    m_history->setWordWrap(true);
    m_history->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_history->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_history->verticalHeader()->hide();
    QScroller::grabGesture(m_history->viewport(), QScroller::TouchGesture);
    body()->addWidget(m_facts);
    body()->addWidget(m_feedTitle);
    body()->addWidget(m_chart, 2);
    body()->addWidget(m_history, 3);
    m_buttons->addWidget(m_correct, 1);
    m_buttons->addWidget(m_void, 1);
    m_buttons->addWidget(m_serial, 1);
    m_buttons->addWidget(m_report, 1);
    m_serial->setObjectName(QStringLiteral("partSerial"));
    m_report->setObjectName(QStringLiteral("partReport"));
    m_serial->setPredicate([this] {
        return !m_canSerial ? tr("no database") : m_part ? QString() : tr("no part chosen");
    });
    m_report->setPredicate([this] {
        return !m_canReport ? tr("no database") : m_part ? QString() : tr("no part chosen");
    });
    connect(m_serial, &QPushButton::clicked, this, &PartDetailPanel::serialRequested);
    connect(m_report, &QPushButton::clicked, this, &PartDetailPanel::reportRequested);
    body()->addLayout(m_buttons);
    m_correct->setPredicate([this] { return whyNot(); });
    m_void->setPredicate([this] { return whyNot(); });
    connect(m_history, &QTableWidget::itemSelectionChanged, this, [this] {
        m_correct->reconsider();
        m_void->reconsider();
    });
    connect(m_correct, &QPushButton::clicked, this, [this] {
        if (const MeasurementRow* row = chosen()) {
            emit correctRequested(*row);
        }
    });
    connect(m_void, &QPushButton::clicked, this, [this] {
        if (const MeasurementRow* row = chosen()) {
            emit voidRequested(*row);
        }
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void PartDetailPanel::retranslate() {
    m_chart->setXAxis(tr("overhang"), "mm");
    m_chart->setYAxis(tr("feed"), "mm/rev");
    m_feedTitle->setText(tr("feed, %1", "unit").arg(m_look.units().of("mm/rev").symbol));
    m_chart->setCurveLabel(m_schedule, tr("schedule"));
    m_chart->setCurveLabel(m_cut, tr("cut"));
    m_correct->setText(tr("Correct"));
    m_void->setText(tr("Take out"));
    m_serial->setText(tr("Serial"));
    m_report->setText(tr("Report"));
    m_buttons->setSpacing(m_look.metrics().touchGap());
    m_history->verticalHeader()->setMinimumSectionSize(m_look.metrics().touch());
    m_history->verticalHeader()->setDefaultSectionSize(m_look.metrics().touch());
    showPart();
}

void PartDetailPanel::show(const std::optional<PartDetail>& part) {
    m_part = part;
    m_problem = {};
    showPart();
}

void PartDetailPanel::showProblem(const Sentence& problem) {
    m_part.reset();
    m_problem = problem;
    showPart();
}

void PartDetailPanel::showPart() {
    std::vector<QPointF> wanted;
    std::vector<QPointF> cut;
    m_chart->setEmptyText(m_part ? tr("No course of the feed is kept for this part.")
                                 : tr("The feed of the part appears here when one is chosen."));
    if (!m_part) {
        setTitle(tr("No part chosen"));
        m_facts->setText(m_problem.empty() ? tr("Touch a row of the table.") : sentenceText(m_problem, m_look.units()));
    } else {
        const PartRow& row = m_part->part;
        setTitle(row.lotName.empty() ? tr("%1, part %2").arg(processName(row.process)).arg(row.number)
                                     : tr("Part %1, lot %2").arg(row.number).arg(QString::fromStdString(row.lotName)));
        QStringList facts;
        if (!row.partTypeName.empty()) {
            facts << QString::fromStdString(row.partTypeName);
        }
        facts << QDateTime::fromMSecsSinceEpoch(row.endedUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        const double time_s = static_cast<double>(row.machineEnd_ns - row.machineBegin_ns) * 1e-9;
        facts << tr("cut in %1 s").arg(UnitSystem::fixed(time_s, 0));
        if (!row.serial.empty()) {
            facts << tr("serial %1").arg(QString::fromStdString(row.serial));
        }
        if (!row.complete) {
            facts << tr("aborted");
        }
        if (m_judge) {
            m_judgement = m_judge(row);
            facts << verdictText(m_judgement.verdict);
        }
        if (std::any_of(m_part->states.begin(), m_part->states.end(), [](const auto& s) { return s.perturbed; })) {
            facts << tr("process change noticed");
        }
        for (const PartFigure& figure : row.figures) {
            facts << figureText(row.process, figure, m_look.units());
        }
        m_facts->setText(facts.join(QStringLiteral(" · ")));
        if (m_part->schedule) {
            const BoringSchedule& schedule = m_part->schedule->schedule;
            m_chart->setXRange(std::min(schedule.overhangFrom_mm, schedule.overhangTo_mm),
                               std::max(schedule.overhangFrom_mm, schedule.overhangTo_mm));
            for (int i = 0; i < kCurvePoints; ++i) {
                const double overhang_mm =
                    schedule.overhangFrom_mm +
                    (schedule.overhangTo_mm - schedule.overhangFrom_mm) * i / (kCurvePoints - 1.0);
                wanted.emplace_back(overhang_mm, schedule.feed_mmPerRev(overhang_mm));
            }
        }
        for (std::size_t i = 0; i < m_part->feed.count; ++i) {
            cut.emplace_back(static_cast<double>(m_part->feed.overhang_mm[i]),
                             static_cast<double>(m_part->feed.feed_mmPerRev[i]));
        }
    }
    m_chart->setPoints(m_schedule, wanted);
    m_chart->setPoints(m_cut, cut);
    showHistory();
    for (ActionButton* button : {m_correct, m_void, m_serial, m_report}) {
        button->reconsider();
    }
}

void PartDetailPanel::setFileActions(bool serial, bool report) {
    m_canSerial = serial;
    m_canReport = report;
    m_serial->reconsider();
    m_report->reconsider();
}

void PartDetailPanel::showHistory() {
    m_history->clear();
    m_history->setColumnCount(4);
    m_history->setHorizontalHeaderLabels(
        {tr("depth"), tr("⌀, %1").arg(m_look.units().of("mm").symbol), tr("by, when"), tr("what, why")});
    QHeaderView* header = m_history->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(3, QHeaderView::Stretch);
    const std::vector<MeasurementRow> none;
    const std::vector<MeasurementRow>& rows = m_part ? m_part->part.measurements : none;
    m_history->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < m_history->rowCount(); ++i) {
        const MeasurementRow& row = rows[static_cast<std::size_t>(i)];
        const bool counts = holds(rows, row);
        QString what;
        switch (row.kind) {
            case MeasurementKind::Entry:
                what = sourceText(row.source, row.sourceName);
                break;
            case MeasurementKind::Correction:
                what = tr("correction") + QStringLiteral(", ") + sourceText(row.source, row.sourceName);
                break;
            case MeasurementKind::Void:
                what = tr("taken out");
                break;
        }
        if (row.confirmed) {
            what += QStringLiteral(", ") + tr("confirmed");
        }
        const bool judged = counts && row.kind != MeasurementKind::Void && row.station < m_judgement.values.size();
        if (judged && isBad(m_judgement.values[row.station].verdict)) {
            what += QStringLiteral(", ") + verdictText(m_judgement.values[row.station].verdict);
        }
        if (!row.reason.empty()) {
            what += QStringLiteral(": ") + reasonText(row.reason);
        }
        if (!counts && row.kind != MeasurementKind::Void) {
            what += QStringLiteral(" – ") + tr("no longer holds");
        }
        const QString value =
            row.diameter_mm ? m_look.units().number(*row.diameter_mm, "mm", kDecimals) : QStringLiteral("–");
        const QString when = QDateTime::fromMSecsSinceEpoch(row.acceptedUtc_ms).toString(QStringLiteral("HH:mm"));
        const QStringList cells{m_look.units().withUnit(row.position_mm, "mm", 0), value,
                                QString::fromStdString(row.author) + QStringLiteral(", ") + when, what};
        for (int column = 0; column < cells.size(); ++column) {
            auto* cell = new QTableWidgetItem(cells[column]);
            cell->setForeground(m_look.color(counts ? Token::Text : Token::Dim));
            m_history->setItem(i, column, cell);
        }
    }
    m_history->resizeRowsToContents();
    for (int i = m_history->rowCount() - 1; i >= 0; --i) {
        if (holds(rows, rows[static_cast<std::size_t>(i)])) {
            m_history->selectRow(i);  // the newest one that holds: most corrections are about it
            break;
        }
    }
}

const MeasurementRow* PartDetailPanel::chosen() const {
    const int row = m_history->currentRow();
    if (!m_part || row < 0 || row >= static_cast<int>(m_part->part.measurements.size()) ||
        m_history->selectionModel()->selectedRows().isEmpty()) {
        return nullptr;
    }
    const MeasurementRow& measurement = m_part->part.measurements[static_cast<std::size_t>(row)];
    return holds(m_part->part.measurements, measurement) ? &measurement : nullptr;
}

QString PartDetailPanel::whyNot() const {
    const QString general = m_whyNoChange ? m_whyNoChange() : QString();
    if (!general.isEmpty()) {
        return general;
    }
    if (!m_part) {
        return tr("no part chosen");
    }
    return chosen() == nullptr ? tr("choose a diameter that holds") : QString();
}

}  // namespace kerf::ui
