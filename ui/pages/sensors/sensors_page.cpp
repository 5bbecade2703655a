// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/sensors/sensors_page.h"

#include <cmath>

#include "ui/link/texts.h"
#include "ui/pages/sensors/sensor_table.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kPeriod_ms = 500;
enum Column { kName, kPlace, kValue, kAge, kState, kColumns };
enum ModuleColumn { kModule, kAddress, kReads, kModuleColumns };

}  // namespace

SensorsPage::SensorsPage(const PageContext& context, QWidget* parent)
    : Page(context, parent), m_service(context.services.sensorService) {
    if (m_service == nullptr && context.services.sensorSetup != nullptr) {
        auto* rows = new QVBoxLayout(this);
        m_panel = new SensorSetupPanel(context, *context.services.sensorSetup, this);
        rows->addWidget(m_panel);
    } else if (m_service == nullptr) {
        auto* rows = new QVBoxLayout(this);
        m_missing = makeLabel(TextRole::Body, this, true);
        m_missing->setAlignment(Qt::AlignCenter);
        rows->addWidget(m_missing);
    } else {
        build();
        connect(&context.client, &EngineClient::statusChanged, this, &SensorsPage::onStatus);
    }
    m_since.start();
    refresh();
}

void SensorsPage::build() {
    auto* columns = new QHBoxLayout(this);
    m_list = new Card(look(), this);
    m_side = new Card(look(), this);
    columns->addWidget(m_list, 3);
    columns->addWidget(m_side, 2);
    m_channels = makeSensorTable("sensorChannels", kColumns, this);
    m_modules = makeSensorTable("sensorModules", kModuleColumns, this);
    m_list->body()->addWidget(m_channels, 3);
    m_list->body()->addWidget(m_modules, 1);
    m_picture = new SensorPicture(look(), this);
    m_hint = makeLabel(TextRole::Body, this, true);
    m_hint->setObjectName(QStringLiteral("sensorHint"));
    m_finger = new ActionButton(look(), this);
    m_finger->setObjectName(QStringLiteral("whichOneRises"));
    m_place = new ActionButton(look(), this);
    m_place->setObjectName(QStringLiteral("placeSensor"));
    m_ask = new ActionButton(look(), this);
    m_ask->setObjectName(QStringLiteral("askGauge"));
    m_setup = new ActionButton(look(), this);
    m_setup->setObjectName(QStringLiteral("sensorSetupOpen"));
    m_setup->setVisible(context().services.sensorSetup != nullptr);
    for (const int column : {kName, kValue, kAge}) {  // the rest is for words
        m_channels->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    m_modules->horizontalHeader()->setSectionResizeMode(kModule, QHeaderView::ResizeToContents);
    m_side->body()->addWidget(m_picture, 1);
    m_side->body()->addWidget(m_hint);
    for (ActionButton* button : {m_finger, m_place, m_ask, m_setup}) {
        m_side->body()->addWidget(button);
    }
    allowOnly(m_place, context().session, Deed::SensorPlace);
    m_place->setPredicate([this] { return m_chosen ? QString() : tr("touch a channel first"); });
    m_ask->setPredicate([this] {
        for (const SensorGaugeView& gauge : m_service->view().gauges) {
            if (gauge.connected && gauge.canAsk) {
                return QString();
            }
        }
        return tr("no gauge that can be asked is connected");
    });
    connect(m_channels, &QTableWidget::cellClicked, this,
            [this](int row, int) { choose(static_cast<std::size_t>(row)); });
    connect(m_picture, &SensorPicture::touched, this, &SensorsPage::placeAt);
    connect(m_finger, &QPushButton::clicked, this, [this] {
        m_placing = false;
        m_service->lookForFinger(!m_service->view().finger.looking);
        show(m_service->view());
    });
    connect(m_place, &QPushButton::clicked, this, [this] {
        context().withPermission(Deed::SensorPlace, [this] {
            m_placing = true;
            show(m_service->view());
        });
    });
    connect(m_setup, &QPushButton::clicked, this, [this] {
        Sheet* sheet = context().sheets.open(tr("Sensor file and modules"));
        sheet->setWide();
        sheet->body()->addWidget(new SensorSetupPanel(context(), *context().services.sensorSetup, sheet), 1);
        sheet->addButton(tr("Close"), [] {});
    });
    connect(m_ask, &QPushButton::clicked, this, [this] {
        const auto& gauges = m_service->view().gauges;
        for (std::size_t i = 0; i < gauges.size(); ++i) {
            if (gauges[i].connected && gauges[i].canAsk) {
                m_service->askGauge(i, true);
            }
        }
    });
}

void SensorsPage::refresh() {
    setObjectName(QStringLiteral("sensorsPage"));
    const int gap = look().space(Space::Medium);
    if (m_panel != nullptr) {
        layout()->setContentsMargins(gap, gap, gap, gap);
    } else if (m_service == nullptr) {
        m_missing->setText(
            tr("This console was started without a sensor file (--sensors): only what the machine itself brings is "
               "read."));
    } else {
        layout()->setContentsMargins(gap, gap, gap, gap);
        layout()->setSpacing(gap);
        m_list->setTitle(tr("Sensors and gauges"));
        m_side->setTitle(tr("Where they sit"));
        m_channels->setHorizontalHeaderLabels({tr("Channel"), tr("Place"), tr("Value"), tr("Age"), tr("State")});
        m_modules->setHorizontalHeaderLabels({tr("Module, gauge"), tr("Address"), tr("Reads")});
        for (QTableWidget* table : {m_channels, m_modules}) {
            table->verticalHeader()->setMinimumSectionSize(look().metrics().touch());
        }
        m_place->setText(tr("Place on the picture"));
        m_ask->setText(tr("Test read of the gauges"));
        m_setup->setText(tr("Sensor file and modules"));
        m_shown = 0;
        show(m_service->view());
    }
    Page::refresh();
}

void SensorsPage::onStatus() {
    if (isVisible() && m_since.elapsed() >= kPeriod_ms) {
        m_since.restart();
        show(m_service->view());
    }
}

void SensorsPage::show(const SensorServiceView& view) {
    showChannels(view);
    showModules(view);
    m_picture->setPicture(QString::fromStdString(view.picture));
    m_picture->setChannels(view.channels);
    showFinger(view);
    m_place->reconsider();
    m_ask->reconsider();
}

void SensorsPage::showChannels(const SensorServiceView& view) {
    m_channels->setRowCount(static_cast<int>(view.channels.size()));
    for (int row = 0; row < m_channels->rowCount(); ++row) {
        const SensorChannelView& channel = view.channels[static_cast<std::size_t>(row)];
        setSensorCell(m_channels, row, kName, QString::fromStdString(channel.name));
        setSensorCell(m_channels, row, kPlace, QString::fromStdString(channel.place));
        setSensorCell(m_channels, row, kValue,
                      channel.value ? look().units().withUnit(*channel.value, channel.unit, 1) : QStringLiteral("–"));
        setSensorCell(m_channels, row, kAge,
                      channel.age_s ? tr("%1 s").arg(*channel.age_s, 0, 'f', *channel.age_s < 10.0 ? 1 : 0)
                                    : QStringLiteral("–"));
        setSensorCell(m_channels, row, kState, channel.value ? tr("good") : engineText(channel.why));
    }
}

void SensorsPage::showModules(const SensorServiceView& view) {
    const auto modules = static_cast<int>(view.modules.size());
    m_modules->setRowCount(modules + static_cast<int>(view.gauges.size()));
    for (int row = 0; row < modules; ++row) {
        const SensorModuleView& module = view.modules[static_cast<std::size_t>(row)];
        setSensorCell(m_modules, row, kModule, QString::fromStdString(module.name));
        setSensorCell(m_modules, row, kAddress, QString::fromStdString(module.address));
        setSensorCell(m_modules, row, kReads, tr("%1 of %2").arg(module.good).arg(module.channels));
    }
    for (int k = 0; k < static_cast<int>(view.gauges.size()); ++k) {
        const SensorGaugeView& gauge = view.gauges[static_cast<std::size_t>(k)];
        setSensorCell(m_modules, modules + k, kModule, QString::fromStdString(gauge.name));
        setSensorCell(m_modules, modules + k, kAddress, QString::fromStdString(gauge.device));
        setSensorCell(m_modules, modules + k, kReads,
                      !gauge.connected      ? tr("not plugged in")
                      : gauge.frame.empty() ? tr("connected")
                      : gauge.understood    ? QString::fromStdString(gauge.frame)
                                            : tr("%1: no reading").arg(QString::fromStdString(gauge.frame)));
    }
}

void SensorsPage::showFinger(const SensorServiceView& view) {
    const FingerView& finger = view.finger;
    m_finger->setText(finger.looking ? tr("Stop looking") : tr("Which one rises?"));
    if (finger.looking && finger.channel && m_chosen != finger.channel) {
        choose(finger.channel);
    }
    QString hint;
    if (!view.problem.empty()) {
        hint = sentenceText(view.problem, look().units());
    } else if (!view.reading) {
        hint = tr("The reading process does not answer; it is started again.");
    } else if (m_placing && m_chosen) {
        hint = tr("Touch the picture where %1 sits.").arg(QString::fromStdString(view.channels[*m_chosen].name));
    } else if (finger.looking && finger.channel) {
        hint = tr("It is %1: %2 warmer.")
                   .arg(QString::fromStdString(view.channels[*finger.channel].name),
                        look().units().difference(finger.rise_K, "K", 1));
    } else if (finger.looking) {
        hint = tr("Warm one thermocouple with a finger; its channel shows itself.");
    } else if (view.picture.empty()) {
        hint =
            tr("A picture of this machine (PNG) in %1 is shown here.").arg(QString::fromStdString(view.pictureFolder));
    } else {
        hint = tr("Touch a channel, then its place on the picture.");
    }
    m_hint->setText(hint);
}

void SensorsPage::choose(std::optional<std::size_t> channel) {
    m_chosen = channel;
    if (channel) {
        m_channels->selectRow(static_cast<int>(*channel));
    }
    m_picture->select(channel);
    m_place->reconsider();
}

void SensorsPage::placeAt(double x, double y) {
    if (!m_placing || !m_chosen) {
        return;
    }
    m_placing = false;
    if (const auto placed = m_service->place(*m_chosen, x, y, context().session.author()); !placed) {
        context().notify(sentenceText(placed.error(), look().units()));
    }
    show(m_service->view());
}

}  // namespace kerf::ui
