// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

namespace kerf::test {

/// Remembers that this test has passed with the very same programs and files: minutes of real time say nothing new
/// then.
///
/// What it rests on: the test itself, Kerf's programs in KERF_BIN, what LinuxCNC's simulator is started with, the
/// fixtures, and the installed LinuxCNC. Nothing is remembered without KERF_PASSED (a folder); KERF_AGAIN=1 looks
/// again.
class PassedBefore {
 public:
    PassedBefore() {
        const QString folder = qEnvironmentVariable("KERF_PASSED");
        if (folder.isEmpty()) {
            return;
        }
        QCryptographicHash told(QCryptographicHash::Sha1);
        QStringList files{QFile::symLinkTarget(QStringLiteral("/proc/self/exe"))};
        const QDir bin(qEnvironmentVariable("KERF_BIN"));
        for (const QString& name : bin.entryList({QStringLiteral("kerf*")}, QDir::Files, QDir::Name)) {
            if (!name.startsWith(QStringLiteral("kerf_"))) {  // benches and fixtures
                files.append(bin.filePath(name));
            }
        }
        const QString source = QStringLiteral(KERF_SOURCE_DIR);
        files.append(source + QStringLiteral("/scripts/linuxcnc-sim"));
        for (const QString& inside : {source + QStringLiteral("/resources/linuxcnc"),
                                      qEnvironmentVariable("KERF_FIXTURES") + QStringLiteral("/thermal")}) {
            QStringList found;
            for (QDirIterator at(inside, QDir::Files, QDirIterator::Subdirectories); at.hasNext();) {
                found.append(at.next());
            }
            found.sort();
            files += found;
        }
        for (const QString& name : files) {
            QFile file(name);
            told.addData(name.toUtf8());
            if (file.open(QIODevice::ReadOnly)) {
                (void)told.addData(&file);
            }
        }
        const QFileInfo control(QStandardPaths::findExecutable(QStringLiteral("linuxcnc")));
        told.addData(QByteArray::number(control.lastModified().toMSecsSinceEpoch()));
        m_mark = folder + u'/' + QString::fromLatin1(told.result().toHex());
    }
    [[nodiscard]] bool passed() const {
        return !m_mark.isEmpty() && !qEnvironmentVariableIsSet("KERF_AGAIN") && QFile::exists(m_mark);
    }
    void remember() const {
        if (!m_mark.isEmpty() && QDir().mkpath(QFileInfo(m_mark).path())) {
            (void)QFile(m_mark).open(QIODevice::WriteOnly);
        }
    }

 private:
    QString m_mark;
};

}  // namespace kerf::test
