#pragma once

#include "core/ray/scene_rays.h"

#include <cstddef>
#include <optional>

namespace unprojector::ray {

/// An occluding edge of the surface inside a pixel: on its two sides, rays of the same pixel hit
/// surfaces at different distances, or one side is background. The pixel's centre lies on one side.
struct PixelEdge {
    /// The surface on the other side: its object, an index in the scene's list. Nothing: the
    /// background.
    std::optional<std::size_t> object;
    /// The distance of the other surface behind the hit of the position, along the ray, world units;
    /// negative before it. 0 for the background, and if the position itself hits nothing.
    double behind = 0.0;
    /// The largest difference of each coordinate, along the ray, from the hit to the surfaces on
    /// both sides of all edges in the pixel. 0 if the position itself hits nothing.
    geometry::WorldVector reach;
};

/// Finds the occluding edges that cross a square of the view, by geometry: the visible edges of
/// triangles with all neighbours on one side in the view, rims, and cuts by clip planes and by the
/// near and far plane. Of several edges, the result is the one with the farthest other surface;
/// surfaces count before the background. Ignores point clouds.
///
/// A step in depth of less than a pixel's width at its distance is roughness and no edge.
/// @param position  the centre of the square, continuous device pixels, origin top-left
/// @param hit       of the ray through the position; nothing: it hits nothing
/// @param pixels    the side of the square, device pixels: a click means its pixel, 1
/// @return nothing without an edge, and where rays cannot be computed
std::optional<PixelEdge> edgeInPixel(const SceneRays &rays, const geometry::DevicePoint &position,
                                     const std::optional<SceneHit> &hit, double pixels = 1.0);

} // namespace unprojector::ray
