#pragma once

#include "core/geometry/projection.h"
#include "core/lessons/link.h"

#include <QString>

namespace unprojector::gui {

/// The anchor in the help of a formula with a number of the paper or one that continues them.
/// @param number  "(9)"; empty: a formula without one, found in the chapter on unprojection
QString helpAnchorOf(const QString &number);

/// The anchor of the matrix of a kind of projection.
QString helpAnchorOf(geometry::ProjectionKind kind);

/// The anchor of that matrix's derivation, step by step.
QString helpAnchorOfSteps(geometry::ProjectionKind kind);

/// The link to an anchor of the help, for a label and QDesktopServices: "formulas:w9".
QString helpAddress(const QString &anchor);

/// The manual's section on a panel: "pipeline.md#viewport".
QString manualPlaceOf(lessons::Panel panel);

/// The link to a section of the manual, like helpAddress: "manual:pipeline.md#viewport".
QString manualAddress(const QString &place);

} // namespace unprojector::gui
