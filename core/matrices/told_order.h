#pragma once

#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <span>
#include <vector>

namespace unprojector::matrices {

/// How a matrix's numbers tell the order in which they stand.
enum class ToldOrder {
    Usual,         ///< that of its form
    Other,         ///< only in the other order are they a camera's
    OtherAsOthers, ///< in both they are a camera's; another matrix of the same form tells that it is the other order
    Open           ///< in both they are a camera's, another one in each, and nothing tells which is meant
};

/// A matrix read in both orders.
struct BothOrders {
    MatrixRole role = MatrixRole::View;
    MatrixForm form = MatrixForm::Flat;
    glm::dmat4 usual{1.0}, other{1.0};
};

/// In which order the matrices of one text stand. Each tells by its own numbers; one that only turns, say, tells nothing and goes
/// by those of the same form, or by all others where these have the order of their forms.
/// @param aspect  width by height of the viewport, where it is known: between two cameras the one of square pixels counts
std::vector<ToldOrder> toldOrders(std::span<const BothOrders> matrices, const std::optional<double> &aspect);

/// What is to be said of it; nothing where the order is the usual one.
std::optional<MatrixFinding> findingOf(ToldOrder told);

} // namespace unprojector::matrices
