// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <map>
#include <numeric>

#include "engine/machine/simulated/simulated_thermal.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"
#include "tests/engine/thermal/lathe_days.h"

using namespace kerf::thermal;
using kerf::test::kLatheChanged;
using kerf::test::kLatheDays;
using kerf::test::Lathe;
using kerf::test::LatheKind;

namespace {

using Days = std::vector<ThermalHistory>;

struct Judged {
    double rms_um{0.0};
    double inside{0.0};
};
Judged judge(const ThermalModel& model, const ThermalHistory& day, double measureEvery_min) {
    const Replay replayed = replay(model, day, measureEvery_min);
    Judged out;
    const auto n = static_cast<double>(replayed.minutes.size());
    for (std::size_t k = 0; k < replayed.minutes.size(); ++k) {
        const ThermalPrediction& p = replayed.minutes[k].prediction;
        const double error_um = day.drift_um(day.baselineRows() + static_cast<Eigen::Index>(k), 0) - p.drift_um[0];
        out.rms_um += error_um * error_um / n;
        out.inside += std::abs(error_um) <= p.half_um[0] ? 1.0 / n : 0.0;
    }
    out.rms_um = std::sqrt(out.rms_um);
    return out;
}
double uncompensated(const ThermalHistory& day) {
    return std::sqrt(day.drift_um.col(0).bottomRows(day.workRows()).squaredNorm() /
                     static_cast<double>(day.workRows()));
}
double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
QByteArray shown(const std::vector<double>& values) {
    QStringList out;
    for (const double value : values) {
        out << QString::number(value, 'f', 3);
    }
    return out.join(u' ').toUtf8();
}

constexpr std::array kKinds{LatheKind::Mild, LatheKind::Spread, LatheKind::Hidden, LatheKind::Coarse,
                            LatheKind::WarmStart};

/// What the days of one lathe say of a law: days left out (every third), and the changed days.
struct Course {
    std::vector<double> uncompensated{}, regression{}, law{}, measured{}, inside{};
    std::vector<double> changedUncompensated{}, changedRegression{}, changed{}, changedMeasured{}, changedInside{};
};
const Course& courseOf(LatheKind kind) {
    static std::map<LatheKind, Course> courses;
    if (const auto found = courses.find(kind); found != courses.end()) {
        return found->second;
    }
    const Days days = Lathe(kind, 3).days();
    Course out;
    for (int d = 0; d < kLatheDays; d += 3) {
        Days rest = days;
        rest.erase(rest.begin() + d);
        const ThermalHistory& day = days[static_cast<std::size_t>(d)];
        const ThermalModel model = *trainHierarchical(rest, {});
        const Judged judged = judge(model, day, 0.0);
        out.uncompensated.push_back(uncompensated(day));
        out.regression.push_back(judge(*trainRegression(rest, {}), day, 0.0).rms_um);
        out.law.push_back(judged.rms_um);
        out.inside.push_back(judged.inside);
        out.measured.push_back(judge(model, day, 60.0).rms_um);
    }
    const Days first(days.begin(), days.begin() + kLatheChanged);
    const ThermalModel model = *trainHierarchical(first, {});
    const ThermalModel regression = *trainRegression(first, {});
    for (int d = kLatheChanged; d < kLatheDays; ++d) {
        const ThermalHistory& day = days[static_cast<std::size_t>(d)];
        const Judged judged = judge(model, day, 0.0);
        out.changedUncompensated.push_back(uncompensated(day));
        out.changedRegression.push_back(judge(regression, day, 0.0).rms_um);
        out.changed.push_back(judged.rms_um);
        out.changedInside.push_back(judged.inside);
        out.changedMeasured.push_back(judge(model, day, 60.0).rms_um);
    }
    return courses.emplace(kind, std::move(out)).first->second;
}

DayLayer smallLayer() {
    DayLayer layer;
    layer.termScale_K = {1.0, 1.0, 1.0};
    for (DayLaw& law : layer.axis) {
        law = {0.3, 4.0, 1.0, 2.0, 60.0, 0.3, 2.0};
    }
    return layer;
}
DayInstant instant(double time_min, double mean_um, double term) {
    DayInstant out;
    out.time_min = time_min;
    out.mean_um = {mean_um, mean_um, mean_um};
    out.term[0] = term;
    return out;
}

}  // namespace

