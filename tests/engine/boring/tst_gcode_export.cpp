// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "engine/process/boring/gcode_export.h"

using namespace kerf;

/// The exported subroutine read back: what a control would cut. Run in LinuxCNC by tests/machine/tst_linuxcnc_loops.
class TestGcodeExport : public QObject {
    Q_OBJECT

    [[nodiscard]] static BoringSchedule schedule() {
        BoringSchedule s;
        s.revision = 7;
        s.lnC = std::log(0.0871);
        s.alpha = 0.5025;
        s.beta = 0.2676;
        s.targetDeflection_mm = 0.1165;
        return s;
    }
    struct Segment {
        double from_mm, to_mm, feed_mmPerRev;
    };
    [[nodiscard]] static std::vector<Segment> cuts(const std::vector<std::string>& lines) {
        std::map<int, double> variables;
        std::vector<Segment> segments;
        double at_mm = 0.0;
        for (const std::string& line : lines) {
            int variable = 0;
            double value = 0.0;
            if (std::sscanf(line.c_str(), "#%d=%lf", &variable, &value) == 2) {
                variables[variable] = value;
            } else if (std::sscanf(line.c_str(), "G1 Z-%lf F#%d", &value, &variable) == 2) {
                segments.push_back({at_mm, value, variables.at(variable)});
                at_mm = value;
            }
        }
        return segments;
    }

 private slots:
    void everySegmentKeepsWithinTheDeviation() {
        boring::GcodeParams params;
        params.deviation = 0.01;
        const BoringSchedule s = schedule();
        const auto lines = boring::boringSubroutine(s, params);
        QVERIFY(lines.has_value());
        const auto segments = cuts(*lines);
        QVERIFY(segments.size() > 10);
        for (const Segment& segment : segments) {
            for (const double z_mm : {segment.from_mm, 0.5 * (segment.from_mm + segment.to_mm), segment.to_mm}) {
                const double wanted = s.feed_mmPerRev(s.overhangFrom_mm + z_mm);
                QVERIFY(std::abs(segment.feed_mmPerRev / wanted - 1.0) < 0.0102);
            }
        }
        QVERIFY(std::abs(segments.back().to_mm - 270.0) < 1e-3);
    }
    void clampedScheduleIsOneSegmentWhereItIsClamped() {
        BoringSchedule s = schedule();
        s.minFeed_mmPerRev = s.maxFeed_mmPerRev = 0.2;
        const auto lines = boring::boringSubroutine(s, {});
        QVERIFY(lines.has_value());
        QCOMPARE(cuts(*lines).size(), std::size_t{1});
        QCOMPARE(cuts(*lines).front().feed_mmPerRev, 0.2);
    }
    void macroDialectIsANumberedSubroutine() {
        boring::GcodeParams params;
        params.dialect = boring::GcodeDialect::Macro;
        params.number = 812;
        const auto lines = boring::boringSubroutine(schedule(), params);
        QVERIFY(lines.has_value());
        QCOMPARE(lines->front(), std::string("%"));
        QCOMPARE(lines->at(1), std::string("O0812"));
        QCOMPARE(lines->at(lines->size() - 2), std::string("M99"));
        QCOMPARE(lines->back(), std::string("%"));
        for (const std::string& line : *lines) {
            QVERIFY2(line.find('<') == std::string::npos, line.c_str());
        }
    }
    void macroDialectHasOnlyWhatThatFamilyTakes() {
        BoringSchedule s = schedule();
        s.alpha = 0.55;
        s.spindleSpeed_rpm = 1499.7;
        boring::GcodeParams params;
        params.dialect = boring::GcodeDialect::Macro;
        const auto lines = boring::boringSubroutine(s, params);
        QVERIFY(lines.has_value());
        for (std::size_t i = 0; i < lines->size(); ++i) {
            const std::string& line = lines->at(i);
            const bool frame = i == 0 || i + 1 == lines->size();
            QVERIFY2(frame == (line.find('%') != std::string::npos), line.c_str());
            QVERIFY2(std::ranges::none_of(line, [](char c) { return (c >= 'a' && c <= 'z') || c == ';' || c == ':'; }),
                     line.c_str());
            int variable = 0;
            if (std::sscanf(line.c_str(), "#%d", &variable) == 1) {
                QVERIFY2(variable >= 101 && variable <= 149, line.c_str());  // #150 and up are an option
            }
        }
        QVERIFY(std::ranges::find(*lines, "M3 S1500") != lines->end());
        // More segments than variables: what is cut stays the same, pass by pass.
        params.dialect = boring::GcodeDialect::LinuxCnc;
        const auto plain = cuts(*boring::boringSubroutine(s, params));
        const auto passes = cuts(*lines);
        QVERIFY(passes.size() > 49);
        QCOMPARE(passes.size(), plain.size());
        for (std::size_t i = 0; i < plain.size(); ++i) {
            QCOMPARE(passes[i].to_mm, plain[i].to_mm);
            QCOMPARE(passes[i].feed_mmPerRev, plain[i].feed_mmPerRev);
        }
    }
    void callersModesComeBack() {
        const auto lines = boring::boringSubroutine(schedule(), {});
        QVERIFY(lines.has_value());
        QCOMPARE(lines->at(1), std::string("M73"));
    }
    void badInputIsRefusedWithASentence() {
        BoringSchedule s = schedule();
        s.alpha = 0.0;
        QVERIFY(!boring::boringSubroutine(s, {}).has_value());
        boring::GcodeParams params;
        params.name = "no good";
        QVERIFY(!boring::boringSubroutine(schedule(), params).has_value());
        params = {};
        params.deviation = 0.001;  // more than 99 segments
        const auto refused = boring::boringSubroutine(schedule(), params);
        QVERIFY(!refused.has_value());
        QVERIFY(!refused.error().english().empty());
    }
};
QTEST_APPLESS_MAIN(TestGcodeExport)
#include "tst_gcode_export.moc"
