#include "core/cameras/told_order.h"

#include "core/geometry/condition_number.h"
#include "core/pipeline/decomposition.h"

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using namespace geometry;
using namespace pipeline;

namespace {

bool isSame(const glm::dmat4 &a, const glm::dmat4 &b)
{
    constexpr double kRounding = 1e-9;
    return largestEntry(a - b) <= kRounding * largestEntry(a);
}

bool has(const std::vector<MatrixFinding> &found, MatrixFault fault)
{
    return std::any_of(found.begin(), found.end(), [fault](const MatrixFinding &one) { return one.fault == fault; });
}

/// Returns whether a matrix has the form of its role or its inverse's.
bool isCamera(const glm::dmat4 &matrix, MatrixRole role)
{
    const std::vector<MatrixFinding> found = findings(matrix, role);
    return !has(found, MatrixFault::Transposed) && !has(found, MatrixFault::UnknownForm)
           && !has(found, MatrixFault::Exchanged);
}

/// Returns whether a projection or a product has square pixels in the viewport.
bool hasSquarePixels(const glm::dmat4 &matrix, MatrixRole role, double aspect)
{
    constexpr double kSquare = 0.01;
    const std::optional<Decomposition> apart = role == MatrixRole::Product ? decomposed(matrix) : std::nullopt;
    if (role == MatrixRole::View || (role == MatrixRole::Product && !apart))
        return false;
    const glm::dmat4 &lens = apart ? apart->clipFromEye : matrix;
    return std::abs(std::abs(lens[1][1] / lens[0][0]) / aspect - 1.0) <= kSquare;
}

/// The order that a matrix alone determines; nothing if both orders are equal, or neither is a
/// camera's.
std::optional<ToldOrder> toldBy(const BothOrders &m, const std::optional<double> &aspect)
{
    if (isSingular(m.usual) || isSame(m.usual, m.other))
        return std::nullopt;
    const bool isUsual = isCamera(m.usual, m.role), isOther = isCamera(m.other, m.role);
    if (isUsual != isOther)
        return isUsual ? ToldOrder::Usual : ToldOrder::Other;
    if (!isUsual)
        return std::nullopt;
    const bool isUsualSquare = aspect && hasSquarePixels(m.usual, m.role, *aspect),
               isOtherSquare = aspect && hasSquarePixels(m.other, m.role, *aspect);
    if (isUsualSquare != isOtherSquare)
        return isUsualSquare ? ToldOrder::Usual : ToldOrder::Other;
    return ToldOrder::Open;
}

} // namespace

std::vector<ToldOrder> toldOrders(std::span<const BothOrders> matrices, const std::optional<double> &aspect)
{
    std::vector<std::optional<ToldOrder>> own;
    for (const BothOrders &m : matrices)
        own.push_back(toldBy(m, aspect));
    // Considers the matrices of one form, or all.
    const auto anyTells = [&](ToldOrder order, const std::optional<MatrixForm> &form) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (own[i] == order && (!form || matrices[i].form == *form))
                return true;
        }
        return false;
    };
    std::vector<ToldOrder> told;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const MatrixForm form = matrices[i].form;
        const bool isUsualHere = anyTells(ToldOrder::Usual, form), isOtherHere = anyTells(ToldOrder::Other, form);
        if (own[i] != ToldOrder::Open)
            told.push_back(own[i].value_or(ToldOrder::Usual));
        else if (isUsualHere != isOtherHere)
            told.push_back(isUsualHere ? ToldOrder::Usual : ToldOrder::OtherAsOthers);
        else
            told.push_back(anyTells(ToldOrder::Usual, {}) && !anyTells(ToldOrder::Other, {}) ? ToldOrder::Usual
                                                                                             : ToldOrder::Open);
    }
    return told;
}

std::optional<MatrixFinding> findingOf(ToldOrder told)
{
    switch (told) {
    case ToldOrder::Usual: break;
    case ToldOrder::Other: return MatrixFinding{MatrixFault::OtherOrder, MatrixRepair::OtherOrder};
    case ToldOrder::OtherAsOthers: return MatrixFinding{MatrixFault::OrderOfOthers, MatrixRepair::OtherOrder};
    case ToldOrder::Open: return MatrixFinding{MatrixFault::OrderOpen, MatrixRepair::OtherOrder};
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