class TestThermalDays : public QObject {
    Q_OBJECT
 private slots:
    void daysLeftOutAreNoWorseThanByTheRegression();
    void intervalsHoldOnDaysLeftOut();
    void changedDaysStayInsideMoreOftenAndErrLess();
    void aMeasurementAnHourHalvesTheError();
    void nothingIsUsedBeforeItIsMeasured();
    void aChangedDayIsSaidAndAnOrdinaryOneIsNot();
    void aDayUnlikeTheOthersDoesNotSpoilTheLaw();
    void withoutARelationNothingIsCorrected();
    void aMeasurementMovesTheCoefficients();
    void aCorrectionIsNeverLargerThanItsEvidence();
    void aStrangeStateIsCorrectedAsTheLastUsualOne();
    void whatIsDoubtedWidensTheIntervalAndAMeasurementBringsItBack();
    void measurementsOfAnEarlierReferenceKeepTheirCoefficients();
    void theOldestMeasurementGoes();
    void oneDisplacementIsEnough();
    void oneDayIsNotEnough();
    void aHardMachineTrainsOnItsOwnDays();
};

void TestThermalDays::daysLeftOutAreNoWorseThanByTheRegression() {
    std::vector<double> ratio;
    for (const LatheKind kind : kKinds) {
        const Course& c = courseOf(kind);
        ratio.push_back(meanOf(c.law) / std::min(meanOf(c.regression), meanOf(c.uncompensated)));
        QVERIFY2(ratio.back() <= 1.10, shown(ratio));
    }
    QVERIFY2(meanOf(ratio) <= 0.97, shown(ratio));
}

void TestThermalDays::intervalsHoldOnDaysLeftOut() {
    std::vector<double> inside;
    for (const LatheKind kind : kKinds) {
        inside.push_back(meanOf(courseOf(kind).inside));
        QVERIFY2(inside.back() >= 0.80, shown(inside));
    }
    QVERIFY2(meanOf(inside) >= 0.90, shown(inside));
}

void TestThermalDays::changedDaysStayInsideMoreOftenAndErrLess() {
    std::vector<double> inside;
    std::vector<double> ratio;
    for (const LatheKind kind : kKinds) {
        const Course& c = courseOf(kind);
        inside.push_back(meanOf(c.changedInside));
        ratio.push_back(meanOf(c.changed) / meanOf(c.changedRegression));
    }
    QVERIFY2(meanOf(inside) >= 0.60, shown(inside));
    QVERIFY2(meanOf(ratio) <= 1.0, shown(ratio));
}

void TestThermalDays::aMeasurementAnHourHalvesTheError() {
    std::vector<double> ratio;
    std::vector<double> changed;
    for (const LatheKind kind : kKinds) {
        const Course& c = courseOf(kind);
        ratio.push_back(meanOf(c.measured) / meanOf(c.law));
        changed.push_back(meanOf(c.changedMeasured) / meanOf(c.changed));
    }
    QVERIFY2(meanOf(ratio) <= 0.75, shown(ratio));
    QVERIFY2(meanOf(changed) <= 0.60, shown(changed));
}

void TestThermalDays::nothingIsUsedBeforeItIsMeasured() {
    const Days days = Lathe(LatheKind::Spread, 4).days();
    const ThermalModel model = *trainHierarchical(Days(days.begin(), days.begin() + 10), {});
    const ThermalHistory& day = days[15];
    const Replay plain = replay(model, day);
    const Replay measured = replay(model, day, 60.0);
    for (std::size_t k = 0; k <= 60; ++k) {
        QCOMPARE(measured.minutes[k].prediction.drift_um[0], plain.minutes[k].prediction.drift_um[0]);
        QCOMPARE(measured.minutes[k].prediction.half_um[0], plain.minutes[k].prediction.half_um[0]);
    }
    QCOMPARE(plain.minutes[61].time_min, 61.0);
    const double before = std::abs(day.drift_um(66, 0) - plain.minutes[61].prediction.drift_um[0]);
    const double after = std::abs(day.drift_um(66, 0) - measured.minutes[61].prediction.drift_um[0]);
    QVERIFY2(after < 0.5 * before + 1.0, shown({before, after}));
    QVERIFY(measured.minutes[61].prediction.half_um[0] < plain.minutes[61].prediction.half_um[0]);
    // Replaying is to do the same again.
    const Replay again = replay(model, day, 60.0);
    for (std::size_t k = 0; k < again.minutes.size(); ++k) {
        QCOMPARE(again.minutes[k].prediction.drift_um[0], measured.minutes[k].prediction.drift_um[0]);
    }
}

