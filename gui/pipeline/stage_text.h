#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

namespace unprojector::gui {

// What the pipeline's panel writes at its stages.

/// "View", backward "View⁻¹".
QString stageName(PipelineStage stage, PipelineDirection direction);
/// The factors of a combined matrix in the order they are written in; empty for a single one.
QString productText(PipelineStage stage, PipelineDirection direction, MatrixLayout layout);
/// Where Help has the matrix.
QString stageHelp(PipelineStage stage, PipelineDirection direction, ProjectionKind projection);
/// The step between window and widget: the y flip, the pixel ratio and, of some conventions, half a pixel.
QString flipText(const PipelineModel &model, const Surface &surface);

} // namespace unprojector::gui
