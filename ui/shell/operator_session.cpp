// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/operator_session.h"

namespace kerf::ui {

OperatorSession::OperatorSession(QStringList known, QObject* parent) : QObject(parent), m_known(std::move(known)) {}

void OperatorSession::signOn(const QString& name) {
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty() || trimmed == m_name) {
        return;
    }
    m_name = trimmed;
    if (!m_known.contains(trimmed)) {
        m_known.append(trimmed);
        emit learned(m_known);
    }
    emit changed();
}

void OperatorSession::signOff() {
    if (signedOn()) {
        m_name.clear();
        emit changed();
    }
}

}  // namespace kerf::ui