void TestThermalDays::aChangedDayIsSaidAndAnOrdinaryOneIsNot() {
    const Days days = Lathe(LatheKind::Mild, 5).days();
    const ThermalModel model = *trainHierarchical(Days(days.begin(), days.begin() + 12), {});
    for (int d = 12; d < kLatheChanged; ++d) {
        const Replay ordinary = replay(model, days[static_cast<std::size_t>(d)], 60.0);
        QVERIFY(ordinary.minutes[130].prediction.changed < kDayDiffers);
    }
    ThermalHistory day = days[12];
    day.drift_um *= -2.0;
    const Replay changed = replay(model, day, 60.0);
    QCOMPARE(changed.minutes[60].prediction.changed, 0.0);
    QVERIFY(changed.minutes.back().prediction.changed >= kDayDiffers);
}

void TestThermalDays::aDayUnlikeTheOthersDoesNotSpoilTheLaw() {
    const Days days = Lathe(LatheKind::Mild, 3).days();
    Days training(days.begin(), days.begin() + 12);
    const double clean = judge(*trainHierarchical(training, {}), days[13], 0.0).rms_um;
    training[4].drift_um *= -3.0;
    const double spoilt = judge(*trainHierarchical(training, {}), days[13], 0.0).rms_um;
    QVERIFY2(spoilt <= 1.3 * clean + 0.5, shown({clean, spoilt}));
}

void TestThermalDays::withoutARelationNothingIsCorrected() {
    // The sign of every day is drawn: no mean law helps, and a correction would hurt.
    Days days = Lathe(LatheKind::Mild, 5).days();
    for (std::size_t d = 0; d < days.size(); ++d) {
        days[d].drift_um *= (d * 7 % 4 < 2) ? 1.0 : -1.0;
    }
    const ThermalModel model = *trainHierarchical(Days(days.begin(), days.begin() + 14), {});
    for (std::size_t d = 14; d < days.size(); ++d) {
        const double rms_um = judge(model, days[d], 0.0).rms_um;
        QVERIFY2(rms_um <= 1.10 * uncompensated(days[d]), shown({rms_um, uncompensated(days[d])}));
    }
}

void TestThermalDays::aMeasurementMovesTheCoefficients() {
    DayPosterior day(smallLayer());
    const double before = day.at(instant(180.0, 20.0, 2.0), 0).half_um;
    day.add({instant(60.0, 10.0, 1.0), {16.0, 16.0, 16.0}, {true, true, true}});
    const auto there = day.at(instant(60.0, 10.0, 1.0), 0);
    QVERIFY(there.shift_um > 4.0 && there.shift_um <= 6.0);
    const auto later = day.at(instant(180.0, 20.0, 2.0), 0);  // twice as warm: more than the offset alone
    QVERIFY2(later.shift_um > 1.2 * there.shift_um && later.shift_um < 2.0 * there.shift_um,
             shown({there.shift_um, later.shift_um}));
    QVERIFY(later.half_um < before);
    day.clear();
    QCOMPARE(day.at(instant(180.0, 20.0, 2.0), 0).half_um, before);
}

void TestThermalDays::aCorrectionIsNeverLargerThanItsEvidence() {
    for (const double off_um : {-40.0, -3.0, 0.0, 0.5, 8.0, 100.0}) {
        DayPosterior day(smallLayer());
        day.add({instant(45.0, 7.0, 0.8), {7.0 + off_um, 0.0, 0.0}, {true, false, false}});
        const double shift_um = day.at(instant(45.0, 7.0, 0.8), 0).shift_um;
        QVERIFY(std::abs(shift_um) <= std::abs(off_um) && shift_um * off_um >= 0.0);
        QCOMPARE(day.at(instant(45.0, 7.0, 0.8), 1).shift_um, 0.0);  // another axis was not measured
    }
    DayPosterior day(smallLayer());
    day.add({instant(45.0, 7.0, 0.8), {std::nan(""), 0.0, 0.0}, {true, false, false}});
    QCOMPARE(day.count(), std::size_t{0});
}

