// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/parts/parts_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QScrollBar>
#include <QScroller>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <vector>

#include "db/api/lot_reader.h"
#include "ui/dialogs/file_place.h"
#include "ui/dialogs/measurement_sheet.h"
#include "ui/link/texts.h"
#include "ui/services/quality_service.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kTypingPause_ms = 250;

}  // namespace

PartsPage::PartsPage(const PageContext& page, QWidget* parent)
    : Page(page, parent),
      m_reader(page.services.parts),
      m_service(page.services.boringService),
      m_columns(new QHBoxLayout(this)) {
    if (m_reader == nullptr) {
        m_missing = addNotice(m_columns);
    } else {
        build();
    }
    refresh();
}

PartsPage::~PartsPage() = default;

void PartsPage::build() {
    m_search = new QLineEdit(this);
    m_process = new QComboBox(this);
    m_thisLot = new QPushButton(this);
    m_bad = new QPushButton(this);
    m_export = new ActionButton(look(), this);
    m_count = makeLabel(TextRole::Dim, this);
    m_table = new QTableView(this);
    m_model = new PartsModel(*m_reader, this);
    m_detail = new PartDetailPanel(
        look(), [this] { return m_service == nullptr ? tr("no lot is open") : QString(); }, this);
    m_exporter = new PartExport(this);
    m_tools = new QHBoxLayout;
    m_search->setObjectName(QStringLiteral("partsSearch"));
    m_thisLot->setObjectName(QStringLiteral("partsThisLot"));
    m_process->setObjectName(QStringLiteral("partsProcess"));
    m_bad->setObjectName(QStringLiteral("partsBad"));
    m_export->setObjectName(QStringLiteral("partsExport"));
    m_count->setObjectName(QStringLiteral("partsCount"));
    m_table->setObjectName(QStringLiteral("partsTable"));
    m_thisLot->setCheckable(true);
    m_bad->setCheckable(true);
    QualityService* quality = context().services.qualityService;
    m_bad->setVisible(quality != nullptr);
    if (quality != nullptr) {
        m_model->setVerdicts([quality](const PartRow& part) { return quality->judge(part).verdict; });
        m_detail->setJudge([quality](const PartRow& part) { return quality->judge(part); });
        quality->onChanged([this] { m_detail->retranslate(); });
    }
    m_search->setClearButtonEnabled(true);

    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    // What is looked for first stands left; the rest is there for those who scroll.
    QHeaderView* header = m_table->horizontalHeader();
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const std::array order{PartsModel::Part,     PartsModel::Lot,       PartsModel::Ended,
                           PartsModel::Verdict,  PartsModel::Diameters, PartsModel::Changes,
                           PartsModel::PartType, PartsModel::Serial,    PartsModel::Result};
    for (int place = 0; place < static_cast<int>(order.size()); ++place) {
        header->moveSection(header->visualIndex(order[static_cast<std::size_t>(place)]), place);
    }
    QScroller::grabGesture(m_table->viewport(), QScroller::TouchGesture);

    m_tools->addWidget(m_search, 1);
    m_tools->addWidget(m_process);
    m_tools->addWidget(m_thisLot);
    m_tools->addWidget(m_bad);
    m_tools->addWidget(m_export);
    auto* left = new QVBoxLayout;
    left->addLayout(m_tools);
    left->addWidget(m_count);
    left->addWidget(m_table, 1);
    m_columns->addLayout(left, 3);
    m_columns->addWidget(m_detail, 2);

    connect(m_model, &PartsModel::problem, this, [this](const Sentence& sentence) { m_problem = sentence; });
    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPause_ms);
    connect(&m_typing, &QTimer::timeout, this, &PartsPage::search);
    connect(m_search, &QLineEdit::textChanged, this, [this] { m_typing.start(); });
    connect(m_search, &QLineEdit::returnPressed, this, &PartsPage::search);
    connect(m_thisLot, &QPushButton::clicked, this, &PartsPage::search);
    connect(m_process, &QComboBox::activated, this, &PartsPage::search);
    connect(m_bad, &QPushButton::clicked, this, &PartsPage::search);
    connect(m_export, &QPushButton::clicked, this, &PartsPage::openExport);
    m_export->setPredicate([this] { return whyNoExport(); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (now.isValid()) {
            choose(now.data(PartsModel::PartIdRole).toLongLong());
        }
    });
    connect(m_detail, &PartDetailPanel::correctRequested, this,
            [this](const MeasurementRow& row) { context().withOperator([this, row] { openForm(row, false); }); });
    connect(m_detail, &PartDetailPanel::voidRequested, this,
            [this](const MeasurementRow& row) { context().withOperator([this, row] { openForm(row, true); }); });
    m_detail->setFileActions(static_cast<bool>(context().services.setSerial),
                             static_cast<bool>(context().services.writeReport));
    connect(m_detail, &PartDetailPanel::serialRequested, this,
            [this] { context().withOperator([this] { askSerial(); }); });
    connect(m_detail, &PartDetailPanel::reportRequested, this, &PartsPage::openReport);
    connect(m_exporter, &PartExport::finished, this, [this](const QString& file, qulonglong rows) {
        m_export->reconsider();
        context().notify(tr("%1 rows written to %2.").arg(rows).arg(file));
    });
    connect(m_exporter, &PartExport::failed, this, [this](const Sentence& why) {
        m_export->reconsider();
        context().notify(tr("Nothing exported: %1").arg(sentenceText(why, look().units())));
    });
    if (m_service != nullptr) {
        m_subscription = m_service->onChanged([this] {
            m_behind = true;
            if (isVisible()) {
                update();
            }
        });
    }
}

