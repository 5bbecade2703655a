// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shift/shift_page.h"

#include <QDateTime>
#include <QDir>
#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPointer>
#include <QScroller>

#include "ui/dialogs/file_place.h"
#include "ui/link/shift_texts.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kLookAgain_ms = 30'000;
constexpr std::int64_t kMinute_ms = 60'000;

QString minuteOf(std::int64_t utc_ms) {
    return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("HH:mm"));
}

void fill(QTableWidget* table, const QList<QStringList>& rows, const QString& none) {
    table->setRowCount(rows.isEmpty() ? 1 : static_cast<int>(rows.size()));
    table->clearSpans();
    if (rows.isEmpty()) {
        table->setSpan(0, 0, 1, table->columnCount());
        table->setItem(0, 0, new QTableWidgetItem(none));
        return;
    }
    for (int r = 0; r < rows.size(); ++r) {
        for (int c = 0; c < rows[r].size(); ++c) {
            auto* item = new QTableWidgetItem(rows[r][c]);
            item->setToolTip(rows[r][c]);
            table->setItem(r, c, item);
        }
    }
}

}  // namespace

ShiftPage::ShiftPage(const PageContext& context, QWidget* parent)
    : Page(context, parent), m_service(context.services.shiftService) {
    if (m_service == nullptr) {
        auto* rows = new QVBoxLayout(this);
        m_missing = makeLabel(TextRole::Body, this, true);
        m_missing->setAlignment(Qt::AlignCenter);
        rows->addWidget(m_missing);
    } else {
        build();
        connect(&m_timer, &QTimer::timeout, this, [this] {
            if (isVisible()) {
                read();
            }
        });
        m_timer.start(kLookAgain_ms);
    }
    refresh();
}

QTableWidget* ShiftPage::makeTable(const char* name, int columns) {
    auto* table = new QTableWidget(0, columns, this);
    table->setObjectName(QLatin1String(name));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setFocusPolicy(Qt::NoFocus);
    table->setShowGrid(false);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->hide();
    table->horizontalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(columns - 1, QHeaderView::Stretch);
    table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    return table;
}

void ShiftPage::build() {
    auto* rows = new QVBoxLayout(this);
    auto* top = new QHBoxLayout;
    m_period = makeLabel(TextRole::Title, this, true);
    m_period->setObjectName(QStringLiteral("shiftPeriod"));
    m_earlier = new QPushButton(this);
    m_earlier->setObjectName(QStringLiteral("shiftEarlier"));
    m_now = new QPushButton(this);
    m_now->setObjectName(QStringLiteral("shiftNow"));
    m_pdf = new QPushButton(this);
    m_pdf->setObjectName(QStringLiteral("shiftPdf"));
    top->addWidget(m_period, 1);
    top->addWidget(m_earlier);
    top->addWidget(m_now);
    top->addWidget(m_pdf);
    rows->addLayout(top);
    auto* grid = new QGridLayout;
    rows->addLayout(grid, 1);
    m_partsCard = new Card(look(), this);
    m_stopsCard = new Card(look(), this);
    m_notesCard = new Card(look(), this);
    m_changesCard = new Card(look(), this);
    m_alarmsCard = new Card(look(), this);
    grid->addWidget(m_partsCard, 0, 0);
    grid->addWidget(m_stopsCard, 1, 0, 2, 1);
    grid->addWidget(m_notesCard, 0, 1);
    grid->addWidget(m_changesCard, 1, 1);
    grid->addWidget(m_alarmsCard, 2, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(0, 4);
    grid->setRowStretch(1, 3);
    grid->setRowStretch(2, 2);
    m_parts = makeTable("shiftParts", 2);
    m_saving = makeLabel(TextRole::Small, this, true);
    m_saving->setObjectName(QStringLiteral("shiftSaving"));
    m_partsCard->body()->addWidget(m_parts, 1);
    m_partsCard->body()->addWidget(m_saving);
    m_stops = makeTable("shiftStops", 4);
    m_stops->setWordWrap(true);
    m_stopsCard->body()->addWidget(m_stops, 1);
    m_notes = makeTable("shiftNotes", 3);
    m_notes->setWordWrap(true);
    m_notesCard->body()->addWidget(m_notes, 1);
    auto* buttons = new QHBoxLayout;
    m_note = new QPushButton(this);
    m_note->setObjectName(QStringLiteral("shiftNote"));
    m_handOver = new ActionButton(look(), this);
    m_handOver->setObjectName(QStringLiteral("shiftHandOver"));
    m_handOver->setPredicate([this] { return m_back == 0 ? QString() : tr("this shift has been handed over"); });
    buttons->addWidget(m_note);
    buttons->addWidget(m_handOver);
    m_notesCard->body()->addLayout(buttons);
    m_changes = makeTable("shiftChanges", 3);
    m_changesCard->body()->addWidget(m_changes, 1);
    m_alarms = makeTable("shiftAlarms", 3);
    m_alarmsCard->body()->addWidget(m_alarms, 1);
    connect(m_earlier, &QPushButton::clicked, this, [this] {
        ++m_back;
        read();
    });
    connect(m_now, &QPushButton::clicked, this, [this] {
        m_back = 0;
        read();
    });
    connect(m_pdf, &QPushButton::clicked, this, &ShiftPage::print);
    connect(m_note, &QPushButton::clicked, this, [this] { write(false); });
    connect(m_handOver, &QPushButton::clicked, this, [this] { write(true); });
    connect(m_stops, &QTableWidget::cellClicked, this, [this](int row, int) { nameStop(row); });
}

void ShiftPage::refresh() {
    setObjectName(QStringLiteral("shiftPage"));
    if (m_service == nullptr) {
        m_missing->setText(tr("No data file is open: a shift is what is stored between two handovers."));
        Page::refresh();
        return;
    }
    const int gap = look().space(Space::Medium);
    layout()->setContentsMargins(gap, gap, gap, gap);
    layout()->setSpacing(gap);
    for (QTableWidget* table : {m_parts, m_stops, m_notes, m_changes, m_alarms}) {
        const int row = table == m_stops ? look().metrics().touch() : look().px(7.0);
        table->verticalHeader()->setMinimumSectionSize(row);
        table->verticalHeader()->setDefaultSectionSize(row);
        table->setMinimumHeight(look().px(14.0));
    }
    m_partsCard->setTitle(tr("Parts"));
    m_stopsCard->setTitle(tr("Stops: touch one and say why"));
    m_notesCard->setTitle(tr("Notes and handover"));
    m_changesCard->setTitle(tr("Changes"));
    m_alarmsCard->setTitle(tr("Alarms"));
    m_earlier->setText(tr("◀ Shift before"));
    m_now->setText(tr("This shift"));
    m_pdf->setText(tr("One page (PDF)"));
    m_note->setText(tr("Leave a note"));
    m_handOver->setText(tr("Hand over"));
    show();
    Page::refresh();
}

void ShiftPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_service != nullptr) {
        read();
    }
}

