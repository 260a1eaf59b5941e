#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// The computation of one coordinate of the pipeline from the space before it.
struct EntryDerivation {
    QString text; ///< plain, lines with the numbers as the panel shows them
    std::optional<pipeline::PipelineStage> stage;
    int matrixRow = 0;                       ///< of the stage's matrix for column vectors; with `stage`
    std::optional<PointModel::Space> source; ///< none for the first space of the direction
    std::vector<int> coordinates;            ///< of the source: 0 for x, 3 for w
};

/// The stage whose matrix yields a space's point. None for the first space of a direction, for the
/// result of a division, and for the step between window and widget.
std::optional<pipeline::PipelineStage> stageOf(PointModel::Space space, pipeline::PipelineDirection direction);

/// The space of the point that a stage's matrix yields; none for a product.
std::optional<PointModel::Space> spaceMadeBy(pipeline::PipelineStage stage, pipeline::PipelineDirection direction);

/// The first space of a direction: no step leads to it.
PointModel::Space startOf(pipeline::PipelineDirection direction);

/// The numbers of one step:
///
///   a matrix      row of the matrix times the vector (rows: the vector times a column);
///                 also (x_n + 1) w/2 + vx for OpenGL's viewport
///   the division  x_c / w_c, backward x' / w'
///   the widget    the y flip, the pixel ratio and, in some conventions, half a pixel
///
/// The text says that a sum is 0 if it is only the rounding of its terms. It says that a sum
/// differs if it is not the number shown. That happens if the user gave the number and the earlier
/// ones were computed back from it.
///
/// @param coordinate  of the space, as shown: 0 for x, 3 for w
EntryDerivation entryDerivation(const PipelineModel &model, const geometry::Setup &setup, PointModel::Space space,
                                int coordinate);

/// The same text with non-breaking spaces inside terms: lines break only after a sign, in a sum (a
/// minus cannot be kept from a break after it).
QString unbrokenTerms(QString text);

/// The hint that is shown while no coordinate is chosen.
QString entryHint();

} // namespace unprojector::gui
