#pragma once

#include "core/ray/pixel_edge.h"
#include "core/ray/ray_comparison.h"
#include "core/ray/scene_rays.h"

#include <QString>

namespace unprojector::gui {

// Ray hits of a click in words.

/// The distance between the ray's hit and the formula's point, and the reason which of the two to
/// trust.
/// @param shown  name of the frame's object
/// @param met    name of the hit object
QString rayComparisonText(const ray::RayComparison &comparison, const QString &shown, const QString &met);
/// The occluding edge inside a clicked pixel, and what lies on its other side.
/// @param other   name of the object there
/// @param hasHit  whether the click hits a surface
QString pixelEdgeText(const ray::PixelEdge &edge, const QString &other, bool hasHit);
QString rayPreparingText();
/// @param reason  a clause; empty: the setup has no rays
QString rayImpossibleText(const QString &reason);

/// The details of a snapped hit: triangle, vertex and edge by their numbers, the plane of a face.
/// @param hit  nothing: nothing was in reach
QString rayDetailText(ray::Snap snap, const std::optional<ray::SceneHit> &hit);

/// The headline of a snapped hit, except for surfaces: "Vertex 12 of Teapot".
QString takenText(ray::Snap snap, const ray::SceneHit &taken, const QString &object);
/// The uncertainty of the snapped point, which differs from the surface's under the pixel.
QString takenCertaintyText(ray::Snap snap, const ray::SceneHit &taken);

} // namespace unprojector::gui
