// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/sensors/sensor_setup_panel.h"

#include <algorithm>

#include "ui/link/texts.h"
#include "ui/pages/sensors/sensor_table.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

enum FileColumn { kFile, kContents, kFileColumns };
enum FoundColumn { kUnit, kIdentity, kRegisters, kFoundColumns };

/// In the language of the screen; key and values stay as they stand in the file.
QString refusalText(const SensorFileRefusal& why) {
    const QString words = engineText(why.text);
    QString out = why.where.empty() ? QString() : QString::fromStdString(why.where) + QStringLiteral(": ");
    for (qsizetype i = 0; i < words.size(); ++i) {
        const int place = words[i] == u'%' && i + 1 < words.size() ? words[i + 1].digitValue() : 0;
        if (place >= 1 && static_cast<std::size_t>(place) <= why.values.size()) {
            out += QString::fromStdString(why.values[static_cast<std::size_t>(place) - 1]);
            ++i;
        } else {
            out += words[i];
        }
    }
    return out;
}

}  // namespace

SensorSetupPanel::SensorSetupPanel(const PageContext& context, SensorSetup& setup, QWidget* parent)
    : FaceWidget(context.look, parent),
      m_context(context),
      m_setup(setup),
      m_fileCard(new Card(context.look, this)),
      m_scanCard(new Card(context.look, this)),
      m_what(makeLabel(TextRole::Body, this, true)),
      m_now(makeLabel(TextRole::Body, this, true)),
      m_files(makeSensorTable("sensorFiles", kFileColumns, this)),
      m_choose(new ActionButton(context.look, this)),
      m_none(new ActionButton(context.look, this)),
      m_again(new ActionButton(context.look, this)),
      m_ask(makeLabel(TextRole::Body, this, true)),
      m_address(new QLineEdit(this)),
      m_scan(new ActionButton(context.look, this)),
      m_found(makeSensorTable("sensorFound", kFoundColumns, this)),
      m_answer(makeLabel(TextRole::Body, this, true)) {
    setObjectName(QStringLiteral("sensorSetup"));
    build();
    connect(&context.client, &EngineClient::statusChanged, this, [this] {
        if (isVisible() && m_shown != m_setup.view().revision) {
            show();
        }
    });
    connect(&context.session, &OperatorSession::changed, this, &SensorSetupPanel::show);
    refresh();
}

void SensorSetupPanel::build() {
    m_now->setObjectName(QStringLiteral("sensorFileNow"));
    m_choose->setObjectName(QStringLiteral("sensorFileUse"));
    m_none->setObjectName(QStringLiteral("sensorFileNone"));
    m_again->setObjectName(QStringLiteral("sensorFileLook"));
    m_address->setObjectName(QStringLiteral("sensorScanAddress"));
    m_scan->setObjectName(QStringLiteral("sensorScan"));
    m_answer->setObjectName(QStringLiteral("sensorScanAnswer"));
    m_address->setPlaceholderText(QStringLiteral("192.168.0.11:502"));
    m_files->horizontalHeader()->setSectionResizeMode(kFile, QHeaderView::ResizeToContents);
    m_found->horizontalHeader()->setSectionResizeMode(kUnit, QHeaderView::ResizeToContents);
    m_fileCard->body()->addWidget(m_what);
    m_fileCard->body()->addWidget(m_now);
    m_fileCard->body()->addWidget(m_files, 1);
    m_fileCard->body()->addWidget(m_choose);
    auto* both = new QHBoxLayout;
    both->addWidget(m_none, 1);
    both->addWidget(m_again, 1);
    m_fileCard->body()->addLayout(both);
    m_scanCard->body()->addWidget(m_ask);
    m_scanCard->body()->addWidget(m_address);
    m_scanCard->body()->addWidget(m_scan);
    m_scanCard->body()->addWidget(m_answer);
    m_scanCard->body()->addWidget(m_found, 1);
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->addWidget(m_fileCard, 1);
    columns->addWidget(m_scanCard, 1);
    allowOnly(m_choose, m_context.session, Deed::SensorPlace);
    allowOnly(m_none, m_context.session, Deed::SensorPlace);
    allowOnly(m_scan, m_context.session, Deed::SensorPlace);
    m_choose->setPredicate([this] { return whyNotChosen(); });
    m_none->setPredicate([this] {
        return std::ranges::any_of(m_setup.view().files, &SensorFileView::chosen) ? QString() : tr("none is chosen");
    });
    m_scan->setPredicate([this] {
        return m_setup.view().scanning                 ? tr("being asked: units 1 to 32")
               : m_address->text().trimmed().isEmpty() ? tr("enter its address first")
                                                       : QString();
    });
    connect(m_files, &QTableWidget::itemSelectionChanged, this, [this] { m_choose->reconsider(); });
    connect(m_address, &QLineEdit::textChanged, this, [this] { m_scan->reconsider(); });
    connect(m_choose, &QPushButton::clicked, this, [this] {
        if (const SensorFileView* file = selected()) {
            choose(QString::fromStdString(file->name));
        }
    });
    connect(m_none, &QPushButton::clicked, this, [this] { choose({}); });
    connect(m_again, &QPushButton::clicked, this, [this] { m_setup.lookForFiles(); });
    connect(m_scan, &QPushButton::clicked, this, &SensorSetupPanel::scan);
    connect(m_address, &QLineEdit::returnPressed, m_scan, &QPushButton::click);
}

