#pragma once

#include "core/geometry/projection.h"

#include <glm/mat4x4.hpp>

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <array>
#include <vector>

namespace unprojector::gui {

/// A view volume transformed by a matrix, beside the target cube from −1 to 1: seen from the front,
/// above and to the right. Its sides have the letters of glOrtho's and glFrustum's arguments. Both
/// fit into the drawing at any size.
class FactorDrawing : public QWidget {
    Q_OBJECT
public:
    explicit FactorDrawing(QWidget *parent = nullptr);

    /// @param carried  for column vectors of eye space; divided by w, which is above 0 in the
    /// volume
    /// @pre the projection is valid
    void setVolume(const geometry::Projection &projection, const glm::dmat4 &carried);
    /// The range of the transformed volume along each axis.
    struct Extent {
        glm::dvec3 least, most;
    };
    Extent extent() const;

    /// The boxes of l, r, b, t, n, f: they overlap neither each other nor a small cube.
    std::array<QRectF, 6> letterBoxes() const;
    QRectF cubeBox() const; ///< the cube's rectangle in the drawing

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    /// The projection onto the drawing.
    struct Paper {
        QPointF from, middle;
        double scale;
        QPointF placed(const glm::dvec3 &point) const;
        std::array<QPointF, 8> placed(const std::array<glm::dvec3, 8> &points) const;
    };
    Paper paper() const;
    /// The letters of the cube's axes; none if there is no room.
    std::vector<QPointF> axisLetters(const Paper &paper) const;

    std::array<glm::dvec3, 8> m_corners{}; ///< in the order of viewVolumeCorners
};

} // namespace unprojector::gui