void PartsPage::refresh() {
    setObjectName(QStringLiteral("partsPage"));
    const int gap = look().space(Space::Medium);
    m_columns->setContentsMargins(gap, gap, gap, gap);
    m_columns->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(tr("This console has no database, so there are no parts to show."));
    } else {
        m_search->setPlaceholderText(tr("Search: lot, part type, serial number"));
        m_thisLot->setText(tr("This lot"));
        m_bad->setText(tr("Out of tolerance"));
        const QSignalBlocker quietly(m_process);
        const int chosen = std::max(0, m_process->currentIndex());
        m_process->clear();
        m_process->addItem(tr("All processes"));
        for (const ProcessDescriptor* process : processes()) {
            if (process->makesParts) {
                m_process->addItem(processName(process->id), static_cast<int>(process->id));
            }
        }
        m_process->setCurrentIndex(chosen);
        m_export->setText(tr("Export"));
        m_tools->setSpacing(look().metrics().touchGap());
        m_table->verticalHeader()->setDefaultSectionSize(look().metrics().touch());
        m_model->setUnits(look().units());
        m_model->retranslate();
        m_export->reconsider();
        showCount();
        fitColumns();
    }
    Page::refresh();
}

void PartsPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_behind && m_model != nullptr) {
        m_searched ? update() : search();
    }
}

void PartsPage::search() {
    m_typing.stop();
    m_behind = false;
    PartQuery query;
    if (m_process->currentData().isValid()) {
        query.process = static_cast<ProcessId>(m_process->currentData().toInt());
    }
    query.text = m_search->text().trimmed().toStdString();
    if (m_thisLot->isChecked() && context().services.lots != nullptr) {
        const ProcessId process = query.process.value_or(ProcessId::Boring);
        if (const auto lot = context().services.lots->activeLot(process); lot && *lot) {
            query.lot = **lot;
        }
    }
    m_problem = {};
    m_searched = true;
    m_model->setOnlyBad(m_bad->isChecked());
    m_model->setQuery(query);
    afterReading();
}

// What is new comes on top; the chosen part stays chosen.
void PartsPage::update() {
    m_behind = false;
    m_problem = {};
    m_model->update();
    afterReading();
}

void PartsPage::afterReading() {
    fitColumns();
    showCount();
    if (!m_table->currentIndex().isValid() && m_model->rowCount() > 0) {
        m_table->selectRow(0);
    } else if (m_chosen) {
        choose(*m_chosen);  // its measurements may have changed
    }
}

