#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

namespace unprojector::gui {

// The texts of the pipeline's stages.

/// "eye → clip", backward "clip → eye".
QString stageSpaces(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// "Projection: eye → clip"
QString stageTitle(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// "View", backward "View⁻¹".
QString stageName(matrices::PipelineStage stage, matrices::PipelineDirection direction);
/// The factors of a combined matrix in written order; empty for a single one.
QString productText(matrices::PipelineStage stage, matrices::PipelineDirection direction,
                    matrices::MatrixLayout layout);
/// The help anchor of the matrix.
QString stageHelp(matrices::PipelineStage stage, matrices::PipelineDirection direction,
                  geometry::ProjectionKind projection);
/// The step between window and widget: the y flip, the pixel ratio and, in some conventions, half a
/// pixel.
QString flipText(const PipelineModel &model, const geometry::Surface &surface);

} // namespace unprojector::gui