void TestThermalDays::aStrangeStateIsCorrectedAsTheLastUsualOne() {
    DayLayer layer = smallLayer();
    layer.whiten = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (DayLaw& law : layer.axis) {
        law.slope_um = 0.1;  // what the law says is far beyond what days differ by
        law.trust = 0.9;
        law.usual = 4.0;
        law.doubt = 1.0;
    }
    const DayPosterior day(layer);
    const auto corrected_um = [&](double times) {
        DayInstant now = instant(60.0, 0.0, times);
        day.setLever(now);
        return 10.0 * times * day.borneOut(now, 0, 10.0 * times);  // the law is linear
    };
    QCOMPARE(corrected_um(1.0), 9.0);
    QCOMPARE(corrected_um(2.0), 18.0);
    for (const double times : {2.5, 4.0, 30.0}) {
        QVERIFY2(std::abs(corrected_um(times) - 18.0) < 1e-9, shown({times, corrected_um(times)}));
    }
    QCOMPARE(corrected_um(0.0), 0.0);
}

void TestThermalDays::whatIsDoubtedWidensTheIntervalAndAMeasurementBringsItBack() {
    DayPosterior day(smallLayer());
    DayInstant whole = instant(60.0, 20.0, 1.0);
    DayInstant half = instant(60.0, 10.0, 1.0);
    half.doubted_um = {10.0, 10.0, 10.0};
    QVERIFY(day.at(half, 0).half_um > day.at(whole, 0).half_um);
    day.add({half, {20.0, 20.0, 20.0}, {true, true, true}});
    QVERIFY(day.at(half, 0).shift_um > 7.0);
    QVERIFY(day.at(half, 0).shift_um <= 10.0);
    half.time_min = 120.0;  // twice as warm: what the law said all along is believed by now
    half.mean_um = half.doubted_um = {20.0, 20.0, 20.0};
    half.term[0] = 2.0;
    QVERIFY2(day.at(half, 0).shift_um > 12.0, shown({day.at(half, 0).shift_um}));
}

void TestThermalDays::measurementsOfAnEarlierReferenceKeepTheirCoefficients() {
    DayPosterior same(smallLayer());
    DayPosterior earlier(smallLayer());
    DayMeasurement measurement{instant(60.0, 10.0, 1.0), {16.0, 16.0, 16.0}, {true, true, true}};
    same.add(measurement);
    earlier.add(measurement);
    DayInstant now = instant(90.0, 10.0, 1.0);
    const double whole = same.at(now, 0).shift_um;
    now.reference = 1;
    const double kept = earlier.at(now, 0).shift_um;
    QVERIFY2(kept > 0.3 * whole && kept < whole, shown({whole, kept}));
}

void TestThermalDays::theOldestMeasurementGoes() {
    DayPosterior day(smallLayer());
    for (std::size_t k = 0; k < 2 * kMaxDayMeasurements; ++k) {
        const double t = 10.0 * static_cast<double>(k + 1);
        day.add({instant(t, 5.0, 0.5), {6.0, 6.0, 6.0}, {true, true, true}});
        const auto now = day.at(instant(t + 5.0, 5.0, 0.5), 0);
        QVERIFY(std::isfinite(now.shift_um) && now.half_um >= 0.0);
    }
    QCOMPARE(day.count(), kMaxDayMeasurements);
}

void TestThermalDays::oneDisplacementIsEnough() {
    const Days days = Lathe(LatheKind::Mild, 3).days();
    const auto trained = trainAuto(Days(days.begin(), days.begin() + 3), {});
    QVERIFY(trained.has_value());
    QCOMPARE(trained->best.kind, ModelKind::Hierarchical);
    QVERIFY(trained->best.axes[0] && !trained->best.axes[1] && !trained->best.axes[2]);
}

void TestThermalDays::oneDayIsNotEnough() {
    const Days days = Lathe(LatheKind::Mild, 3).days();
    const auto model = trainHierarchical({days[0]}, {});
    QVERIFY(!model.has_value());
    QVERIFY(!model.error().empty());
}

void TestThermalDays::aHardMachineTrainsOnItsOwnDays() {
    QCOMPARE(trainingDay(1, 0, 0).trueDrift_um, trainingDay(1, 0).trueDrift_um);
    QVERIFY(trainingDay(1, 0, 7).trueDrift_um != trainingDay(1, 0).trueDrift_um);
    const auto warm = [](const kerf::SimulatedThermal::Params& params) {
        const kerf::SimulatedThermal machine(params);
        ThermalPlant plant = machine.plant();
        plant.advance(3000.0, 3600.0);
        return plant.drift_um();
    };
    const auto reference = warm({1, 1, 0, Season::None});
    QCOMPARE(warm({1, 1}), reference);
    QVERIFY(warm({1, 1, 7, Season::None}) != reference);
    QVERIFY(warm({1, 1, 0, Season::Door}) != reference);
}

QTEST_GUILESS_MAIN(TestThermalDays)
#include "tst_thermal_days.moc"
