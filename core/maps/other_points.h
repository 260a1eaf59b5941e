#pragma once

#include "core/maps/map_points.h"
#include "core/maps/pixel_map.h"

#include <functional>
#include <span>

namespace unprojector::maps {

/// Computes what another one answers to the clicks on a row's pixels, one point a pixel; not finite where it has no answer.
using OtherPoints = std::function<void(const RowPixels &, const SurfaceImage &, PointArrays &)>;

/// Prepares these answers for a picture. Programs and mistakes answer by the inverted matrix.
/// @param objects  of the scene, where the surfaces are theirs: a mistake of the model matrix is made with that of the object
/// @return the errors of ClickBatch::of and doctor::Given::of
geometry::Result<OtherPoints> otherPoints(const Other &other, const geometry::Setup &setup,
                                          std::span<const scene::SceneObject> objects);

} // namespace unprojector::maps
