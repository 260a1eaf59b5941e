#pragma once

#include "core/unproject/batch/batch_unproject.h"

#include <array>
#include <cstddef>
#include <vector>

/// Three arrays of numbers: what a batch takes, or gives.
template <class Scalar>
struct Triples {
    std::array<std::vector<Scalar>, 3> of;
    explicit Triples(std::size_t count = 0)
        : of{std::vector<Scalar>(count), std::vector<Scalar>(count), std::vector<Scalar>(count)}
    {
    }

    std::size_t count() const { return of[0].size(); }
    unprojector::unproject::BatchInput<Scalar> input() const { return {of[0].data(), of[1].data(), of[2].data()}; }
    unprojector::unproject::BatchOutput<Scalar> output() { return {of[0].data(), of[1].data(), of[2].data()}; }
    glm::dvec3 at(std::size_t i) const { return {of[0][i], of[1][i], of[2][i]}; }
};

template <class Scalar>
Triples<Scalar>
unprojected(const unprojector::unproject::BatchUnprojection &unprojection, const Triples<Scalar> &clicks,
            unprojector::unproject::InstructionSet set = unprojector::unproject::availableInstructionSets().back())
{
    Triples<Scalar> points(clicks.count());
    unprojection(clicks.input(), points.output(), clicks.count(), set);
    return points;
}
