#pragma once

#include "core/geometry/projection.h"
#include "core/lessons/link.h"

#include <QString>

namespace unprojector::gui {

/// Where Help has a formula of the paper or one of those numbered on from it.
/// @param number  "(9)"; empty: a formula without one, whose place is the chapter of the way back
QString helpAnchorOf(const QString &number);

/// Where Help has the matrix of a kind of projection.
QString helpAnchorOf(geometry::ProjectionKind kind);

/// Where Help derives it step by step.
QString helpAnchorOfSteps(geometry::ProjectionKind kind);

/// The link to a place of Help, for a label and QDesktopServices: "formulas:w9".
QString helpAddress(const QString &anchor);

/// Where the manual explains a panel: "pipeline.md#viewport".
QString manualPlaceOf(lessons::Panel panel);

/// The link to a place of the manual, as helpAddress: "manual:pipeline.md#viewport".
QString manualAddress(const QString &place);

} // namespace unprojector::gui
