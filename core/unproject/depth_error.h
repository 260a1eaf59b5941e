#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/depth_sample.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <optional>

namespace unprojector::unproject {

/// What is known of a surface that was drawn, besides the depth that it left in a pixel.
struct DrawnSurface {
    /// From the space of the vertices as the GPU has them, in single precision about their mesh's origin, to world space.
    glm::dmat4 worldFromVertices{1.0};
    /// The triangle that the ray through the pixel's centre meets, its corners in the space of the vertices. Without one the
    /// slope that the depths around the pixel show has to do; and triangles that are thinner than a pixel, or far smaller, and
    /// no continuation of each other, are then worse off than is said.
    std::optional<std::array<glm::dvec3, 3>> triangle = {};
    /// A point of a point cloud was drawn, of which all that is known is that it lies in the pixel.
    bool isPoint = false;
    /// The GPU's vertices are the surface's, rounded to single precision.
    bool areVerticesRounded = false;
};

/// By how much the depth that was read may differ from that of the surface at the pixel's centre. Window depth.
struct DepthError {
    double rounding = 0.0; ///< half a step of the depth buffer
    double drawing = 0.0;  ///< what the rasteriser was off before that

    double whole() const { return rounding + drawing; }
};

/// Where errors of a depth come from, each carried to the pixel's centre and all added up, u = 2^-24:
///
///   rounding       half a step of the depth buffer
///   vertices       clip = M v in single precision: u (sum_j |M_ij v_j|) / |w| of each NDC coordinate i, and as much by w for
///                  its share in the quotient; x and y times the slope of the depth. The same again where the vertices
///                  themselves are rounded
///   window depth   2 u d: the viewport's product and sum, and those of the interpolation
///   interpolation  2 u (|x dd/dx| + |y dd/dy|): a triangle's depth is a plane through the framebuffer's corner
///   thin triangle  the relative error of its area and its differences, times how far it goes (see thinTriangleError)
///   corners        cornerShiftPixels (|dd/dx| + |dd/dy|): the plane goes through the corners where they were put
///   an edge        as near to an edge of the triangle as corners are moved, the neighbour may have been drawn: the
///                  slopes of both, times kCornerShiftPixels
///
/// The slope dd/dx, dd/dy is that of the triangle where it is known, else that of the sample; where neither is known, a
/// surface inclined by 80 degrees to the picture is assumed.
///
/// To first order this bounds every error but for the roundings, which are counted as often as they were found to add up
/// to, not as often as they occur: over 10^5 random clicks (bench_certainty) 99.9 % and more lie within, and would not if
/// all were half as large. Single precision as in OpenGL's own pipeline, about the mesh's origin, is assumed.
/// @param window   the pixel's centre with the depth that was read; device pixels, origin bottom-left
/// @param world    the same point in the world
/// @pre the setup is valid and by parameters
DepthError depthErrorAt(const geometry::Setup &setup, const geometry::WindowPoint &window,
                        const geometry::WorldPoint &world, const DepthSample &sample, const DrawnSurface &surface);

/// The same for many pixels of one mesh: what hangs on the mesh alone is computed once.
class DepthErrors {
public:
    /// @pre the setup is valid and by parameters
    DepthErrors(const geometry::Setup &setup, const glm::dmat4 &worldFromVertices, bool areVerticesRounded);

    /// @param triangle, isPoint  see DrawnSurface
    DepthError at(const geometry::WindowPoint &window, const geometry::WorldPoint &world, const DepthSample &sample,
                  const std::optional<std::array<glm::dvec3, 3>> &triangle, bool isPoint = false) const;

private:
    geometry::Setup m_setup;
    glm::dmat4 m_clipFromVertices;
    glm::dmat4 m_verticesFromWorld;
    double m_vertexRoundings; ///< how often u counts
};

} // namespace unprojector::unproject
