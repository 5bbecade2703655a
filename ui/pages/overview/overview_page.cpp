// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/overview/overview_page.h"

#include <QDateTime>
#include <algorithm>
#include <array>

#include "ui/link/release_stop.h"
#include "ui/link/shop_text.h"
#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/shell/start_rest.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kSamplePeriod_ms = 200;
constexpr std::array<const char*, kAxisCount> kAxisNames{"X", "Y", "Z"};
}  // namespace

LoopCard::LoopCard(Look& look, const PageEntry& entry, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_entry(entry),
      m_lamp(new Lamp(look, this)),
      m_reason(makeLabel(TextRole::Body, this, true)),
      m_place(new QVBoxLayout),
      m_course(new Sparkline(look, this)) {
    setObjectName(QStringLiteral("card_") + QLatin1String(entry.key));
    setCursor(Qt::PointingHandCursor);
    header()->addWidget(m_lamp);
    body()->addWidget(m_reason);
    body()->addLayout(m_place);
    body()->addWidget(m_course, 1);
    body()->addStretch(0);
    retitle();
}

void LoopCard::retitle() {
    setTitle(m_entry.title());
}

void LoopCard::show(const LoopStatus& loop, const KeyFigure& figure) {
    if (!loop.fitted) {
        m_lamp->set(Sign::Off, tr("not fitted"));
        m_reason->setText(loop.reason.empty() ? tr("Not fitted yet.") : sentenceText(loop.reason, m_look.units()));
        m_course->hide();
        if (m_number != nullptr) {
            m_number->hide();
        }
        return;
    }
    m_lamp->setState(loop.state);
    m_reason->setText(sentenceText(loop.reason, m_look.units()));
    m_course->show();
    const bool other =
        m_number == nullptr || std::string_view(m_kind.unit) != figure.unit || m_kind.decimals != figure.decimals;
    if (other) {
        delete m_number;
        m_number = new NumberDisplay(m_look, figure.unit, figure.decimals, TextSize::Page, this);
        m_place->addWidget(m_number);
    }
    m_kind = figure;
    m_number->show();
    m_number->setLabel(figure.label);
    if (figure.value) {
        m_number->setValue(*figure.value);
        m_number->setHalf95(figure.half95);
        m_number->setLimited(figure.limited);
    } else {
        m_number->setNothing();
    }
    const auto limit = [&](const std::optional<double>& value) -> std::optional<Sparkline::Limit> {
        if (!value) {
            return std::nullopt;
        }
        return Sparkline::Limit{*value, m_look.units().number(*value, figure.unit, figure.decimals)};
    };
    m_course->setLimits(limit(figure.lower), limit(figure.upper));
}

void LoopCard::sample(const KeyFigure& figure) {
    if (!figure.course.empty()) {
        m_course->setValues(figure.course);
    } else if (figure.value) {
        m_course->push(*figure.value);
    }
}

void LoopCard::mouseReleaseEvent(QMouseEvent*) {
    emit opened();
}

namespace {

PageList processEntries(const PageContext& context) {
    PageList entries = context.pages != nullptr ? *context.pages : PageList{};
    std::erase_if(entries, [](const PageEntry& entry) { return !entry.process; });
    return entries;
}

const LoopStatus& loopOf(const PageEntry& entry, const Status& status) {
    return status.loops[static_cast<std::size_t>(*entry.process)];
}

KeyFigure figureOf(const PageEntry& entry, const Services& services, const Status& status) {
    return entry.keyFigure ? entry.keyFigure(services, status) : KeyFigure{};
}

}  // namespace

OverviewPage::OverviewPage(const PageContext& context, QWidget* parent)
    : Page(context, parent),
      m_entries(processEntries(context)),
      m_grid(new QGridLayout(this)),
      m_machine(new Card(context.look, this)),
      m_machineLamp(new Lamp(context.look, this)),
      m_sentence(makeLabel(TextRole::Body, this, true)),
      m_shop(makeLabel(TextRole::Small, this, true)),
      m_feed(new NumberDisplay(context.look, "mm/s", 2, TextSize::Page, this)),
      m_feedCourse(new Sparkline(context.look, this)),
      m_parts(new NumberDisplay(context.look, "", 0, TextSize::Card, this)),
      m_start(new ActionButton(context.look, this)),
      m_release(new ActionButton(context.look, this)) {
    for (const PageEntry& entry : m_entries) {
        auto* card = new LoopCard(look(), entry, this);
        connect(card, &LoopCard::opened, this, [this, key = entry.key] { this->context().showPage(key); });
        card->hide();
        m_cards.push_back(card);
    }
    buildMachine();
    m_sinceSample.start();
    connect(&context.client, &EngineClient::statusChanged, this, &OverviewPage::onStatus);
    refresh();
}

void OverviewPage::arrange(const Status& status) {
    std::vector<bool> fitted;
    for (const PageEntry& entry : m_entries) {
        fitted.push_back(loopOf(entry, status).fitted);
    }
    if (fitted == m_arranged) {
        return;
    }
    m_arranged = fitted;
    const int count = static_cast<int>(std::ranges::count(fitted, true));
    const int columns = (count + 1) / 2;
    int cell = 0;
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        m_grid->removeWidget(m_cards[i]);
        m_cards[i]->setVisible(fitted[i]);
        if (fitted[i]) {
            m_grid->addWidget(m_cards[i], cell / columns, cell % columns);
            ++cell;
        }
    }
    m_grid->removeWidget(m_machine);
    const bool oneCellLeft = count % 2 == 1 && count > 1;
    m_grid->addWidget(m_machine, oneCellLeft ? 1 : 0, oneCellLeft ? columns - 1 : columns, oneCellLeft ? 1 : 2, 1);
    for (int i = 0; i < m_grid->columnCount(); ++i) {
        m_grid->setColumnStretch(i, i < columns || (!oneCellLeft && i == columns) ? 1 : 0);
    }
    for (int i = 0; i < 2; ++i) {
        m_grid->setRowStretch(i, i == 0 || count > 1 ? 1 : 0);
    }
}

