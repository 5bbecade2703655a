// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: renders every page on the fake engine, for the eyes of whoever changes them.
//   render_pages FOLDER [WIDTH HEIGHT SCALE en|ko light|dark mm|inch]
#include <QTest>

#include "tests/support/shell_bench.h"

int main(int argc, char** argv) {
    using namespace kerf::ui;
    QApplication application(argc, argv);
    const QStringList args = application.arguments();
    Preferences p;
    p.scale = args.value(4, QStringLiteral("1")).toDouble();
    p.language = args.value(5) == QStringLiteral("ko") ? Language::Korean : Language::English;
    p.brightness = args.value(6) == QStringLiteral("dark") ? Brightness::Dark : Brightness::Light;
    p.length = args.value(7) == QStringLiteral("inch") ? LengthUnit::Inch : LengthUnit::Millimetre;
    kerf::test::ShellBench bench(kerf::test::allPages(), p);
    bench.window->resize(args.value(2, QStringLiteral("1280")).toInt(), args.value(3, QStringLiteral("800")).toInt());
    bench.window->show();
    bench.raise(kerf::test::kSensorAlarm);
    bench.raise(kerf::test::kToolAlarm);
    for (int i = 0; i < 8; ++i) {
        bench.engine.fake.boring.feed_mmPerRev.value += 0.01 * (i % 3 - 1);
        QTest::qWait(210);
    }
    return bench.window->renderPages(args.value(1, QStringLiteral("."))).isEmpty() ? 1 : 0;
}
