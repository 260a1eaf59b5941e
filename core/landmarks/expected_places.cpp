#include "core/landmarks/expected_places.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::landmarks {

namespace {

std::size_t commonCount(const Configuration &a, const Configuration &b)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += a[i] && b[i] ? std::size_t(1) : 0;
    return count;
}

/// The median of the aligned specimens but one, landmark by landmark.
Configuration meanWithout(const std::vector<Configuration> &aligned, std::size_t one)
{
    Configuration mean(aligned[one].size());
    for (std::size_t j = 0; j < mean.size(); ++j) {
        std::vector<double> x, y, z;
        for (std::size_t k = 0; k < aligned.size(); ++k) {
            if (k == one || !aligned[k][j])
                continue;
            x.push_back(aligned[k][j]->x);
            y.push_back(aligned[k][j]->y);
            z.push_back(aligned[k][j]->z);
        }
        if (!x.empty())
            mean[j] = glm::dvec3(medianOf(std::move(x)), medianOf(std::move(y)), medianOf(std::move(z)));
    }
    return mean;
}

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
    for (std::size_t k = 0; k < m_others.aligned.size(); ++k)
        m_rest.push_back(meanWithout(m_others.aligned, k));
}

ExpectedPlaces PlaceExpectation::placesFor(const Configuration &placed) const
{
    const std::size_t count = std::max(placed.size(), m_others.mean.size());
    Configuration own = placed, mean = m_others.mean;
    own.resize(count);
    mean.resize(count);
    ExpectedPlaces result;
    result.places.resize(count);
    const bool isAny = std::any_of(mean.begin(), mean.end(), [](const auto &point) { return point.has_value(); });
    if (!isAny) {
        result.reason = NoExpectedPlaces::NoOthers;
        return result;
    }
    if (commonCount(own, mean) < kFewestToExpect) {
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
