// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/service/boring/shop_memory.h"
#include "db/connection.h"
#include "db/location.h"
#include "db/migrator.h"
#include "db/readers/database_reader.h"
#include "db/shop/outbox.h"
#include "db/shop/pg_connection.h"
#include "db/stores/store.h"
#include "engine/core/random.h"
#include "engine/process/boring/model.h"

/// Data folders of consoles that bore the same part type.
///   memory_fixture lots FOLDER MACHINE KIND LEVEL LOTS PARTS SEED   adds lots; bending e^LEVEL of the target's
///   memory_fixture correct FOLDER DIAMETER                         corrects the first bore there is
///   memory_fixture leave-out FOLDER SUBJECT                        a lot by its memory subject, for a reason
///   memory_fixture compare FOLDER CONNINFO STORE SIMULATED         what another console, STORE, gets from the shop of
///                                                                  this one's lots: every digit of the evidence here?
namespace {

using namespace kerf;

constexpr const char* kPartType = "Sleeve 50";
constexpr double kSigma_mm = 0.005;

class Console {
 public:
    explicit Console(const std::string& folder)
        : m_file(made(folder)), m_connection(m_file, db::Access::Write), m_store(m_connection.database()) {}
    [[nodiscard]] Receipt must(const StoreCommand& command) {
        const auto receipt = m_store.apply(command);
        if (!receipt) {
            qFatal("%s", receipt.error().english().c_str());
        }
        return *receipt;
    }
    [[nodiscard]] const std::string& file() const { return m_file; }

