#pragma once

#include "core/unproject/pick.h"
#include "gui/text/formula_with_numbers.h"

#include <QString>

namespace unprojector::gui {

/// The formulas that a pick was computed by, and their terms.
struct PickFormulas {
    std::vector<FormulaWithNumbers> formulas;
    FormulaTerms terms;

    /// The text for the clipboard, with a blank line between two formulas.
    QString text() const;
};

/// The formulas of a pick. On a surface, as in the paper: the distance z from the depth, x by (9)
/// or (11), y by (10) or (12), and the world point from the camera's axes. On the background, the
/// ray through the pixel. Numbers are rounded for reading; the results come from the full doubles.
/// @return none if a method found no point
PickFormulas formulasOf(const unproject::Pick &pick);

/// The uncertainty of the picked coordinate and its causes. On the background: where the ray enters
/// and leaves the view volume.
QString certaintyText(const unproject::Pick &pick);

} // namespace unprojector::gui
