// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <cmath>
#include <cstdio>
#include <string>

#include "db/location.h"
#include "tests/db/db_test_support.h"

/// `shop_fixture FOLDER PARTS SEED`: a data folder as a console leaves it: a lot, parts with feed traces and three
/// measurements each, a correction, an alarm, a setting, a kept setup. Called again it adds parts to the same lot.
int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    if (argc != 4) {
        std::fprintf(stderr, "usage: shop_fixture FOLDER PARTS SEED\n");
        return 2;
    }
    using namespace kerf;
    QDir().mkpath(QString::fromUtf8(argv[1]));
    const std::string file = db::databaseFile(argv[1]);
    if (const auto ready = db::prepareDatabase(file); !ready) {
        std::fprintf(stderr, "%s\n", ready.error().english().c_str());
        return 3;
    }
    test::Shop shop(file);
    const int seed = std::stoi(argv[3]);
    MeasurementId last = 0;
    PartId lastPart = 0;
    for (int i = 0; i < std::stoi(argv[2]); ++i) {
        lastPart = shop.addPart(static_cast<std::uint32_t>(i));
        for (std::uint8_t station = 0; station < 3; ++station) {
            // Sums of tenths: most have no short decimal form.
            const double diameter = 50.0 + 0.1 * (seed % 7) + 0.2 + std::sin(i * 0.7 + station) * 1e-3;
            MeasurementRow row = test::measured(lastPart, station, diameter);
            row.source = static_cast<MeasurementSource>(station);
            row.sourceName = station == 0 ? "" : station == 1 ? "G-07 내경" : "값 1.csv";
            last = shop.must(AcceptMeasurement{row, {test::stateOf(0.1 * i + 0.2)}, std::nullopt}).id;
        }
    }
    if (last > 0) {
        MeasurementRow correction = test::measured(lastPart, 2, 50.1 + 0.2);
        correction.kind = MeasurementKind::Correction;
        correction.replaces = last;
        correction.reason = "자릿수 \"바뀜\" \\ 'quoted'";
        (void)shop.must(AcceptMeasurement{correction, {test::stateOf(0.3)}, std::nullopt});
        (void)shop.must(SetPartSerial{lastPart, "SN-" + std::to_string(seed), "Kim", {}});
    }
    (void)shop.must(RaiseAlarm{101, 2, Sentence("Bore %1 mm outside", SentenceArg(50.125, 3))});
    (void)shop.must(ClearAlarm{101});
    (void)shop.must(ChangeSetting{"display.unit", seed % 2 == 0 ? "mm" : "inch", "Lee", "as the drawing"});
    (void)shop.must(ChangeSetting{"operators", "Kim\toperator\tsealed" + std::to_string(seed), "Lee", {}});
    return 0;
}
