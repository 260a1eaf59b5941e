#include "core/landmarks/procrustes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace unprojector::landmarks {

namespace {

/// The eigenvectors of a symmetric matrix (columns) and their eigenvalues, by Jacobi rotations.
template <std::size_t N>
struct Eigen {
    std::array<std::array<double, N>, N> vectors{}; ///< vectors[i]: the i-th
    std::array<double, N> values{};
};

template <std::size_t N>
Eigen<N> eigenOf(std::array<std::array<double, N>, N> m)
{
    Eigen<N> eigen;
    for (std::size_t i = 0; i < N; ++i)
        eigen.vectors[i][i] = 1.0;
    for (int sweep = 0; sweep < 50; ++sweep) {
        for (std::size_t p = 0; p + 1 < N; ++p) {
            for (std::size_t q = p + 1; q < N; ++q) {
                if (m[p][q] == 0.0)
                    continue;
                const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
                const double c = 1.0 / std::hypot(1.0, t), s = t * c;
                for (std::size_t k = 0; k < N; ++k) {
                    const double kp = m[k][p], kq = m[k][q];
                    m[k][p] = c * kp - s * kq;
                    m[k][q] = s * kp + c * kq;
                }
                for (std::size_t k = 0; k < N; ++k) {
                    const double pk = m[p][k], qk = m[q][k];
                    m[p][k] = c * pk - s * qk;
                    m[q][k] = s * pk + c * qk;
                    const double vp = eigen.vectors[p][k], vq = eigen.vectors[q][k];
                    eigen.vectors[p][k] = c * vp - s * vq;
                    eigen.vectors[q][k] = s * vp + c * vq;
                }
                m[p][q] = m[q][p] = 0.0;
            }
        }
    }
    for (std::size_t i = 0; i < N; ++i)
        eigen.values[i] = m[i][i];
    return eigen;
}

/// Sums over the landmarks of both configurations, about their centroids.
struct Moments {
    glm::dvec3 fromCenter{0.0}, toCenter{0.0};
    glm::dmat3 fromFrom{0.0}, toTo{0.0}, fromTo{0.0}; ///< fromTo[j][i] = sum of w from_i to_j
};

/// Returns whether a scatter matrix belongs to points on a line, within 1 % of their length.
bool isLine(const glm::dmat3 &scatter)
{
    constexpr double kWidth = 0.01;
    std::array<std::array<double, 3>, 3> m{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m[std::size_t(i)][std::size_t(j)] = scatter[j][i];
    }
    std::array<double, 3> values = eigenOf<3>(m).values;
    std::sort(values.begin(), values.end());
    return !(values[1] > kWidth * kWidth * values[2]);
}

double traceOf(const glm::dmat3 &m)
{
    return m[0][0] + m[1][1] + m[2][2];
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

/// Horn's rotation for the sums m[j][i] of from_i to_j.
glm::dmat3 rotationOf(const glm::dmat3 &m)
{
    const auto s = [&m](int i, int j) { return m[j][i]; };
    const Eigen<4> eigen = eigenOf<4>({{
        {s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0)},
        {s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2)},
        {s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1)},
        {s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1)},
    }});
    const auto largest = std::max_element(eigen.values.begin(), eigen.values.end()) - eigen.values.begin();
    const std::array<double, 4> &q = eigen.vectors[static_cast<std::size_t>(largest)];
    return glm::mat3_cast(glm::normalize(glm::dquat(q[0], q[1], q[2], q[3])));
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

/// The mean of aligned specimens, landmark by landmark.
Configuration meanOf(std::span<const Configuration> aligned, Estimate estimate, std::size_t count)
{
    Configuration mean(count);
    for (std::size_t i = 0; i < count; ++i) {
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
    similarity.rotation = rotationOf(moments->fromTo);
    const double fromSquares = traceOf(moments->fromFrom);
    // The sum of y . R x is the trace of R times the sum of x y^T.
    similarity.scale = scaling == Scaling::Sizes ? std::sqrt(traceOf(moments->toTo) / fromSquares)
                                                 : traceOf(similarity.rotation * moments->fromTo) / fromSquares;
    similarity.translation = moments->toCenter - similarity.scale * (similarity.rotation * moments->fromCenter);
    if (!(similarity.scale > 0.0) || !std::isfinite(similarity.scale))
        return std::nullopt;
    return similarity;
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
    const Configuration *first = nullptr;
    for (const Configuration &specimen : specimens) {
        count = std::max(count, specimen.size());
        const auto known = static_cast<std::size_t>(
            std::count_if(specimen.begin(), specimen.end(), [](const auto &point) { return point.has_value(); }));
        if (known > most) {
            most = known;
            first = &specimen;
        }
    }
    std::vector<Configuration> same(specimens.begin(), specimens.end()); // of equal length
    for (Configuration &specimen : same)
        specimen.resize(count);
    result.aligned.assign(specimens.size(), Configuration(count));
    result.mean.resize(count);
    if (!first)
        return result;
    result.mean = *first;
    result.mean.resize(count);
    result.mean = normalized(std::move(result.mean));
    constexpr int kMostSteps = 200, kFirstSteps = 10;
    constexpr double kStays = 1e-26; // the mean's squared change, at centroid size 1
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
        Configuration mean = normalized(meanOf(result.aligned, estimate, count));
        const double change = squaredDistance(mean, result.mean);
        const bool isLost = std::none_of(mean.begin(), mean.end(), [](const auto &point) { return point.has_value(); });
        if (!isLost)
            result.mean = std::move(mean);
        if (isLost || (change < kStays && (estimate == Estimate::LeastSquares || step > kFirstSteps)))
            break;
    }
    return result;
}

} // namespace unprojector::landmarks
