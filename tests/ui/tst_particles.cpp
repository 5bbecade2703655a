// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "ui/theme/particles.h"

/// The particle that fits what was filled in, as a Korean reads it aloud.
class TestParticles : public QObject {
    Q_OBJECT
 private slots:
    void fitsWhatStandsBefore_data() {
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("read");
        const auto row = [](const char* written, const char* read) {
            QTest::newRow(read) << QString::fromUtf8(written) << QString::fromUtf8(read);
        };
        row("공작물 16이(가) 크게 나왔습니다.", "공작물 16이 크게 나왔습니다.");
        row("공작물 2이(가) 목표대로 나왔습니다.", "공작물 2가 목표대로 나왔습니다.");
        row("공작물 10이(가) 작게", "공작물 10이 작게");
        row("50.011 mm을(를) 50.012 mm(으)로 바꿉니다.", "50.011 mm를 50.012 mm로 바꿉니다.");
        row("개정 3(으)로", "개정 3으로");
        row("개정 1(으)로", "개정 1로");
        row("개정 2(으)로", "개정 2로");
        row("로트 실린더을(를)", "로트 실린더를");
        row("로트 강판을(를)", "로트 강판을");
        row("“길이”은(는) 숫자가", "“길이”는 숫자가");
        row("“abc”은(는) 숫자가", "“abc”는 숫자가");
        row("연필(으)로", "연필로");
        row("5 %은(는)", "5 %는");
        row("(괄호) 그대로", "(괄호) 그대로");
        row("Part 16 came out.", "Part 16 came out.");
        row("", "");
    }
    void fitsWhatStandsBefore() {
        QFETCH(QString, written);
        QFETCH(QString, read);
        QCOMPARE(kerf::ui::withParticles(written), read);
    }
};
QTEST_GUILESS_MAIN(TestParticles)
#include "tst_particles.moc"
