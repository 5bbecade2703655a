// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QChartView>
#include <QLineSeries>
#include <QValueAxis>
#include <optional>
#include <vector>

#include "ui/charts/decimate.h"
#include "ui/theme/look.h"

class QAreaSeries;

namespace kerf::ui {

/// A chart as the house draws it: round ticks, unit in the axis title, labels at the lines instead of a legend,
/// labelled limits, interval bands, one sentence while it is empty. No OpenGL.
///
/// All values go in in stored units; axes show the operator's. Titles and labels are set in the page's refresh().
class Chart : public QChartView {
    Q_OBJECT
 public:
    using CurveId = std::size_t;
    using BandId = std::size_t;

    enum class Kind { Line, Dashed, Points, LineAndPoints };
    enum class Marker { Disc, Ring, Diamond, Triangle };
    struct CurveStyle {
        Token token{Token::Measured};
        Kind kind{Kind::Line};
        Marker marker{Marker::Disc};
        Stroke stroke{Stroke::Normal};
    };
    struct BandPoint {
        double x{0.0};
        double low{0.0};
        double high{0.0};
    };
    /// A horizontal line with its name.
    struct Limit {
        double value{0.0};
        QString label{};
        Token token{Token::Limit};
        bool dashed{false};
        bool below{false};  ///< the name stands under the line
    };
    /// A vertical line with its name: a process change, the present part.
    struct Mark {
        double x{0.0};
        QString label{};
        Token token{Token::Dim};
    };

    explicit Chart(Look& look, QWidget* parent = nullptr);

    /// @param unit stored unit of the axis' values; "" for none. @param wholeNumbers part numbers: no fractions on
    /// ticks
    void setXAxis(const QString& title, const char* unit, bool wholeNumbers = false);
    void setYAxis(const QString& title, const char* unit);
    /// For low charts: the x title stands left of the tick labels, the y title in the card's own title. Saves two
    /// lines.
    void setLowTitles(bool low);
    /// Fixed range in stored units; without it the axis follows the points.
    void setXRange(double from, double to);
    void setYRange(double from, double to);
    /// A value the automatic y range must always show (a target, both tolerance lines are included by setLimits).
    void setYIncludes(std::vector<double> values);

    [[nodiscard]] CurveId addCurve(const CurveStyle& style);
    void setCurveLabel(CurveId curve, const QString& label);
    virtual void setPoints(CurveId curve, const std::vector<QPointF>& points);
    [[nodiscard]] BandId addBand(Token token);
    void setBand(BandId band, const std::vector<BandPoint>& points);
    void setLimits(std::vector<Limit> limits);
    void setMarks(std::vector<Mark> marks);
    /// Shown while no curve has a point: what will appear, and when.
    void setEmptyText(const QString& sentence);

    /// Points of a curve as drawn, in shown units (tests).
    [[nodiscard]] QList<QPointF> drawn(CurveId curve) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    struct Curve {
        CurveStyle style;
        QString label;
        std::vector<QPointF> points;   ///< stored units
        QList<QPointF> shown;          ///< shown units, as drawn
        QLineSeries* series{nullptr};  ///< draws `shown`; empty where a derived chart draws it itself
    };
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void resizeEvent(QResizeEvent* event) override;
    /// Lines that are not left to a series; called between limits and labels.
    virtual void paintLines(QPainter& painter, const QRectF& plot) const;
    /// Where a shown point stands on the widget.
    [[nodiscard]] QPointF place(const QPointF& shown) const;
    /// Shown values and axes anew from the stored ones.
    virtual void rebuild();
    [[nodiscard]] Look& look() const { return m_look; }
    [[nodiscard]] std::vector<Curve>& curves() { return m_curves; }
    [[nodiscard]] const std::vector<Curve>& curves() const { return m_curves; }
    [[nodiscard]] QValueAxis* xAxis() const { return m_x; }
    [[nodiscard]] QValueAxis* yAxis() const { return m_y; }
    [[nodiscard]] const char* yUnit() const { return m_yUnit; }
    /// False: the axis shows this already.
    bool applyRange(QValueAxis* axis, double from, double to, bool widen, bool wholeNumbers = false);
    void fitY(double from, double to, bool keepWide);

 private:
    struct Band {
        Token token;
        std::vector<BandPoint> points;
        QLineSeries* low{nullptr};
        QLineSeries* high{nullptr};
        QAreaSeries* area{nullptr};
    };
    void restyle();
    void retitle();
    void paintLowTitle(QPainter& painter, const QRectF& plot) const;
    void draw(Curve& curve);
    void fit();
    bool fitAxes();
    [[nodiscard]] double radius() const;                      ///< of a point's mark, px
    [[nodiscard]] QRegion covered(const Curve& curve) const;  ///< by its points' marks
    void paintLimits(QPainter& painter, const QRectF& plot, std::vector<QRectF>& taken) const;
    void paintMarks(QPainter& painter, const QRectF& plot) const;
    [[nodiscard]] std::vector<QRectF> linesBetween(double left, double right) const;
    void paintCurves(QPainter& painter, const QRectF& plot, std::vector<QRectF>& taken) const;

    Look& m_look;
    QChart* m_chart;
    QValueAxis* m_x;
    QValueAxis* m_y;
    QString m_xTitle;
    QString m_yTitle;
    const char* m_xUnit{""};
    const char* m_yUnit{""};
    bool m_wholeNumbers{false};
    bool m_lowTitles{false};
    std::optional<std::pair<double, double>> m_xRange;
    std::optional<std::pair<double, double>> m_yRange;
    std::vector<double> m_yIncludes;
    std::vector<Curve> m_curves;
    std::vector<Band> m_bands;
    std::vector<Limit> m_limits;
    std::vector<Mark> m_marks;
    QString m_emptyText;
};

}  // namespace kerf::ui
