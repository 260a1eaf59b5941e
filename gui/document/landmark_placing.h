#pragma once

#include "core/landmarks/landmark.h"
#include "core/unproject/depth_sample.h"

#include <optional>

namespace unprojector::gui {

class SceneDocument;

// Computes where a landmark is placed. Nothing here changes the document.

/// The landmark at a pixel, in the current snap mode, anchored to the mesh that its ray hits.
/// @param position  device pixels, origin top-left: a pixel's centre has halves
/// @param pixels    see ray::landmarkAt
/// @return nothing if the ray hits no mesh, and while models are not prepared for rays
std::optional<landmarks::Landmark> landmarkOnMesh(const SceneDocument &document, const geometry::DevicePoint &position,
                                                  double pixels = 1.0);
/// The same on the surface itself, regardless of the snap mode.
std::optional<landmarks::Landmark> landmarkOnSurface(const SceneDocument &document,
                                                     const geometry::DevicePoint &position, double pixels = 1.0);
/// The landmark of a click: on the mesh, else by the depth that was read.
/// @return nothing for the background
std::optional<landmarks::Landmark> landmarkOfClick(const SceneDocument &document, const geometry::WidgetPoint &position,
                                                   const std::optional<unproject::DepthSample> &sample);

} // namespace unprojector::gui
