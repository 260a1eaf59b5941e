#pragma once

#include "core/geometry/components.h"
#include "gui/document/pick_history.h"

#include <QString>

#include <vector>

namespace unprojector::gui {

/// The texts of a row in the list of picks.
struct PickRow {
    QString object;     ///< its display name; "Background" for the background
    QString coordinate; ///< "(x, y, z)" to the last certain digit; empty without a point
    QString pixel;      ///< "(i, j)", device pixels from the top-left corner
};

/// @param objects  the current ones
PickRow pickRow(const EarlierPick &earlier, const std::vector<scene::SceneObject> &objects);

/// The differences of two picks, a line each: distance, coordinates, depth, pixel, object, setup.
QString pickDifferenceText(const EarlierPick &from, const EarlierPick &to,
                           const std::vector<scene::SceneObject> &objects);

/// The rows as shown, with a heading, tab-separated.
QString pickRowsText(const std::vector<EarlierPick> &picks, const std::vector<scene::SceneObject> &objects);
/// The rows with all digits as a table for other programs: pick, object, x, y, z, the uncertainty
/// of each, pixel and depth.
QString pickRowsCsv(const std::vector<EarlierPick> &picks, const std::vector<scene::SceneObject> &objects);

} // namespace unprojector::gui
