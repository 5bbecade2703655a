// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/operator_session.h"

#include <QCryptographicHash>
#include <QRandomGenerator>
#include <algorithm>

namespace kerf::ui {
namespace {

constexpr int kDigestRounds = 5000;  // some milliseconds for each try
constexpr qint64 kMinute_ms = 60'000;

QString digest(const QString& salt, const QString& pin) {
    QByteArray bytes = (salt + u':' + pin).toUtf8();
    for (int i = 0; i < kDigestRounds; ++i) {
        bytes = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    }
    return salt + u':' + QString::fromLatin1(bytes.toHex());
}

QString sealed(const QString& pin) {
    return digest(QString::number(QRandomGenerator::system()->generate64(), 16), pin);
}

bool opens(const QString& stored, const QString& pin) {
    return stored.isEmpty() || digest(stored.section(u':', 0, 0), pin) == stored;
}

}  // namespace

QString roleName(Role role) {
    switch (role) {
        case Role::Operator:
            return OperatorSession::tr("operator");
        case Role::Setter:
            return OperatorSession::tr("setter");
        case Role::Engineer:
            return OperatorSession::tr("process engineer");
    }
    return {};
}

const char* roleKey(Role role) {
    switch (role) {
        case Role::Operator:
            break;
        case Role::Setter:
            return "setter";
        case Role::Engineer:
            return "engineer";
    }
    return "operator";
}

Role roleOf(const QString& key) {
    return key == QLatin1String("engineer") ? Role::Engineer
           : key == QLatin1String("setter") ? Role::Setter
                                            : Role::Operator;
}

OperatorSession::OperatorSession(SignOnSettings settings, QObject* parent)
    : QObject(parent), m_settings(std::move(settings)) {}

QStringList OperatorSession::known() const {
    QStringList names;
    for (const OperatorAccount& account : m_settings.accounts) {
        names << account.name;
    }
    return names;
}

const OperatorAccount* OperatorSession::account(const QString& name) const {
    const auto found = std::ranges::find(m_settings.accounts, name, &OperatorAccount::name);
    return found == m_settings.accounts.end() ? nullptr : &*found;
}

OperatorAccount* OperatorSession::find(const QString& name) {
    return const_cast<OperatorAccount*>(account(name));
}

std::optional<Role> OperatorSession::role() const {
    const OperatorAccount* me = signedOn() ? account(m_name) : nullptr;
    return me == nullptr ? std::nullopt : std::optional(me->role);
}

QString OperatorSession::whyNot(Role least) const {
    const auto mine = role();
    if (!mine || *mine >= least) {
        return {};
    }
    return least == Role::Engineer ? tr("Only a process engineer may do this.")
                                   : tr("Only a setter or a process engineer may do this.");
}

QString OperatorSession::whyNoRoles() const {
    const bool engineerKnown = std::ranges::any_of(
        m_settings.accounts, [](const OperatorAccount& known) { return known.role == Role::Engineer; });
    return !engineerKnown || role() == Role::Engineer ? QString() : tr("Only a process engineer may give this role.");
}

bool OperatorSession::signOn(const QString& name, Role roleOfNew, const QString& pin) {
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty() || trimmed == m_name) {
        return !trimmed.isEmpty();
    }
    const OperatorAccount* known = account(trimmed);
    if (known != nullptr && !opens(known->pin, pin)) {
        emit audited(trimmed, QStringLiteral("PIN refused"), {});
        return false;
    }
    if (signedOn()) {
        emit audited(m_name, QStringLiteral("signed off"), {});
    }
    m_name = trimmed;
    m_lastTouch_ms.reset();
    if (known == nullptr) {
        m_settings.accounts.push_back({trimmed, roleOfNew, {}});
        emit settingsChanged(m_settings);
    }
    emit audited(m_name, QStringLiteral("signed on"), QLatin1String(roleKey(*role())));
    emit changed();
    return true;
}

void OperatorSession::signOff() {
    leave(QStringLiteral("signed off"));
}

void OperatorSession::leave(const QString& action) {
    if (signedOn()) {
        const QString who = m_name;
        m_name.clear();
        emit audited(who, action, {});
        emit changed();
    }
}

void OperatorSession::setRole(const QString& name, Role role) {
    OperatorAccount* known = find(name);
    if (known == nullptr || known->role == role || !whyNoRoles().isEmpty()) {
        return;
    }
    known->role = role;
    emit audited(m_name.isEmpty() ? name : m_name, QStringLiteral("role set"),
                 name + u' ' + QLatin1String(roleKey(role)));
    emit settingsChanged(m_settings);
    emit changed();
}

bool OperatorSession::setPin(const QString& name, const QString& pin) {
    const bool digits = std::ranges::all_of(pin, [](QChar c) { return c >= u'0' && c <= u'9'; });
    OperatorAccount* known = find(name);
    if (known == nullptr || !digits || (!pin.isEmpty() && (pin.size() < kShortestPin || pin.size() > kLongestPin))) {
        return false;
    }
    known->pin = pin.isEmpty() ? QString() : sealed(pin);
    emit audited(m_name.isEmpty() ? name : m_name,
                 pin.isEmpty() ? QStringLiteral("PIN removed") : QStringLiteral("PIN set"), name);
    emit settingsChanged(m_settings);
    return true;
}

void OperatorSession::setAutoSignOff_min(int minutes) {
    if (minutes != m_settings.autoSignOff_min) {
        m_settings.autoSignOff_min = minutes;
        emit settingsChanged(m_settings);
    }
}

void OperatorSession::tick(qint64 now_ms) {
    if (!signedOn() || !m_lastTouch_ms) {
        m_lastTouch_ms = now_ms;  // counting begins with the first tick after the sign-on
        return;
    }
    const int minutes = m_settings.autoSignOff_min;
    if (minutes != SignOnSettings::kNever && now_ms - *m_lastTouch_ms >= minutes * kMinute_ms) {
        leave(QStringLiteral("signed off by itself"));
    }
}

}  // namespace kerf::ui
