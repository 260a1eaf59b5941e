#include "core/landmarks/repeats.h"

#include "core/landmarks/distinct_names.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::landmarks {
using namespace geometry;

namespace {

/// The exponent of the power of two by which several coordinates are divided. It fits the largest
/// one, so that neither sums nor squares overflow.
int exponentOf(const std::vector<glm::dvec3> &places)
{
    double largest = 0.0;
    for (const glm::dvec3 &place : places) {
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(place[axis]));
    }
    return largest > 0.0 ? std::ilogb(largest) : 0;
}

glm::dvec3 scaled(const glm::dvec3 &place, int exponent)
{
    return {std::ldexp(place.x, exponent), std::ldexp(place.y, exponent), std::ldexp(place.z, exponent)};
}

} // namespace

std::vector<RepeatedLandmark> repeatsOf(std::span<const LandmarkSet> placings)
{
    const DistinctNames distinct = distinctNames(placings);
    std::vector<RepeatedLandmark> repeats(distinct.names.size());
    std::vector<std::vector<glm::dvec3>> places(repeats.size());
    for (std::size_t i = 0; i < placings.size(); ++i) {
        for (std::size_t k = 0; k < placings[i].landmarks.size(); ++k) {
            if (const auto &world = placings[i].landmarks[k].world)
                places[distinct.places[i][k]].push_back(world->coordinates());
        }
    }
    for (std::size_t i = 0; i < repeats.size(); ++i) {
        RepeatedLandmark &repeated = repeats[i];
        repeated.name = distinct.names[i];
        repeated.count = places[i].size();
        if (places[i].empty())
            continue;
        const int exponent = exponentOf(places[i]);
        for (glm::dvec3 &place : places[i])
            place = scaled(place, -exponent);
        // Sums are relative to the first one, because far from the origin they would lose digits.
        const glm::dvec3 first = places[i].front();
        const auto count = static_cast<double>(places[i].size());
        glm::dvec3 sum(0.0);
        for (const glm::dvec3 &place : places[i])
            sum += place - first;
        const glm::dvec3 mean = first + sum / count;
        double squares = 0.0, farthest = 0.0;
        for (const glm::dvec3 &place : places[i]) {
            const double distance = glm::distance(place, mean);
            squares += distance * distance;
            farthest = std::max(farthest, distance);
        }
        repeated.mean = WorldPoint(scaled(mean, exponent));
        repeated.farthest = std::ldexp(farthest, exponent);
        if (places[i].size() < 2)
            continue;
        const double error = std::ldexp(std::sqrt(squares / (count - 1.0)), exponent);
        if (std::isfinite(error))
            repeated.error = error;
    }
    return repeats;
}

} // namespace unprojector::landmarks
