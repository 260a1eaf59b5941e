#pragma once

#include "core/landmarks/landmark.h"
#include "gui/document/scene_curves.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// One measure of placed points, in words.
struct MeasureRow {
    QString kind;                      ///< "Distance"
    QString points;                    ///< "nasion – pronasale"
    QString value;                     ///< "12.34 ± 0.05 mm", or why there is none
    std::optional<double> number = {}; ///< in the scene's unit, or degrees
    std::optional<double> error = {};
    /// How the view can show it; what it cannot show has none. Its text is to be put in.
    std::optional<ShownMeasure> shown = {};
};

/// What can be measured at some points, in their order in the list: the distance of two; the angles of three and their
/// distances; the height of the fourth over the plane of the three before it; the length along all of them.
/// @param indices  of the points, rising
std::vector<MeasureRow> measuresOf(const landmarks::LandmarkSet &set, const std::vector<std::size_t> &indices);

/// The length along the surface through these points.
/// @param line  as SceneCurves has it
MeasureRow surfaceLengthOf(const landmarks::LandmarkSet &set, const std::vector<std::size_t> &indices,
                           const SceneCurves::Line &line);
/// Of a curve, "12.34 ± 0.05 mm", or why there is none.
QString curveLengthText(const SceneCurves::Line &line, const QString &unit);

/// The plane that mirrors left points best into right ones, which points it is made from and which of them have no ±; how far each
/// pair, and each point of the middle, is from its own mirror image, or why it is left out: hidden ones are, and sided ones without a
/// partner. Empty without a pair.
std::vector<MeasureRow> sidesOf(const landmarks::LandmarkSet &set);

/// The rows as a table: kind, points, value and error with all their digits, unit.
QString csvOf(const std::vector<MeasureRow> &rows, const QString &unit);

} // namespace unprojector::gui