// Nobody scrolls sideways with gloves: what the chosen part's panel says anyway goes first when it is narrow.
void PartsPage::fitColumns() {
    constexpr std::array kExpendable{PartsModel::Result, PartsModel::PartType, PartsModel::Changes, PartsModel::Serial,
                                     PartsModel::Ended};
    for (int column = 0; column < PartsModel::ColumnCount; ++column) {
        m_table->setColumnHidden(column, false);
    }
    m_table->resizeColumnsToContents();
    // The bar that the rows will need may not be there yet.
    const bool scrolls = m_table->verticalHeader()->length() > m_table->viewport()->height();
    const int bar = scrolls ? m_table->verticalScrollBar()->sizeHint().width() : 0;
    const int room = m_table->maximumViewportSize().width() - bar;
    int width = 0;
    for (int column = 0; column < PartsModel::ColumnCount; ++column) {
        width += m_table->columnWidth(column);
    }
    for (const int column : kExpendable) {
        if (width <= room) {
            break;
        }
        width -= m_table->columnWidth(column);
        m_table->setColumnHidden(column, true);
    }
    // What is left over spreads evenly, so that the eye finds the end of a line.
    std::vector<int> shown;
    for (int column = 0; column < PartsModel::ColumnCount; ++column) {
        if (!m_table->isColumnHidden(column)) {
            shown.push_back(column);
        }
    }
    const int spare = room - width;
    for (const int column : shown) {
        m_table->setColumnWidth(column,
                                m_table->columnWidth(column) + std::max(0, spare / static_cast<int>(shown.size())));
    }
}

void PartsPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    if (m_table != nullptr) {
        QMetaObject::invokeMethod(
            this, [this] { fitColumns(); }, Qt::QueuedConnection);  // once the table has its new width
    }
}

void PartsPage::askSerial() {
    if (!m_detail->part()) {
        return;
    }
    const PartRow& part = m_detail->part()->part;
    Sheet* sheet = context().sheets.open(tr("Serial number of part %1").arg(part.number),
                                         tr("Type it or read it with a scanner."));
    auto* edit = new QLineEdit(QString::fromStdString(part.serial), sheet);
    edit->setObjectName(QStringLiteral("serialNumber"));
    edit->selectAll();
    sheet->body()->addWidget(edit);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    QPushButton* accept = sheet->addButton(tr("Save"), std::function<void()>(), false);
    connect(accept, &QPushButton::clicked, sheet, [this, sheet, accept, edit, id = part.id] {
        const auto told = [self = QPointer<PartsPage>(this)](const Result<void>& stored) {
            if (PartsPage* page = self.data()) {
                page->context().notify(stored ? tr("The serial number is stored.")
                                              : sentenceText(stored.error(), page->look().units()));
                page->update();
            }
        };
        context().services.setSerial(id, edit->text().simplified(), context().session.name(),
                                     sheet->whenStored(accept, told));
    });
    accept->setObjectName(QStringLiteral("serialSave"));
    connect(edit, &QLineEdit::returnPressed, accept, &QPushButton::click);
    edit->setFocus();
}

void PartsPage::writeReport(PartId part, const QString& file) {
    const auto told = [self = QPointer<PartsPage>(this), file](const Result<void>& written) {
        if (PartsPage* page = self.data()) {
            page->context().notify(written ? tr("Written: %1").arg(file)
                                           : sentenceText(written.error(), page->look().units()));
        }
    };
    context().services.writeReport(part, file, told);
}

void PartsPage::openReport() {
    if (!m_detail->part()) {
        return;
    }
    const PartRow& part = m_detail->part()->part;
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString name = part.serial.empty()
                             ? QStringLiteral("lot%1_part%2").arg(QString::fromStdString(part.lotName)).arg(part.number)
                             : QString::fromStdString(part.serial);
    Sheet* sheet = context().sheets.open(tr("Report of part %1").arg(part.number),
                                         tr("One page as PDF, or its measurements as CSV."));
    auto* file = new QLineEdit(folder + QStringLiteral("/kerf_") + QString(name).replace(u'/', u'_'), sheet);
    file->setObjectName(QStringLiteral("reportFile"));
    sheet->body()->addWidget(file);
    addFolders(sheet, context().services.backupFolders ? context().services.backupFolders() : QStringList(), file);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("reportClose"));
    QPushButton* csv = sheet->addButton(
        tr("CSV"),
        [this, sheet, file, id = part.id] {
            if (!m_exporter->running()) {
                PartQuery only;
                only.after = id - 1;
                only.before = id + 1;
                m_exporter->start(context().services.openParts, {}, only, PartExport::What::Measurements,
                                  freeFileName(file->text().trimmed() + QStringLiteral(".csv")));
                sheet->close();
            }
        },
        false);
    csv->setObjectName(QStringLiteral("reportCsv"));
    csv->setEnabled(static_cast<bool>(context().services.openParts));
    QPushButton* pdf = sheet->addButton(
        tr("PDF"),
        [this, sheet, file, id = part.id] {
            writeReport(id, freeFileName(file->text().trimmed() + QStringLiteral(".pdf")));
            sheet->close();
        },
        false);
    pdf->setObjectName(QStringLiteral("reportPdf"));
    pdf->setEnabled(static_cast<bool>(context().services.writeReport));
}

