// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/alarms/alarms_page.h"

#include <QButtonGroup>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QSaveFile>
#include <algorithm>

#include "db/api/alarm_reader.h"
#include "ui/dialogs/file_place.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

AlarmsPage::AlarmsPage(const PageContext& context, QWidget* parent)
    : Page(context, parent),
      m_model(context.look, context.alarms),
      m_nowButton(new QPushButton(this)),
      m_historyButton(new QPushButton(this)),
      m_table(new QTableView(this)),
      m_empty(makeLabel(TextRole::Dim, this, true)),
      m_detail(new Card(context.look, this)),
      m_title(makeLabel(TextRole::Title, this, true)),
      m_acknowledge(new ActionButton(context.look, this)),
      m_more(new ActionButton(context.look, this)),
      m_filter(new QPushButton(this)),
      m_export(new QPushButton(this)) {
    m_filter->setObjectName(QStringLiteral("alarmFilter"));
    m_export->setObjectName(QStringLiteral("alarmExport"));
    m_nowButton->setObjectName(QStringLiteral("alarmsNow"));
    m_historyButton->setObjectName(QStringLiteral("alarmsHistory"));
    m_table->setObjectName(QStringLiteral("alarmTable"));
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {m_nowButton, m_historyButton}) {
        button->setCheckable(true);
        group->addButton(button);
    }
    m_nowButton->setChecked(true);
    connect(m_nowButton, &QPushButton::clicked, this, [this] { showHistory(false); });
    connect(m_historyButton, &QPushButton::clicked, this, [this] { showHistory(true); });

    m_table->setModel(&m_model);
    m_table->setItemDelegateForColumn(AlarmModel::SignColumn, new SignDelegate(look(), this));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setWordWrap(true);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(AlarmModel::AlarmColumn, QHeaderView::Stretch);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &AlarmsPage::showDetail);

    auto* column = new QVBoxLayout(this);
    auto* top = new QHBoxLayout;
    top->addWidget(m_nowButton);
    top->addWidget(m_historyButton);
    top->addStretch(1);
    top->addWidget(m_filter);
    top->addWidget(m_export);
    top->addWidget(m_more);
    column->addLayout(top);
    column->addWidget(m_table, 3);
    column->addWidget(m_empty, 3);
    column->addWidget(m_detail, 2);
    m_empty->setAlignment(Qt::AlignCenter);

    m_detail->body()->addWidget(m_title);
    for (Part* part : {&m_cause, &m_consequence, &m_action}) {
        *part = {makeLabel(TextRole::Small, this), makeLabel(TextRole::Body, this, true)};
        m_detail->body()->addWidget(part->name);
        m_detail->body()->addWidget(part->text);
    }
    m_detail->body()->addStretch(1);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_acknowledge);
    m_detail->body()->addLayout(row);
    m_acknowledge->setPrimary(true);
    m_acknowledge->setPredicate([this] { return whyNoAcknowledge(); });
    m_more->setPredicate([this] { return m_complete ? tr("That is all.") : QString(); });
    connect(m_more, &QPushButton::clicked, this, &AlarmsPage::loadMore);
    connect(m_filter, &QPushButton::clicked, this, [this] {
        m_lowest = m_lowest == 1 ? 3 : m_lowest - 1;
        refresh();
    });
    connect(m_export, &QPushButton::clicked, this, &AlarmsPage::askExport);
    connect(m_acknowledge, &QPushButton::clicked, this, [this] {
        const AlarmLine* line = chosen();
        if (line == nullptr) {
            return;
        }
        this->context().withOperator([this, code = line->code] {
            this->context().alarms.acknowledge(code, this->context().session.name(), QDateTime::currentDateTime());
            selectFirstUnseen();
        });
    });
    connect(&context.alarms, &AlarmList::changed, this, &AlarmsPage::reload);
    refresh();
}

void AlarmsPage::showHistory(bool history) {
    m_showHistory = history;
    m_nowButton->setChecked(!history);
    m_historyButton->setChecked(history);
    if (history) {
        m_history.clear();
        m_oldest.reset();
        m_complete = false;
        loadMore();
    }
    reload();
}

