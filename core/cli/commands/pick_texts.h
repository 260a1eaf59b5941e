#pragma once

#include "core/cli/rows/row_writer.h"
#include "core/ray/scene_rays.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// A pick as one JSON object on one line.
/// @param name  name of the object that was hit
std::string pickJson(const geometry::DevicePoint &position, const std::optional<ray::SceneHit> &hit,
                     const std::string &name);
/// A pick as text of several lines, with significant digits only. A vertex has as many digits as
/// identify its floats; a computed coordinate has digits to a tenth of its ±.
std::string pickText(const geometry::DevicePoint &position, ray::Snap snap, const std::optional<ray::SceneHit> &hit,
                     const std::vector<scene::SceneObject> &objects);

/// The columns of a pick in a table.
std::vector<std::string> pickColumns();
/// Writes the cells of a pick; all empty where nothing was hit.
/// @param nameCell  as the format writes it
void writePick(RowWriter &writer, const std::optional<ray::SceneHit> &hit, const std::string &name);

} // namespace unprojector::cli
