#include "core/landmarks/expected_places.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::landmarks {

namespace {

/// The landmarks of a configuration that are placed on this specimen too.
Configuration onlyPlaced(Configuration points, const Configuration &placed)
{
    for (std::size_t j = 0; j < points.size(); ++j) {
        if (!placed[j])
            points[j].reset();
    }
    return points;
}

} // namespace

PlaceExpectation::PlaceExpectation(std::span<const Configuration> others)
    : m_others(superimposed(others, Estimate::Robust))
{
    for (Configuration &points : m_others.aligned) {
        Configuration kept(points.size());
        kept.swap(points); // the mean is that of the rest
        m_rest.push_back(meanOf(m_others.aligned, Estimate::Robust));
        kept.swap(points);
    }
}

ExpectedPlaces PlaceExpectation::placesFor(const Configuration &placed) const
{
    const std::size_t count = std::max(placed.size(), m_others.mean.size());
    Configuration own = placed, mean = m_others.mean;
    own.resize(count);
    mean.resize(count);
    ExpectedPlaces result;
    result.places.resize(count);
    if (placedCount(mean) == 0) {
        result.reason = NoExpectedPlaces::NoOthers;
        return result;
    }
    if (placedCount(onlyPlaced(mean, own)) < kFewestToExpect) {
        result.reason = NoExpectedPlaces::TooFew;
        return result;
    }
    const std::optional<Similarity> ownFromMean = similarityOf(mean, own);
    if (!ownFromMean) {
        result.reason = NoExpectedPlaces::OnALine;
        return result;
    }
    std::vector<std::vector<double>> squares(count); // in the mean's space
    for (std::size_t k = 0; k < m_rest.size(); ++k) {
        Configuration other = m_others.aligned[k];
        other.resize(count);
        const Configuration &rest = m_rest[k];
        const std::optional<Similarity> map = similarityOf(rest, onlyPlaced(other, own));
        for (std::size_t j = 0; map && j < rest.size(); ++j) {
            if (!own[j] && rest[j] && other[j]) {
                const double off = glm::distance(map->mapped(*rest[j]), *other[j]);
                squares[j].push_back(off * off);
            }
        }
    }
    for (std::size_t j = 0; j < count; ++j) {
        if (own[j] || !mean[j])
            continue;
        ExpectedPlace expected;
        expected.place = ownFromMean->mapped(*mean[j]);
        if (squares[j].size() >= 2) {
            double sum = 0.0;
            for (const double square : squares[j])
                sum += square;
            expected.spread = ownFromMean->scale * std::sqrt(sum / static_cast<double>(squares[j].size()));
        }
        result.places[j] = expected;
    }
    return result;
}

} // namespace unprojector::landmarks
