// SPDX-License-Identifier: GPL-3.0-or-later
// What the way to the shop costs a console: the same acceptances at the same pace, without a sender and with one.
//   kerf_shop_load FOLDER SECONDS PER_SECOND [CONNINFO]
// One JSON line: seconds of processor time, acceptance times in ms, and with a server what is still unsent at the end.
#include <sys/resource.h>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "db/location.h"
#include "db/shop/shop_sender.h"
#include "db/writer_thread.h"
#include "tests/db/db_test_support.h"

namespace {

double processorTime_s() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace kerf;
    const QCoreApplication application(argc, argv);
    if (argc < 4) {
        std::fprintf(stderr, "usage: kerf_shop_load FOLDER SECONDS PER_SECOND [CONNINFO]\n");
        return 2;
    }
    QDir().mkpath(QString::fromLocal8Bit(argv[1]));
    const std::string file = db::databaseFile(argv[1]);
    if (const auto ready = db::prepareDatabase(file); !ready) {
        std::fprintf(stderr, "%s\n", ready.error().english().c_str());
        return 3;
    }
    const auto total = static_cast<std::uint32_t>(std::stoi(argv[2]) * std::stoi(argv[3]));
    std::vector<PartId> parts;
    {
        test::Shop shop(file);
        for (std::uint32_t i = 0; i <= total / 3; ++i) {
            parts.push_back(shop.addPart(i));
        }
    }
    db::WriterThread writer(file, nullptr);
    if (!writer.start()) {
        return 3;
    }
    std::unique_ptr<db::ShopSender> sender;
    if (argc > 4) {
        sender = std::make_unique<db::ShopSender>(file, argv[4]);
        while (sender->state().lastContact_utc_ms == 0 || sender->state().unsent > 0) {  // what was made beforehand
            QThread::msleep(100);
        }
    }
    std::vector<double> took_ms;
    std::uint32_t sent = 0;
    QTimer pace;
    const double before_s = processorTime_s();
    QObject::connect(&pace, &QTimer::timeout, &application, [&] {
        if (sent == total) {
            pace.stop();
            QTimer::singleShot(1500, &application, &QCoreApplication::quit);
            return;
        }
        auto since = std::make_shared<QElapsedTimer>();
        since->start();
        const double diameter_mm = 50.0 + 1e-3 * (sent % 7);
        writer.submit(
            AcceptMeasurement{test::measured(parts[sent / 3], static_cast<std::uint8_t>(sent % 3), diameter_mm),
                              {test::stateOf(0.1 * sent)},
                              std::nullopt},
            [&took_ms, since](const Result<Receipt>& receipt) {
                if (receipt) {
                    took_ms.push_back(1e-6 * static_cast<double>(since->nsecsElapsed()));
                }
            });
        ++sent;
    });
    pace.setTimerType(Qt::PreciseTimer);
    pace.start(1000 / std::stoi(argv[3]));
    QElapsedTimer wall;
    wall.start();
    QCoreApplication::exec();
    const double used_s = processorTime_s() - before_s;
    const double wall_s = 1e-9 * static_cast<double>(wall.nsecsElapsed());
    std::ranges::sort(took_ms);
    const auto at = [&](double share) {
        return took_ms.empty() ? 0.0
                               : took_ms[static_cast<std::size_t>(share * static_cast<double>(took_ms.size() - 1))];
    };
    std::printf(R"({"acceptances":%zu,"wall_s":%.2f,"processor_s":%.4f,"median_ms":%.3f,"p99_ms":%.3f,"unsent":%lld})"
                "\n",
                took_ms.size(), wall_s, used_s, at(0.5), at(0.99),
                sender ? static_cast<long long>(sender->state().unsent) : -1LL);
    writer.stop();
    return 0;
}
