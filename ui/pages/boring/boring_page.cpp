// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/boring_page.h"

#include <QApplication>
#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "db/api/settings_reader.h"
#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/pages/boring/import_form.h"
#include "ui/pages/boring/lot_form.h"
#include "ui/pages/boring/measurement_list.h"
#include "ui/services/quality_service.h"
#include "ui/services/sensor_service.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr const char* kChannelsSetting = "gauge.channels";
constexpr const char* kGaugesSetting = "gauge.at_hand";
}  // namespace

BoringPage::BoringPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.boringService) {
    m_rows = new QVBoxLayout(this);
    if (m_service == nullptr) {
        m_missing = addNotice(m_rows);
    } else {
        build();
    }
    refresh();
}

BoringPage::~BoringPage() = default;

void BoringPage::build() {
    m_boreCard = new Card(look(), this);
    m_bore = new BoreChart(look(), m_boreCard);
    m_note = makeLabel(TextRole::Body, m_boreCard, true);
    m_note->setObjectName(QStringLiteral("boringNote"));
    m_key = makeLabel(TextRole::Dim, m_boreCard);
    m_capability = makeLabel(TextRole::Body, m_boreCard);
    m_capability->setObjectName(QStringLiteral("boringCapability"));
    m_boreCard->header()->addWidget(m_capability);
    m_boreCard->header()->addWidget(m_key);
    m_boreCard->body()->addWidget(m_bore, 1);
    m_boreCard->body()->addWidget(m_note);
    m_feed = new FeedPanel(look(), this);
    m_next = new NextPartPanel(look(), this);
    m_estimates = new EstimatePanel(look(), this);
    if (QualityService* quality = context().services.qualityService; quality != nullptr) {
        quality->onChanged([page = QPointer<BoringPage>(this)] {
            if (page) {
                page->showGaugeDue();
            }
        });
    }
    m_entry = new EntryPanel(look(), *m_service,
                             {[this] { return context().session.author(); }, context().withOperator,
                              [this](int channel) { return gaugeOn(channel); }},
                             this);

    m_entry->setAskGauges([this](bool really) { return askGauges(really); });

    m_top = new QHBoxLayout;
    m_bottom = new QHBoxLayout;
    m_charts = new QVBoxLayout;
    m_charts->addWidget(m_boreCard, 5);
    m_charts->addWidget(m_feed, 4);
    m_top->addLayout(m_charts, 1);
    m_top->addWidget(m_next);
    m_bottom->addWidget(m_estimates, 2);
    m_bottom->addWidget(m_entry, 3);
    m_rows->addLayout(m_top, 1);
    m_rows->addLayout(m_bottom);

    connect(m_bore, &BoreChart::partTouched, this, [this](std::uint32_t number) {
        m_touched = number;
        showNote();
    });
    connect(m_next, &NextPartPanel::modeRequested, this,
            [this](LoopMode mode) { context().withPermission(Deed::SwitchLoop, [this, mode] { setMode(mode); }); });
    connect(m_next, &NextPartPanel::lotsRequested, this, [this] { LotForm::open(context()); });
    m_next->setSession(context().session);
    connect(m_next, &NextPartPanel::acceptRequested, this,
            [this] { context().withOperator([this] { acceptSchedule(); }); });
    connect(m_next, &NextPartPanel::changeRequested, this,
            [this] { context().withOperator([this] { openChange(); }); });
    connect(m_entry, &EntryPanel::undoRequested, this, [this] { context().withOperator([this] { undoLast(); }); });
    connect(m_entry, &EntryPanel::measurementsRequested, this, &BoringPage::openList);
    connect(m_entry, &EntryPanel::attentionNeeded, this, [this] {
        if (!isVisible()) {
            context().showPage("boring");
        }
    });
    m_next->setLotsThere(context().services.boringLots != nullptr);
    EngineClient& client = context().client;
    connect(&client, &EngineClient::statusChanged, this, &BoringPage::onStatus);
    connect(&client, &EngineClient::samplesArrived, m_feed, &FeedPanel::addSamples);

    m_wedge = new GaugeWedge(this);
    qApp->installEventFilter(m_wedge);
    connect(m_wedge, &GaugeWedge::reading, this, &BoringPage::onGauge);
    connect(m_wedge, &GaugeWedge::repeated, m_entry, &EntryPanel::tellRepeated);
    connect(m_wedge, &GaugeWedge::halved, m_entry, &EntryPanel::tellHalved);
    connect(m_wedge, &GaugeWedge::numLockOff, m_entry, &EntryPanel::tellNumLockOff);
    connect(m_entry, &EntryPanel::gaugeTold, this, &BoringPage::tellElsewhere);
    connect(m_entry, &EntryPanel::channelsRequested, this, &BoringPage::openChannels);
    connect(&this->context().session, &OperatorSession::changed, this, [this] {
        if (this->context().session.signedOn()) {
            takeUnsigned();
        }
    });
    const Services& services = context().services;
    GaugeChannels channels;
    if (services.settings != nullptr) {
        if (const auto text = services.settings->setting(kChannelsSetting); text && *text) {
            channels = GaugeChannels::fromText(QString::fromStdString(**text));
        }
    }
    if (services.settings != nullptr) {
        if (const auto text = services.settings->setting(kGaugesSetting); text && *text) {
            m_gauges = GaugesAtHand::fromText(QString::fromStdString(**text));
        }
    }
    m_entry->setChannels(channels);
    connect(m_entry, &EntryPanel::channelLearnt, this, [this] { saveChannels(); });

    m_subscription = m_service->onChanged([this] { onServiceChanged(); });
}

