// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCryptographicHash>
#include <QSignalSpy>
#include <QTest>

#include "ui/shell/operator_session.h"
#include "ui/shell/pin_seal.h"

using namespace kerf::ui;

class TestOperatorSession : public QObject {
    Q_OBJECT

    static constexpr qint64 kMinute_ms = 60'000;

 private slots:
    void eachRoleMayWhatTheOnesBeforeItMay() {
        OperatorSession session;
        QVERIFY(session.whyNot(Role::Engineer).isEmpty());  // nobody there: the action asks who it is
        QVERIFY(!session.may(Role::Operator));
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QVERIFY(session.may(Role::Operator));
        QVERIFY(session.whyNot(Role::Setter).contains(QStringLiteral("Only a setter")));
        QVERIFY(session.signOn(QStringLiteral("Lee"), Role::Setter));
        QVERIFY(session.may(Role::Setter));
        QVERIFY(!session.may(Role::Engineer));
        QVERIFY(session.signOn(QStringLiteral("Park"), Role::Engineer));
        QVERIFY(session.may(Role::Engineer));
    }
    void aKnownNameKeepsItsRole() {
        OperatorSession session;
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        session.signOff();
        QVERIFY(session.signOn(QStringLiteral("  Kim "), Role::Engineer));
        QCOMPARE(*session.role(), Role::Operator);
        QCOMPARE(session.settings().accounts.size(), std::size_t{1});
    }
    void rolesAreGivenByAnEngineerOnceThereIsOne() {
        OperatorSession session;
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QVERIFY(session.whyNoRoles().isEmpty());  // no engineer yet: somebody must be the first
        session.setRole(QStringLiteral("Kim"), Role::Engineer);
        QCOMPARE(*session.role(), Role::Engineer);
        QVERIFY(session.signOn(QStringLiteral("Lee"), Role::Operator));
        QVERIFY(!session.whyNoRoles().isEmpty());
        session.setRole(QStringLiteral("Lee"), Role::Engineer);
        QCOMPARE(*session.role(), Role::Operator);
    }
    void aSecondPersonCountsForTwoMinutesAndForOnePerson() {
        OperatorSession session;
        qint64 now_ms = 1'000'000;
        session.setClock([&now_ms] { return now_ms; });
        QVERIFY(session.signOn(QStringLiteral("Park"), Role::Engineer));
        QVERIFY(session.signOn(QStringLiteral("Lee"), Role::Setter));
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QVERIFY(session.signOn(QStringLiteral("Park")));
        QVERIFY(session.possibleSeconds().isEmpty());  // nobody has a PIN
        QVERIFY(session.setPin(QStringLiteral("Lee"), QStringLiteral("1234")));
        QVERIFY(session.setPin(QStringLiteral("Kim"), QStringLiteral("1234")));
        QCOMPARE(session.possibleSeconds(), QStringList{QStringLiteral("Lee")});
        QVERIFY(!session.confirmAsSecond(QStringLiteral("Park"), {}));  // not oneself
        QVERIFY(!session.confirmAsSecond(QStringLiteral("Kim"), QStringLiteral("1234")));
        QVERIFY(!session.confirmAsSecond(QStringLiteral("Lee"), QStringLiteral("9999")));
        QVERIFY(session.second().isEmpty());
        QVERIFY(session.confirmAsSecond(QStringLiteral("Lee"), QStringLiteral("1234")));
        QCOMPARE(session.second(), QStringLiteral("Lee"));
        now_ms += OperatorSession::kSecondCounts_ms + 1;
        QVERIFY(session.second().isEmpty());
        QVERIFY(session.confirmAsSecond(QStringLiteral("Lee"), QStringLiteral("1234")));
        session.signOff();
        QVERIFY(session.signOn(QStringLiteral("Park")));
        QVERIFY(session.second().isEmpty());
    }
    void anEngineerTakesOthersOffTheList() {
        OperatorSession session;
        QVERIFY(session.signOn(QStringLiteral("Park"), Role::Engineer));
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QVERIFY(!session.whyNotRemove(QStringLiteral("Park")).isEmpty());  // an operator may not
        session.remove(QStringLiteral("Park"));
        QCOMPARE(session.known().size(), 2);
        QVERIFY(session.signOn(QStringLiteral("Park")));
        QVERIFY(!session.whyNotRemove(QStringLiteral("Park")).isEmpty());  // nor anybody himself
        QSignalSpy changed(&session, &OperatorSession::settingsChanged);
        session.remove(QStringLiteral("Kim"));
        QCOMPARE(session.known(), QStringList{QStringLiteral("Park")});
        QCOMPARE(changed.count(), 1);
        session.signOff();
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Engineer));  // back: a new person, an operator
        QCOMPARE(*session.role(), Role::Operator);
    }
    void aPinIsAskedForAndNeverStoredAsTyped() {
        OperatorSession session;
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Engineer));
        QVERIFY(!session.setPin(QStringLiteral("Kim"), QStringLiteral("12")));
        QVERIFY(!session.setPin(QStringLiteral("Kim"), QStringLiteral("12a4")));
        QVERIFY(session.setPin(QStringLiteral("Kim"), QStringLiteral("1234")));
        QVERIFY(!session.account(QStringLiteral("Kim"))->pin.contains(QStringLiteral("1234")));
        session.signOff();
        QSignalSpy audited(&session, &OperatorSession::audited);
        QVERIFY(!session.signOn(QStringLiteral("Kim"), Role::Operator, QStringLiteral("4321")));
        QVERIFY(!session.signedOn());
        QCOMPARE(audited.takeFirst().at(1).toString(), QStringLiteral("PIN refused"));
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator, QStringLiteral("1234")));
    }
    void aSealIsAPasswordHashAndOldOnesAreWrapped() {
        const QString seal = sealPin(QStringLiteral("1234"));
        QVERIFY(seal.startsWith(QLatin1String("$argon2id$")));
        QVERIFY(seal != sealPin(QStringLiteral("1234")));  // salted
        QVERIFY(opensSeal(seal, QStringLiteral("1234")));
        QVERIFY(!opensSeal(seal, QStringLiteral("1235")));
        QByteArray digest = "salt:1234";
        for (int i = 0; i < 5000; ++i) {
            digest = QCryptographicHash::hash(digest, QCryptographicHash::Sha256);
        }
        const QString old = QStringLiteral("old:salt:") + QString::fromLatin1(digest.toHex());
        const QString wrapped = wrappedSeal(old);
        QVERIFY(!wrapped.contains(QString::fromLatin1(digest.toHex())));
        for (const QString& kept : {old, wrapped}) {
            QVERIFY(opensSeal(kept, QStringLiteral("1234")));
            QVERIFY(!opensSeal(kept, QStringLiteral("4321")));
        }
    }
    void wrongPinsMakeOneWait() {
        SignOnSettings settings;
        settings.accounts.push_back({QStringLiteral("Kim"), Role::Operator, sealPin(QStringLiteral("1234"))});
        OperatorSession session(settings);
        qint64 now_ms = 1'000'000;
        session.setClock([&now_ms] { return now_ms; });
        const auto tried = [&](const char* pin) {
            return session.signOn(QStringLiteral("Kim"), Role::Operator, QLatin1String(pin));
        };
        QSignalSpy wrong(&session, &OperatorSession::wrongPins);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(session.whyNotYet(QStringLiteral("Kim")).isEmpty());
            QVERIFY(!tried("0000"));
        }
        QVERIFY(session.whyNotYet(QStringLiteral("Kim")).contains(QLatin1Char('5')));
        QVERIFY(!tried("1234"));  // not even looked at
        QCOMPARE(wrong.size(), 3);
        now_ms += 5'000;
        QVERIFY(!tried("0001"));
        now_ms += 9'999;
        QVERIFY(!tried("1234"));
        now_ms += 1;
        QVERIFY(tried("1234"));
        QCOMPARE(wrong.last().at(1).toUInt(), 0U);
        QCOMPARE(pinWait_ms(1000), qint64{300'000});  // 10,000 tries are a month
    }
    void onARealMachineTheFirstEngineerIsMadeAndNobodyBecomesOneAlone() {
        SignOnSettings settings;
        settings.demonstration = false;
        OperatorSession session(settings);
        QVERIFY(session.firstEngineerMissing());
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Engineer));
        QCOMPARE(*session.role(), Role::Operator);
        session.setRole(QStringLiteral("Kim"), Role::Engineer);
        QCOMPARE(*session.role(), Role::Operator);
        QVERIFY(!session.makeFirstEngineer(QStringLiteral("Lee"), QString()));  // not without a PIN
        QVERIFY(session.makeFirstEngineer(QStringLiteral("Lee"), QStringLiteral("4711")));
        QCOMPARE(*session.role(), Role::Engineer);
        QVERIFY(!session.makeFirstEngineer(QStringLiteral("Choi"), QStringLiteral("4711")));
        session.setRole(QStringLiteral("Kim"), Role::Setter);
        QCOMPARE(session.account(QStringLiteral("Kim"))->role, Role::Setter);
        QVERIFY(session.signOn(QStringLiteral("Kim")));
        QVERIFY(!session.setPin(QStringLiteral("Lee"), QStringLiteral("0000")));  // not somebody else's
    }
    void nobodyTouchingAnythingSignsOff() {
        OperatorSession session;
        session.setAutoSignOff_min(5);
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QSignalSpy audited(&session, &OperatorSession::audited);
        session.tick(0);
        session.touched(4 * kMinute_ms);
        session.tick(8 * kMinute_ms);
        QVERIFY(session.signedOn());
        session.tick(9 * kMinute_ms);
        QVERIFY(!session.signedOn());
        QCOMPARE(audited.takeFirst().at(1).toString(), QStringLiteral("signed off by itself"));
    }
    void neverMeansNever() {
        OperatorSession session;
        session.setAutoSignOff_min(SignOnSettings::kNever);
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        session.tick(0);
        session.tick(1'000 * kMinute_ms);
        QVERIFY(session.signedOn());
    }
    void theListSurvivesAnotherSession() {
        OperatorSession first;
        QSignalSpy saved(&first, &OperatorSession::settingsChanged);
        QVERIFY(first.signOn(QStringLiteral("Kim"), Role::Setter));
        QCOMPARE(saved.size(), 1);
        OperatorSession second(first.settings());
        QVERIFY(second.signOn(QStringLiteral("Kim"), Role::Operator));
        QCOMPARE(*second.role(), Role::Setter);
    }
};

QTEST_MAIN(TestOperatorSession)
#include "tst_operator_session.moc"
