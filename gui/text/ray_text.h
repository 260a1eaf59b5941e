#pragma once

#include "core/ray/ray_comparison.h"
#include "core/ray/scene_rays.h"

#include <QString>

namespace unprojector::gui {

// What is said of a click's ray on the meshes.

/// How far what the ray meets is from the formula's point, which of the two to trust, and why.
/// @param shown  the name of the object that the frame has there
/// @param met    of what the ray meets
QString rayComparisonText(const ray::RayComparison &comparison, const QString &shown, const QString &met);
QString rayPreparingText();
/// @param reason  a clause; empty: the picture has no rays
QString rayImpossibleText(const QString &reason);

/// What a click takes, beside its coordinates: triangle, vertex and edge by their numbers, the plane of a face.
/// @param hit  nothing: nothing was in reach
QString rayDetailText(ray::Snap snap, const std::optional<ray::SceneHit> &hit);

/// What a click has taken in a mode that is not of surfaces, for a headline: "Vertex 12 of Teapot".
QString takenText(ray::Snap snap, const ray::SceneHit &taken, const QString &object);
/// How certain the point is that it has taken, which is not the surface's under the pixel.
QString takenCertaintyText(ray::Snap snap, const ray::SceneHit &taken);

} // namespace unprojector::gui
