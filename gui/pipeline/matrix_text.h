#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/geometry/setup.h"
#include "core/pipeline/matrix_findings.h"

#include <QString>

namespace unprojector::gui {

// Pasted matrices in words.

/// "Projection", "View or modelview", "Product (MVP)".
QString roleName(pipeline::MatrixRole role);
/// The form in which a matrix was recognized: "four rows".
QString formName(cameras::MatrixForm form);
/// A finding about a matrix, in a sentence.
QString findingSentence(const pipeline::MatrixFinding &finding, pipeline::MatrixRole role);
/// The text of its button; empty if there is nothing to fix.
/// @param order  in which the matrix is read
QString repairName(const pipeline::MatrixFinding &finding, cameras::NumberOrder order);
/// Explains why a text is not such a matrix, with the position of the error.
QString errorText(const cameras::PasteError &error, pipeline::MatrixRole role);
/// The meaning of projection and view: the eye, its direction, field of view, near and far.
/// @param setup  by parameters
/// @param lens   the matrix of its projection, if it was given as one
QString cameraText(const geometry::Setup &setup, const std::optional<geometry::Lens> &lens);

} // namespace unprojector::gui
