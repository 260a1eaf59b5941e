#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/depth_sample.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <optional>

namespace unprojector::unproject {

/// Known properties of a drawn surface, in addition to its depth in a pixel.
struct DrawnSurface {
    /// The transform from the space of the vertices as the GPU has them, in single precision about
    /// their mesh's origin, to world space.
    glm::dmat4 worldFromVertices{1.0};
    /// The triangle hit by the ray through the pixel's centre, its corners in the space of the
    /// vertices. Without it the slope comes from the depths around the pixel. Then the error of
    /// triangles that are thinner than a pixel, or far smaller, and do not continue each other, is
    /// underestimated.
    std::optional<std::array<glm::dvec3, 3>> triangle = {};
    /// True if a point of a point cloud was drawn; all that is known is that it lies in the pixel.
    bool isPoint = false;
    /// True if the GPU's vertices are the surface's, rounded to single precision.
    bool areVerticesRounded = false;
};

/// The bound on the difference between the depth read and the surface's depth at the pixel's
/// centre. Window depth.
struct DepthError {
    double rounding = 0.0; ///< half a step of the depth buffer
    double drawing = 0.0;  ///< the rasteriser's error before that

    double whole() const { return rounding + drawing; }
};

/// Sums all sources of depth error, each extrapolated to the pixel's centre, u = 2^-24:
///
///   rounding       half a step of the depth buffer
///   vertices       clip = M v in single precision: u (sum_j |M_ij v_j|) / |w| of each NDC
///                  coordinate i, and as much by w for its share in the quotient; x and y times
///                  the slope of the depth. The same again if the vertices themselves are rounded
///   window depth   2 u d: the viewport's product and sum, and the interpolation's
///   interpolation  2 u (|x dd/dx| + |y dd/dy|): a triangle's depth is a plane through the
///                  framebuffer's corner
///   thin triangle  the relative error of its area and its differences, times its extent (see
///                  thinTriangleError)
///   corners        cornerShiftPixels (|dd/dx| + |dd/dy|): the plane goes through the shifted
///                  corners
///   an edge        within the corner shift of an edge of the triangle, the neighbour may have been
///                  drawn: the slopes of both, times kCornerShiftPixels
///
/// The slope dd/dx, dd/dy is the triangle's if known, else the sample's. If neither is known, a
/// surface inclined by 80 degrees to the view is assumed.
///
/// To first order this bounds every error except the roundings. These are counted as often as they
/// add up in measurements, not as often as they occur. Over 10^5 random clicks (bench_certainty),
/// 99.9 % and more lie within the bound; with half the size they would not. Single precision as in
/// OpenGL's own pipeline, about the mesh's origin, is assumed.
/// @param window   the pixel's centre with the depth read; device pixels, origin bottom-left
/// @param world    the same point in the world
/// @pre the setup is valid and by parameters
DepthError depthErrorAt(const geometry::Setup &setup, const geometry::WindowPoint &window,
                        const geometry::WorldPoint &world, const DepthSample &sample, const DrawnSurface &surface);

/// The same for many pixels of one mesh: constants of the mesh are computed once.
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
    double m_vertexRoundings; ///< the factor of u
};

} // namespace unprojector::unproject
