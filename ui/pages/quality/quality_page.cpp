// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/quality_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <map>

#include "db/api/lot_reader.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr std::uint32_t kMostLots = 200;
constexpr PartId kPartsAhead = 2'500;

/// The oldest part on the charts.
PartId firstShown(const LotQuality& lot, const PartWindow& window) {
    std::size_t shown = 0;
    PartId first = 0;
    for (auto part = lot.parts.rbegin(); part != lot.parts.rend() && shown < kChartParts; ++part) {
        if ((window.last == 0 || part->id <= window.last) && (!window.belongs || window.belongs(part->id))) {
            first = part->id;
            ++shown;
        }
    }
    return first;
}

}  // namespace

QualityPage::QualityPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.qualityService) {
    if (m_service == nullptr || page.services.lots == nullptr) {
        auto* column = new QHBoxLayout(this);
        m_missing = makeLabel(TextRole::Body, this, true);
        m_missing->setAlignment(Qt::AlignCenter);
        column->addWidget(m_missing, 1);
    } else {
        build();
    }
    refresh();
}

QualityPage::~QualityPage() = default;

void QualityPage::build() {
    m_gaugeSheets = new GaugeSheets(context(), *m_service, this);
    m_sheets = new QualitySheets(context(), *m_service, this);
    m_lots = new QComboBox(this);
    m_characteristics = new QComboBox(this);
    m_groups = new QComboBox(this);
    m_older = new ActionButton(look(), this);
    m_newer = new ActionButton(look(), this);
    m_sentence = makeLabel(TextRole::Title, this, true);
    m_counts = makeLabel(TextRole::Body, this, true);
    m_indices = makeLabel(TextRole::Body, this, true);
    m_gaugeNote = makeLabel(TextRole::Dim, this, true);
    m_decide = new ActionButton(look(), this);
    m_gauges = new QPushButton(this);
    m_files = new ActionButton(look(), this);
    m_limits = new ActionButton(look(), this);
    m_rules = new QPushButton(this);
    m_residualCard = new Card(look(), this);
    m_rawCard = new Card(look(), this);
    m_actionCard = new Card(look(), this);
    m_spreadCard = new Card(look(), this);
    m_residuals = new ResidualChart(look(), m_residualCard);
    m_raw = new RawChart(look(), m_rawCard);
    m_action = new ActionChart(look(), m_actionCard);
    m_spread = new SpreadChart(look(), m_spreadCard);
    m_lots->setObjectName(QStringLiteral("qualityLot"));
    m_characteristics->setObjectName(QStringLiteral("qualityCharacteristic"));
    m_groups->setObjectName(QStringLiteral("qualityGroup"));
    m_older->setObjectName(QStringLiteral("qualityOlder"));
    m_newer->setObjectName(QStringLiteral("qualityNewer"));
    m_sentence->setObjectName(QStringLiteral("qualitySentence"));
    m_counts->setObjectName(QStringLiteral("qualityCounts"));
    m_indices->setObjectName(QStringLiteral("qualityIndices"));
    m_gaugeNote->setObjectName(QStringLiteral("qualityGaugeNote"));
    m_decide->setObjectName(QStringLiteral("qualityDecide"));
    m_gauges->setObjectName(QStringLiteral("qualityGauges"));
    m_files->setObjectName(QStringLiteral("qualityFiles"));
    m_rules->setObjectName(QStringLiteral("qualityRules"));
    m_limits->setObjectName(QStringLiteral("qualityLimits"));

    m_tools = new QHBoxLayout;
    m_tools->addWidget(m_lots, 2);
    m_tools->addWidget(m_characteristics, 1);
    m_tools->addWidget(m_groups, 1);
    for (QPushButton* button : std::initializer_list<QPushButton*>{m_decide, m_gauges, m_rules, m_limits, m_files}) {
        m_tools->addWidget(button);
    }
    m_residualCard->body()->addWidget(m_residuals, 1);
    m_rawCard->body()->addWidget(m_raw, 1);
    m_actionCard->body()->addWidget(m_action, 1);
    m_spreadCard->body()->addWidget(m_spread, 1);
    m_grid = new QGridLayout(this);
    m_grid->addLayout(m_tools, 0, 0, 1, 2);
    m_grid->addWidget(m_sentence, 1, 0, 1, 2);
    m_grid->addWidget(m_counts, 2, 0);
    m_grid->addWidget(m_indices, 2, 1);
    m_pages = new QHBoxLayout;
    m_pages->addWidget(m_gaugeNote, 1);
    m_pages->addWidget(m_older);
    m_pages->addWidget(m_newer);
    m_grid->addLayout(m_pages, 3, 0, 1, 2);
    m_grid->addWidget(m_residualCard, 4, 0);
    m_grid->addWidget(m_rawCard, 4, 1);
    m_grid->addWidget(m_actionCard, 5, 0);
    m_grid->addWidget(m_spreadCard, 5, 1);
    m_grid->setRowStretch(4, 1);
    m_grid->setRowStretch(5, 1);

    m_decide->setPredicate([this] { return undecided() == nullptr ? tr("no part waits for a decision") : QString(); });
    m_files->setPredicate([this] { return whyNoFile(); });
    m_limits->setPredicate([this] {
        const LotQuality* lot = m_service->shown();
        return lot == nullptr                          ? tr("no lot is shown")
               : lot->lot.process == ProcessId::Boring ? tr("the recipe holds the limits of a bore")
                                                       : QString();
    });
    m_older->setPredicate([this]() -> QString {
        const LotQuality* lot = m_service->shown();
        if (lot == nullptr) {
            return tr("no lot is shown");
        }
        const PartId first = firstShown(*lot, window());
        const bool more = std::ranges::any_of(lot->parts, [&](const LotPart& part) { return part.id < first; });
        return more || lot->olderParts ? QString() : tr("these are the first parts");
    });
    m_newer->setPredicate([this] { return m_last == 0 ? tr("these are the newest parts") : QString(); });
    connect(m_lots, &QComboBox::activated, this, [this] {
        m_last = 0;
        m_service->show(chosenLot());
    });
    connect(m_groups, &QComboBox::activated, this, [this] { showLot(); });
    connect(m_older, &QPushButton::clicked, this, [this] { turnPage(true); });
    connect(m_newer, &QPushButton::clicked, this, [this] { turnPage(false); });
    connect(m_characteristics, &QComboBox::activated, this, &QualityPage::showCharacteristic);
    connect(m_gauges, &QPushButton::clicked, this, [this] { m_gaugeSheets->openRegister(); });
    connect(m_decide, &QPushButton::clicked, this,
            [this] { context().withPermission(Deed::QualityDecision, [this] { decide(); }); });
    connect(m_files, &QPushButton::clicked, this, [this] { m_sheets->openFiles(); });
    connect(m_rules, &QPushButton::clicked, this, [this] { m_sheets->openRules(); });
    connect(m_limits, &QPushButton::clicked, this, [this] { m_sheets->openLimits(m_service->shown()->lot.process); });
    m_service->onChanged([this] {
        if (isVisible()) {
            showLot();
        }
    });
    if (context().services.boringService != nullptr) {
        m_bores = context().services.boringService->onChanged([this] {
            if (isVisible() && m_lots->currentIndex() >= 0 && m_last == 0) {
                m_service->show(chosenLot());
            }
        });
    }
}

