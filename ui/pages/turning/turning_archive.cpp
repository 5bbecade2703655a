// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/turning_archive.h"

#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScroller>
#include <QTableWidget>

#include "ui/link/reason_text.h"
#include "ui/link/texts.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kRowsShown = 3;
constexpr double kPercent = 100.0;
}  // namespace

TurningArchive* TurningArchive::open(const PageContext& context, TurningService& service) {
    Sheet* sheet = context.sheets.open({});
    auto* archive = new TurningArchive(context, service, sheet);
    sheet->body()->addWidget(archive);
    archive->show();
    return archive;
}

TurningArchive::TurningArchive(const PageContext& context, TurningService& service, Sheet* sheet)
    : FaceWidget(context.look, sheet),
      m_page(context),
      m_service(service),
      m_sheet(sheet),
      m_table(new QTableWidget(this)),
      m_text(makeLabel(TextRole::Small, this, true)),
      m_spectrumTitle(makeLabel(TextRole::Dim, this)),
      m_forceTitle(makeLabel(TextRole::Dim, this)),
      m_spectrum(new SpectrumChart(context.look, this)),
      m_force(new Chart(context.look, this)),
      m_swing(m_force->addBand(Token::Past)),
      m_mean(m_force->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_charts(new QGridLayout),
      m_reason(new QLineEdit(this)),
      m_leaveOut(new QPushButton(this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_close(new QPushButton) {
    setObjectName(QStringLiteral("turningArchiveSheet"));
    m_table->setObjectName(QStringLiteral("turningArchiveTable"));
    m_text->setObjectName(QStringLiteral("turningArchiveText"));
    m_spectrum->setObjectName(QStringLiteral("turningArchiveSpectrum"));
    m_force->setObjectName(QStringLiteral("turningArchiveForce"));
    m_reason->setObjectName(QStringLiteral("turningArchiveReason"));
    m_leaveOut->setObjectName(QStringLiteral("turningArchiveLeaveOut"));
    m_message->setObjectName(QStringLiteral("turningArchiveMessage"));
    m_close->setObjectName(QStringLiteral("turningArchiveClose"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    QScroller::grabGesture(m_table->viewport(), QScroller::TouchGesture);
    m_force->setLowTitles(true);
    m_charts->addWidget(m_spectrumTitle, 0, 0);
    m_charts->addWidget(m_forceTitle, 0, 1);
    m_charts->addWidget(m_spectrum, 1, 0);
    m_charts->addWidget(m_force, 1, 1);
    m_charts->setColumnStretch(0, 3);
    m_charts->setColumnStretch(1, 2);
    m_charts->setRowStretch(1, 1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_text);
    rows->addLayout(m_charts, 1);
    auto* memory = new QHBoxLayout;
    memory->addWidget(m_reason, 1);
    memory->addWidget(m_leaveOut);
    rows->addLayout(memory);
    rows->addWidget(m_message);
    m_message->hide();
    sheet->addButton(m_close, {});
    m_table->setFocus();  // a reason is typed by who wants to, the keys are not waiting for it
    connect(m_leaveOut, &QPushButton::clicked, this, &TurningArchive::leaveOut);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showPart(row); });
    refresh();
}

void TurningArchive::refresh() {
    if (m_sheet) {
        m_sheet->setTitle(tr("Archive of turned parts"));
    }
    m_reason->setPlaceholderText(tr("Reason to leave this part out of what the next ones begin from"));
    m_close->setText(tr("Close"));
    m_spectrum->retranslate();
    m_spectrumTitle->setText(m_spectrum->axesText());
    m_forceTitle->setText(tr("force, %1, along the face, %", "unit").arg(look().units().of("N").symbol));
    m_force->setXAxis(QStringLiteral("%"), "");
    m_force->setYAxis(tr("force"), "N");
    m_force->setEmptyText(tr("This part has no force trace."));
    m_force->setAccessibleName(tr("Force along the face"));
    const int touch = look().metrics().touch();
    m_table->verticalHeader()->setDefaultSectionSize(touch);
    m_table->verticalHeader()->setMinimumSectionSize(touch);
    m_table->setMinimumHeight(kRowsShown * touch);
    m_charts->setHorizontalSpacing(look().space(Space::Large));
    m_charts->setVerticalSpacing(0);
    layout()->setSpacing(look().space(Space::Medium));
    setMinimumWidth(2 * look().metrics().sideWidth());
    fill();
    FaceWidget::refresh();
}

void TurningArchive::fill() {
    const UnitSystem& units = look().units();
    const auto titled = [&](const QString& name, const char* unit) {
        return name + QStringLiteral(", ") + units.of(unit).symbol;
    };
    const QStringList titles{tr("part"),
                             tr("ended"),
                             tr("controller"),
                             titled(tr("RMS"), "um"),
                             titled(tr("P-V"), "um"),
                             titled(tr("open", "surface without the trim"), "um"),
                             titled(tr("mean force"), "N")};
    m_table->setColumnCount(static_cast<int>(titles.size()));
    m_table->setHorizontalHeaderLabels(titles);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    const auto& parts = m_service.view().parts;
    m_table->setRowCount(static_cast<int>(parts.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const TurningPartView& part = parts[parts.size() - 1 - static_cast<std::size_t>(row)];
        const TurningRecord& record = part.record;
        const bool second = record.steadyRms_um > 0.0;
        const auto length = [&](double value_um) {
            return value_um > 0.0 ? units.number(value_um, "um", kSurfaceDecimals) : QStringLiteral("–");
        };
        const QString law = record.controlled ? controllerName(record.controller)
                            : record.leftLoop ? tr("left the loop")
                                              : tr("no control");
        const QStringList texts{
            QString::number(part.number),
            QDateTime::fromMSecsSinceEpoch(part.endedUtc_ms).toString(QStringLiteral("MM-dd HH:mm")),
            law,
            length(second ? record.steadyRms_um : record.surfaceRms_um),
            length(second ? record.steadyPv_um : record.surfacePv_um),
            length(second ? record.openSteadyRms_um : record.untreatedRms_um),
            units.number(second ? record.steadyForce_N : part.forceMean_N, "N", kForceDecimals)};
        for (int column = 0; column < static_cast<int>(texts.size()); ++column) {
            m_table->setItem(row, column, new QTableWidgetItem(texts[column]));
        }
    }
    showMemory();
    for (QWidget* one : {static_cast<QWidget*>(m_reason), static_cast<QWidget*>(m_leaveOut)}) {
        one->setVisible(m_table->rowCount() > 0);
    }
    if (m_table->rowCount() > 0) {
        m_table->setCurrentCell(std::min(m_row, m_table->rowCount() - 1), 0);
        showPart(m_table->currentRow());
    }
}

QString TurningArchive::textOf(const TurningPartView& part) const {
    const UnitSystem& units = look().units();
    const TurningRecord& record = part.record;
    QString text = tr("Part %1: %2. Touched at %3, zero %4, largest trim %5.")
                       .arg(part.number)
                       .arg(setupText(record.setup, units), units.withUnit(record.touchOff_mm, "mm", 4),
                            units.withUnit(record.forceZero_N, "N", kForceDecimals),
                            units.withUnit(record.trimPeak_um, "um", kDepthDecimals));
    if (record.identification.available) {
        const auto value = [&](std::size_t i) {
            return UnitSystem::fixed(record.identification.value[i], 4) + QStringLiteral(" ± ") +
                   UnitSystem::fixed(record.identification.half95[i], 4);
        };
        text += u' ' + tr("a₁ %1, b₀ %2, b₁ %3.").arg(value(0), value(1), value(2));
    }
    if (!part.complete) {
        text += u' ' + tr("It was not cut to the end.");
    }
    if (part.leftOut) {
        text +=
            u'\n' +
            tr("Left out by %1: %2").arg(QString::fromStdString(part.leftOutAuthor), reasonText(part.leftOutReason));
    }
    return text;
}

/// Above the table: what to touch, and what the first part after a start begins from.
void TurningArchive::showMemory() {
    if (!m_sheet) {
        return;
    }
    const TurningMemoryView& memory = m_service.view().memory;
    QString begins = tr("The first part after a start begins from the assumed process: none of this cut is sure.");
    if (memory.part) {
        begins = tr("The first part after a start begins from part %1; parts of this cut that count: %2.")
                     .arg(*memory.part)
                     .arg(memory.counted);
    } else if (memory.counted > 0) {
        begins =
            tr("The first part after a start begins from the assumed process: the parts of this cut contradict "
               "each other.");
    }
    m_sheet->setText(tr("Touch a part to see its spectrum and its force along the face.") + u' ' + begins);
}

const TurningPartView* TurningArchive::touched() const {
    const auto& parts = m_service.view().parts;
    return m_row < static_cast<int>(parts.size()) ? &parts[parts.size() - 1 - static_cast<std::size_t>(m_row)]
                                                  : nullptr;
}

void TurningArchive::leaveOut() {
    const QString reason = m_reason->text();
    const QPointer<TurningArchive> self(this);
    m_page.withPermission(Deed::TurningMemory, [self, reason] {
        if (TurningArchive* archive = self.data(); archive != nullptr) {
            archive->sendLeaveOut(reason);
        }
    });
}

void TurningArchive::sendLeaveOut(const QString& reason) {
    const TurningPartView* part = touched();
    if (part == nullptr) {
        return;
    }
    m_service.leaveOut(part->id, !part->leftOut, m_page.session.author(), reason.simplified().toStdString(),
                       [self = QPointer<TurningArchive>(this), reason](const Result<void>& done) {
                           if (TurningArchive* archive = self.data(); archive != nullptr) {
                               archive->answered(reason, done);
                           }
                       });
}

void TurningArchive::answered(const QString& reason, const Result<void>& done) {
    m_message->setText(done ? QString() : sentenceText(done.error(), look().units()));
    m_message->setVisible(!done);
    if (!done) {
        return;
    }
    if (m_reason->text() == reason) {  // else the next one is being typed
        m_reason->clear();
    }
    fill();
}

void TurningArchive::showPart(int row) {
    const auto& parts = m_service.view().parts;
    if (row < 0 || row >= static_cast<int>(parts.size())) {
        return;
    }
    m_row = row;
    const TurningPartView& part = parts[parts.size() - 1 - static_cast<std::size_t>(row)];
    m_text->setText(textOf(part));
    m_leaveOut->setText(part.leftOut ? tr("Take in again") : tr("Leave out"));
    m_spectrum->setSpectrum(part.spectrum);
    m_spectrum->setTones({part.record.tones.begin(), part.record.tones.begin() + part.record.toneCount});
    std::vector<Chart::BandPoint> swing;
    std::vector<QPointF> mean;
    for (const TurningForcePiece& piece : part.force) {
        swing.push_back({kPercent * piece.progress, piece.low_N, piece.high_N});
        mean.emplace_back(kPercent * piece.progress, piece.mean_N);
    }
    m_force->setXRange(0.0, kPercent);
    m_force->setYIncludes({0.0});
    m_force->setLimits({{part.record.forceTarget_N, tr("target"), Token::Wanted, true, false}});
    m_force->setBand(m_swing, swing);
    m_force->setPoints(m_mean, mean);
}

}  // namespace kerf::ui
