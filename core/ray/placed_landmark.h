#pragma once

#include "core/landmarks/landmark.h"
#include "core/ray/pixel_edge.h"
#include "core/ray/scene_rays.h"

#include <optional>
#include <string>

namespace unprojector::ray {

/// The anchor of a landmark placed at a hit: the triangle; the vertex for a point of a point cloud
/// or a click snapped to a vertex; the edge for a click snapped to an edge.
/// @param snap  the mode of the click
landmarks::Anchor anchorOf(const SceneHit &hit, Snap snap);

/// A landmark without a name at a hit. Its uncertainty is the sum of SceneHit::uncertainty and the
/// extent on the surface of a pointing error of `pixels` (to first order; surfaces seen at less
/// than 0.6 degrees count as 0.6 degrees). A vertex and a point of a point cloud have only
/// SceneHit::uncertainty, since the file defines their coordinates.
/// @param rays      of the hit
/// @param position  of the hit in their setup
/// @param object    the name of the hit object
/// @param pixels    the precision of pointing, device pixels: a click means its pixel, 1
landmarks::Landmark landmarkAt(const SceneHit &hit, Snap snap, const SceneRays &rays,
                               const geometry::DevicePoint &position, const std::string &object, double pixels = 1.0);

/// An occluding edge in the pixel that a landmark was placed by: what lay on its other side.
struct LandmarkEdge {
    std::string object;  ///< UTF-8; empty: the background
    double behind = 0.0; ///< see PixelEdge
};

/// Records the edge of its pixel in a landmark, and adds the edge's reach to its uncertainty: the
/// user may have meant the other side.
/// @param object  name of the object on the other side; ignored for the background
void addEdge(landmarks::Landmark &landmark, const PixelEdge &edge, const std::string &object);
/// The recorded edge; nothing if there is none or a file has another value there.
std::optional<LandmarkEdge> edgeOf(const landmarks::Landmark &landmark);
/// Replaces the recorded edge of a landmark by another landmark's.
void takeEdge(landmarks::Landmark &landmark, const landmarks::Landmark &of);

} // namespace unprojector::ray
