#pragma once

#include "core/landmarks/landmark.h"
#include "gui/document/scene_curves.h"
#include "gui/landmarks/measure_rows.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The indices of a measure's landmarks; empty if the set lacks one of them.
std::vector<std::size_t> indicesOf(const landmarks::KeptMeasure &measure, const landmarks::LandmarkSet &set);

/// Rows for the kept measures: name, kind with landmarks, value or the reason why there is none.
/// @param selection  landmarks with the path `along`
/// @param along      along the surface; may be null
std::vector<MeasureRow> protocolRows(const landmarks::LandmarkSet &set, const std::vector<std::size_t> &selection,
                                     const SceneCurves::Line *along);

/// The value of a kept measure, or "–"; and the tip: its landmarks with the value, or why there is none.
QString protocolText(const landmarks::KeptMeasure &measure, const landmarks::LandmarkSet &set);
QString protocolTip(const landmarks::KeptMeasure &measure, const landmarks::LandmarkSet &set);

/// A measure of the selection as one to keep, with a name of its own. Nothing if its landmarks have no
/// names of their own, which a protocol needs.
/// @pre shown is of this set
std::optional<landmarks::KeptMeasure> keptMeasureOf(const ShownMeasure &shown, const landmarks::LandmarkSet &set);

} // namespace unprojector::gui
