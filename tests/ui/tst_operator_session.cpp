// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "ui/shell/operator_session.h"

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
