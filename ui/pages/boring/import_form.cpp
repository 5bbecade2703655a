// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/import_form.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <functional>

#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr qsizetype kMostFiles = 6;
constexpr std::size_t kMostQuestions = 3;
constexpr std::size_t kMostNotes = 3;

}  // namespace

ImportForm* ImportForm::open(const PageContext& context) {
    Sheet* sheet = context.sheets.open({});
    auto* form = new ImportForm(context, sheet);
    sheet->body()->addWidget(form);
    form->show();
    return form;
}

ImportForm::ImportForm(const PageContext& context, Sheet* sheet)
    : FaceWidget(context.look, sheet),
      m_context(context),
      m_service(*context.services.boringService),
      m_sheet(sheet),
      m_path(new QLineEdit(this)),
      m_plan(makeLabel(TextRole::Body, this, true)),
      m_look(new ActionButton(context.look)),
      m_take(new ActionButton(context.look)) {
    m_path->setObjectName(QStringLiteral("importPath"));
    m_plan->setObjectName(QStringLiteral("importPlan"));
    m_look->setObjectName(QStringLiteral("importLook"));
    m_take->setObjectName(QStringLiteral("importTake"));
    new QVBoxLayout(this);
    layout()->setContentsMargins(0, 0, 0, 0);
    listFiles();
    layout()->addWidget(m_path);
    layout()->addWidget(m_plan);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("importCancel"));
    sheet->addButton(
        m_look, [this] { lookInto(); }, false);
    sheet->addButton(
        m_take,
        [this] {
            m_context.withOperator([form = QPointer<ImportForm>(this)] {
                if (ImportForm* const there = form.data(); there != nullptr) {
                    there->take();
                }
            });
        },
        false);
    m_look->setPredicate([this] {
        return m_busy ? tr("being read") : m_path->text().trimmed().isEmpty() ? tr("choose a file first") : QString();
    });
    m_take->setPredicate([this] { return whyNoTake(); });
    m_take->setPrimary(true);
    connect(m_path, &QLineEdit::textChanged, this, [this] {
        m_read.reset();
        m_refusal = {};
        refresh();
    });
    connect(m_path, &QLineEdit::returnPressed, this, [this] { lookInto(); });
    refresh();
}

/// One touch per file: newest first, of the endings that loggers and gauge stations use.
void ImportForm::listFiles() {
    QFileInfoList files;
    for (const char* ending : {"csv", "txt", "tsv"}) {
        const auto& there = m_context.services.filesThere;
        for (const QString& file : there ? there(QLatin1String(ending)) : QStringList{}) {
            files << QFileInfo(file);
        }
    }
    std::ranges::stable_sort(files, std::greater{}, [](const QFileInfo& info) { return info.lastModified(); });
    for (const QFileInfo& info : files.first(std::min(kMostFiles, files.size()))) {
        auto* button = new QPushButton(
            info.fileName() + QStringLiteral("  –  ") + QDir::toNativeSeparators(info.absolutePath()), this);
        button->setObjectName(QStringLiteral("importFile%1").arg(m_files.size()));
        connect(button, &QPushButton::clicked, this, [this, file = info.absoluteFilePath()] {
            m_path->setText(file);
            lookInto();
        });
        layout()->addWidget(button);
        m_files.push_back(button);
    }
}

void ImportForm::refresh() {
    if (m_sheet) {
        m_sheet->setTitle(tr("Diameters from a file"));
        m_sheet->setText(tr(
            "A table with the columns part, overhang and diameter, in any order and spelling. Nothing is taken before "
            "you have seen what it would do."));
    }
    m_path->setPlaceholderText(tr("or the file's path"));
    m_path->setAccessibleName(tr("File"));
    m_look->setText(tr("Look into it"));
    const auto count = static_cast<int>(m_would.rows.size());
    m_take->setText(!m_read || count == 0        ? tr("Take over")
                    : !m_would.questions.empty() ? tr("Yes, take all %1 as they are").arg(count)
                                                 : tr("Take %1 diameters").arg(count));
    m_plan->setText(planText());
    layout()->setSpacing(look().metrics().touchGap());
    m_look->reconsider();
    m_take->reconsider();
    FaceWidget::refresh();
}

