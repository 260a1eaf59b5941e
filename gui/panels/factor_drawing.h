#pragma once

#include "core/geometry/projection.h"

#include <glm/mat4x4.hpp>

#include <QWidget>

#include <array>

namespace unprojector::gui {
using namespace geometry;

/// A view volume, carried by a matrix, beside the cube from −1 to 1 that it is to become: seen from the front, above and to the
/// right. Its sides have the letters of glOrtho's and glFrustum's arguments. Both fit into the drawing, whatever their sizes.
class FactorDrawing : public QWidget {
    Q_OBJECT
public:
    explicit FactorDrawing(QWidget *parent = nullptr);

    /// @param carried  for column vectors of eye space; divided by w, which is above 0 in the volume
    /// @pre the projection is valid
    void setVolume(const Projection &projection, const glm::dmat4 &carried);
    /// From where to where the carried volume reaches along each axis.
    struct Extent {
        glm::dvec3 least, most;
    };
    Extent extent() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::array<glm::dvec3, 8> m_corners{}; ///< in the order of viewVolumeCorners
};

} // namespace unprojector::gui