void QualityPage::refresh() {
    setObjectName(QStringLiteral("qualityPage"));
    if (m_missing != nullptr) {
        m_missing->setText(tr("This console has no database, so there is no quality to show."));
        Page::refresh();
        return;
    }
    const int gap = look().space(Space::Medium);
    m_grid->setContentsMargins(gap, gap, gap, gap);
    m_grid->setSpacing(gap);
    m_tools->setSpacing(look().metrics().touchGap());
    m_pages->setSpacing(look().metrics().touchGap());
    m_older->setText(tr("Older"));
    m_newer->setText(tr("Newer"));
    m_older->setAccessibleName(tr("Older parts"));
    m_newer->setAccessibleName(tr("Newer parts"));
    m_groups->setAccessibleName(tr("Parts of one tool, person or gauge"));
    m_decide->setText(tr("Decide"));
    m_gauges->setText(tr("Gauges"));
    m_files->setText(tr("Reports"));
    m_limits->setText(tr("Limits"));
    m_rules->setText(tr("Rules"));
    m_residualCard->setTitle(tr("Error against the law"));
    m_rawCard->setTitle(tr("Measured, with tolerance"));
    m_actionCard->setTitle(tr("What the controller does"));
    m_spreadCard->setTitle(tr("Spread"));
    m_residuals->retranslate();
    m_raw->retranslate();
    m_action->retranslate();
    m_spread->retranslate();
    listLots();
    showLot();
    Page::refresh();
}

void QualityPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_lots != nullptr) {
        listLots();
        if (m_lots->currentIndex() >= 0) {
            m_last = 0;
            m_service->show(chosenLot());
        }
    }
}

LotId QualityPage::chosenLot() const {
    return m_lots->currentData().toLongLong();
}

