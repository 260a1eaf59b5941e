#include "core/landmarks/procrustes.h"

#include "core/geometry/rotation_fit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace unprojector::landmarks {

namespace {

/// Sums over the landmarks of both configurations, about their centroids.
struct Moments {
    glm::dvec3 fromCenter{0.0}, toCenter{0.0};
    glm::dmat3 fromFrom{0.0}, toTo{0.0}, fromTo{0.0}; ///< fromTo[j][i] = sum of w from_i to_j
};

double traceOf(const glm::dmat3 &m)
{
    return m[0][0] + m[1][1] + m[2][2];
}

/// Returns whether a scatter matrix belongs to points on a line, within 1 % of their length: the sum
/// of the products of two eigenvalues is small beside the square of their sum.
bool isLine(const glm::dmat3 &m)
{
    constexpr double kWidth = 0.01;
    const double products = m[0][0] * m[1][1] - m[0][1] * m[1][0] + m[0][0] * m[2][2] - m[0][2] * m[2][0]
                            + m[1][1] * m[2][2] - m[1][2] * m[2][1];
    return !(products > kWidth * kWidth * traceOf(m) * traceOf(m));
}

std::optional<Moments> momentsOf(const Configuration &from, const Configuration &to, std::span<const double> weights)
{
    const std::size_t count = std::min(from.size(), to.size());
    const auto weightOf = [&](std::size_t i) { return !from[i] || !to[i] ? 0.0 : weights.empty() ? 1.0 : weights[i]; };
    Moments moments;
    double sum = 0.0;
    std::size_t common = 0, first = count;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = weightOf(i);
        if (!(weight > 0.0))
            continue;
        first = std::min(first, i);
        ++common;
        sum += weight;
        // Sums are relative to the first one, because far from the origin they would lose digits.
        moments.fromCenter += weight * (*from[i] - *from[first]);
        moments.toCenter += weight * (*to[i] - *to[first]);
    }
    if (common < 3)
        return std::nullopt;
    moments.fromCenter = *from[first] + moments.fromCenter / sum;
    moments.toCenter = *to[first] + moments.toCenter / sum;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = weightOf(i);
        if (!(weight > 0.0))
            continue;
        const glm::dvec3 a = *from[i] - moments.fromCenter, b = *to[i] - moments.toCenter;
        moments.fromFrom += weight * glm::outerProduct(a, a);
        moments.toTo += weight * glm::outerProduct(b, b);
        moments.fromTo += weight * glm::outerProduct(a, b);
    }
    const bool isFinite = std::isfinite(traceOf(moments.fromFrom)) && std::isfinite(traceOf(moments.toTo));
    if (!isFinite || isLine(moments.fromFrom) || isLine(moments.toTo))
        return std::nullopt;
    return moments;
}

glm::dvec3 centroidOf(const Configuration &points)
{
    glm::dvec3 sum(0.0);
    double count = 0.0;
    const std::optional<glm::dvec3> *first = nullptr;
    for (const std::optional<glm::dvec3> &point : points) {
        if (!point)
            continue;
        if (!first)
            first = &point;
        sum += *point - **first;
        count += 1.0;
    }
    return first ? **first + sum / count : glm::dvec3(0.0);
}

/// Moves the centroid to 0 and scales the centroid size to 1.
Configuration normalized(Configuration points)
{
    const glm::dvec3 center = centroidOf(points);
    const double size = centroidSizeOf(points);
    for (std::optional<glm::dvec3> &point : points) {
        if (point && size > 0.0)
            point = (*point - center) / size;
    }
    return points;
}

constexpr int kFirstSteps = 10; ///< alignments with weights 1 / r

/// The weights of the landmarks in a specimen after an alignment.
/// @param isFirst  weights 1 / r instead of Tukey's: they find the right alignment from a wrong one
std::vector<double> weightsOf(const Configuration &aligned, const Configuration &mean, bool isFirst)
{
    std::vector<double> residuals(aligned.size(), 0.0), known;
    for (std::size_t i = 0; i < aligned.size(); ++i) {
        if (aligned[i] && mean[i])
            known.push_back(residuals[i] = glm::distance(*aligned[i], *mean[i]));
    }
    constexpr double kRounding = 1e-12; // of the mean's size, 1
    const double spread = std::max(kSpreadPerMedian * medianOf(known), kRounding);
    for (double &residual : residuals) {
        if (isFirst) {
            residual = 1.0 / std::max(residual / spread, 0.1);
        } else {
            const double share = residual / (3.0 * spread);
            residual = share < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
        }
    }
    return residuals;
}

double squaredDistance(const Configuration &a, const Configuration &b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].has_value() != b[i].has_value())
            return std::numeric_limits<double>::infinity();
        if (a[i])
            sum += glm::dot(*a[i] - *b[i], *a[i] - *b[i]);
    }
    return sum;
}

} // namespace