void ShiftPage::read() {
    if (m_reading) {
        return;
    }
    m_reading = true;
    m_service->read(m_back, [page = QPointer<ShiftPage>(this)](const Result<ShiftView>& view) {
        if (ShiftPage* self = page.data()) {
            self->arrived(view);
        }
    });
}

void ShiftPage::arrived(const Result<ShiftView>& view) {
    m_reading = false;
    if (view) {
        m_view = *view;
        show();
    } else {
        m_period->setText(sentenceText(view.error(), look().units()));
    }
}

void ShiftPage::show() {
    if (m_view.toUtc_ms != 0) {
        const QString from =
            QDateTime::fromMSecsSinceEpoch(m_view.fromUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        m_period->setText(
            !m_view.current ? tr("Shift from %1 to %2").arg(from, minuteOf(m_view.toUtc_ms))
            : m_view.takenFrom.empty()
                ? tr("The last twelve hours; a shift begins when one is handed over.")
                : tr("This shift, taken over from %2 at %1").arg(from, QString::fromStdString(m_view.takenFrom)));
    }
    QList<QStringList> parts;
    for (const ShiftParts& row : m_view.parts) {
        parts << QStringList{processName(row.process), shiftPartsText(row)};
    }
    fill(m_parts, parts, tr("No part was finished."));
    m_saving->setText(shiftSavingText(m_view.saving));
    QList<QStringList> stops;
    for (const ShiftStop& stop : m_view.stops) {
        stops << QStringList{stop.goesOn
                                 ? tr("since %1").arg(minuteOf(stop.fromUtc_ms))
                                 : QStringLiteral("%1–%2").arg(minuteOf(stop.fromUtc_ms), minuteOf(stop.toUtc_ms)),
                             tr("%1 min").arg((stop.toUtc_ms - stop.fromUtc_ms) / kMinute_ms),
                             stopReasonText(stop.reason), QString::fromStdString(stop.author)};
    }
    fill(m_stops, stops, tr("Nothing stood longer than three minutes."));
    QList<QStringList> notes;
    for (const ShiftNote& note : m_view.notes) {
        const QString text = QString::fromStdString(note.text);
        notes << QStringList{minuteOf(note.utc_ms), QString::fromStdString(note.author),
                             note.handover ? tr("Handover: %1").arg(text) : text};
    }
    fill(m_notes, notes, tr("No note was left."));
    QList<QStringList> changes;
    for (const ShiftChange& change : m_view.changes) {
        changes << QStringList{minuteOf(change.utc_ms), QString::fromStdString(change.author), changeText(change)};
    }
    fill(m_changes, changes, tr("Nothing was changed."));
    QList<QStringList> alarms;
    for (const ShiftAlarm& alarm : m_view.alarms) {
        alarms << QStringList{minuteOf(alarm.lastUtc_ms), QStringLiteral("%1×").arg(alarm.times),
                              alarmText(context().alarms.spec(alarm.code), alarm.code).title};
    }
    fill(m_alarms, alarms, tr("No alarm came."));
    m_now->setEnabled(m_back > 0);
    m_earlier->setEnabled(m_view.fromUtc_ms > 0 && !m_view.takenFrom.empty());
    m_handOver->reconsider();
}

void ShiftPage::told(const Result<void>& result, const QString& done) {
    context().notify(result ? done : sentenceText(result.error(), look().units()));
    read();
}

void ShiftPage::nameStop(int row) {
    if (row < 0 || row >= static_cast<int>(m_view.stops.size())) {
        return;
    }
    const ShiftStop stop = m_view.stops[static_cast<std::size_t>(row)];
    context().withOperator([this, stop] {
        Sheet* sheet =
            context().sheets.open(tr("Why did nothing run?"),
                                  QStringLiteral("%1–%2").arg(minuteOf(stop.fromUtc_ms), minuteOf(stop.toUtc_ms)));
        auto* grid = new QGridLayout;
        grid->setSpacing(look().metrics().touchGap());
        int i = 0;
        for (const std::string& key : stopReasons()) {
            auto* button = new QPushButton(stopReasonText(key), sheet);
            button->setObjectName(QStringLiteral("stopReason_") + QString::fromStdString(key));
            connect(button, &QPushButton::clicked, sheet, [this, sheet, key, stop] {
                sheet->close();
                m_service->nameStop(stop.fromUtc_ms, key, context().session.author(),
                                    [page = QPointer<ShiftPage>(this)](const Result<void>& result) {
                                        if (ShiftPage* self = page.data()) {
                                            self->told(result, tr("The reason is kept."));
                                        }
                                    });
            });
            grid->addWidget(button, i / 3, i % 3);
            ++i;
        }
        sheet->body()->addLayout(grid);
        sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    });
}

void ShiftPage::write(bool handover) {
    context().withOperator([this, handover] {
        Sheet* sheet = context().sheets.open(
            handover ? tr("Hand over the shift") : tr("A note for the next shift"),
            handover ? tr("It is signed by %1. The next shift begins now.").arg(context().session.name()) : QString());
        auto* text = new QLineEdit(sheet);
        text->setObjectName(QStringLiteral("shiftText"));
        text->setMaxLength(400);
        text->setPlaceholderText(tr("What the next one has to know"));
        sheet->body()->addWidget(text);
        text->setFocus();
        sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
        QPushButton* save =
            sheet->addButton(handover ? tr("Sign and hand over") : tr("Keep the note"), std::function<void()>(), false);
        connect(save, &QPushButton::clicked, sheet, [this, sheet, save, text, handover] {
            const std::string words = text->text().trimmed().toStdString();
            if (!handover && words.empty()) {
                sheet->close();
                return;
            }
            const auto done =
                sheet->whenStored(save, [page = QPointer<ShiftPage>(this), handover](const Result<void>& result) {
                    if (ShiftPage* self = page.data()) {
                        self->told(result, handover ? tr("The shift is handed over.") : tr("The note is kept."));
                    }
                });
            handover ? m_service->handOver(words, context().session.author(), done)
                     : m_service->note(words, context().session.author(), done);
        });
        save->setObjectName(QStringLiteral("shiftSave"));
        connect(text, &QLineEdit::returnPressed, save, &QPushButton::click);
    });
}

void ShiftPage::print() {
    const QStringList folders =
        context().services.backupFolders ? context().services.backupFolders() : QStringList{QDir::homePath()};
    Sheet* sheet = context().sheets.open(tr("Where to"), tr("A file that is there already is never written over."));
    auto* column = new QVBoxLayout;
    column->setSpacing(look().metrics().touchGap());
    const QString name = tr("shift", "file name") +
                         QDateTime::fromMSecsSinceEpoch(m_view.toUtc_ms).toString(QStringLiteral("_yyyy-MM-dd_HHmm"));
    for (int i = 0; i < folders.size(); ++i) {
        auto* button = new QPushButton(folders[i], sheet);
        button->setObjectName(QStringLiteral("shiftFolder%1").arg(i));
        connect(button, &QPushButton::clicked, sheet, [this, sheet, folder = folders[i], name] {
            sheet->close();
            const QString file = freeFileName(QDir(folder).filePath(name + QStringLiteral(".pdf")));
            m_service->writePdf(m_view, file.toStdString(),
                                [page = QPointer<ShiftPage>(this), file](const Result<void>& r) {
                                    if (ShiftPage* self = page.data()) {
                                        self->told(r, tr("Written: %1").arg(file));
                                    }
                                });
        });
        column->addWidget(button);
    }
    sheet->body()->addLayout(column);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace kerf::ui
