#pragma once

#include "core/pipeline/pipeline.h"

#include <string_view>

namespace unprojector::pipeline {

/// The meaning of an entry of a stage's matrix, in the symbols of the formulas: "2n/(r−l)",
/// "−s·eye", "vx + w/2"; "0", "1" or "−1" if the entry always has that value. UTF-8.
///
/// The symbols: s, u, f are the axes of gluLookAt. l, r, b, t, n, f are the arguments of glFrustum
/// and glOrtho; θ, φ the shear angles; vx, vy, w, h the arguments of glViewport; dn, df of
/// glDepthRange. X, Y, Z of a model are the images of the object's axes, T the image of its origin.
/// Backward, X, Y, Z, T belong to the space that the matrix starts from.
///
/// @param kind         of the projection; matters for PipelineStage::ProjectionMatrix
/// @param isSkewed     the projection is a frustum with a skew
/// @param row, column  0 to 3, in the column-vector layout (swap them for rows)
/// @return empty for an entry of the whole pipeline, which is a product without a short name
std::string_view matrixEntryName(PipelineStage stage, PipelineDirection direction, geometry::ProjectionKind kind,
                                 int row, int column, bool isSkewed = false);

} // namespace unprojector::pipeline
