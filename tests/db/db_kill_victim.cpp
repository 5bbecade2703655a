// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <QCoreApplication>
#include <cstdio>
#include <thread>

#include "db/migrator.h"
#include "db/readers/database_reader.h"
#include "db/writer_thread.h"
#include "db_test_support.h"
#include "engine/core/random.h"
#include "kill_story.h"

/// Works a lot through the real writer until it is killed: an engine thread finishes parts, the main thread accepts
/// measurements, corrects some and voids some. One line on stdout per accepted row, written only after the commit.
/// Usage: db_kill_victim FILE SEED. Goes on where the file ends.
namespace {

using namespace kerf;

class Victim : public QObject {
 public:
    Victim(db::WriterThread& writer, std::vector<MeasurementRow> rows, std::vector<PartId> parts, std::uint64_t seed)
        : m_writer(writer), m_rows(std::move(rows)), m_parts(std::move(parts)), m_random(seed) {
        m_subscription = m_writer.onPartStored([this](const StoredPart& part) {
            m_parts.push_back(part.id);
            next();
        });
    }

    void next() {
        if (m_busy || m_parts.empty()) {
            return;
        }
        m_busy = true;
        MeasurementRow row = test::measured(m_parts.back(), static_cast<std::uint8_t>(m_rows.size() % 2),
                                            50.0 + 0.01 * m_random.gauss());
        const std::vector<MeasurementRow> effective = effectiveMeasurements(m_rows);
        if (const double draw = m_random.uniform(); draw < 0.2 && !effective.empty()) {
            const auto pick = static_cast<std::size_t>(m_random.uniform() * static_cast<double>(effective.size()));
            row.kind = draw < 0.1 ? MeasurementKind::Void : MeasurementKind::Correction;
            row.replaces = effective[pick].id;
            row.part = effective[pick].part;
            row.station = effective[pick].station;
            row.reason = "second look";
            if (row.kind == MeasurementKind::Void) {
                row.diameter_mm.reset();
            }
        }
        row.id = INT64_MAX;  // newest; the store gives the real one
        std::vector<MeasurementRow> after = m_rows;
        after.push_back(row);
        const double state = test::foldOf(after);
        EstimatorStateRow stored = test::stateOf(0.5);
        stored.theta[0] = state;
        stored.stateJson = fmt::format(R"({{"fold":{:.17g}}})", state);
        m_writer.submit(AcceptMeasurement{row, {stored}, std::nullopt},
                        [this, row, state](const Result<Receipt>& done) {
                            if (!done) {
                                std::fprintf(stderr, "refused: %s\n", done.error().english().c_str());
                                QCoreApplication::exit(1);
                                return;
                            }
                            m_rows.push_back(row);
                            m_rows.back().id = done->id;
                            const std::string line = "ack " + test::storyLine(m_rows.back(), state) + "\n";
                            if (::write(STDOUT_FILENO, line.data(), line.size()) < 0) {
                                QCoreApplication::exit(1);
                                return;
                            }
                            m_busy = false;
                            next();
                        });
    }

 private:
    db::WriterThread& m_writer;
    std::vector<MeasurementRow> m_rows;
    std::vector<PartId> m_parts;
    Random m_random;
    std::unique_ptr<Subscription> m_subscription;
    bool m_busy{false};
};

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    if (argc != 3) {
        std::fprintf(stderr, "usage: db_kill_victim FILE SEED\n");
        return 2;
    }
    const std::string path = argv[1];
    if (const auto ready = db::prepareDatabase(path); !ready) {
        std::fprintf(stderr, "%s\n", ready.error().english().c_str());
        return 1;
    }
    LotId lot = 0;
    std::vector<MeasurementRow> rows;
    std::vector<PartId> parts;
    {
        test::Shop shop(path);
        lot = shop.lot;
        (void)shop.must(SetActiveLot{ProcessId::Boring, lot, "Lee"});
        const auto history = shop.reader()->history(lot);
        rows = (*history)->measurements;
        for (const PartDetail& detail : (*history)->parts) {
            parts.push_back(detail.part.id);
        }
    }
    SpscRing<PartRecord> ring(8);
    db::WriterThread writer(path, &ring, {.queueCapacity = 8, .ringPoll_ms = 1, .retry_ms = 10});
    if (const auto started = writer.start(); !started) {
        std::fprintf(stderr, "%s\n", started.error().english().c_str());
        return 1;
    }
    const auto seed = std::stoull(argv[2]) + rows.size();
    Victim victim(writer, rows, parts, seed);
    std::thread engine([&ring, lot] {
        for (std::uint32_t sequence = 1;; ++sequence) {
            PartRecord part = test::boringPart(sequence, sequence);
            part.order.lot = lot;
            // About one part per few measurements: the ring stays full, the writer sets the pace.
            while (!ring.tryPush(part)) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
        }
    });
    victim.next();
    return QCoreApplication::exec();  // never returns: killed
}
