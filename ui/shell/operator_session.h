// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/services/permissions.h"

namespace kerf::ui {

/// What somebody is trusted with (ui/services/permissions.h).
using Role = Trust;
inline constexpr std::array kRoles{Role::Operator, Role::Setter, Role::Engineer};

/// A person known at this machine.
struct OperatorAccount {
    QString name{};
    Role role{Role::Operator};
    QString pin{};           ///< its seal (ui/shell/pin_seal.h), never the PIN itself; empty: none is asked
    unsigned wrongTries{0};  ///< wrong PINs in a row, and when the last was typed, ms since 1970
    qint64 lastWrong_ms{0};

    friend bool operator==(const OperatorAccount&, const OperatorAccount&) = default;
};

/// What is kept about signing on; the application stores it.
struct SignOnSettings {
    static constexpr int kNever = 0;

    std::vector<OperatorAccount> accounts{};
    /// A simulated machine: a new name may take any role while no process engineer is known. On a real one the first
    /// engineer is made with a PIN at first start, and everybody else begins as an operator.
    bool demonstration{true};
    int autoSignOff_min{15};  ///< without a touch or key; kNever: stays signed on

    friend bool operator==(const SignOnSettings&, const SignOnSettings&) = default;
};

/// Who stands at the machine, and what he or she may do. Every entry and correction carries this name.
///
/// A PIN keeps colleagues apart; it is no protection against somebody who can read the data file. Time is handed in
/// (milliseconds of any steady clock), so that signing off by itself can be tested without waiting.
class OperatorSession : public QObject {
    Q_OBJECT
 public:
    static constexpr int kShortestPin = 4;
    static constexpr int kLongestPin = 8;
    static constexpr qint64 kSecondCounts_ms = 120'000;

    explicit OperatorSession(SignOnSettings settings = {}, QObject* parent = nullptr);

    [[nodiscard]] QString name() const { return m_name; }
    [[nodiscard]] bool signedOn() const { return !m_name.isEmpty(); }
    /// The name as the service wants it.
    [[nodiscard]] std::string author() const { return m_name.toStdString(); }
    /// Empty: nobody is signed on.
    [[nodiscard]] std::optional<Role> role() const;
    [[nodiscard]] const SignOnSettings& settings() const { return m_settings; }
    [[nodiscard]] QStringList known() const;
    /// Null: not known.
    [[nodiscard]] const OperatorAccount* account(const QString& name) const;

    /// Why the one who is signed on may not do what needs `least` ("Only a setter or an engineer …", translated). Empty
    /// when it is allowed, and when nobody is signed on: then the action asks who is there first.
    [[nodiscard]] QString whyNot(Role least) const;
    [[nodiscard]] QString whyNot(Deed deed) const { return whyNot(permissionOf(deed).least); }
    /// Signed on, and trusted with it.
    [[nodiscard]] bool may(Role least) const { return signedOn() && whyNot(least).isEmpty(); }
    /// Why nobody's role can be set now; only a demonstration without an engineer lets anybody name one.
    [[nodiscard]] QString whyNoRoles() const;

    /// Why a PIN of this account is not even looked at now ("Wait %1 s …"); empty: it is.
    [[nodiscard]] QString whyNotYet(const QString& name) const;
    /// A real machine without a process engineer: the first one has to be made, with a PIN.
    [[nodiscard]] bool firstEngineerMissing() const;
    /// Makes the first process engineer and signs him on. False: there is one, or the PIN is none.
    bool makeFirstEngineer(const QString& name, const QString& pin);
    /// Milliseconds since 1970, for the wait after wrong PINs; tests hand in their own.
    void setClock(std::function<qint64()> now_ms) { m_now_ms = std::move(now_ms); }

    /// A name not yet known is added with `roleOfNew`, or as operator where whyNoRoles() says so. False when a PIN is
    /// asked for and `pin` is not it, or it is too early after wrong ones.
    bool signOn(const QString& name, Role roleOfNew = Role::Engineer, const QString& pin = {});
    void signOff();
    /// @pre whyNoRoles() is empty
    void setRole(const QString& name, Role role);
    /// Digits only, kShortestPin to kLongestPin of them, or empty to ask for none. False when it is neither.
    bool setPin(const QString& name, const QString& pin);
    /// Somebody else, a setter or process engineer with a PIN, stands beside the one who is signed on and says yes; it
    /// counts for kSecondCounts_ms, and ends with whoever it was said to. False: not such a person, or another PIN.
    bool confirmAsSecond(const QString& name, const QString& pin);
    /// Empty: nobody, or too long ago.
    [[nodiscard]] QString second() const;
    /// Who could: all but the one who is signed on.
    [[nodiscard]] QStringList possibleSeconds() const;
    /// Why this person cannot be taken off the list: oneself, or the last process engineer. Empty: can be.
    [[nodiscard]] QString whyNotRemove(const QString& name) const;
    /// @pre whyNotRemove() is empty
    void remove(const QString& name);
    void setAutoSignOff_min(int minutes);

    /// Somebody touched the screen or a key.
    void touched(qint64 now_ms) { m_lastTouch_ms = now_ms; }
    /// Now and then: signs off when nobody has touched anything for long enough.
    void tick(qint64 now_ms);

 signals:
    /// Another person, another role, or nobody.
    void changed();
    void settingsChanged(const kerf::ui::SignOnSettings& settings);
    /// A wrong PIN, or the right one after wrong ones.
    void wrongPins(const QString& name, unsigned tries, qint64 last_ms);
    /// For the audit log, in English: "signed on", "signed off", "PIN refused", "role set" …
    void audited(const QString& author, const QString& action, const QString& detail);

 private:
    void leave(const QString& action);
    OperatorAccount* find(const QString& name);

    SignOnSettings m_settings;
    QString m_name;
    QString m_second;
    qint64 m_secondSaid_ms{0};
    std::function<qint64()> m_now_ms;
    std::optional<qint64> m_lastTouch_ms{};
};

[[nodiscard]] QString roleName(Role role);
/// "operator", "setter", "engineer": as stored.
[[nodiscard]] const char* roleKey(Role role);
[[nodiscard]] Role roleOf(const QString& key);

}  // namespace kerf::ui