void OverviewPage::buildMachine() {
    m_machine->setObjectName(QStringLiteral("card_machine"));
    m_machine->header()->addWidget(m_machineLamp);
    m_machine->body()->addWidget(m_sentence);
    m_shop->setObjectName(QStringLiteral("overviewShop"));
    m_shop->hide();
    m_machine->body()->addWidget(m_shop);
    m_feed->setObjectName(QStringLiteral("feedRate"));
    m_parts->setObjectName(QStringLiteral("partCounter"));
    m_feed->setWidest(88.0);
    m_machine->body()->addWidget(m_feedCourse, 1);
    auto* numbers = new QGridLayout;
    numbers->addWidget(m_feed, 0, 0, 1, 2);
    numbers->addWidget(m_parts, 0, 2);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        auto* number = new NumberDisplay(look(), "mm", 3, TextSize::Body, this);
        number->setLabel(QLatin1String(kAxisNames[axis]));
        number->setWidest(888.0);
        m_position.push_back(number);
        numbers->addWidget(number, 1, static_cast<int>(axis));
    }
    m_machine->body()->addLayout(numbers);
    auto* buttons = new QHBoxLayout;
    m_start->setObjectName(QStringLiteral("startPart"));
    m_release->setObjectName(QStringLiteral("releaseHold"));
    m_start->setPrimary(true);
    m_start->setPredicate([this] { return whyNoStart(); });
    restUntilShown(m_start, context(), [this] { return std::optional(mainProcess()); });
    m_release->setPredicate([this] { return whyNoRelease(); });
    buttons->addWidget(m_start);
    buttons->addWidget(m_release);
    m_machine->body()->addLayout(buttons);
    connect(m_start, &QPushButton::clicked, this, [this] { context().client.startPart(mainProcess()); });
    connect(m_release, &QPushButton::clicked, this, [this] { release(); });
}

ProcessId OverviewPage::mainProcess() const {
    const auto& loops = context().client.status().loops;
    const auto first = std::ranges::find_if(loops, &LoopStatus::fitted);
    return first == loops.end() ? ProcessId::Boring : static_cast<ProcessId>(first - loops.begin());
}

QString OverviewPage::whyNoStart() const {
    return startObstacle(context().client.status(), context().client.engine().capabilities().cycleStart, mainProcess(),
                         look().units());
}

QString OverviewPage::whyNoRelease() const {
    return context().client.status().held || stopped() ? QString() : tr("Nothing is held.");
}

std::optional<ProcessId> OverviewPage::stopped() const {
    return stoppedProcess(context().client.status());
}

void OverviewPage::release() {
    const Status status = context().client.status();  // as shown: what comes while somebody signs on is looked at anew
    if (status.held) {
        context().client.sendAction(ReleaseHold{});
    } else if (const std::optional<ProcessId> process = stopped()) {
        context().withOperator([this, status, process] {
            context().client.sendAction(releaseOf(status, *process, context().session.author()));
        });
    }
}