void BoringPage::refresh() {
    setObjectName(QStringLiteral("boringPage"));
    const int gap = look().space(Space::Medium);
    const int edge = look().space(Space::Small);  // inch in Korean needs the height at 1280 × 800
    m_rows->setContentsMargins(gap, edge, gap, edge);
    m_rows->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(tr("No boring lot is open on this machine. The page fills as soon as one is."));
    } else {
        for (QBoxLayout* row : std::initializer_list<QBoxLayout*>{m_top, m_bottom, m_charts}) {
            row->setSpacing(gap);
        }
        m_next->setFixedWidth(look().metrics().sideWidth());
        m_bore->retranslate();
        m_behind = true;
        onServiceChanged();
    }
    Page::refresh();
}

void BoringPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_entry != nullptr) {
        showGaugeDue();
        m_entry->field()->setFocus();
    }
    if (m_behind) {
        onServiceChanged();
    }
}

void BoringPage::showGaugeDue() {
    QStringList notes;
    const std::int64_t now_ms = QDateTime::currentMSecsSinceEpoch();
    const std::vector<Gauge> gauges = suitable();
    for (const Gauge& gauge : gauges) {
        if (gauge.dueUtc_ms > 0 && now_ms > gauge.dueUtc_ms) {
            notes << tr("Gauge %1 is overdue since %2: have it checked before you rely on it.")
                         .arg(QString::fromStdString(gauge.identity),
                              QDateTime::fromMSecsSinceEpoch(gauge.dueUtc_ms).toString(QStringLiteral("yyyy-MM-dd")));
        }
    }
    m_entry->setGaugeNote(notes.join(u' '));
    m_entry->setGaugesThere(!gauges.empty());
}

void BoringPage::onServiceChanged() {
    if (m_service == nullptr) {
        return;
    }
    const BoringServiceView& view = m_service->view();
    showGaugeDue();
    m_entry->refreshView();  // also while hidden: a gauge enters from any page
    m_behind = !isVisible();
    if (m_behind && m_shownRevision != 0) {
        return;
    }
    m_shownRevision = view.revision;
    m_boreCard->setTitle(tr("Bore ⌀, %1 – last 25 parts of lot %2", "unit, lot")
                             .arg(look().units().of("mm").symbol, QString::fromStdString(view.lot)));
    m_bore->setView(view);
    m_key->setText(m_bore->key());
    const auto& capable = view.capability;
    m_capability->setVisible(capable.has_value());
    if (capable && capable->depth < view.depths.size()) {
        m_capability->setText(tr("Cpk %1 (%2)", "figure, depth")
                                  .arg(UnitSystem::fixed(capable->cpk, 2), depthName(view.depths[capable->depth])));
    }
    m_feed->setView(view);
    m_next->setView(view);
    m_estimates->setView(view);
    if (auto* list = context().sheets.findChild<MeasurementList*>()) {
        list->refreshView();
    }
    showNote();
}

