#pragma once

#include "core/maps/map_points.h"
#include "core/maps/pixel_map.h"

#include <functional>
#include <span>

namespace unprojector::maps {

/// Computes another program's answers to the clicks on a row's pixels, one point per pixel; not
/// finite where it has no answer.
using OtherPoints = std::function<PointArrays(const RowPixels &, const SurfaceImage &)>;

/// Prepares these answers for a setup. Programs and mistakes answer by the inverted matrix.
/// @param objects  of the scene that the surfaces belong to: a mistake of the model matrix uses the
///         matrix of the pixel's object
/// @return the errors of ClickBatch::of and doctor::Given::of
geometry::Result<OtherPoints> otherPoints(const Other &other, const geometry::Setup &setup,
                                          std::span<const scene::SceneObject> objects);

} // namespace unprojector::maps