 private:
    static std::string made(const std::string& folder) {
        QDir().mkpath(QString::fromStdString(folder));
        std::string file = db::databaseFile(folder);
        if (const auto ready = db::prepareDatabase(file); !ready) {
            qFatal("%s", ready.error().english().c_str());
        }
        return file;
    }
    std::string m_file;
    db::Connection m_connection;
    db::Store m_store;
};

void addLots(const std::string& folder, const std::string& machineName, const std::string& kind, double level, int lots,
             int parts, std::uint64_t seed) {
    Console console(folder);
    const BoringRecipe recipe;
    const auto machine = console.must(EnsureMachine{machineName, kind}).id;
    const Receipt type = console.must(EnsurePartType{ProcessId::Boring, kPartType, recipeJson(recipe), "Lee"});
    Random random(seed);
    const double atOnes = std::log(boring::kTableTargetDeflection_mm) + level - 0.55 * std::log(0.17) -
                          0.3 * std::log(std::sqrt(40.0 * 310.0));
    std::uint32_t sequence = 0;
    for (int l = 0; l < lots; ++l) {
        const auto lot = console
                             .must(EnsureLot{machine, type.id, type.second,
                                             std::to_string(seed) + "-" + std::to_string(l + 1), 30, "kalman", "Lee"})
                             .id;
        const boring::LawConstants law{atOnes + 0.03 * random.gauss(), 0.55, 0.3};
        for (int p = 0; p < parts; ++p) {
            PartRecord record;
            record.partSequence = ++sequence;
            record.begin_ns = sequence * 60'000'000'000LL;
            record.end_ns = record.begin_ns + 41'000'000'000LL;
            record.schedule.revision = static_cast<std::uint32_t>(p) + 1U;
            record.order.lot = lot;
            record.schedule.lnC = law.lnC + 0.1 * random.gauss();
            record.schedule.alpha = law.alpha + 0.02 * random.gauss();
            record.schedule.beta = law.beta;
            record.schedule.targetDeflection_mm = boring::kTableTargetDeflection_mm;
            if (p % 2 == 0) {  // every second part with a trace of what was really cut
                record.feed.count = 3;
                for (std::size_t i = 0; i < 3; ++i) {
                    record.feed.overhang_mm[i] = 40.0F + 135.0F * static_cast<float>(i);
                    record.feed.feed_mmPerRev[i] =
                        static_cast<float>(record.schedule.feed_mmPerRev(40.0 + 135.0 * static_cast<double>(i)));
                }
            }
            const PartId part = console.must(AddPart{lot, record, {}}).id;
            for (std::uint8_t station = 0; station < 2; ++station) {
                const double overhang_mm = station == 0 ? 40.0 : 310.0;
                const double feed = p % 2 == 0 ? static_cast<double>(record.feed.feed_mmPerRev[station == 0 ? 0 : 2])
                                               : record.schedule.feed_mmPerRev(overhang_mm);
                MeasurementRow row;
                row.part = part;
                row.station = station;
                row.position_mm = overhang_mm;
                row.diameter_mm = boring::diameterFromDeflection_mm(
                    boring::deflection_mm(law, feed, overhang_mm) + kSigma_mm * random.gauss(),
                    recipe.targetDiameter_mm, recipe.targetDeflection_mm, recipe.phi_deg);
                row.author = "Kim";
                (void)console.must(AcceptMeasurement{row, {}, std::nullopt});
            }
        }
        if (parts > 10) {
            (void)console.must(AddRoomRecord{ProcessId::Boring, kChangeRecord, std::to_string(lot),
                                             changeJson(6, boring::StretchKind::Insert), "Kim", "announced"});
        }
    }
}

void correctFirst(const std::string& folder, double diameter_mm) {
    Console console(folder);
    const auto reader = db::DatabaseReader::open(console.file());
    const auto lots = (*reader)->lots(std::nullopt, 1000);
    const auto history = (*reader)->history(lots->back().id);
    MeasurementRow row = (*history)->measurements.front();
    row.kind = MeasurementKind::Correction;
    row.replaces = row.id;
    row.diameter_mm = diameter_mm;
    row.reason = "misread";
    (void)console.must(AcceptMeasurement{row, {}, std::nullopt});
}

bool sameEvidence(const boring::Stretch& a, const boring::Stretch& b) {
    return a.kind == b.kind && a.fromPart == b.fromPart && a.toPart == b.toPart && a.bores == b.bores &&
           a.information == b.information && a.vector == b.vector && a.lnFeed == b.lnFeed &&
           a.lnOverhang == b.lnOverhang;
}

int compare(const std::string& folder, const std::string& conninfo, const std::string& store, bool simulated) {
    const std::string file = db::databaseFile(folder);
    const db::Interrupt interrupt;
    db::PgConnection server(conninfo, interrupt);
    std::vector<BoringMemoryLot> there = askShopLots(server, kPartType, store, simulated);
    const std::string own = db::OutboxReader(db::Connection(file, db::Access::Read).database()).identity().store;
    std::erase_if(there, [&](const BoringMemoryLot& lot) { return lot.store != own; });
    // What is kept with a lot and read again must be the same, too.
    const auto again = shopLotsFromJson(shopLotsJson(there));
    const auto reader = db::DatabaseReader::open(file);
    int equal = 0;
    for (std::size_t i = 0; i < there.size(); ++i) {
        const auto history = (*reader)->history(there[i].lot.id);
        const auto announced = announcedIn(**reader, there[i].lot.id);
        const auto here = stretchesOf(**history, *announced);
        const bool same =
            std::equal(here.begin(), here.end(), there[i].stretches.begin(), there[i].stretches.end(), sameEvidence) &&
            i < again.size() &&
            std::equal(here.begin(), here.end(), again[i].stretches.begin(), again[i].stretches.end(), sameEvidence);
        equal += same && !here.empty() ? 1 : 0;
    }
    std::printf("{\"lots\": %zu, \"equal\": %d}\n", there.size(), equal);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const std::string what = argc > 2 ? argv[1] : "";
    if (what == "lots" && argc == 9) {
        addLots(argv[2], argv[3], argv[4], std::stod(argv[5]), std::stoi(argv[6]), std::stoi(argv[7]),
                std::stoull(argv[8]));
    } else if (what == "correct" && argc == 4) {
        correctFirst(argv[2], std::stod(argv[3]));
    } else if (what == "leave-out" && argc == 4) {
        Console console(argv[2]);
        (void)console.must(
            AddRoomRecord{ProcessId::Boring, kMemoryRecord, argv[3], leftOutJson(true), "Lee", "wrong insert"});
    } else if (what == "compare" && argc == 6) {
        return compare(argv[2], argv[3], argv[4], std::string(argv[5]) == "1");
    } else {
        std::fprintf(stderr, "see the head of memory_fixture.cpp\n");
        return 2;
    }
    return 0;
}