void BoringPage::onStatus(const Status& status) {
    if (const auto& nextFrame = context().services.nextGaugeFrame) {
        while (const std::optional<GaugeLineFrame> frame = nextFrame()) {
            if (std::optional<GaugeReading> reading = parseGaugeFrame(frame->frame)) {
                reading->depth = frame->depth;
                reading->gauge = registered(frame->gauge);
                onGauge(*reading);
            }
        }
    }
    if (!isVisible()) {
        return;
    }
    if (const bool there = askGauges(false); there != m_gaugeThere) {  // plugged in or out
        m_gaugeThere = there;
        m_entry->reconsiderGauge();
    }
    m_feed->setStatus(status);
    m_next->setLoop(status.loops[static_cast<std::size_t>(ProcessId::Boring)]);
}

void BoringPage::showNote() {
    const BoringServiceView& view = m_service->view();
    QString text;
    if (!view.storeProblem.empty()) {
        text = tr("Nothing can be stored at the moment: %1").arg(sentenceText(view.storeProblem, look().units()));
    } else {
        for (const BorePartView& part : view.parts) {
            if (part.number != m_touched) {
                continue;
            }
            QStringList values;
            for (std::size_t depth = 0; depth < view.depths.size(); ++depth) {
                const BoreMeasurementView* m = measurementAt(part, static_cast<std::uint8_t>(depth));
                QString value =
                    m != nullptr ? look().units().number(m->diameter_mm, "mm", kDiameterDecimals) : QStringLiteral("–");
                if (m != nullptr && m->corrected) {
                    value = tr("%1 (corrected)").arg(value);
                }
                if (depth < part.predicted.size() && part.predicted[depth]) {
                    value =
                        tr("%1, expected %2 ± %3", "diameter, prediction, half interval")
                            .arg(value,
                                 look().units().number(part.predicted[depth]->diameter_mm, "mm", kDiameterDecimals),
                                 look().units().difference(part.predicted[depth]->half95_mm, "mm", kDiameterDecimals));
                }
                values << depthName(view.depths[depth]) + u' ' + value;
            }
            text = tr("Part %1: %2 %3.", "number, diameters, unit")
                       .arg(part.number)
                       .arg(values.join(QStringLiteral("; ")), look().units().of("mm").symbol);
            if (part.perturbed) {
                text += u' ' + sentenceText(part.perturbedReason, look().units());
            }
        }
    }
    m_note->setText(text);
    m_note->setVisible(!text.isEmpty());
}

void BoringPage::undoLast() {
    const LastMeasurement last = lastMeasurement(m_service->view());
    if (last.measurement != nullptr) {
        openForm(last.part->id, last.measurement->depth, last.measurement->id, MeasurementForm::Start::Void);
    }
}

void BoringPage::openForm(PartId id, std::uint8_t depth, MeasurementId measurement, MeasurementForm::Start start) {
    const BoringServiceView& view = m_service->view();
    const BorePartView* part = findPart(view, id);
    if (part == nullptr || depth >= view.depths.size()) {
        return;
    }
    MeasurementSubject subject;
    subject.id = measurement;
    subject.place = placeName(part->number, view.depths[depth]);
    subject.expected_mm = view.targetDiameter_mm;
    subject.settingRing_mm = view.settingRing_mm;
    for (const BoreMeasurementView& m : part->measurements) {
        if (m.id == measurement) {
            subject.diameter_mm = m.diameter_mm;
        }
    }
    MeasurementForm::open(
        context().sheets, look(), *m_service, [this] { return context().session.author(); }, subject, start,
        context().notify);
}

