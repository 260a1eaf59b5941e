#pragma once

#include "core/geometry/setup.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"

#include <QString>

namespace unprojector::gui {

// Pasted matrices in words.

/// "Projection", "View or modelview", "Product (MVP)".
QString roleName(matrices::MatrixRole role);
/// What a matrix was taken for: "four rows".
QString formName(matrices::MatrixForm form);
/// What is to be seen of a matrix, in a sentence.
QString findingSentence(const matrices::MatrixFinding &finding, matrices::MatrixRole role);
/// What its button says; empty where nothing is to be done.
/// @param order  that the matrix is read in
QString repairName(const matrices::MatrixFinding &finding, matrices::NumberOrder order);
/// Why a text is no such matrix, with the place in it.
QString errorText(const matrices::PasteError &error, matrices::MatrixRole role);
/// What projection and view mean: where the eye is, which way it looks, field of view, near and far.
/// @param setup  by parameters
/// @param lens   the matrix that its projection was read from, if it was
QString cameraText(const geometry::Setup &setup, const std::optional<geometry::MatrixProjection> &lens);

} // namespace unprojector::gui
