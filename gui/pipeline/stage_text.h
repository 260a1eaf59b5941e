#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QString>

namespace unprojector::gui {

// The texts of the pipeline's stages.

/// "eye → clip", backward "clip → eye".
QString stageSpaces(pipeline::PipelineStage stage, pipeline::PipelineDirection direction);
/// "Projection: eye → clip"
QString stageTitle(pipeline::PipelineStage stage, pipeline::PipelineDirection direction);
/// "View", backward "View⁻¹".
QString stageName(pipeline::PipelineStage stage, pipeline::PipelineDirection direction);
/// The factors of a combined matrix in written order; empty for a single one.
QString productText(pipeline::PipelineStage stage, pipeline::PipelineDirection direction,
                    pipeline::MatrixLayout layout);
/// The help anchor of the matrix.
QString stageHelp(pipeline::PipelineStage stage, pipeline::PipelineDirection direction,
                  geometry::ProjectionKind projection);
/// The step between window and widget: the y flip, the pixel ratio and, in some conventions, half a
/// pixel.
QString flipText(const PipelineModel &model, const geometry::Surface &surface);

} // namespace unprojector::gui