void BoringPage::openList() {
    Sheet* sheet = context().sheets.open(tr("Diameters of this lot"),
                                         tr("Touch a value to correct or take it out, an empty place to enter it."));
    auto* list = new MeasurementList(look(), *m_service, sheet);
    sheet->body()->addWidget(list);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("measurementListClose"));
    if (context().services.readBores) {
        sheet
            ->addButton(
                tr("From a file"), [this] { context().withOperator([this] { ImportForm::open(context()); }); }, false)
            ->setObjectName(QStringLiteral("measurementListImport"));
    }
    connect(list, &MeasurementList::measurementTouched, this, [this](qint64 part, int depth, qint64 measurement) {
        context().withOperator([this, part, depth, measurement] {
            openForm(part, static_cast<std::uint8_t>(depth), measurement, MeasurementForm::Start::Correct);
        });
    });
    connect(list, &MeasurementList::openPlaceTouched, this, [this, sheet](qint64 part, int depth) {
        sheet->close();
        m_entry->choose(part, static_cast<std::uint8_t>(depth));
    });
}

void BoringPage::onGauge(const GaugeReading& reading) {
    // A value is being corrected, on whatever page: the gauge means that one.
    if (const Sheet* sheet = context().sheets.waiting()) {
        if (auto* form = sheet->findChild<MeasurementForm*>()) {
            form->takeGauge(reading, m_entry->gaugeOf(reading));
            context().notify(form->message());
            return;
        }
        // A study of the gauge itself: its field takes the reading as typed.
        for (QLineEdit* field : sheet->findChildren<QLineEdit*>()) {
            if (field->property("takesReadings").toBool() && field->isVisibleTo(sheet)) {
                const double value_mm = judgeReading(reading, 0.0, LengthUnit::Millimetre).value_mm;
                field->setText(QString::number(value_mm, 'g', 12));
                QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, QStringLiteral("\r"));
                QCoreApplication::sendEvent(field, &enter);
                return;
            }
        }
    }
    if (context().session.signedOn()) {
        m_entry->takeGauge(reading);
        return;
    }
    m_unsigned.push_back({reading, {}});
    m_unsigned.back().since.start();
    context().notify(tr("The gauge sent %1: it is taken when somebody signs on.").arg(reading.frame));
    if (context().sheets.current() == nullptr) {  // else somebody types in one, perhaps his name
        context().withOperator([this] { takeUnsigned(); });
    }
}

void BoringPage::takeUnsigned() {
    constexpr qint64 kStale_ms = 60'000;  // by then another part may lie in the gauge
    std::vector<Unsigned> waiting;
    waiting.swap(m_unsigned);
    for (const Unsigned& one : waiting) {
        if (one.since.elapsed() < kStale_ms) {
            m_entry->takeGauge(one.reading);
        } else {
            m_entry->tellLeftOut(tr("The gauge sent %1 a while ago: left out, measure again.").arg(one.reading.frame));
        }
    }
}

void BoringPage::tellElsewhere(const QString& sentence) {
    if (!isVisible() || context().sheets.current() != nullptr) {
        context().notify(sentence);
    }
}