QString OverviewPage::stopText(const StopStatus& stop) const {
    const AlarmSpec* spec = context().client.engine().alarmSpec(stop.slot.cause);
    return spec != nullptr ? engineText(spec->title) : sentenceText(stop.reason, look().units());
}

QString OverviewPage::machineSentence() const {
    const Status& status = context().client.status();
    if (status.held && status.link == LinkState::Up && !status.emergencyStop && status.machineOn) {
        return tr("All loops are held with their last offset.");
    }
    if (const QString why = machineObstacle(status); !why.isEmpty()) {
        return why;
    }
    for (const StopStatus& stop : status.stops) {
        if (stop.slot.active()) {
            return tr("Stopped: %1").arg(stopText(stop));
        }
    }
    switch (status.program) {
        case ProgramState::Idle:
            return tr("Ready for the next part.");
        case ProgramState::Running:
            return status.boring.cutting ? tr("Cutting, %1 s to go.").arg(static_cast<int>(status.boring.remaining_s))
                                         : tr("The program is running.");
        case ProgramState::Paused:
            return tr("The program is paused.");
        case ProgramState::Finished:
            return tr("Part finished.");
        case ProgramState::Aborted:
            return tr("The last part was aborted.");
    }
    return {};
}

void OverviewPage::onStatus(const Status& status) {
    // The first status with loops in it is the page's content: it is not waited for.
    const bool empty = std::ranges::none_of(m_arranged, [](bool fitted) { return fitted; });
    if (!empty && m_sinceSample.elapsed() < kSamplePeriod_ms) {
        return;
    }
    m_sinceSample.restart();
    arrange(status);
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        const KeyFigure figure = figureOf(m_entries[i], context().services, status);
        m_cards[i]->sample(figure);
        if (isVisible()) {
            m_cards[i]->show(loopOf(m_entries[i], status), figure);
        }
    }
    if (status.actualFeed_mmPerS.good()) {
        m_feedCourse->push(status.actualFeed_mmPerS.value);
    }
    if (!isVisible()) {
        return;
    }
    m_sentence->setText(machineSentence());
    showShop();
    const bool up = status.link == LinkState::Up && status.machineOn && !status.emergencyStop;
    const bool running = status.program == ProgramState::Running;
    m_machineLamp->set(up ? Sign::Up : Sign::Off, up ? (running ? tr("cutting") : tr("ready")) : tr("off"));
    m_feed->setReading(status.actualFeed_mmPerS, status.machineTime_ns);
    m_feed->setLimited(status.feedScaleLimited);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_position[axis]->setReading(status.position_mm[axis], status.machineTime_ns);
    }
    m_parts->setValue(static_cast<double>(status.boring.partsCut + status.milling.partsCut + status.turning.partsCut +
                                          status.tapping.partsCut));
    m_start->reconsider();
    m_release->setText(context().client.status().held || !stopped() ? tr("Release hold") : tr("Release stop"));
    m_release->reconsider();
}

void OverviewPage::showShop() {
    auto shop = context().services.shop ? context().services.shop() : std::nullopt;
    if (shop) {
        shop->detail.clear();  // Diagnostics has it
        m_shop->setText(tr("Shop: %1").arg(shopText(*shop, QDateTime::currentMSecsSinceEpoch())));
    }
    m_shop->setVisible(shop.has_value());
}

void OverviewPage::refresh() {
    const int gap = look().space(Space::Medium);
    layout()->setContentsMargins(gap, gap, gap, gap);
    layout()->setSpacing(gap);
    for (LoopCard* card : m_cards) {
        card->retitle();
    }
    m_machine->setTitle(tr("Machine"));
    m_feed->setLabel(tr("Feed"));
    m_parts->setLabel(tr("Parts since start"));
    m_start->setText(tr("Start part"));
    m_release->setText(context().client.status().held || !stopped() ? tr("Release hold") : tr("Release stop"));
    Page::refresh();
    const Status& status = context().client.status();
    m_sentence->setText(machineSentence());
    showShop();
    arrange(status);
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        m_cards[i]->show(loopOf(m_entries[i], status), figureOf(m_entries[i], context().services, status));
    }
    m_start->reconsider();
    m_release->reconsider();
}

}  // namespace kerf::ui
