#pragma once

#include "core/cli/rows/row_writer.h"
#include "core/ray/scene_rays.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// A pick as one JSON object on one line.
/// @param name  of the object that was hit
std::string pickJson(const geometry::DevicePoint &position, const std::optional<ray::SceneHit> &hit,
                     const std::string &name);
/// The same in words, several lines, without the digits that say nothing: a vertex has as many as are held as the same
/// floats, what is computed has them to a tenth of its ±.
std::string pickText(const geometry::DevicePoint &position, ray::Snap snap, const std::optional<ray::SceneHit> &hit,
                     const std::vector<scene::SceneObject> &objects);

/// The columns of a pick in rows.
std::vector<std::string> pickColumns();
/// Writes their cells; all empty where nothing was hit.
/// @param nameCell  as the format writes it
void writePick(RowWriter &writer, const std::optional<ray::SceneHit> &hit, const std::string &name);

} // namespace unprojector::cli
