#pragma once

#include "core/unproject/depth_precision.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// The error from rounding a depth over the distance in front of the eye: one curve for each depth
/// format. Both axes are logarithmic; for a near plane at or behind the eye, possible with glOrtho,
/// distances are linear. Curves differ in line style, not only in colour.
class DepthPrecisionPlot : public QWidget {
    Q_OBJECT
public:
    struct Curve {
        QString name;
        unproject::DepthScale scale;
        unproject::DepthFormat format;
    };

    explicit DepthPrecisionPlot(QWidget *parent = nullptr);

    /// @param curves  one to three; the first is the view's
    /// @param marked  a distance to mark on the first curve
    void show(std::vector<Curve> curves, const std::optional<double> &marked);
    const std::vector<Curve> &curves() const { return m_curves; }
    const std::optional<double> &marked() const { return m_marked; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Axes;
    Axes axes() const;
    void paintAxes(QPainter &painter, const Axes &axes) const;
    void paintCurve(QPainter &painter, const Axes &axes, std::size_t index) const;
    void paintMark(QPainter &painter, const Axes &axes) const;
    void paintNames(QPainter &painter) const;
    std::vector<QPointF> namePlaces() const;
    double sampleWidth() const;
    QPen penOf(std::size_t index) const;

    std::vector<Curve> m_curves;
    std::optional<double> m_marked;
};

} // namespace unprojector::gui
