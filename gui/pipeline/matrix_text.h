#pragma once

#include "core/geometry/setup.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"

#include <QString>

namespace unprojector::gui {

// Pasted matrices in words.

/// "Projection", "View or modelview", "Product (MVP)".
QString roleName(matrices::MatrixRole role);
/// The form in which a matrix was recognized: "four rows".
QString formName(matrices::MatrixForm form);
/// A finding about a matrix, in a sentence.
QString findingSentence(const matrices::MatrixFinding &finding, matrices::MatrixRole role);
/// The text of its button; empty if there is nothing to fix.
/// @param order  in which the matrix is read
QString repairName(const matrices::MatrixFinding &finding, matrices::NumberOrder order);
/// Explains why a text is not such a matrix, with the position of the error.
QString errorText(const matrices::PasteError &error, matrices::MatrixRole role);
/// The meaning of projection and view: the eye, its direction, field of view, near and far.
/// @param setup  by parameters
/// @param lens   the matrix of its projection, if it was given as one
QString cameraText(const geometry::Setup &setup, const std::optional<geometry::Lens> &lens);

} // namespace unprojector::gui
