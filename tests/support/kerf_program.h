// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace kerf::test {

/// What one run of the headless program left behind.
struct KerfRun {
    int exitCode{-1};
    QString out{};
    QString err{};
};

/// Runs bin/kerf with these arguments in the test's scratch folder.
inline KerfRun runKerf(const QStringList& arguments) {
    QProcess process;
    process.start(qEnvironmentVariable("KERF_BIN", QStringLiteral(".")) + QStringLiteral("/kerf"), arguments);
    KerfRun run;
    if (process.waitForStarted() && process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit) {
        run.exitCode = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

/// The same for `kerf COMMAND …`, as one would type it; no argument with a space in it.
inline KerfRun runKerf(const char* command, const QString& arguments) {
    return runKerf(QStringList{QLatin1String(command)} + arguments.split(u' ', Qt::SkipEmptyParts));
}

/// Writes a file into the scratch folder; returns its name.
inline QString scratchFile(const QString& name, const QString& text) {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        return {};
    }
    file.write(text.toUtf8());
    return name;
}

/// Fields of a CSV's rows, the header first.
inline QList<QStringList> csvRows(const QString& text) {
    QList<QStringList> rows;
    for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts)) {
        rows.append(line.split(u','));
    }
    return rows;
}

}  // namespace kerf::test