PartWindow QualityPage::window() const {
    PartWindow window{m_last, {}};
    const LotQuality* lot = m_service->shown();
    const QVariant chosen = m_groups->currentData();
    if (lot != nullptr && chosen.isValid()) {
        const std::size_t group = chosen.toULongLong();
        window.belongs = [lot, group](PartId id) {
            const auto part = std::ranges::lower_bound(lot->parts, id, {}, &LotPart::id);
            return part != lot->parts.end() && part->id == id &&
                   std::ranges::find(part->groups, group) != part->groups.end();
        };
    }
    return window;
}

void QualityPage::listGroups(const LotQuality& lot) {
    const QString chosen = m_groups->currentText();
    const QSignalBlocker quietly(m_groups);
    m_groups->clear();
    m_groups->addItem(tr("all parts"));
    for (std::size_t i = 0; i < lot.groups.size(); ++i) {
        m_groups->addItem(groupName(lot.groups[i]), QVariant::fromValue(static_cast<qulonglong>(i)));
    }
    m_groups->setCurrentIndex(std::max(0, m_groups->findText(chosen)));
}

// A page of the charts; what lies outside the parts that were read is read on the worker.
void QualityPage::turnPage(bool older) {
    const LotQuality* lot = m_service->shown();
    if (lot == nullptr || lot->parts.empty()) {
        return;
    }
    const auto& parts = lot->parts;
    const auto at = [&](PartId id) {
        return static_cast<std::size_t>(std::ranges::lower_bound(parts, id, {}, &LotPart::id) - parts.begin());
    };
    if (older) {
        const std::size_t first = at(firstShown(*lot, window()));
        m_last = first > 0 ? parts[first - 1].id : parts.front().id - 1;
        if (first < kChartParts && lot->olderParts) {
            m_service->showUpTo(chosenLot(), m_last);
        }
    } else {
        const std::size_t next = at(m_last) + kChartParts;
        if (next < parts.size()) {
            m_last = parts[next].id;
        } else if (lot->newerParts) {  // some pages on, so that the next ones are there without reading
            m_last += kChartParts;
            m_service->showUpTo(chosenLot(), parts.back().id + kPartsAhead);
        } else {
            m_last = 0;
        }
    }
    showLot();
}

void QualityPage::listLots() {
    const auto lots = context().services.lots->lots(std::nullopt, kMostLots);
    const QVariant chosen = m_lots->currentData();
    const QSignalBlocker quietly(m_lots);
    m_lots->clear();
    for (const LotRow& lot : lots ? *lots : std::vector<LotRow>{}) {
        m_lots->addItem(
            tr("%1: lot %2").arg(QString::fromStdString(lot.partTypeName), QString::fromStdString(lot.name)),
            QVariant::fromValue(static_cast<qlonglong>(lot.id)));
    }
    std::map<PartTypeId, int> count;
    for (const LotRow& lot : lots ? *lots : std::vector<LotRow>{}) {
        if (++count[lot.partType] == 2) {
            m_lots->addItem(tr("%1: all lots").arg(QString::fromStdString(lot.partTypeName)),
                            QVariant::fromValue(static_cast<qlonglong>(allLotsOf(lot.partType))));
        }
    }
    for (const ProcessDescriptor* process : processes()) {
        if (!process->partResults.empty()) {
            m_lots->addItem(tr("%1: newest parts").arg(processName(process->id)),
                            QVariant::fromValue(static_cast<qlonglong>(partsWithoutLot(process->id))));
        }
    }
    m_lots->setCurrentIndex(std::max(0, m_lots->findData(chosen)));
}

