// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <string>

namespace kerf::ui {

/// Who stands at the machine. Every entry and correction carries this name.
class OperatorSession : public QObject {
    Q_OBJECT
 public:
    explicit OperatorSession(QStringList known = {}, QObject* parent = nullptr);

    [[nodiscard]] QString name() const { return m_name; }
    [[nodiscard]] bool signedOn() const { return !m_name.isEmpty(); }
    /// The name as the desk wants it.
    [[nodiscard]] std::string author() const { return m_name.toStdString(); }
    [[nodiscard]] const QStringList& known() const { return m_known; }

    void signOn(const QString& name);
    void signOff();

 signals:
    void changed();
    void learned(const QStringList& known);

 private:
    QString m_name;
    QStringList m_known;
};

}  // namespace kerf::ui
