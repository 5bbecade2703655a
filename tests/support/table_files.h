// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QList>
#include <QString>
#include <functional>
#include <string>

#include "tests/support/golden.h"

/// Tables that a test bends a little before a command reads them, in the folder the test runs in.
namespace kerf::test {

inline QByteArray bytesOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QByteArray day(const char* name) {
    return bytesOf(QString::fromStdString(fixture(std::string("thermal/") + name + ".csv")));
}

inline QString put(const QString& name, const QByteArray& bytes) {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) || file.write(bytes) != bytes.size()) {
        return {};
    }
    return name;
}

/// A further column behind the others.
inline QByteArray withColumn(const QByteArray& text, const QByteArray& name,
                             const std::function<QByteArray(int)>& value) {
    QList<QByteArray> lines = text.split('\n');
    for (int k = 0; k < lines.size(); ++k) {
        if (!lines[k].isEmpty()) {
            lines[k] += ',' + (k == 0 ? name : value(k));
        }
    }
    return lines.join('\n');
}

}  // namespace kerf::test
