#pragma once

#include "core/geometry/projection.h"

#include <glm/mat4x4.hpp>

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <array>
#include <vector>

namespace unprojector::gui {

/// A view volume, carried by a matrix, beside the cube from −1 to 1 that it is to become: seen from the front, above and to the
/// right. Its sides have the letters of glOrtho's and glFrustum's arguments. Both fit into the drawing, whatever their sizes.
class FactorDrawing : public QWidget {
    Q_OBJECT
public:
    explicit FactorDrawing(QWidget *parent = nullptr);

    /// @param carried  for column vectors of eye space; divided by w, which is above 0 in the volume
    /// @pre the projection is valid
    void setVolume(const geometry::Projection &projection, const glm::dmat4 &carried);
    /// From where to where the carried volume reaches along each axis.
    struct Extent {
        glm::dvec3 least, most;
    };
    Extent extent() const;

    /// Of l, r, b, t, n, f: none is on another, nor on the cube where that is small.
    std::array<QRectF, 6> letterBoxes() const;
    QRectF cubeBox() const; ///< what it takes of the drawing

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    /// The way onto the paper.
    struct Paper {
        QPointF from, middle;
        double scale;
        QPointF placed(const glm::dvec3 &point) const;
        std::array<QPointF, 8> placed(const std::array<glm::dvec3, 8> &points) const;
    };
    Paper paper() const;
    /// Those of the cube's axes; none where there is no room for them.
    std::vector<QPointF> axisLetters(const Paper &paper) const;

    std::array<glm::dvec3, 8> m_corners{}; ///< in the order of viewVolumeCorners
};

} // namespace unprojector::gui