void AlarmsPage::loadMore() {
    AlarmReader* reader = context().services.alarms;
    m_problem.clear();
    if (reader == nullptr) {
        m_problem = tr("No database is connected: only the alarms since the start are known.");
        m_complete = true;
        m_history.clear();
        const auto& entries = context().alarms.entries();
        for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
            m_history.push_back(alarmLine(*entry));
        }
    } else {
        const auto rows = reader->alarms(m_oldest, kHistoryPage);
        if (!rows) {
            m_problem = sentenceText(rows.error(), look().units());
            m_complete = true;
        } else {
            for (const AlarmRow& row : *rows) {
                m_history.push_back(alarmLine(row));
                m_oldest = row.id;
            }
            m_complete = rows->size() < kHistoryPage;
        }
    }
    m_more->reconsider();
    if (m_showHistory) {
        reload();
    }
}

void AlarmsPage::reload() {
    const AlarmLine* before = chosen();
    const std::optional<std::pair<AlarmCode, QDateTime>> key =
        before != nullptr ? std::optional(std::pair(before->code, before->raised)) : std::nullopt;
    std::vector<AlarmLine> lines;
    if (m_showHistory) {
        std::ranges::copy_if(m_history, std::back_inserter(lines),
                             [this](const AlarmLine& line) { return wanted(line); });
    } else {
        for (const AlarmEntry& entry : context().alarms.entries()) {
            if (entry.open()) {
                lines.push_back(alarmLine(entry));
            }
        }
        // Act-now first, then in the order they came: the first out of a group stays at its head.
        std::stable_sort(lines.begin(), lines.end(),
                         [](const AlarmLine& a, const AlarmLine& b) { return a.priority < b.priority; });
    }
    int select = lines.empty() ? -1 : 0;
    for (std::size_t i = 0; key && i < lines.size(); ++i) {
        if (lines[i].code == key->first && lines[i].raised == key->second) {
            select = static_cast<int>(i);
        }
    }
    m_model.setLines(std::move(lines));
    const bool empty = m_model.rowCount() == 0;
    m_table->setVisible(!empty);
    m_empty->setVisible(empty);
    m_detail->setVisible(!empty);
    for (QWidget* button : std::initializer_list<QWidget*>{m_more, m_filter, m_export}) {
        button->setVisible(m_showHistory);
    }
    m_export->setEnabled(!empty);
    m_empty->setText(!m_problem.isEmpty() && m_showHistory ? m_problem
                     : m_showHistory
                         ? tr("No alarm has been recorded yet.")
                         : tr("No alarms stand. One that comes up appears here until it has gone and been seen."));
    if (select >= 0) {
        m_table->selectRow(select);
    }
    showDetail();
}

const AlarmLine* AlarmsPage::chosen() const {
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() ? m_model.line(current.row()) : nullptr;
}

QString AlarmsPage::whyNoAcknowledge() const {
    const AlarmLine* line = chosen();
    if (line == nullptr) {
        return tr("Choose an alarm.");
    }
    if (line->acknowledged) {
        return tr("Seen by %1.").arg(line->acknowledgedBy);
    }
    const auto& entries = context().alarms.entries();
    const bool known = std::any_of(entries.begin(), entries.end(),
                                   [line](const AlarmEntry& e) { return e.code == line->code && !e.acknowledged; });
    return known ? QString() : tr("It is from an earlier run.");
}

void AlarmsPage::showDetail() {
    const AlarmLine* line = chosen();
    m_acknowledge->reconsider();
    if (line == nullptr) {
        return;
    }
    const AlarmText text = alarmText(context().alarms.spec(line->code), line->code);
    const QString numbers = m_model.detail(*line);
    m_title->setText(numbers.isEmpty() ? text.title : text.title + QStringLiteral(" – ") + numbers);
    const auto show = [](const Part& part, const QString& words) {
        part.text->setText(words);
        part.name->setVisible(!words.isEmpty());
        part.text->setVisible(!words.isEmpty());
    };
    show(m_cause, text.cause);
    show(m_consequence, text.consequence);
    show(m_action, text.action);
}