void QualityPage::showLot() {
    const LotQuality* lot = m_service->shown();
    if (!m_service->problem().empty()) {
        m_sentence->setText(sentenceText(m_service->problem(), look().units()));
    } else if (lot == nullptr) {
        m_sentence->setText(m_service->reading() ? tr("The lot is being read.") : tr("Choose a lot."));
    } else {
        m_sentence->setText(sentenceText(lot->sentence, look().units()));
    }
    if (lot != nullptr) {
        QString counts = tr("%1 good, %2 rework possible, %3 scrap, %4 not judged")
                             .arg(lot->good)
                             .arg(lot->rework)
                             .arg(lot->scrap)
                             .arg(lot->notJudged);
        if ((lot->olderParts || lot->newerParts) && !lot->parts.empty()) {
            counts = tr("Parts %1 to %2: %3", "of a lot that is larger than what is read at once")
                         .arg(lot->parts.front().number)
                         .arg(lot->parts.back().number)
                         .arg(counts);
        }
        m_counts->setText(counts);
        const int chosen = std::max(0, m_characteristics->currentIndex());
        const QSignalBlocker quietly(m_characteristics);
        m_characteristics->clear();
        for (const Characteristic& characteristic : lot->characteristics) {
            m_characteristics->addItem(characteristicName(characteristic));
        }
        m_characteristics->setCurrentIndex(std::min(chosen, m_characteristics->count() - 1));
        listGroups(*lot);
        m_residuals->setLot(*lot, window());
        m_action->setLot(*lot, window());
        showCharacteristic();
    }
    QStringList notes;
    const std::int64_t now_ms = QDateTime::currentMSecsSinceEpoch();
    if (lot != nullptr && lot->gaugeSigma_mm > 0.0) {
        const auto same = std::ranges::find_if(m_service->gauges(), [&](const Gauge& gauge) {
            return gauge.sigma_mm && std::abs(*gauge.sigma_mm - lot->gaugeSigma_mm) < 1e-9 * lot->gaugeSigma_mm + 1e-9;
        });
        const QString sigma = look().units().withUnit(lot->gaugeSigma_mm, "mm", 4);
        notes << (same == m_service->gauges().end()
                      ? withParticles(
                            tr("The estimator takes σ %1 for the gauge: typed in the recipe, not from a study.")
                                .arg(sigma))
                      : tr("The estimator takes σ %1 for the gauge, from the study of %2 (%3 to %4).")
                            .arg(sigma, QString::fromStdString(same->identity),
                                 look().units().number(same->sigmaLow_mm, "mm", 4),
                                 look().units().number(same->sigmaHigh_mm, "mm", 4)));
    }
    for (const Gauge& gauge : m_service->gauges()) {
        if (isOverdue(gauge, now_ms)) {
            notes << tr("Gauge %1 is %2.").arg(QString::fromStdString(gauge.identity), dueText(gauge, now_ms));
        }
    }
    m_gaugeNote->setText(notes.join(u' '));
    const bool pages = lot != nullptr && (lot->parts.size() > kChartParts || lot->olderParts || lot->newerParts);
    m_older->setVisible(pages);  // what fits on the charts needs none
    m_newer->setVisible(pages);
    m_older->reconsider();
    m_newer->reconsider();
    m_decide->reconsider();
    m_files->reconsider();
    m_limits->reconsider();
}

void QualityPage::showCharacteristic() {
    const LotQuality* lot = m_service->shown();
    const int chosen = m_characteristics->currentIndex();
    if (lot == nullptr) {
        return;
    }
    const auto at = static_cast<std::size_t>(std::max(0, chosen));
    m_raw->setLot(*lot, at, window());
    m_spread->setLot(*lot, at, window());
    const QVariant group = m_groups->currentData();
    const auto& capability =
        group.isValid() ? lot->groups[static_cast<std::size_t>(group.toULongLong())].capability : lot->capability;
    m_indices->setText(at < capability.size() ? capabilityText(capability[at], look().units()) : QString());
}

const LotPart* QualityPage::undecided() const {
    const LotQuality* lot = m_service->shown();
    if (lot == nullptr) {
        return nullptr;
    }
    const auto waits = [this](const LotPart& part) {
        const bool bad =
            part.judgement.verdict == quality::Verdict::Scrap || part.judgement.verdict == quality::Verdict::Rework;
        return bad && !m_service->dispositions().contains(part.id);
    };
    const auto found = std::ranges::find_if(lot->parts, waits);
    return found == lot->parts.end() ? nullptr : &*found;
}

void QualityPage::decide() {
    const LotPart* part = undecided();
    if (part == nullptr) {
        return;
    }
    Sheet* sheet = context().sheets.open(
        tr("Part %1 is out of tolerance: %2").arg(part->number).arg(verdictText(part->judgement.verdict)),
        tr("What was done with it?"));
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto answer = [this, sheet, id = part->id](const QString& text, const char* what, const char* name) {
        QPushButton* button = sheet->addButton(text, [this, id, what] {
            m_service->dispose(id, what, context().session.name().toStdString(), [this](const Result<void>& done) {
                if (!done) {
                    context().notify(tr("Not stored: %1").arg(sentenceText(done.error(), look().units())));
                }
            });
        });
        button->setObjectName(QLatin1String(name));
    };
    if (part->judgement.verdict == quality::Verdict::Rework) {
        answer(tr("Cut again"), KERF_TEXT("reworked"), "decideReworked");
    }
    answer(tr("Scrapped"), KERF_TEXT("scrapped"), "decideScrapped");
    answer(tr("Accepted under concession"), KERF_TEXT("accepted under concession"), "decideAccepted");
}

QString QualityPage::whyNoFile() const {
    const LotQuality* lot = m_service->shown();
    return lot == nullptr ? tr("no lot is shown") : partTypeOfAllLots(lot->lot.id) ? tr("choose one lot") : QString();
}

}  // namespace kerf::ui
