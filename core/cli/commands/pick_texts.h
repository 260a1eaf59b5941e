#pragma once

#include "core/cli/rows/row_writer.h"
#include "core/ray/scene_rays.h"
#include "core/scene_file/ray_on_mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// A pick as one JSON object on one line.
std::string pickJson(const geometry::DevicePoint &position, const scene_file::RayOnMesh &ray);
/// A pick as text of several lines, with significant digits only. A vertex has as many digits as
/// identify its floats; a computed coordinate has digits to a tenth of its ±.
std::string pickText(const geometry::DevicePoint &position, ray::Snap snap, const scene_file::RayOnMesh &ray,
                     const std::vector<scene::SceneObject> &objects);

/// The columns of a pick in a table.
/// @param hasEdges  with the edge inside the pixel
std::vector<std::string> pickColumns(bool hasEdges);
/// Writes the cells of a pick. The cells of the hit are empty where nothing was hit, those of the
/// edge where there is none.
void writePick(RowWriter &writer, const scene_file::RayOnMesh &ray, bool hasEdges);

} // namespace unprojector::cli
