// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTest>

#include "app/service/thermal/thermal_service.h"
#include "tests/support/service_bench.h"

using namespace kerf;

namespace {

/// The service on a real database and a machine whose days are files, with rights by name: Kim is an operator, Lee a
/// setter.
struct Bench : test::FiveServicesBench {
    Bench() {
        engine.caps.simulated = false;
        QDir().mkpath(QString::fromStdString(folder()));
        for (const char* name : {"monday.csv", "tuesday.csv"}) {
            QFile day(QString::fromStdString(folder() + '/' + name));
            (void)day.open(QIODevice::WriteOnly);
        }
        open();
    }
    ~Bench() { service.reset(); }
    void open() {
        service.reset();
        readAnew();
        StoredThermalService::Links links{engine, writer, *thermalExchange};
        links.dayFolder = folder();
        links.rights = [](const std::string& author, Deed deed) -> std::optional<Sentence> {
            const Trust has = author == "Lee" ? Trust::Setter : Trust::Operator;
            return has >= permissionOf(deed).least ? std::nullopt : std::optional(Sentence("not trusted with it"));
        };
        service = std::make_unique<StoredThermalService>(links, *reader, *reader);
    }
    [[nodiscard]] std::string folder() const { return scratch.path() + "-days"; }
    [[nodiscard]] Result<void> leaveOut(const char* day, bool out, const char* author, const char* reason) {
        return wait([&](const auto& answer) { service->leaveOut(day, out, author, reason, answer); });
    }
    [[nodiscard]] const ThermalDayView& day(const char* id) const {
        return *std::ranges::find(service->view().days, id, &ThermalDayView::id);
    }

    std::unique_ptr<StoredThermalService> service;
};

constexpr const char* kMonday = "file:monday.csv";
constexpr const char* kTuesday = "file:tuesday.csv";

}  // namespace

/// What the thermal service keeps beside a day, and from whom it takes it.
class TestThermalService : public QObject {
    Q_OBJECT
 private slots:
    void aDayIsLeftOutByASetterWithAReasonAndStaysSo() {
        Bench bench;
        QCOMPARE(bench.service->view().days.size(), std::size_t{2});
        QVERIFY(!bench.leaveOut(kMonday, true, "Kim", "door open"));
        QVERIFY(!bench.leaveOut(kMonday, true, "Lee", ""));
        QVERIFY(!bench.leaveOut("file:friday.csv", true, "Lee", "door open"));
        QVERIFY(!bench.day(kMonday).leftOut);
        QVERIFY(bench.leaveOut(kMonday, true, "Lee", "door open"));
        for (int start = 0; start < 2; ++start) {
            QVERIFY(bench.day(kMonday).leftOut && !bench.day(kTuesday).leftOut);
            QCOMPARE(bench.day(kMonday).leftOutAuthor, std::string("Lee"));
            QCOMPARE(bench.day(kMonday).leftOutReason, std::string("door open"));
            const auto refused = bench.service->train("regression", {kTuesday, kMonday});
            QVERIFY(!refused);
            QVERIFY(refused.error().english().find("left out") != std::string::npos);
            QVERIFY(bench.service->view().training.state == TrainingState::Idle);
            bench.open();
        }
        const auto entries = bench.reader->audit(std::nullopt, 100);
        QVERIFY(entries.has_value());
        QVERIFY(std::ranges::any_of(
            *entries, [](const AuditRow& row) { return row.author == "Lee" && row.reason == "door open"; }));
        QVERIFY(bench.leaveOut(kMonday, false, "Lee", "it was closed"));
        QVERIFY(!bench.day(kMonday).leftOut);
        QCOMPARE(bench.day(kMonday).leftOutReason, std::string("it was closed"));
        QVERIFY(bench.service->train("regression", {kTuesday, kMonday}));
    }
};

QTEST_GUILESS_MAIN(TestThermalService)
#include "tst_thermal_service.moc"
