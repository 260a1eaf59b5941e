#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// How one coordinate of the pipeline comes about from the space before it, and of what.
struct EntryDerivation {
    QString text; ///< plain, lines with the numbers as the panel shows them
    std::optional<matrices::PipelineStage> stage;
    int matrixRow = 0;                       ///< of the stage's matrix for column vectors; with `stage`
    std::optional<PointModel::Space> source; ///< none for the first space of the direction
    std::vector<int> coordinates;            ///< of the source: 0 for x, 3 for w
};

/// The stage whose matrix makes a space's point; none where a division or the way to the widget does, and at the start.
std::optional<matrices::PipelineStage> stageOf(PointModel::Space space, matrices::PipelineDirection direction);

/// The space whose point a stage's matrix makes; none for a product.
std::optional<PointModel::Space> spaceMadeBy(matrices::PipelineStage stage, matrices::PipelineDirection direction);

/// Where a direction starts: no step leads there.
PointModel::Space startOf(matrices::PipelineDirection direction);

/// The numbers of one step:
///
///   a matrix      row of the matrix times the vector (rows: the vector times a column); of OpenGL's viewport also
///                 (x_n + 1) w/2 + vx
///   the division  x_c / w_c, backward x' / w'
///   the widget    the y flip, the pixel ratio and, of some conventions, half a pixel
///
/// A sum that is no more than what rounding leaves of its terms is said to be 0, and one that is not the number shown (that was
/// given, and what leads to it computed back) is said to differ.
///
/// @param coordinate  of the space, as it is shown: 0 for x, 3 for w
EntryDerivation entryDerivation(const PipelineModel &model, const geometry::Setup &setup, PointModel::Space space,
                                int coordinate);

/// The same text with blanks that keep a term together: lines break behind a sign, and nowhere else in a sum (behind a minus
/// they could not be kept from it).
QString unbrokenTerms(QString text);

/// What there is to be said as long as no coordinate is chosen.
QString entryHint();

} // namespace unprojector::gui