void PartsPage::showCount() {
    const std::uint64_t matches = m_model->matches();
    if (!m_problem.empty()) {
        m_count->setText(sentenceText(m_problem, look().units()));
    } else if (m_model->onlyBad()) {
        m_count->setText(
            tr("%1 parts out of tolerance among the newest %2").arg(m_model->rowCount()).arg(m_model->lookedAt()));
    } else if (matches >= PartsModel::kCountedAtMost) {
        m_count->setText(tr("More than %1 parts, newest first").arg(PartsModel::kCountedAtMost));
    } else if (matches == 0) {
        m_count->setText(tr("No part matches. Finished parts appear here by themselves."));
    } else {
        m_count->setText(tr("%1 parts, newest first").arg(matches));
    }
}

void PartsPage::choose(PartId id) {
    m_chosen = id;
    const Result<std::optional<PartDetail>> part = m_reader->part(id);
    if (part) {
        m_detail->show(*part);
    } else {
        m_detail->showProblem(part.error());
    }
}

void PartsPage::openForm(const MeasurementRow& row, bool takeOut) {
    if (m_service == nullptr || !m_detail->part()) {
        return;
    }
    MeasurementSubject subject;
    subject.id = row.id;
    subject.place = tr("part %1, %2 deep", "part number, position")
                        .arg(m_detail->part()->part.number)
                        .arg(look().units().withUnit(row.position_mm, "mm", 0));
    subject.diameter_mm = row.diameter_mm.value_or(0.0);
    subject.expected_mm = subject.diameter_mm;
    subject.settingRing_mm = m_service->view().settingRing_mm;
    MeasurementForm::open(
        context().sheets, look(), *m_service, [this] { return context().session.author(); }, subject,
        takeOut ? MeasurementForm::Start::Void : MeasurementForm::Start::Correct,
        [this](const QString& sentence) {
            context().notify(sentence);
            update();
        });
}

QString PartsPage::whyNoExport() const {
    if (!context().services.openParts) {
        return tr("no database");
    }
    return m_exporter->running() ? tr("being written") : QString();
}

void PartsPage::openExport() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmm"));
    Sheet* sheet = context().sheets.open(
        tr("Export as CSV"), tr("All parts that the search shows, oldest first, in mm whatever the screen shows."));
    auto* file = new QLineEdit(folder + QStringLiteral("/kerf_") + stamp + QStringLiteral(".csv"), sheet);
    file->setObjectName(QStringLiteral("exportFile"));
    sheet->body()->addWidget(file);
    addFolders(sheet, context().services.backupFolders ? context().services.backupFolders() : QStringList(), file);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("exportClose"));
    const auto add = [this, sheet, file](const QString& text, const char* name, PartExport::What what) {
        sheet
            ->addButton(text,
                        [this, file = QPointer<QLineEdit>(file), what] {
                            if (const QLineEdit* edit = file.data(); edit != nullptr && !m_exporter->running()) {
                                QualityService* quality = context().services.qualityService;
                                m_exporter->start(
                                    context().services.openParts,
                                    quality != nullptr ? quality->openVerdicts() : PartExport::OpenVerdicts(),
                                    m_model->query(), what, freeFileName(edit->text().trimmed()));
                                m_export->reconsider();
                            }
                        })
            ->setObjectName(QLatin1String(name));
    };
    add(tr("Parts"), "exportParts", PartExport::What::Parts);
    add(tr("Measurements"), "exportMeasurements", PartExport::What::Measurements);
    add(tr("Figures"), "exportFigures", PartExport::What::Figures);
    add(tr("Feed"), "exportFeed", PartExport::What::Feed);
}

}  // namespace kerf::ui
