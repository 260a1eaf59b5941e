#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/batch/kernels.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace unprojector::unproject {

/// The line of all points that a position of the view shows: start + z ahead, world space. z is the
/// distance from the plane of the eye, along the view axis.
struct PixelLine {
    glm::dvec3 start, ahead;
};

/// The distances of the near and the far plane, eye units; far may be infinite.
/// @return the errors of check(projection) and recognised
struct ClipDistances {
    double atNear, atFar;
};
geometry::Result<ClipDistances> clipDistances(const geometry::Setup &setup);

/// The lines of all positions of a view, for points at known distances. No window depth is
/// computed: it would round a distance far behind the near plane.
class PixelLines {
public:
    /// Builds the lines by formulas (9) to (12) and the camera's axes: start = eye,
    /// ahead = f + X (r - l) / (width n) s - Y (t - b) / (height n) u. In a box, X and Y are terms
    /// of start.
    /// @return the errors of BatchUnprojection::byFormula and clipDistances
    static geometry::Result<PixelLines> byFormula(const geometry::Setup &setup);

    /// Builds the lines by the inverted matrix M. In a perspective, M (0, 0, 1, 0) is the eye, and
    /// M (px, py, 0, 1) a second point of the line. In a box, M (0, 0, 1, 0) is the direction.
    /// @return the errors of BatchUnprojection::byMatrix and clipDistances
    static geometry::Result<PixelLines> byMatrix(const geometry::Setup &setup);

    /// @param px, py  device position, origin top-left
    PixelLine at(double px, double py) const;

    /// The points under the pixels of a row at known distances, one a pixel.
    /// @param line    distances from the plane of the eye
    /// @param points  x, y, z of each pixel; that of a NaN is NaN
    template <class Scalar>
    void line(const batch::DepthLine &line, Scalar *points) const;
    /// The same of numbers in single precision. @pre canTakeFloats()
    template <class Scalar>
    void line(const batch::FloatLine &line, Scalar *points) const;
    bool canTakeFloats() const { return m_perspective.has_value(); }

    bool isPerspective() const { return m_isPerspective; }
    /// Focal length in pixels along a row of the image: fx. @pre isPerspective()
    double focalPixels() const { return m_focalPixels; }

private:
    /// One vector as a sum over a position: across px + down py + rest, counted from the axis.
    struct Sum {
        glm::dvec3 across{0.0}, down{0.0}, rest{0.0};
        glm::dvec3 at(double x, double y) const { return across * x + (down * y + rest); }
    };

    Sum m_start, m_ahead;
    glm::dvec3 m_rate{0.0, 0.0, 1.0}; ///< ahead is divided by rate.x x + rate.y y + rate.z
    double m_axisX = 0.0, m_axisY = 0.0, m_axisXRest = 0.0, m_axisYRest = 0.0;
    double m_focalPixels = 1.0;
    bool m_isPerspective = true;
    std::optional<batch::ClosedFormConstants> m_perspective; ///< of the formulas, for many pixels at once
};

} // namespace unprojector::unproject
