// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "db/writer_thread.h"
#include "engine/process/tapping/tap_exchange.h"
#include "engine/process/thermal/thermal_exchange.h"
#include "engine/process/turning/turning_exchange.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"

namespace kerf::test {

/// What a service stands between: a data file of its own with writer and reader, and an engine that the test answers
/// for. Services are members of whoever derives, so that they go first.
struct ServiceBench {
    using Done = std::function<void(const Result<void>&)>;

    /// `path`: a data file that is there already; empty: one of its own.
    explicit ServiceBench(std::string path = {})
        : file(path.empty() ? scratch.path() : std::move(path)),
          writer(file, &ring, {.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2}) {
        if (!writer.start()) {
            qFatal("no writer");
        }
        readAnew();
    }
    /// As a console that starts again.
    void readAnew() { reader = std::move(*db::DatabaseReader::open(file)); }
    /// The answer of a change.
    [[nodiscard]] Result<void> wait(const std::function<void(const Done&)>& call) {
        std::optional<Result<void>> result;
        call([&result](const Result<void>& answer) { result = answer; });
        if (!QTest::qWaitFor([&] { return result.has_value(); })) {
            return fail("no answer");
        }
        return *result;
    }

    ScratchDatabase scratch;
    const std::string file;
    FakeEngine engine;
    SpscRing<PartRecord> ring{64};
    db::WriterThread writer;
    std::unique_ptr<db::DatabaseReader> reader;
    std::unique_ptr<TurningExchange> turningExchange{std::make_unique<TurningExchange>()};
};

/// With what the services of all five hand over beside commands.
struct FiveServicesBench : ServiceBench {
    std::unique_ptr<ThermalExchange> thermalExchange{std::make_unique<ThermalExchange>()};
    std::unique_ptr<TapExchange> tapExchange{std::make_unique<TapExchange>()};
};

}  // namespace kerf::test
