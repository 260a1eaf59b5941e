#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/pipeline/matrix_findings.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <span>
#include <vector>

namespace unprojector::cameras {

/// The order of a matrix's numbers, derived from the numbers.
enum class ToldOrder {
    Usual,         ///< the usual order of its form
    Other,         ///< only the other order gives a camera's matrix
    OtherAsOthers, ///< both orders give a camera's matrix; a matrix of the same form shows that it is the other
    Open           ///< both orders give a camera's matrix, a different one each, and nothing decides between them
};

/// A matrix read in both orders.
struct BothOrders {
    pipeline::MatrixRole role = pipeline::MatrixRole::View;
    MatrixForm form = MatrixForm::Flat;
    glm::dmat4 usual{1.0}, other{1.0};
};

/// The orders of the matrices of one text. Each is derived from its own numbers. An ambiguous
/// matrix, such as a pure rotation, takes the order of the others of its form. If these don't
/// decide, it takes its usual order, provided that matrices of other forms have theirs.
/// @param aspect  the viewport's width / height, if known: of two possible cameras, the one with
///         square pixels is chosen
std::vector<ToldOrder> toldOrders(std::span<const BothOrders> matrices, const std::optional<double> &aspect);

/// The finding about an order; nothing for the usual order.
std::optional<pipeline::MatrixFinding> findingOf(ToldOrder told);

} // namespace unprojector::cameras
