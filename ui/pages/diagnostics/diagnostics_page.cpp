// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/diagnostics/diagnostics_page.h"

#include <QDateTime>
#include <QGridLayout>
#include <QPointer>

#include "ui/dialogs/restore_sheet.h"
#include "ui/link/shop_text.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kPeriod_ms = 500;
}

DiagnosticsPage::DiagnosticsPage(const PageContext& context, QWidget* parent)
    : Page(context, parent),
      m_costCard(new Card(context.look, this)),
      m_lateCard(new Card(context.look, this)),
      m_cost(new HistogramChart(context.look, this)),
      m_late(new HistogramChart(context.look, this)),
      m_engine(new Card(context.look, this)),
      m_link(new Card(context.look, this)),
      m_scheduling(makeLabel(TextRole::Body, this, true)),
      m_backup(new ActionButton(context.look, this)),
      m_restore(new ActionButton(context.look, this)) {
    auto* grid = new QGridLayout(this);
    grid->addWidget(m_costCard, 0, 0);
    grid->addWidget(m_lateCard, 0, 1);
    grid->addWidget(m_engine, 1, 0);
    grid->addWidget(m_link, 1, 1);
    grid->setRowStretch(0, 3);
    grid->setRowStretch(1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    m_costCard->body()->addWidget(m_cost);
    m_lateCard->body()->addWidget(m_late);
    m_period = addFact(m_engine, "cyclePeriod");
    m_cycles = addFact(m_engine, "cycles");
    m_overruns = addFact(m_engine, "overruns");
    m_dropped = addFact(m_engine, "droppedSamples");
    m_speed = addFact(m_engine, "achievedSpeed");
    m_scheduling->setObjectName(QStringLiteral("scheduling"));
    m_engine->body()->addWidget(m_scheduling);
    m_engine->body()->addStretch(1);
    m_machine = addFact(m_link, "machine");
    m_state = addFact(m_link, "linkState");
    m_clock = addFact(m_link, "machineTime");
    m_versions = addFact(m_link, "versions");
    m_shop = addFact(m_link, "shopState");
    m_link->body()->addStretch(1);
    m_backup->setObjectName(QStringLiteral("backup"));
    m_backup->setPredicate([this] {
        return !this->context().services.backUp ? tr("no database") : m_backingUp ? tr("being written") : QString();
    });
    connect(m_backup, &QPushButton::clicked, this, &DiagnosticsPage::askBackup);
    m_link->body()->addWidget(m_backup);
    m_restore->setObjectName(QStringLiteral("restore"));
    m_restore->setPredicate([this] { return !this->context().services.restore ? tr("no database") : QString(); });
    allowOnly(m_restore, this->context().session, Deed::DataRestore);
    connect(m_restore, &QPushButton::clicked, this,
            [this] { this->context().withPermission(Deed::DataRestore, [this] { openRestore(this->context()); }); });
    m_link->body()->addWidget(m_restore);
    m_since.start();
    connect(&context.client, &EngineClient::statusChanged, this, &DiagnosticsPage::onStatus);
    refresh();
}

DiagnosticsPage::Fact DiagnosticsPage::addFact(Card* card, const char* objectName) {
    Fact fact{makeLabel(TextRole::Dim, card), makeLabel(TextRole::Body, card, true)};
    fact.value->setObjectName(QLatin1String(objectName));
    auto* row = new QHBoxLayout;
    row->addWidget(fact.name, 2);
    row->addWidget(fact.value, 3);
    card->body()->addLayout(row);
    return fact;
}

// One touch on a folder and the copy is on its way; removable drives stand first.
void DiagnosticsPage::askBackup() {
    Sheet* sheet = context().sheets.open(
        tr("Back up all data"),
        tr("A checked copy in one file, made while everything goes on. Touch where it shall go."));
    const QString name =
        QStringLiteral("/kerf_%1.db").arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")));
    const QStringList folders = context().services.backupFolders ? context().services.backupFolders() : QStringList();
    for (int i = 0; i < folders.size(); ++i) {
        auto* button = new QPushButton(folders[i], sheet);
        button->setObjectName(QStringLiteral("backupFolder%1").arg(i));
        sheet->body()->addWidget(button);
        connect(button, &QPushButton::clicked, sheet, [this, sheet, file = folders[i] + name] {
            startBackup(file);
            sheet->close();
        });
    }
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

void DiagnosticsPage::startBackup(const QString& file) {
    m_backingUp = true;
    m_backup->reconsider();
    const auto told = [self = QPointer<DiagnosticsPage>(this), file](const Result<void>& done) {
        if (DiagnosticsPage* page = self.data()) {
            page->m_backingUp = false;
            page->m_backup->reconsider();
            page->context().notify(done
                                       ? tr("Backed up to %1").arg(file)
                                       : tr("Not backed up: %1").arg(sentenceText(done.error(), page->look().units())));
        }
    };
    context().services.backUp(file, told);
}

void DiagnosticsPage::onStatus(const Status& status) {
    if (isVisible() && m_since.elapsed() >= kPeriod_ms) {
        m_since.restart();
        update(status);
    }
}

void DiagnosticsPage::update(const Status& status) {
    const Capabilities& capabilities = context().client.engine().capabilities();
    m_cost->setHistogram(status.stats.cost);
    m_late->setHistogram(status.stats.lateness);
    m_cost->setDeadline(capabilities.cycle_ns);
    m_late->setDeadline(capabilities.cycle_ns);
    const double period_ms = static_cast<double>(capabilities.cycle_ns) / 1e6;
    m_period.value->setText(tr("%1 ms (%2 kHz)").arg(period_ms, 0, 'f', 1).arg(1.0 / period_ms, 0, 'f', 1));
    m_cycles.value->setText(QString::number(status.stats.cycles));
    const double share = status.stats.cycles > 0 ? 100.0 * static_cast<double>(status.stats.overruns) /
                                                       static_cast<double>(status.stats.cycles)
                                                 : 0.0;
    m_overruns.value->setText(tr("%1 (%2 %)").arg(status.stats.overruns).arg(share, 0, 'f', 4));
    m_dropped.value->setText(QString::number(status.stats.droppedSamples));
    m_speed.value->setText(QStringLiteral("×%1").arg(status.stats.achievedSpeed, 0, 'f', 2));
    m_scheduling->setText(
        status.stats.realTimeScheduling
            ? tr("Real-time scheduling is granted: the cycle goes before all other work of this computer.")
        : capabilities.simulated && status.simulationSpeed != 1.0
            ? tr("The simulation runs faster than time: it needs no real-time scheduling and asks for none.")
            : tr("Real-time scheduling is not granted: other programs can delay the cycle. Allow it with "
                 "“rtprio” in /etc/security/limits.conf."));
    m_machine.value->setText(QString::fromUtf8(capabilities.machineName.data()));
    m_state.value->setText(status.link == LinkState::Up           ? tr("up")
                           : status.link == LinkState::Connecting ? tr("connecting")
                                                                  : tr("down"));
    const auto shop = context().services.shop ? context().services.shop() : std::nullopt;
    m_shop.value->setText(shop ? shopText(*shop, QDateTime::currentMSecsSinceEpoch())
                               : tr("none: this console keeps its data to itself"));
    m_clock.value->setText(tr("%1 s").arg(static_cast<double>(status.machineTime_ns) / 1e9, 0, 'f', 1));
}

void DiagnosticsPage::refresh() {
    const int gap = look().space(Space::Medium);
    layout()->setContentsMargins(gap, gap, gap, gap);
    layout()->setSpacing(gap);
    m_costCard->setTitle(tr("Work in one cycle"));
    m_lateCard->setTitle(tr("Start after the deadline"));
    m_cost->setTitle(tr("time per cycle; height: share of all cycles"));
    m_late->setTitle(tr("lateness; height: share of all cycles"));
    m_engine->setTitle(tr("Engine"));
    m_link->setTitle(tr("Machine and versions"));
    m_backup->setText(tr("Back up all data"));
    m_restore->setText(tr("Restore a backup"));
    m_period.name->setText(tr("Period of the cycle"));
    m_cycles.name->setText(tr("Cycles"));
    m_overruns.name->setText(tr("Overruns"));
    m_dropped.name->setText(tr("Chart samples dropped"));
    m_speed.name->setText(tr("Machine time per second"));
    m_machine.name->setText(tr("Machine"));
    m_state.name->setText(tr("Link"));
    m_clock.name->setText(tr("Machine time"));
    m_versions.name->setText(tr("Versions"));
    m_shop.name->setText(tr("Shop"));
    m_versions.value->setText(
        QStringLiteral("Kerf %1, Qt %2").arg(QStringLiteral(KERF_VERSION), QLatin1String(qVersion())));
    update(context().client.status());
    Page::refresh();
}

}  // namespace kerf::ui
