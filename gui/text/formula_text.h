#pragma once

#include "core/unproject/pick.h"
#include "gui/text/formula_with_numbers.h"

#include <QString>

namespace unprojector::gui {

/// The formulas that a pick was computed by, and what they name.
struct PickFormulas {
    std::vector<FormulaWithNumbers> formulas;
    FormulaTerms terms;

    /// For the clipboard, a blank line between two of them.
    QString text() const;
};

/// Of a surface pick, as the paper has them: the distance z from the depth, x by (9) or (11), y by (10) or (12), and the
/// world point from the camera's axes. Of the background the ray under the pixel. Numbers are rounded for reading; the
/// results are those of the full doubles.
/// @return none where a method found no point
PickFormulas formulasOf(const unproject::Pick &pick);

/// How far off the picked coordinate can be, and from what. Of the background: where the ray enters and leaves the view
/// volume.
QString certaintyText(const unproject::Pick &pick);

} // namespace unprojector::gui
