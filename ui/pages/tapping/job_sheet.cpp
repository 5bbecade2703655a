// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/job_sheet.h"

#include <QGridLayout>
#include <QLineEdit>
#include <array>
#include <cmath>

#include "ui/link/texts.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kThreadColumns = 4;
constexpr std::size_t kMostThreads = 24;
enum Field : std::size_t { kSpeed, kDepth, kGear, kPart, kTap, kFields };

constexpr std::array<ParamSpec, kFields> kSpecs{{
    {"tapping.speed_rpm", "", "rpm", 10.0, 20'000.0, 3000.0, 0, ""},
    {"tapping.depth_rev", "", "rev", 1.0, 200.0, 22.0, 1, ""},
    {"tapping.gear", "", "", 1.0, 9.0, 1.0, 0, ""},
    {"tapping.part", "", "", 1.0, 99'999.0, 1.0, 0, ""},
    {"tapping.tap", "", "", 1.0, 99'999.0, 1.0, 0, ""},
}};
constexpr std::array<const char*, kFields> kNames{"jobSpeed", "jobDepth", "jobGear", "jobPart", "jobTap"};

double numberOf(const std::string& name) {
    return std::max(1.0, QString::fromStdString(name).toDouble());
}

}  // namespace

JobForm* JobForm::open(SheetHost& host, Look& look, TappingService& service, std::function<std::string()> author) {
    Sheet* sheet = host.open({});
    auto* form = new JobForm(*sheet, look, service, std::move(author));
    sheet->body()->addWidget(form);
    return form;
}

JobForm::JobForm(Sheet& sheet, Look& look, TappingService& service, std::function<std::string()> author)
    : FaceWidget(look, &sheet),
      m_sheet(sheet),
      m_service(service),
      m_choice(service.view().choice),
      m_coarse(!service.view().loaded || service.view().thread.coarse),
      m_coarseButton(new QPushButton(this)),
      m_fineButton(new QPushButton(this)),
      m_threads(new QGridLayout),
      m_thread(makeLabel(TextRole::Small, this, true)),
      m_keypad(new Keypad(look, Keypad::Shape::Wide, this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_author(std::move(author)),
      m_memory(makeLabel(TextRole::Small, this, true)),
      m_reason(new QLineEdit(this)),
      m_leaveOut(new QPushButton(this)) {
    setObjectName(QStringLiteral("tappingJobForm"));
    m_message->setObjectName(QStringLiteral("jobMessage"));
    m_thread->setObjectName(QStringLiteral("jobThreadText"));
    m_coarseButton->setObjectName(QStringLiteral("jobCoarse"));
    m_fineButton->setObjectName(QStringLiteral("jobFine"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    auto* left = new QVBoxLayout;
    auto* right = new QVBoxLayout;
    row->addLayout(left, 1);
    row->addLayout(right, 1);
    m_fieldGrid = new QGridLayout;
    auto* series = new QHBoxLayout;
    for (QPushButton* button : {m_coarseButton, m_fineButton}) {
        button->setCheckable(true);
        series->addWidget(button, 1);
    }
    left->addLayout(series);
    left->addLayout(m_threads);
    left->addStretch(1);
    left->addWidget(m_message);
    left->addWidget(m_thread);
    m_memory->setObjectName(QStringLiteral("jobMemory"));
    m_reason->setObjectName(QStringLiteral("jobReason"));
    m_leaveOut->setObjectName(QStringLiteral("jobLeaveOut"));
    auto* memory = new QHBoxLayout;
    memory->addWidget(m_reason, 1);
    memory->addWidget(m_leaveOut);
    left->addWidget(m_memory);
    left->addLayout(memory);
    connect(m_leaveOut, &QPushButton::clicked, this, &JobForm::leaveOut);
    for (std::size_t i = 0; i < kMostThreads; ++i) {
        auto* button = new QPushButton(this);
        button->setCheckable(true);
        m_threads->addWidget(button, static_cast<int>(i) / kThreadColumns, static_cast<int>(i) % kThreadColumns);
        m_threadButtons.push_back(button);
        connect(button, &QPushButton::clicked, this, [this, button] {
            m_choice.thread = button->property("thread").toString().toStdString();
            showThreads();
        });
    }
    right->addLayout(m_fieldGrid);
    for (std::size_t i = 0; i < kFields; ++i) {
        auto* field = new ValueField(look, kSpecs[i], this);
        field->setObjectName(QLatin1String(kNames[i]));
        field->edit()->setObjectName(QLatin1String(kNames[i]) + QStringLiteral("Edit"));
        m_fieldGrid->addWidget(field, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
        m_fields.push_back(field);
    }
    right->addWidget(m_keypad);
    right->addStretch(1);
    m_fields[kSpeed]->setValue(m_choice.speed_rpm);
    m_fields[kDepth]->setValue(m_choice.depth_rev);
    m_fields[kGear]->setValue(m_choice.gear);
    m_fields[kPart]->setValue(numberOf(m_choice.partType));
    m_fields[kTap]->setValue(numberOf(m_choice.tap));
    connect(m_coarseButton, &QPushButton::clicked, this, [this] {
        m_coarse = true;
        showThreads();
    });
    connect(m_fineButton, &QPushButton::clicked, this, [this] {
        m_coarse = false;
        showThreads();
    });
    m_cancel = sheet.addButton(QString(), {});
    m_cancel->setObjectName(QStringLiteral("jobCancel"));
    m_apply = sheet.addButton(
        QString(), [this] { apply(); }, false);
    m_apply->setObjectName(QStringLiteral("jobApply"));
    refresh();
    m_fields[kSpeed]->edit()->setFocus();
}

void JobForm::refresh() {
    FaceWidget::refresh();
    m_sheet.setTitle(tr("What is tapped"));
    m_fields[kSpeed]->setLabel(tr("speed"));
    m_fields[kDepth]->setLabel(tr("depth"));
    m_fields[kGear]->setLabel(tr("gear"));
    m_fields[kPart]->setLabel(tr("part type no."));
    m_fields[kTap]->setLabel(tr("tap no."));
    m_cancel->setText(tr("Cancel"));
    m_apply->setText(tr("Load"));
    m_reason->setPlaceholderText(tr("Reason"));
    showMemory();
    const int gap = look().space(Space::Medium);
    m_threads->setSpacing(gap);
    m_fieldGrid->setHorizontalSpacing(gap);
    m_fieldGrid->setVerticalSpacing(look().space(Space::Small));
    layout()->setSpacing(look().space(Space::Large));
    showThreads();
}

void JobForm::showMemory() {
    const TappingServiceView& view = m_service.view();
    const bool stored = view.source == GainsSource::Stored || view.source == GainsSource::StoredGains;
    const bool out = !view.leftOut.empty();
    QString words = !view.loaded ? QString() : sourceText(view);
    if (out) {
        words +=
            u' ' + tr("A stored tuning is left out, %1.", "by whom and why").arg(QString::fromStdString(view.leftOut));
    }
    m_memory->setText(words);
    m_leaveOut->setText(out ? tr("Take in again") : tr("Leave out"));
    m_leaveOut->setVisible(stored || out);
    m_reason->setVisible(stored || out);
}

void JobForm::leaveOut() {
    const bool out = m_service.view().leftOut.empty();
    const auto done = m_service.leaveOut(out, m_author(), m_reason->text().simplified().toStdString());
    m_message->setText(done ? QString() : sentenceText(done.error(), look().units()));
    if (done) {
        m_reason->clear();
    }
    showMemory();
}

void JobForm::showThreads() {
    m_coarseButton->setChecked(m_coarse);
    m_fineButton->setChecked(!m_coarse);
    // The threads of the shop's own table; the other one stays in reach by the units in Settings.
    const bool inch = look().units().length() == LengthUnit::Inch;
    m_coarseButton->setText(inch ? QStringLiteral("UNC") : tr("coarse"));
    m_fineButton->setText(inch ? QStringLiteral("UNF") : tr("fine"));
    std::size_t place = 0;
    for (const TapThreadView& thread : m_service.threads()) {
        if (thread.name == m_choice.thread) {
            const QString sentence = thread.name.starts_with('M')
                                         ? tr("%1: pitch diameter 6H (ISO 965-1) allows %2 p-p in the work, %3 with a "
                                              "tap at its upper limit.")
                                         : tr("%1: pitch diameter 2B (ASME B1.1) allows %2 p-p in the work, %3 with a "
                                              "tap at its upper limit.");
            m_thread->setText(sentence.arg(threadText(thread), errorText(thread.allowedPp_um, look().units()),
                                           errorText(thread.allowedPpWornTap_um, look().units())));
        }
        if (thread.coarse != m_coarse || thread.name.starts_with('M') == inch || place >= m_threadButtons.size()) {
            continue;
        }
        QPushButton* button = m_threadButtons[place++];
        const QString name = QString::fromStdString(thread.name);
        button->setText(QString(name).replace(u'x', QStringLiteral("×")));
        button->setObjectName(QStringLiteral("thread_") + name);
        button->setProperty("thread", name);
        button->setChecked(thread.name == m_choice.thread);
        button->show();
    }
    for (; place < m_threadButtons.size(); ++place) {
        m_threadButtons[place]->setObjectName({});
        m_threadButtons[place]->hide();
    }
}

void JobForm::apply() {
    for (const ValueField* field : m_fields) {
        if (!field->value()) {
            m_message->setText(field->whyInvalid());
            return;
        }
    }
    m_choice.speed_rpm = *m_fields[kSpeed]->value();
    m_choice.depth_rev = *m_fields[kDepth]->value();
    m_choice.gear = static_cast<std::uint8_t>(std::lround(*m_fields[kGear]->value()));
    m_choice.partType = std::to_string(std::lround(*m_fields[kPart]->value()));
    m_choice.tap = std::to_string(std::lround(*m_fields[kTap]->value()));
    if (const auto loaded = m_service.load(m_choice, m_author()); !loaded) {
        m_message->setText(sentenceText(loaded.error(), look().units()));
        return;
    }
    m_sheet.close();
}

}  // namespace kerf::ui
