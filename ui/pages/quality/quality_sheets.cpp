// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/quality_sheets.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <array>
#include <memory>

#include "ui/dialogs/limits_sheet.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

/// "Nelson 1: one beyond 3σ"
QString ruleName(quality::Rule rule) {
    const QString key = QString::fromLatin1(quality::ruleKey(rule));
    const QString text = engineText(quality::ruleText(rule));
    const QChar number = key.back();
    return key.startsWith(QLatin1String("nelson"))    ? QStringLiteral("Nelson %1: %2").arg(number).arg(text)
           : key.startsWith(QLatin1String("western")) ? QStringLiteral("Western Electric %1: %2").arg(number).arg(text)
                                                      : text;
}

}  // namespace

QualitySheets::QualitySheets(const PageContext& context, QualityService& service, QObject* parent)
    : QObject(parent), m_context(context), m_service(service) {}

void QualitySheets::tell(const QString& file, const Result<void>& written) {
    m_context.notify(written ? tr("Written: %1").arg(file)
                             : tr("Nothing written: %1").arg(sentenceText(written.error(), m_context.look.units())));
}

void QualitySheets::openFiles() {
    const LotQuality& lot = *m_service.shown();
    QString name = lot.lot.id > 0 ? QString::fromStdString(lot.lot.partTypeName + "_" + lot.lot.name)
                                  : QString::fromLatin1(processKey(lot.lot.process));
    for (QChar& letter : name) {
        if (!letter.isLetterOrNumber()) {
            letter = u'_';
        }
    }
    Sheet* sheet = m_context.sheets.open(tr("Report and files of the lot"),
                                         tr("A report is a PDF with the values attached as Q-DAS file and CSV."));
    auto* file = new QLineEdit(
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/kerf_") + name, sheet);
    file->setObjectName(QStringLiteral("fileName"));
    sheet->body()->addWidget(file);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto add = [this, sheet, file](const QString& text, const char* key, auto write) {
        sheet
            ->addButton(text,
                        [file = QPointer<QLineEdit>(file), write] {
                            if (file) {
                                write(file->text().trimmed());
                            }
                        })
            ->setObjectName(QLatin1String(key));
    };
    const auto report = [this, id = lot.lot.id](bool firstArticle, const QString& target) {
        m_service.writeReport(id, firstArticle, target.toStdString(),
                              [self = QPointer<QualitySheets>(this), target](const Result<void>& written) {
                                  if (self) {
                                      self->tell(target, written);
                                  }
                              });
    };
    add(tr("Lot report"), "fileLotReport",
        [report](const QString& base) { report(false, base + QStringLiteral(".pdf")); });
    add(tr("First article"), "fileFirstArticle",
        [report](const QString& base) { report(true, base + QStringLiteral("_first.pdf")); });
    add(tr("Q-DAS file"), "fileDfq", [this, id = lot.lot.id](const QString& base) {
        const QString target = base + QStringLiteral(".dfq");
        m_service.writeDfq(id, target.toStdString(),
                           [self = QPointer<QualitySheets>(this), target](const Result<void>& written) {
                               if (self) {
                                   self->tell(target, written);
                               }
                           });
    });
    sheet->addButton(tr("Automatic files"), [this] { openAutomaticFiles(); })
        ->setObjectName(QStringLiteral("fileAutomatic"));
}

void QualitySheets::openAutomaticFiles() {
    const DfqFiles now = m_service.dfqFiles();
    Sheet* sheet = m_context.sheets.open(
        tr("Q-DAS files by themselves"),
        tr("Each part gets a file in this folder once it is judged. Without a folder there are no files. "
           "Names may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}."));
    auto* form = new QFormLayout;
    auto* folder = new QLineEdit(QString::fromStdString(now.folder), sheet);
    auto* pattern = new QLineEdit(QString::fromStdString(now.pattern), sheet);
    auto* why = makeLabel(TextRole::Body, sheet, true);
    folder->setObjectName(QStringLiteral("dfqFolder"));
    pattern->setObjectName(QStringLiteral("dfqPattern"));
    why->setObjectName(QStringLiteral("dfqWhy"));
    form->addRow(tr("Folder"), folder);
    form->addRow(tr("File name"), pattern);
    sheet->body()->addLayout(form);
    sheet->body()->addWidget(why);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto save = [this, folder, pattern, why, open = QPointer<Sheet>(sheet)] {
        const DfqFiles files{folder->text().trimmed().toStdString(), pattern->text().trimmed().toStdString()};
        m_context.withPermission(Deed::QualityFiles, [this, files, why = QPointer<QLabel>(why), open] {
            if (open) open->sent();
            m_service.setDfqFiles(files, m_context.session.name().toStdString(),
                                  [this, why, open](const Result<void>& stored) {
                                      if (!stored && why) {
                                          why->setText(sentenceText(stored.error(), m_context.look.units()));
                                      } else if (stored && open) {
                                          open->taken();
                                      }
                                  });
        });
    };
    sheet->addButton(tr("Save"), save, false)->setObjectName(QStringLiteral("dfqSave"));
    QTimer::singleShot(0, folder, qOverload<>(&QWidget::setFocus));
}

void QualitySheets::openLimits(ProcessId process) {
    openLimitsSheet(m_context, process);
}

void QualitySheets::openRules() {
    Sheet* sheet = m_context.sheets.open(
        tr("Rules of the charts"),
        tr("What a rule finds becomes a signal and an alarm. Each one more alarms wrongly more often: Nelson 1 with "
           "the "
           "EWMA once in about 400 parts of a steady lot, all eight of Nelson once in about 100."));
    sheet->setWide();
    const quality::RuleSet now = m_service.rules();
    auto* grid = new QGridLayout;
    const auto boxes = std::make_shared<std::array<QPointer<QCheckBox>, quality::kRules>>();
    constexpr int kRows = 5;
    for (std::size_t i = 0; i < quality::kRules; ++i) {
        const auto rule = static_cast<quality::Rule>(i);
        auto* box = new QCheckBox(ruleName(rule), sheet);
        box->setObjectName(QStringLiteral("rule_") + QLatin1String(quality::ruleKey(rule)));
        box->setChecked(now[i]);
        grid->addWidget(box, static_cast<int>(i) % kRows, static_cast<int>(i) / kRows);
        (*boxes)[i] = box;
    }
    sheet->body()->addLayout(grid);
    auto* why = makeLabel(TextRole::Body, sheet, true);
    why->setObjectName(QStringLiteral("rulesWhy"));
    sheet->body()->addWidget(why);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto set = [boxes](const quality::RuleSet& rules) {
        for (std::size_t i = 0; i < quality::kRules; ++i) {
            (*boxes)[i]->setChecked(rules[i]);
        }
    };
    sheet
        ->addButton(
            tr("Default set"), [set] { set(quality::kDefaultRules); }, false)
        ->setObjectName(QStringLiteral("rulesDefault"));
    const auto save = [this, boxes, why, open = QPointer<Sheet>(sheet)] {
        quality::RuleSet rules;
        for (std::size_t i = 0; i < quality::kRules; ++i) {
            rules[i] = (*boxes)[i]->isChecked();
        }
        m_context.withPermission(Deed::QualityLimits, [this, rules, why = QPointer<QLabel>(why), open] {
            m_service.setRules(rules, m_context.session.name().toStdString(),
                               [this, why, open](const Result<void>& stored) {
                                   if (!stored && why) {
                                       why->setText(sentenceText(stored.error(), m_context.look.units()));
                                   } else if (stored && open) {
                                       open->close();
                                   }
                               });
        });
    };
    sheet->addButton(tr("Save"), save, false)->setObjectName(QStringLiteral("rulesSave"));
}

}  // namespace kerf::ui
