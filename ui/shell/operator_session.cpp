// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/operator_session.h"

#include <QDateTime>
#include <algorithm>

#include "ui/shell/pin_seal.h"

namespace kerf::ui {
namespace {

constexpr qint64 kMinute_ms = 60'000;

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
    : QObject(parent), m_settings(std::move(settings)), m_now_ms(&QDateTime::currentMSecsSinceEpoch) {}

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
    const bool free = !engineerKnown && m_settings.demonstration;
    return free || role() == Role::Engineer ? QString() : tr("Only a process engineer may give this role.");
}

bool OperatorSession::signOn(const QString& name, Role roleOfNew, const QString& pin) {
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty() || trimmed == m_name) {
        return !trimmed.isEmpty();
    }
    OperatorAccount* known = find(trimmed);
    if (known != nullptr && !whyNotYet(trimmed).isEmpty()) {
        return false;
    }
    if (known != nullptr && !opensSeal(known->pin, pin)) {
        known->lastWrong_ms = m_now_ms();
        emit wrongPins(trimmed, ++known->wrongTries, known->lastWrong_ms);
        emit audited(trimmed, QStringLiteral("PIN refused"), {});
        return false;
    }
    if (known != nullptr && known->wrongTries > 0) {
        known->wrongTries = 0;
        emit wrongPins(trimmed, 0, 0);
    }
    const bool mayChoose = whyNoRoles().isEmpty();
    if (signedOn()) {
        emit audited(m_name, QStringLiteral("signed off"), {});
    }
    m_name = trimmed;
    m_second.clear();
    m_lastTouch_ms.reset();
    if (known == nullptr) {
        OperatorAccount fresh;
        fresh.name = trimmed;
        fresh.role = mayChoose ? roleOfNew : Role::Operator;
        m_settings.accounts.push_back(fresh);
        emit settingsChanged(m_settings);
    }
    emit audited(m_name, QStringLiteral("signed on"), QLatin1String(roleKey(*role())));
    emit changed();
    return true;
}

QString OperatorSession::whyNotYet(const QString& name) const {
    const OperatorAccount* known = account(name);
    const qint64 left_ms = known == nullptr ? 0 : known->lastWrong_ms + pinWait_ms(known->wrongTries) - m_now_ms();
    return left_ms <= 0 || known->wrongTries == 0
               ? QString()
               : tr("Several wrong PINs were typed: wait %1 s.").arg((left_ms + 999) / 1000);
}

bool OperatorSession::firstEngineerMissing() const {
    return !m_settings.demonstration && std::ranges::none_of(m_settings.accounts, [](const OperatorAccount& known) {
        return known.role == Role::Engineer;
    });
}

bool OperatorSession::makeFirstEngineer(const QString& name, const QString& pin) {
    const QString trimmed = name.simplified();
    const bool digits = std::ranges::all_of(pin, [](QChar c) { return c >= u'0' && c <= u'9'; });
    if (!firstEngineerMissing() || trimmed.isEmpty() || !digits || pin.size() < kShortestPin ||
        pin.size() > kLongestPin) {
        return false;
    }
    std::erase_if(m_settings.accounts, [&trimmed](const OperatorAccount& known) { return known.name == trimmed; });
    OperatorAccount first;
    first.name = trimmed;
    first.role = Role::Engineer;
    first.pin = sealPin(pin);
    m_settings.accounts.push_back(first);
    m_name = trimmed;
    m_lastTouch_ms.reset();
    emit settingsChanged(m_settings);
    emit audited(m_name, QStringLiteral("first process engineer made"), {});
    emit audited(m_name, QStringLiteral("signed on"), QLatin1String(roleKey(Role::Engineer)));
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
        m_second.clear();
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
    // Somebody else's PIN is set by a process engineer, one's own by oneself.
    const bool mine =
        name == m_name || role() == Role::Engineer || (m_settings.demonstration && whyNoRoles().isEmpty());
    if (known == nullptr || !digits || !mine ||
        (!pin.isEmpty() && (pin.size() < kShortestPin || pin.size() > kLongestPin))) {
        return false;
    }
    known->pin = pin.isEmpty() ? QString() : sealPin(pin);
    emit audited(m_name.isEmpty() ? name : m_name,
                 pin.isEmpty() ? QStringLiteral("PIN removed") : QStringLiteral("PIN set"), name);
    emit settingsChanged(m_settings);
    return true;
}

bool OperatorSession::confirmAsSecond(const QString& name, const QString& pin) {
    OperatorAccount* other = find(name);
    if (!signedOn() || other == nullptr || !possibleSeconds().contains(name) || !whyNotYet(name).isEmpty()) {
        return false;
    }
    if (!opensSeal(other->pin, pin)) {
        other->lastWrong_ms = m_now_ms();
        emit wrongPins(name, ++other->wrongTries, other->lastWrong_ms);
        emit audited(name, QStringLiteral("PIN refused"), {});
        return false;
    }
    m_second = name;
    m_secondSaid_ms = m_now_ms();
    emit audited(name, QStringLiteral("second person"), m_name);
    return true;
}

QString OperatorSession::second() const {
    return m_now_ms() - m_secondSaid_ms <= kSecondCounts_ms ? m_second : QString();
}

QStringList OperatorSession::possibleSeconds() const {
    QStringList names;
    for (const OperatorAccount& account : m_settings.accounts) {
        if (account.name != m_name && account.role >= Role::Setter && !account.pin.isEmpty()) {
            names << account.name;
        }
    }
    return names;
}

QString OperatorSession::whyNotRemove(const QString& name) const {
    if (const QString may = whyNot(Deed::PersonRemove); !may.isEmpty()) {
        return may;
    }
    return !signedOn() ? tr("Sign on first.") : name == m_name ? tr("Nobody takes himself off the list.") : QString();
}

void OperatorSession::remove(const QString& name) {
    if (!whyNotRemove(name).isEmpty()) {
        return;
    }
    std::erase_if(m_settings.accounts, [&name](const OperatorAccount& known) { return known.name == name; });
    emit settingsChanged(m_settings);
    emit changed();
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