void BoringPage::openChannels() {
    Sheet* sheet = context().sheets.open(tr("Gauges"),
                                         tr("Which gauge sends the readings: it is kept with each value. Which channel "
                                            "of a gauge's switch measures at which depth."));
    const auto& depths = m_service->view().depths;
    const std::vector<Gauge> gauges = suitable();
    auto* grid = new QGridLayout;
    grid->setSpacing(look().metrics().touchGap());
    int row = 0;
    const auto choice = [&](int channel) {
        auto* box = new QComboBox(sheet);
        box->setObjectName(QStringLiteral("boringGauge%1").arg(channel));
        box->setAccessibleName(tr("Gauge"));
        box->addItem(tr("not said"), QString());
        for (const Gauge& gauge : gauges) {
            const QString identity = QString::fromStdString(gauge.identity);
            box->addItem(identity, identity);
        }
        box->setCurrentIndex(std::max(0, box->findData(QString::fromStdString(gaugeOn(channel)))));
        connect(box, &QComboBox::activated, this,
                [this, box, channel] { keepGauge(channel, box->currentData().toString().toStdString()); });
        return box;
    };
    if (!gauges.empty()) {
        auto* label = makeLabel(TextRole::Body, sheet);
        label->setText(tr("Gauge at hand"));
        grid->addWidget(label, row, 0);
        grid->addWidget(choice(GaugesAtHand::kNoChannel), row, 1, 1, std::max(1, static_cast<int>(depths.size())));
        ++row;
    }
    for (const auto& [channel, its] : m_entry->channels().all()) {
        auto* label = makeLabel(TextRole::Body, sheet);
        label->setText(tr("Channel %1").arg(channel));
        grid->addWidget(label, row, 0);
        for (std::size_t depth = 0; depth < depths.size(); ++depth) {
            auto* button = new QPushButton(depthName(depths[depth]), sheet);
            button->setObjectName(QStringLiteral("boringChannel%1Depth%2").arg(channel).arg(depth));
            button->setCheckable(true);
            button->setChecked(depth == its);
            connect(button, &QPushButton::clicked, this, [this, channel = channel, depth] {
                GaugeChannels now = m_entry->channels();
                now.set(channel, static_cast<std::uint8_t>(depth));
                keepChannels(now);
                openChannels();
            });
            grid->addWidget(button, row, static_cast<int>(depth) + 1);
        }
        if (!gauges.empty()) {
            grid->addWidget(choice(channel), row, static_cast<int>(depths.size()) + 1);
        }
        ++row;
    }
    sheet->body()->addLayout(grid);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("boringChannelsClose"));
    if (!m_entry->channels().all().empty()) {
        sheet->addButton(tr("Learn the channels anew"), [this] { keepChannels({}); })
            ->setObjectName(QStringLiteral("boringChannelsForget"));
    }
}

std::vector<Gauge> BoringPage::suitable() const {
    const QualityService* quality = context().services.qualityService;
    std::vector<Gauge> gauges = quality != nullptr ? quality->gauges() : std::vector<Gauge>{};
    const double target_mm = m_service->view().targetDiameter_mm;
    std::erase_if(gauges, [target_mm](const Gauge& gauge) {
        return target_mm < gauge.rangeFrom_mm || target_mm > gauge.rangeTo_mm;
    });
    return gauges;
}

std::string BoringPage::gaugeOn(int channel) const {
    return m_gauges.of(channel, suitable(), m_service->view().targetDiameter_mm);
}

std::string BoringPage::registered(const std::string& identity) const {
    const QualityService* quality = context().services.qualityService;
    const std::vector<Gauge> gauges = quality != nullptr ? quality->gauges() : std::vector<Gauge>{};
    return std::ranges::find(gauges, identity, &Gauge::identity) != gauges.end() ? identity : std::string();
}

bool BoringPage::askGauges(bool really) {
    SensorService* sensors = context().services.sensorService;
    std::vector<std::size_t> anywhere;  // whose reading is of the bore that waits, whichever that is
    bool there = false;
    for (std::size_t i = 0; sensors != nullptr && i < sensors->view().gauges.size(); ++i) {
        const SensorGaugeView& gauge = sensors->view().gauges[i];
        if (!gauge.connected || !gauge.canAsk) {
            continue;
        }
        there = true;
        if (!gauge.saysDepth) {
            anywhere.push_back(i);
        } else if (really) {
            sensors->askGauge(i, false);
        }
    }
    if (!really || anywhere.empty()) {
        return there;
    }
    anywhere = atHandOf(std::move(anywhere));
    if (anywhere.size() == 1) {
        sensors->askGauge(anywhere.front(), false);
    } else {
        chooseGaugeToAsk(anywhere);
    }
    return there;
}

