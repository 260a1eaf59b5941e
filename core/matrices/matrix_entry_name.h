#pragma once

#include "core/matrices/pipeline.h"

#include <string_view>

namespace unprojector::matrices {

/// What an entry of a stage's matrix stands for, in the symbols of the formulas: "2n/(r−l)", "−s·eye", "vx + w/2", and
/// "0", "1", "−1" where it always has that value. UTF-8.
///
/// The symbols: s, u, f the axes of gluLookAt; l, r, b, t, n, f glFrustum's and glOrtho's arguments; θ, φ the shear
/// angles; vx, vy, w, h glViewport's, dn, df glDepthRange's. X, Y, Z of a model are the images of the object's axes,
/// T that of its origin; backward X, Y, Z, T are those of the space the matrix starts from.
///
/// @param kind         of the projection; matters for PipelineStage::ProjectionMatrix
/// @param row, column  0 to 3, in the column-vector layout (swap them for rows)
/// @return empty for an entry of the whole pipeline, which is a product without a short name
std::string_view matrixEntryName(PipelineStage stage, PipelineDirection direction, geometry::ProjectionKind kind,
                                 int row, int column);

} // namespace unprojector::matrices