QString ImportForm::whyNoTake() const {
    if (m_busy) {
        return tr("a moment");
    }
    if (!m_read) {
        return tr("look into a file first");
    }
    if (!m_read->problem.empty()) {
        return tr("it cannot be read");
    }
    return m_would.refused ? tr("a row is refused") : m_would.rows.empty() ? tr("nothing new in it") : QString();
}

QString ImportForm::planText() const {
    if (m_busy) {
        return tr("A moment …");
    }
    if (!m_read) {
        return {};
    }
    if (!m_read->problem.empty()) {
        return tr("Nothing is taken: %1").arg(QString::fromStdString(m_read->problem));
    }
    const UnitSystem& units = m_context.look.units();
    const auto finding = [&units](const BoreImportPlan::Finding& one) {
        return tr("Line %1: %2").arg(one.line).arg(sentenceText(one.reason, units));
    };
    QStringList lines;
    if (!m_refusal.empty()) {
        lines << tr("Nothing is taken: %1").arg(sentenceText(m_refusal, units));
    }
    if (m_would.refused) {
        lines << tr("Nothing is taken: %1").arg(finding(*m_would.refused));
    } else {
        const auto& rows = m_would.rows;
        if (!rows.empty()) {
            const auto [least, most] = std::ranges::minmax(rows, {}, &BoreImportPlan::Row::diameter_mm);
            lines << tr("%1 would be entered: %2 diameters of parts %3 to %4, from %5 to %6.")
                         .arg(QString::fromStdString(m_read->file), QString::number(rows.size()),
                              QString::number(rows.front().partNumber), QString::number(rows.back().partNumber),
                              diameterText(least.diameter_mm, units), diameterText(most.diameter_mm, units));
        }
        if (m_would.known > 0) {
            lines << tr("%1 of its values are stored already.").arg(m_would.known);
        }
        for (std::size_t i = 0; i < m_would.questions.size() && i < kMostQuestions; ++i) {
            lines << finding(m_would.questions[i]);
        }
        if (m_would.questions.size() > kMostQuestions) {
            lines << tr("… and %1 more like it.").arg(m_would.questions.size() - kMostQuestions);
        }
    }
    for (std::size_t i = 0; i < m_read->notes.size() && i < kMostNotes; ++i) {
        lines << QString::fromStdString(m_read->notes[i]);
    }
    return lines.join(u'\n');
}

void ImportForm::lookInto() {
    const QString file = m_path->text().trimmed();
    const auto& read = m_context.services.readBores;
    if (m_busy || file.isEmpty() || !read) {
        return;
    }
    m_busy = true;
    m_read.reset();
    m_refusal = {};
    refresh();
    read(file, [form = QPointer<ImportForm>(this)](const ReadBores& there) {
        if (ImportForm* const open = form.data(); open != nullptr) {
            open->found(there);
        }
    });
}

void ImportForm::found(const ReadBores& read) {
    m_busy = false;
    m_read = read;
    m_would = read.problem.empty() ? m_service.planImport(read) : BoreImportPlan{};
    refresh();
}

void ImportForm::take() {
    if (!whyNoTake().isEmpty()) {
        return;
    }
    m_busy = true;
    refresh();
    if (m_sheet) {
        m_sheet->sent();
    }
    m_service.importBores(*m_read, m_context.session.author(), !m_would.questions.empty(),
                          [form = QPointer<ImportForm>(this)](const Result<void>& result) {
                              if (ImportForm* const there = form.data(); there != nullptr) {
                                  there->answered(result);
                              }
                          });
}

void ImportForm::answered(const Result<void>& result) {
    m_busy = false;
    if (!result) {
        m_refusal = result.error();
        m_would = m_service.planImport(*m_read);
        refresh();
        return;
    }
    m_context.notify(tr("%1 diameters taken over from %2.")
                         .arg(QString::number(m_would.rows.size()), QString::fromStdString(m_read->file)));
    if (m_sheet) {
        m_sheet->taken();
    }
}

}  // namespace kerf::ui