Configuration meanOf(std::span<const Configuration> aligned, Estimate estimate)
{
    Configuration mean(aligned.empty() ? 0 : aligned.front().size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
        std::array<std::vector<double>, 3> values;
        for (const Configuration &points : aligned) {
            for (int axis = 0; points[i] && axis < 3; ++axis)
                values[std::size_t(axis)].push_back((*points[i])[axis]);
        }
        if (values[0].empty())
            continue;
        glm::dvec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double> &all = values[std::size_t(axis)];
            if (estimate == Estimate::Robust) {
                point[axis] = medianOf(all);
                continue;
            }
            for (const double value : all)
                point[axis] += value / static_cast<double>(all.size());
        }
        mean[i] = point;
    }
    return mean;
}

std::size_t placedCount(const Configuration &points)
{
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [](const auto &point) { return point.has_value(); }));
}

Configuration Similarity::mapped(const Configuration &points) const
{
    Configuration result = points;
    for (std::optional<glm::dvec3> &point : result) {
        if (point)
            point = mapped(*point);
    }
    return result;
}

Similarity Similarity::inverse() const
{
    const glm::dmat3 back = glm::transpose(rotation);
    return {1.0 / scale, back, -(back * translation) / scale};
}

std::optional<Similarity> similarityOf(const Configuration &from, const Configuration &to, Scaling scaling,
                                       std::span<const double> weights)
{
    const std::optional<Moments> moments = momentsOf(from, to, weights);
    if (!moments)
        return std::nullopt;
    Similarity similarity;
    similarity.rotation = geometry::rotationOfSums(moments->fromTo);
    const double fromSquares = traceOf(moments->fromFrom);
    // The sum of y . R x is the trace of R times the sum of x y^T.
    similarity.scale = scaling == Scaling::Sizes ? std::sqrt(traceOf(moments->toTo) / fromSquares)
                                                 : traceOf(similarity.rotation * moments->fromTo) / fromSquares;
    similarity.translation = moments->toCenter - similarity.scale * (similarity.rotation * moments->fromCenter);
    if (!(similarity.scale > 0.0) || !std::isfinite(similarity.scale))
        return std::nullopt;
    return similarity;
}

std::optional<Similarity> robustSimilarityOf(const Configuration &from, const Configuration &to)
{
    constexpr int kSteps = 30;
    std::vector<double> weights;
    std::optional<Similarity> best;
    for (int step = 0; step < kSteps; ++step) {
        const std::optional<Similarity> similarity = similarityOf(from, to, Scaling::Sizes, weights);
        if (!similarity) // too few of them have a weight
            break;
        best = similarity;
        weights = weightsOf(similarity->mapped(from), to, step < kFirstSteps);
    }
    return best;
}

double centroidSizeOf(const Configuration &points)
{
    const glm::dvec3 center = centroidOf(points);
    double squares = 0.0;
    for (const std::optional<glm::dvec3> &point : points) {
        if (point)
            squares += glm::dot(*point - center, *point - center);
    }
    return std::sqrt(squares);
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Superimposition superimposed(std::span<const Configuration> specimens, Estimate estimate)
{
    Superimposition result;
    result.meanFromSpecimen.resize(specimens.size());
    std::size_t count = 0, most = 0;
    for (const Configuration &specimen : specimens)
        count = std::max(count, specimen.size());
    std::vector<Configuration> same(specimens.begin(), specimens.end()); // of equal length
    result.mean.resize(count);
    for (Configuration &specimen : same) {
        specimen.resize(count);
        if (placedCount(specimen) > most) {
            most = placedCount(specimen);
            result.mean = specimen;
        }
    }
    result.aligned.assign(specimens.size(), Configuration(count));
    if (most == 0)
        return result;
    result.mean = normalized(std::move(result.mean));
    constexpr int kMostSteps = 200;
    const double stays = estimate == Estimate::Robust ? 1e-16 : 1e-26; // the mean's squared change, at size 1
    std::vector<std::vector<double>> weights(specimens.size());
    for (int step = 0; step < kMostSteps; ++step) {
        for (std::size_t k = 0; k < same.size(); ++k) {
            std::optional<Similarity> similarity = similarityOf(same[k], result.mean, Scaling::Sizes, weights[k]);
            if (!similarity) // too few of them have a weight
                similarity = similarityOf(same[k], result.mean, Scaling::Sizes);
            result.meanFromSpecimen[k] = similarity;
            result.aligned[k] = similarity ? similarity->mapped(same[k]) : Configuration(count);
            if (similarity && estimate == Estimate::Robust)
                weights[k] = weightsOf(result.aligned[k], result.mean, step < kFirstSteps);
        }
        Configuration mean = normalized(meanOf(result.aligned, estimate));
        const double change = squaredDistance(mean, result.mean);
        const bool isLost = placedCount(mean) == 0;
        if (!isLost)
            result.mean = std::move(mean);
        if (isLost || (change < stays && (estimate == Estimate::LeastSquares || step > kFirstSteps)))
            break;
    }
    return result;
}

} // namespace unprojector::landmarks
