#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/pipeline/matrix_findings.h"

#include <QString>

namespace unprojector::gui {

// Pasted matrices in words.

/// "Projection", "View or modelview", "Product (MVP)".
QString roleName(pipeline::MatrixRole role);
/// A finding about a matrix, in a sentence.
QString findingSentence(const pipeline::MatrixFinding &finding, pipeline::MatrixRole role);
/// The text of its button; empty if there is nothing to fix.
/// @param order  in which the matrix is read
QString repairName(const pipeline::MatrixFinding &finding, cameras::NumberOrder order);

} // namespace unprojector::gui
