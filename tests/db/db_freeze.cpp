// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QFile>
#include <cstdio>

#include "db_test_support.h"

/// Writes the frozen database of the present schema version: `db_freeze tests/fixtures/db/v1.db`. Run once per release
/// of a schema; a frozen file is never written again.
int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    if (argc != 2 || QFile::exists(QString::fromUtf8(argv[1]))) {
        std::fprintf(stderr, "usage: db_freeze NEW_FILE\n");
        return 2;
    }
    using namespace kerf;
    test::ScratchDatabase scratch;
    {
        test::Shop shop(scratch.path());
        (void)shop.must(SetActiveLot{ProcessId::Boring, shop.lot, "Lee"});
        const PartId first = shop.addPart(1);
        const PartId second = shop.addPart(2);
        const PartId third = shop.addPart(3);
        const auto accept = [&](MeasurementRow row, double alpha) {
            return shop.must(AcceptMeasurement{row, {test::stateOf(alpha)}, std::nullopt}).id;
        };
        accept(test::measured(first, 0, 50.0031), 0.50);
        const MeasurementId typo = accept(test::measured(first, 1, 50.1250), 0.71);
        accept(test::measured(second, 0, 50.0019), 0.49);
        MeasurementRow correction = test::measured(first, 1, 50.0125);
        correction.kind = MeasurementKind::Correction;
        correction.replaces = typo;
        correction.reason = "digits swapped";
        accept(correction, 0.51);
        MeasurementRow read = test::measured(second, 1, 50.0102);
        read.source = MeasurementSource::Gauge;
        read.sourceName = "G-07";
        accept(read, 0.51);
        const MeasurementId wrongPart = accept(test::measured(third, 0, 50.0044), 0.52);
        MeasurementRow gone = test::measured(third, 0, 1.0);
        gone.kind = MeasurementKind::Void;
        gone.diameter_mm.reset();
        gone.replaces = wrongPart;
        gone.reason = "wrong part on the gauge";
        accept(gone, 0.51);
        (void)shop.must(RaiseAlarm{101, 2, Sentence("Bore %1 mm outside", SentenceArg(50.125, 3))});
        (void)shop.must(ChangeSetting{"display.unit", "mm", "Lee", "as the drawing"});
        const Receipt rail = shop.must(EnsurePartType{ProcessId::Milling, "Rail", R"({"reference_N":392})", "Lee"});
        const LotId milled =
            shop.must(EnsureLot{shop.machine, rail.id, rail.second, "R7", 2, "", "Kim", "end mill 8", "caliper 3"}).id;
        for (std::uint32_t sequence = 4; sequence <= 5; ++sequence) {
            db::FinishedPart part;
            part.record.process = ProcessId::Milling;
            part.record.partSequence = sequence;
            part.record.begin_ns = sequence * 60'000'000'000LL;
            part.record.end_ns = part.record.begin_ns + 41'000'000'000LL;
            part.record.order = {sequence == 4 ? milled : 0, rail.second, 0};
            if (!shop.store().addParts(std::span<const db::FinishedPart>(&part, 1))) {
                return 1;
            }
        }
        (void)shop.must(CloseLot{milled, "Choi", "done"});
    }
    const auto copied = db::backupDatabase(scratch.path(), argv[1]);
    return copied ? 0 : 1;
}
