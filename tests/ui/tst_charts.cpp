// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPaintEvent>
#include <QScreen>
#include <QTest>
#include <QWindow>
#include <cmath>

#include "ui/charts/chart.h"
#include "ui/charts/decimate.h"
#include "ui/charts/live_plot.h"

using namespace kerf::ui;

namespace {

/// What of a widget was painted since it was last asked.
class Painted : public QObject {
 public:
    explicit Painted(QWidget* widget) : QObject(widget) { widget->installEventFilter(this); }
    QRegion take() { return std::exchange(m_region, {}); }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            m_region += static_cast<QPaintEvent*>(event)->region();
        }
        return false;
    }

 private:
    QRegion m_region;
};

QImage onScreen(QWidget& window) {
    return window.windowHandle()->screen()->grabWindow(window.winId()).toImage();
}

}  // namespace

class TestCharts : public QObject {
    Q_OBJECT
 private slots:
    void decimationKeepsEveryPeak() {
        std::vector<QPointF> points;
        for (int i = 0; i < 30'000; ++i) {
            points.emplace_back(i * 0.01, i % 1000 == 500 ? 5.0 : i % 1000 == 700 ? -5.0 : std::sin(i * 0.01));
        }
        QList<QPointF> out;
        decimate(points, 0.0, 300.0, 600, out);
        QVERIFY(out.size() <= 4 * 600 + 2);
        QCOMPARE(std::count_if(out.begin(), out.end(), [](const QPointF& p) { return p.y() == 5.0; }), 30);
        QCOMPARE(std::count_if(out.begin(), out.end(), [](const QPointF& p) { return p.y() == -5.0; }), 30);
        QVERIFY(
            std::is_sorted(out.begin(), out.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); }));
        QCOMPARE(out.first(), points.front());
        QCOMPARE(out.last(), points.back());
    }
    void fewPointsStayAsTheyAre() {
        const std::vector<QPointF> points{{0, 1}, {1, 3}, {2, 2}};
        QList<QPointF> out;
        decimate(points, 0.0, 2.0, 100, out);
        QCOMPARE(out, QList<QPointF>(points.begin(), points.end()));
        decimate({}, 0.0, 2.0, 100, out);
        QVERIFY(out.isEmpty());
    }
    void axesHaveFourToSixRoundTicks() {
        for (double span = 1e-6; span < 1e6; span *= 1.37) {
            for (const double from : {0.0, -0.4 * span, 50.0, -3.3}) {
                const AxisRange r = roundRange(from, from + span);
                const double intervals = (r.to - r.from) / r.step;
                QVERIFY2(intervals > 2.9 && intervals < 5.1, qPrintable(QString::number(intervals)));
                QVERIFY(r.from <= from + 1e-6 * span && r.to >= from + span - 1e-6 * span);
                const double lead = r.step / std::pow(10.0, std::floor(std::log10(r.step) + 1e-9));
                QVERIFY(std::abs(lead - 1) < 1e-6 || std::abs(lead - 2) < 1e-6 || std::abs(lead - 2.5) < 1e-6 ||
                        std::abs(lead - 5) < 1e-6);
            }
        }
        QVERIFY(roundRange(3.0, 3.0).to > roundRange(3.0, 3.0).from);
    }
    void aChartFollowsTheUnit() {
        Look look(96.0);
        Chart chart(look);
        chart.setYAxis(QStringLiteral("feed"), "mm/rev");
        const auto curve = chart.addCurve({Token::Measured});
        chart.setPoints(curve, {{1.0, 0.254}, {2.0, 0.508}});
        QCOMPARE(chart.drawn(curve)[1].y(), 0.508);
        Preferences inch = look.preferences();
        inch.length = LengthUnit::Inch;
        look.apply(inch);
        QVERIFY(std::abs(chart.drawn(curve)[1].y() - 0.02) < 1e-12);
        const auto axes = chart.chart()->axes(Qt::Vertical);
        QVERIFY(axes.first()->titleText().contains(QStringLiteral("in/rev")));
    }
    void nowStaysAtTheRightEdge() {
        Look look(96.0);
        LivePlot plot(look, 60.0);
        const auto curve = plot.addCurve({Token::Measured});
        plot.resize(600, 300);
        plot.show();
        for (int i = 0; i <= 10'000; ++i) {
            plot.append(curve, i * 0.01, 1.0);
        }
        plot.advance(100.0);
        const QList<QPointF> drawn = plot.drawn(curve);
        QCOMPARE(drawn.last().x(), 0.0);
        QVERIFY(drawn.size() <= 4 * 600 + 8);
        const auto* axis = qobject_cast<QValueAxis*>(plot.chart()->axes(Qt::Horizontal).first());
        QCOMPARE(axis->min(), -60.0);
        QCOMPARE(axis->max(), 0.0);
    }
    void aLivePointMovesAloneAndLeavesNothingBehind() {
        Look look(96.0);
        QWidget window;
        window.resize(600, 400);
        Chart chart(look, &window);
        chart.setGeometry(window.rect());
        const auto line = chart.addCurve({Token::Measured});
        const auto point = chart.addCurve({Token::Wanted, Chart::Kind::Points, Chart::Marker::Diamond, Stroke::Bold});
        chart.setXRange(0.0, 10.0);
        chart.setYIncludes({0.0, 4.0});
        chart.setPoints(line, {{0.0, 1.0}, {5.0, 3.0}, {10.0, 2.0}});
        chart.setPoints(point, {{1.0, 1.0}});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCoreApplication::processEvents();
        Painted painted(chart.viewport());
        const QImage there = onScreen(window);
        for (const QPointF at : {QPointF(4.0, 2.0), QPointF(4.2, 3.9), QPointF(9.9, 0.1)}) {
            (void)painted.take();
            chart.setPoints(point, {at});
            QCoreApplication::processEvents();
            const QRect rect = painted.take().boundingRect();
            QVERIFY(!rect.isEmpty());
            QVERIFY2(rect != chart.viewport()->rect(), "the whole chart was painted for one point");
        }
        chart.setPoints(point, {{1.0, 1.0}});
        QCoreApplication::processEvents();
        QCOMPARE(onScreen(window), there);
        // A point beyond the axes takes them along, and everything is painted.
        (void)painted.take();
        chart.setPoints(point, {{1.0, 40.0}});
        QCoreApplication::processEvents();
        QCOMPARE(painted.take().boundingRect(), chart.viewport()->rect());
        // No point any more: nothing of it stays.
        chart.setPoints(point, {{1.0, 1.0}});
        chart.setPoints(point, {});
        QCoreApplication::processEvents();
        QVERIFY(onScreen(window) != there);
        QCOMPARE(onScreen(window), window.grab().toImage().convertToFormat(onScreen(window).format()));
    }
    void everyChartDrawsItself() {
        Look look(96.0);
        Chart chart(look);
        chart.setEmptyText(QStringLiteral("Nothing yet"));
        chart.resize(400, 250);
        const QImage empty = chart.grab().toImage();
        const auto band = chart.addBand(Token::Predicted);
        const auto curve = chart.addCurve({Token::Measured, Chart::Kind::LineAndPoints, Chart::Marker::Triangle});
        chart.setCurveLabel(curve, QStringLiteral("top"));
        chart.setBand(band, {{1, 0, 1}, {2, 0.5, 1.5}});
        chart.setPoints(curve, {{1, 0.5}, {2, 1.0}});
        chart.setLimits({{1.8, QStringLiteral("upper")}});
        chart.setMarks({{1.5, QStringLiteral("change")}});
        QVERIFY(chart.grab().toImage() != empty);
    }
};

QTEST_MAIN(TestCharts)
#include "tst_charts.moc"