void SensorSetupPanel::refresh() {
    m_fileCard->setTitle(tr("Sensor file"));
    m_scanCard->setTitle(tr("What answers at an address"));
    m_what->setText(
        tr("A sensor file (JSON) says which temperature modules and gauges hang on this machine: where each "
           "channel sits, its register, its scale. Put it into %1; docs/sensors.md has every key and an example.")
            .arg(QString::fromStdString(m_setup.view().folder)));
    m_ask->setText(
        tr("Address of a temperature module (Modbus TCP), with its port where that is not 502. It is only "
           "read. What a module has in its registers says which channel is which."));
    m_choose->setText(tr("Use this file from the next start"));
    m_none->setText(tr("Use none"));
    m_again->setText(tr("Look again"));
    m_scan->setText(tr("Ask what is there"));
    m_files->setHorizontalHeaderLabels({tr("File"), tr("What is in it")});
    m_found->setHorizontalHeaderLabels({tr("Unit"), tr("Module"), tr("First registers")});
    for (QTableWidget* table : {m_files, m_found}) {
        table->verticalHeader()->setMinimumSectionSize(look().metrics().touch());
    }
    layout()->setSpacing(look().space(Space::Medium));
    show();
    FaceWidget::refresh();
}

void SensorSetupPanel::showEvent(QShowEvent* event) {
    FaceWidget::showEvent(event);
    m_setup.lookForFiles();
}

void SensorSetupPanel::show() {
    const SensorSetupView& view = m_setup.view();
    m_shown = view.revision;
    const auto chosen = std::ranges::find_if(view.files, &SensorFileView::chosen);
    const QString next = chosen != view.files.end() ? QString::fromStdString(chosen->name) : QString();
    const QString inUse = QString::fromStdString(view.inUse);
    m_now->setText(
        !view.problem.empty() ? sentenceText(view.problem, look().units())
        : view.byCommandLine  ? tr("In use: %1. It was named at the start (--sensors), so it stays.").arg(inUse)
        : !inUse.isEmpty() && next == inUse  ? tr("In use: %1.").arg(inUse)
        : !inUse.isEmpty() && next.isEmpty() ? tr("In use: %1. From the next start none is used.").arg(inUse)
        : !inUse.isEmpty()                   ? tr("In use: %1. From the next start: %2.").arg(inUse, next)
        : !next.isEmpty()
            ? tr("From the next start: %1. Until then only what the machine itself brings is read.").arg(next)
            : tr("None is in use: only what the machine itself brings is read."));
    showFiles(view);
    showFound(view);
    for (ActionButton* button : {m_choose, m_none, m_scan}) {
        button->reconsider();
    }
}

void SensorSetupPanel::showFiles(const SensorSetupView& view) {
    m_files->setRowCount(static_cast<int>(view.files.size()));
    for (int row = 0; row < m_files->rowCount(); ++row) {
        const SensorFileView& file = view.files[static_cast<std::size_t>(row)];
        setSensorCell(m_files, row, kFile, QString::fromStdString(file.name));
        setSensorCell(
            m_files, row, kContents,
            file.refused.empty()
                ? tr("modules: %1, channels: %2, gauges: %3").arg(file.modules).arg(file.channels).arg(file.gauges)
                : tr("cannot be used: %1").arg(refusalText(file.refused)));
    }
}

void SensorSetupPanel::showFound(const SensorSetupView& view) {
    m_found->setRowCount(static_cast<int>(view.found.size()));
    for (int row = 0; row < m_found->rowCount(); ++row) {
        const FoundUnitView& unit = view.found[static_cast<std::size_t>(row)];
        setSensorCell(m_found, row, kUnit, QString::number(unit.unit));
        setSensorCell(m_found, row, kIdentity,
                      unit.identity.empty() ? QStringLiteral("–") : QString::fromStdString(unit.identity));
        setSensorCell(m_found, row, kRegisters, QString::fromStdString(unit.registers));
    }
    const QString address = QString::fromStdString(view.scanned);
    m_answer->setText(
        address.isEmpty()       ? QString()
        : view.scanning         ? tr("%1 is asked; that takes up to 20 s.").arg(address)
        : !view.refused.empty() ? QStringLiteral("%1: %2").arg(address, sentenceText(view.refused, look().units()))
        : view.found.empty()    ? tr("%1 takes a connection, but no unit from 1 to 32 answers.").arg(address)
                                : tr("%1 answers; register numbers are as on the wire, from 0.").arg(address));
}

const SensorFileView* SensorSetupPanel::selected() const {
    const int row = m_files->currentRow();
    const auto& files = m_setup.view().files;
    return row >= 0 && row < static_cast<int>(files.size()) ? &files[static_cast<std::size_t>(row)] : nullptr;
}

QString SensorSetupPanel::whyNotChosen() const {
    const SensorFileView* file = selected();
    return m_setup.view().files.empty() ? tr("no sensor file is there yet")
           : file == nullptr            ? tr("touch a file first")
           : !file->refused.empty()     ? tr("this one cannot be used")
           : file->chosen               ? tr("it is chosen already")
                                        : QString();
}

void SensorSetupPanel::choose(const QString& name) {
    m_context.withPermission(Deed::SensorPlace, [this, name] {
        if (const auto chosen = m_setup.choose(name.toStdString(), m_context.session.author()); !chosen) {
            m_context.notify(sentenceText(chosen.error(), look().units()));
        }
    });
}

void SensorSetupPanel::scan() {
    m_context.withPermission(Deed::SensorPlace, [this] {
        const auto asked = m_setup.scan(m_address->text().trimmed().toStdString(), m_context.session.author());
        if (!asked) {
            m_context.notify(sentenceText(asked.error(), look().units()));
        }
        show();
    });
}

}  // namespace kerf::ui
