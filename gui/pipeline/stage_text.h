#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

namespace unprojector::gui {

// What the pipeline's panel writes at its stages.

/// "eye → clip", backward "clip → eye".
QString stageSpaces(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// "Projection: eye → clip"
QString stageTitle(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// "View", backward "View⁻¹".
QString stageName(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// The factors of a combined matrix in the order they are written in; empty for a single one.
QString productText(matrices::PipelineStage stage, matrices::PipelineDirection direction,
                    matrices::MatrixLayout layout);
/// Where Help has the matrix.
QString stageHelp(matrices::PipelineStage stage, matrices::PipelineDirection direction,
                  geometry::ProjectionKind projection);
/// The step between window and widget: the y flip, the pixel ratio and, of some conventions, half a pixel.
QString flipText(const PipelineModel &model, const geometry::Surface &surface);

} // namespace unprojector::gui
