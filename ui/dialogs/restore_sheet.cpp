// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/restore_sheet.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

struct Restore {
    Q_DECLARE_TR_FUNCTIONS(Restore)
};

constexpr int kMostFiles = 6;  // newest first: who wants an older one moves it

/// Checking a large backup takes seconds: who has left the question and types elsewhere keeps his form.
void laidReady(const PageContext& context, const Sheet* asked, const Result<void>& done) {
    const QString why = done ? QString() : sentenceText(done.error(), context.look.units());
    if (!context.sheets.isOpen(asked)) {
        context.notify(done ? Restore::tr("The backup is whole and takes the place of the data at the next start.")
                            : Restore::tr("Not restored: %1").arg(why));
        return;
    }
    if (!done) {
        context.sheets.tell(Restore::tr("Not restored"), why);
        return;
    }
    Sheet* sheet = context.sheets.open(
        Restore::tr("The backup is whole and waits"),
        Restore::tr(
            "It takes the place of the data at the next start of Kerf. What is stored until then goes aside with "
            "the data that are there now."));
    sheet->addButton(Restore::tr("Later"), {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet
        ->addButton(Restore::tr("End Kerf now"),
                    [window = QPointer<QWidget>(context.sheets.window())] {
                        if (window) {
                            window->close();  // asks, when something is being cut
                        }
                    })
        ->setObjectName(QStringLiteral("restoreEnd"));
}

void askWhy(const PageContext& context, const QString& file) {
    Sheet* sheet = context.sheets.open(
        Restore::tr("Put this backup in the place of the data?"),
        Restore::tr("%1, of %2. Everything stored since then goes aside into a file of its own, nothing is deleted.")
            .arg(QFileInfo(file).fileName(),
                 QLocale().toString(QFileInfo(file).lastModified(), QStringLiteral("yyyy-MM-dd HH:mm"))));
    auto* why = new QLineEdit(sheet);
    why->setObjectName(QStringLiteral("restoreReason"));
    why->setMaxLength(200);
    why->setPlaceholderText(Restore::tr("Why"));
    sheet->body()->addWidget(why);
    why->setFocus();
    sheet->addButton(Restore::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    auto* go = new QPushButton(Restore::tr("Check it and lay it ready"));
    go->setObjectName(QStringLiteral("restoreGo"));
    const auto check = [context, file, why, go, sheet] {
        go->setEnabled(false);
        why->setReadOnly(true);
        sheet->setText(Restore::tr("It is being checked …"));
        context.services.restore(file, QString::fromStdString(context.session.author()), why->text(),
                                 [context, why, go, asked = QPointer<Sheet>(sheet)](const Result<void>& done) {
                                     if (asked && !done) {  // another try
                                         go->setEnabled(true);
                                         why->setReadOnly(false);
                                         asked->setText({});
                                     }
                                     laidReady(context, asked, done);
                                 });
    };
    sheet->addButton(go, check, false);
}

}  // namespace

void openRestore(const PageContext& context) {
    const QStringList files = context.services.filesThere(QStringLiteral("db"));
    Sheet* sheet = context.sheets.open(
        Restore::tr("Restore a backup"),
        files.isEmpty()
            ? Restore::tr(
                  "No backup lies on a removable drive, among the documents or in the backups folder of the data.")
            : Restore::tr("Touch the one that shall take the place of the data; it is checked first."));
    for (int i = 0; i < std::min<int>(kMostFiles, static_cast<int>(files.size())); ++i) {
        const QFileInfo info(files[i]);
        auto* button = new QPushButton(info.fileName() + QStringLiteral("   ") +
                                           QLocale().toString(info.lastModified(), QStringLiteral("yyyy-MM-dd HH:mm")) +
                                           QStringLiteral("\n") + info.absolutePath(),
                                       sheet);
        button->setObjectName(QStringLiteral("restoreFile%1").arg(i));
        sheet->body()->addWidget(button);
        QObject::connect(button, &QPushButton::clicked, sheet, [context, file = files[i]] { askWhy(context, file); });
    }
    sheet->addButton(Restore::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace kerf::ui