void AlarmsPage::refresh() {
    const int gap = look().space(Space::Medium);
    layout()->setContentsMargins(gap, gap, gap, gap);
    layout()->setSpacing(gap);
    layout()->itemAt(0)->layout()->setSpacing(look().metrics().touchGap());
    m_nowButton->setText(tr("Standing or unseen"));
    m_historyButton->setText(tr("History"));
    m_more->setText(tr("Older"));
    m_filter->setText(m_lowest == 3   ? tr("All priorities")
                      : m_lowest == 2 ? tr("Priority 1 and 2")
                                      : tr("Priority 1 only"));
    m_export->setText(tr("Export"));
    m_cause.name->setText(tr("Cause"));
    m_consequence.name->setText(tr("Consequence"));
    m_action.name->setText(tr("What to do"));
    m_acknowledge->setText(tr("Seen"));
    m_table->verticalHeader()->setDefaultSectionSize(look().metrics().touch());
    m_table->verticalHeader()->setMinimumSectionSize(look().metrics().touch());
    m_model.retranslate();
    reload();
    Page::refresh();
}

void AlarmsPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_showHistory) {
        showHistory(true);
    }
    selectFirstUnseen();
}

// What the list shows, as CSV.
void AlarmsPage::askExport() {
    Sheet* sheet =
        context().sheets.open(tr("Export the history"),
                              tr("What the list shows, as CSV. A file that is there already is never written over."));
    const QString name = QStringLiteral("kerf_alarms_%1.csv")
                             .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmm")));
    const QStringList folders = context().services.backupFolders ? context().services.backupFolders() : QStringList();
    for (int i = 0; i < folders.size(); ++i) {
        auto* button = new QPushButton(folders[i], sheet);
        button->setObjectName(QStringLiteral("alarmFolder%1").arg(i));
        sheet->body()->addWidget(button);
        connect(button, &QPushButton::clicked, sheet, [this, sheet, folder = folders[i], name] {
            const QString file = freeFileName(QDir(folder).filePath(name));
            const Result<void> written = writeHistory(file);
            context().notify(written ? tr("Written: %1").arg(file) : sentenceText(written.error(), look().units()));
            sheet->close();
        });
    }
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

Result<void> AlarmsPage::writeHistory(const QString& file) const {
    const auto quoted = [](QString text) { return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"'; };
    const auto instant = [](const std::optional<QDateTime>& at) {
        return at ? at->toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) : QString();
    };
    QString text = QStringLiteral("code,priority,alarm,detail,raised,cleared,acknowledged,acknowledged_by\r\n");
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const AlarmLine& line = *m_model.line(row);
        text += QStringList{QString::number(line.code),
                            QString::number(line.priority),
                            quoted(alarmText(context().alarms.spec(line.code), line.code).title),
                            quoted(m_model.detail(line)),
                            instant(line.raised),
                            instant(line.cleared),
                            instant(line.acknowledged),
                            quoted(line.acknowledgedBy)}
                    .join(u',') +
                QStringLiteral("\r\n");
    }
    QDir().mkpath(QFileInfo(file).absolutePath());
    QSaveFile target(file);
    const QByteArray bytes = QByteArray("\xEF\xBB\xBF") + text.toUtf8();  // spreadsheets take UTF-8 only with this mark
    if (!target.open(QIODevice::WriteOnly) || target.write(bytes) != bytes.size() || !target.commit()) {
        return fail(KERF_TEXT("The file cannot be written there. Choose another folder."));
    }
    return {};
}

// The one on the bottom line: "Show" and "Seen" then mean what the operator has read there.
void AlarmsPage::selectFirstUnseen() {
    const AlarmEntry* first = context().alarms.firstUnacknowledged();
    for (int row = 0; first != nullptr && !m_showHistory && row < m_model.rowCount(); ++row) {
        const AlarmLine* line = m_model.line(row);
        if (line->code == first->code && line->raised == first->raised) {
            m_table->selectRow(row);
        }
    }
}

}  // namespace kerf::ui
