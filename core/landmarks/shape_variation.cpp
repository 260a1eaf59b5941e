#include "core/landmarks/shape_variation.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::landmarks {

namespace {

/// The specimens that say how landmarks vary; more of them would cost time and tell little.
constexpr std::size_t kMostSpecimens = 48;
/// The variance of a landmark is averaged with the usual one, which counts like so many specimens.
constexpr double kPooledCount = 8.0;

std::vector<double> variancesOf(std::span<const Offsets> specimens, std::size_t landmarks)
{
    std::vector<double> sums(landmarks, 0.0), counts(landmarks, 0.0);
    double sum = 0.0, count = 0.0;
    for (const Offsets &offsets : specimens) {
        for (std::size_t j = 0; j < landmarks; ++j) {
            if (!offsets[j])
                continue;
            const double square = glm::dot(*offsets[j], *offsets[j]) / 3.0;
            sums[j] += square;
            counts[j] += 1.0;
            sum += square;
            count += 1.0;
        }
    }
    const double usual = sum / std::max(count, 1.0);
    for (std::size_t j = 0; j < landmarks; ++j)
        sums[j] = (sums[j] + kPooledCount * usual) / (counts[j] + kPooledCount);
    return sums;
}

/// The lower triangle L of a positive matrix L L^T.
class Cholesky {
public:
    /// @param matrix  its lower triangle, row by row
    Cholesky(std::vector<double> matrix, std::size_t size) : m_lower(std::move(matrix)), m_size(size)
    {
        for (std::size_t k = 0; k < size; ++k) {
            for (std::size_t l = 0; l <= k; ++l) {
                double sum = m_lower[k * size + l];
                for (std::size_t i = 0; i < l; ++i)
                    sum -= m_lower[k * size + i] * m_lower[l * size + i];
                m_lower[k * size + l] = k == l ? std::sqrt(sum) : sum / m_lower[l * size + l];
            }
        }
    }
    /// L^-1 vector.
    template <class T>
    void divide(std::vector<T> &vector) const
    {
        for (std::size_t k = 0; k < m_size; ++k) {
            for (std::size_t i = 0; i < k; ++i)
                vector[k] -= m_lower[k * m_size + i] * vector[i];
            vector[k] /= m_lower[k * m_size + k];
        }
    }

private:
    std::vector<double> m_lower;
    std::size_t m_size;
};

} // namespace

std::vector<std::vector<double>> smoothFunctionsOver(const Configuration &shape)
{
    constexpr std::size_t kMost = 10;
    constexpr double kLeast = 0.01; // of the kernel's variance, 1
    const std::size_t landmarks = shape.size();
    const double size = centroidSizeOf(shape), radiusSquare = size * size / static_cast<double>(placedCount(shape));
    std::vector<std::vector<double>> functions;
    if (!(radiusSquare > 0.0))
        return functions;
    std::vector<double> left(landmarks, 0.0); // of the variance
    for (std::size_t j = 0; j < landmarks; ++j)
        left[j] = shape[j] ? 1.0 : 0.0;
    while (functions.size() < kMost) {
        const auto pivot = static_cast<std::size_t>(std::max_element(left.begin(), left.end()) - left.begin());
        if (left[pivot] < kLeast)
            break;
        std::vector<double> values(landmarks, 0.0);
        for (std::size_t j = 0; j < landmarks; ++j) {
            if (!shape[j])
                continue;
            const glm::dvec3 offset = *shape[j] - *shape[pivot];
            double value = std::exp(-0.5 * glm::dot(offset, offset) / radiusSquare);
            for (const std::vector<double> &other : functions)
                value -= other[j] * other[pivot];
            values[j] = value / std::sqrt(left[pivot]);
        }
        for (std::size_t j = 0; j < landmarks; ++j)
            left[j] -= values[j] * values[j];
        functions.push_back(std::move(values));
    }
    return functions;
}

ShapeVariation::ShapeVariation(std::span<const Offsets> specimens, const std::vector<std::vector<double>> &smooth,
                               const VarianceShares &shares)
{
    if (specimens.empty() || shares.own >= 1.0)
        return;
    const std::size_t landmarks = specimens.front().size();
    const std::vector<double> variances = variancesOf(specimens, landmarks);
    const double shown = 1.0 - shares.own - shares.smooth;
    const std::size_t step = (specimens.size() + kMostSpecimens - 1) / kMostSpecimens;
    const std::size_t taken = (specimens.size() + step - 1) / step;
    for (std::size_t k = 0; shown > 0.0 && k < specimens.size(); k += step) {
        std::vector<glm::dvec3> &row = m_rows.emplace_back(landmarks, glm::dvec3(0.0));
        for (std::size_t j = 0; j < landmarks; ++j) {
            if (specimens[k][j])
                row[j] = std::sqrt(shown / static_cast<double>(taken)) * *specimens[k][j];
        }
    }
    for (std::size_t i = 0; shares.smooth > 0.0 && i < smooth.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<glm::dvec3> &row = m_rows.emplace_back(landmarks, glm::dvec3(0.0));
            for (std::size_t j = 0; j < landmarks; ++j)
                row[j][axis] = std::sqrt(shares.smooth * variances[j]) * smooth[i][j];
        }
    }
    constexpr double kRounding = 1e-24; // of the mean's squared size, 1
    for (const double variance : variances)
        m_diagonal.push_back(std::max(shares.own * variance, kRounding));
}

Offsets ShapeVariation::rests(const Offsets &offsets, const std::vector<bool> &isLeftOut) const
{
    const std::size_t size = m_rows.size();
    if (size == 0)
        return offsets;
    // Woodbury's identity: a matrix as large as the number of rows instead of all coordinates.
    std::vector<double> matrix(size * size, 0.0), known(size, 0.0);
    for (std::size_t k = 0; k < size; ++k)
        matrix[k * size + k] = 1.0;
    std::vector<glm::dvec3> rows(size);
    const auto takeRows = [&](std::size_t j) {
        for (std::size_t k = 0; k < size; ++k)
            rows[k] = m_rows[k][j];
    };
    for (std::size_t j = 0; j < offsets.size(); ++j) {
        if (!offsets[j] || isLeftOut[j])
            continue;
        takeRows(j);
        for (std::size_t k = 0; k < size; ++k) {
            const glm::dvec3 row = rows[k] / m_diagonal[j];
            known[k] += glm::dot(row, *offsets[j]);
            for (std::size_t l = 0; l <= k; ++l)
                matrix[k * size + l] += glm::dot(row, rows[l]);
        }
    }
    const Cholesky cholesky(std::move(matrix), size);
    cholesky.divide(known);
    Offsets result = offsets;
    for (std::size_t j = 0; j < offsets.size(); ++j) {
        if (!offsets[j])
            continue;
        takeRows(j);
        cholesky.divide(rows);
        glm::dmat3 alone(1.0); // P_jj times the diagonal
        for (std::size_t k = 0; k < size; ++k) {
            *result[j] -= known[k] * rows[k];
            alone -= glm::outerProduct(rows[k], rows[k]) / m_diagonal[j];
        }
        if (!isLeftOut[j])
            *result[j] = glm::inverse(alone) * *result[j];
    }
    return result;
}

} // namespace unprojector::landmarks