std::vector<std::size_t> BoringPage::atHandOf(std::vector<std::size_t> gauges) const {
    const auto& known = context().services.sensorService->view().gauges;
    const std::string atHand = gaugeOn(GaugesAtHand::kNoChannel);
    for (const std::size_t i : gauges) {
        if (known[i].name == atHand) {
            return {i};
        }
    }
    const std::vector<Gauge> fitting = suitable();
    std::vector<std::size_t> left = gauges;
    std::erase_if(left, [&](std::size_t i) {
        return !registered(known[i].name).empty() &&
               std::ranges::find(fitting, known[i].name, &Gauge::identity) == fitting.end();
    });
    return left.empty() ? gauges : left;
}

void BoringPage::chooseGaugeToAsk(const std::vector<std::size_t>& gauges) {
    Sheet* sheet = context().sheets.open(tr("Which gauge is asked?"), tr("Touch the one that measures this bore."));
    for (const std::size_t i : gauges) {
        const SensorGaugeView& gauge = context().services.sensorService->view().gauges[i];
        auto* button = new QPushButton(
            QString::fromStdString(gauge.name) + QStringLiteral(" · ") + QString::fromStdString(gauge.device), sheet);
        button->setObjectName(QStringLiteral("boringAsk%1").arg(i));
        sheet->body()->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, sheet, i] {
            sheet->close();
            context().services.sensorService->askGauge(i, false);
        });
    }
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

void BoringPage::keepGauge(int channel, const std::string& identity) {
    m_gauges.set(channel, identity);
    m_entry->showChannels();
    if (const auto& save = context().services.saveSetting) {
        save(QLatin1String(kGaugesSetting), m_gauges.text());
    }
}

void BoringPage::keepChannels(const GaugeChannels& channels) {
    m_entry->setChannels(channels);
    saveChannels();
}

void BoringPage::saveChannels() {
    if (const auto& save = context().services.saveSetting) {
        save(QLatin1String(kChannelsSetting), m_entry->channels().text());
    }
}

void BoringPage::acceptSchedule() {
    m_next->setBusy(true);
    const QPointer<BoringPage> self(this);
    m_service->acceptSchedule(context().session.author(), [self](const Result<void>& result) {
        BoringPage* page = self.data();
        if (page == nullptr) {
            return;
        }
        page->m_next->setBusy(false);
        if (!result) {
            page->context().notify(sentenceText(result.error(), page->look().units()));
        }
    });
}

void BoringPage::openChange() {
    Sheet* sheet = context().sheets.open(
        tr("What is new with the next part?"),
        tr("The expected diameters then begin from what such changes have brought before. Nothing known: just go on."));
    const std::array<std::pair<BoringChange, const char*>, 3> kinds{{{BoringChange::Insert, "boringChangeInsert"},
                                                                     {BoringChange::Reground, "boringChangeReground"},
                                                                     {BoringChange::Material, "boringChangeMaterial"}}};
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("boringChangeCancel"));
    if (m_service->view().announced) {
        sheet->addButton(tr("Take back"), [this] { tellChange(std::nullopt); })
            ->setObjectName(QStringLiteral("boringChangeNone"));
    }
    for (const auto& [kind, name] : kinds) {
        sheet->addButton(changeName(kind), [this, kind = kind] { tellChange(kind); })
            ->setObjectName(QLatin1String(name));
    }
}

void BoringPage::tellChange(std::optional<BoringChange> change) {
    const QPointer<BoringPage> self(this);
    const auto answered = [self](const Result<void>& result) {
        BoringPage* page = self.data();
        if (page == nullptr) {
            return;
        }
        if (!result) {
            page->context().notify(sentenceText(result.error(), page->look().units()));
        }
    };
    const std::string author = context().session.author();
    change ? m_service->announceChange(*change, author, answered) : m_service->withdrawChange(author, answered);
}

void BoringPage::setMode(LoopMode mode) {
    context().client.sendAction(SetLoopMode{ProcessId::Boring, mode});
}

}  // namespace kerf::ui
