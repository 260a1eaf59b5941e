#include "core/pipeline/matrix_factors.h"

#include "core/geometry/unit_in_last_place.h"

#include <algorithm>
#include <cmath>

namespace unprojector::pipeline {
using namespace geometry;

namespace {

std::vector<MatrixFactor> boxFactors(const Ortho &box)
{
    const auto &[l, r, b, t, n, f] = box;
    glm::dmat4 move(1.0), scale(1.0), turn(1.0);
    move[3] = {-(r + l) / 2.0, -(t + b) / 2.0, (f + n) / 2.0, 1.0};
    scale[0][0] = 2.0 / (r - l);
    scale[1][1] = 2.0 / (t - b);
    scale[2][2] = 2.0 / (f - n);
    turn[2][2] = -1.0;
    return {{MatrixStep::MoveBox, move}, {MatrixStep::ScaleBox, scale}, {MatrixStep::TurnZ, turn}};
}

std::vector<MatrixFactor> frustumFactors(const Frustum &frustum)
{
    const auto &[l, r, b, t, n, f, skew] = frustum;
    glm::dmat4 ontoNear(0.0), toSquare(1.0);
    ontoNear[0][0] = ontoNear[1][1] = n;
    ontoNear[2] = {0.0, 0.0, -(f + n) / (f - n), -1.0};
    ontoNear[3][2] = -2.0 * f * n / (f - n);
    toSquare[0][0] = 2.0 / (r - l);
    toSquare[1][1] = 2.0 / (t - b);
    toSquare[3] = {-(r + l) / (r - l), -(t + b) / (t - b), 0.0, 1.0};
    std::vector<MatrixFactor> result{{MatrixStep::OntoNear, ontoNear}, {MatrixStep::NearToSquare, toSquare}};
    if (skew != 0.0) {
        glm::dmat4 shear(1.0);
        shear[1][0] = skew;
        result.insert(result.begin(), {MatrixStep::Skew, shear});
    }
    return result;
}

struct FactorsOf {
    std::vector<MatrixFactor> operator()(const Frustum &p) const { return frustumFactors(p); }
    std::vector<MatrixFactor> operator()(const Pinhole &p) const
    {
        // Its edges are rounded; the matrix is not rounded from them.
        std::vector<MatrixFactor> result = frustumFactors(frustumFromPinhole(p));
        const glm::dmat4 whole = clipFromEye(Projection(p)).value();
        glm::dmat4 &toSquare = result.back().matrix;
        toSquare[0][0] = whole[0][0] / p.nearDistance;
        toSquare[1][1] = whole[1][1] / p.nearDistance;
        toSquare[3] = {-whole[2][0], -whole[2][1], 0.0, 1.0};
        return result;
    }
    std::vector<MatrixFactor> operator()(const Perspective &p) const
    {
        return frustumFactors(frustumFromPerspective(p));
    }
    std::vector<MatrixFactor> operator()(const Ortho &p) const { return boxFactors(p); }
    std::vector<MatrixFactor> operator()(const Oblique &p) const
    {
        glm::dmat4 shear(1.0);
        shear[2][0] = cotangent(p.theta);
        shear[2][1] = cotangent(p.phi);
        std::vector<MatrixFactor> result = boxFactors(p.box);
        result.insert(result.begin(), {MatrixStep::Shear, shear});
        return result;
    }
};

glm::dmat4 absolute(const glm::dmat4 &matrix)
{
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        result[column] = glm::abs(matrix[column]);
    return result;
}

} // namespace

Result<std::vector<MatrixFactor>> factors(const Projection &projection)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    return std::visit(FactorsOf(), projection);
}

Result<std::vector<MatrixFactor>> factors(const LookAt &view)
{
    const Result<EyeFrame> frame = eyeFrame(view);
    if (!frame)
        return frame.error();
    glm::dmat4 move(1.0), turn = eyeFromWorld(*frame);
    turn[3] = {0.0, 0.0, 0.0, 1.0};
    move[3] = {-frame->eye.x, -frame->eye.y, -frame->eye.z, 1.0};
    return std::vector<MatrixFactor>{{MatrixStep::MoveEye, move}, {MatrixStep::TurnAxes, turn}};
}

std::vector<MatrixFactor> inConventions(std::vector<MatrixFactor> factors, const AxisChange &source,
                                        const AxisChange &target)
{
    const glm::dmat4 ours = source.inverse().matrix(), theirs = target.matrix(), same(1.0);
    if (ours != same)
        factors.insert(factors.begin(), {MatrixStep::FromConventions, ours});
    if (theirs != same)
        factors.push_back({MatrixStep::ToConventions, theirs});
    return factors;
}

glm::dmat4 partOf(const glm::dmat4 &factor, double share)
{
    return glm::dmat4(1.0) * (1.0 - share) + factor * share;
}

glm::dmat4 productOf(const std::vector<MatrixFactor> &factors, const std::vector<double> &shares)
{
    glm::dmat4 product(1.0);
    for (std::size_t i = 0; i < factors.size(); ++i)
        product = partOf(factors[i].matrix, shares.at(i)) * product;
    return product;
}

double differenceUlps(const std::vector<MatrixFactor> &factors, const glm::dmat4 &matrix)
{
    const glm::dmat4 product = productOf(factors, std::vector<double>(factors.size(), 1.0));
    glm::dmat4 sizes(1.0);
    for (const MatrixFactor &factor : factors)
        sizes = absolute(factor.matrix) * sizes;
    double greatest = 0.0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            const double size = std::max(std::abs(matrix[column][row]), sizes[column][row]);
            greatest = std::max(greatest, std::abs(product[column][row] - matrix[column][row]) / unitInLastPlace(size));
        }
    }
    return greatest;
}

} // namespace unprojector::pipeline
