// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/file_place.h"

#include <QDir>
#include <QFileInfo>

namespace kerf::ui {

QString freeFileName(const QString& wanted) {
    const QFileInfo info(wanted);
    QString name = wanted;
    for (int n = 2; QFileInfo::exists(name); ++n) {
        const QString ending = info.suffix().isEmpty() ? QString() : u'.' + info.suffix();
        name = info.dir().filePath(QStringLiteral("%1_%2%3").arg(info.completeBaseName()).arg(n).arg(ending));
    }
    return name;
}

void addFolders(Sheet* sheet, const QStringList& folders, QLineEdit* file) {
    for (int i = 0; i < folders.size(); ++i) {
        auto* button = new QPushButton(folders[i], sheet);
        button->setObjectName(QStringLiteral("fileFolder%1").arg(i));
        sheet->body()->addWidget(button);
        QObject::connect(button, &QPushButton::clicked, file, [file, folder = folders[i]] {
            file->setText(QDir(folder).filePath(QFileInfo(file->text().trimmed()).fileName()));
        });
    }
}

}  // namespace kerf::ui
