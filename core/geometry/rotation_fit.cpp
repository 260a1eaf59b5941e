#include "core/geometry/rotation_fit.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace unprojector::geometry {
namespace {

constexpr std::size_t kSize = 4;

/// The eigenvectors of a symmetric matrix (columns) and their eigenvalues, by Jacobi rotations.
struct Eigen {
    std::array<std::array<double, kSize>, kSize> vectors{}; ///< vectors[i]: the i-th
    std::array<double, kSize> values{};
};

Eigen eigenOf(std::array<std::array<double, kSize>, kSize> m)
{
    Eigen eigen;
    for (std::size_t i = 0; i < kSize; ++i)
        eigen.vectors[i][i] = 1.0;
    for (int sweep = 0; sweep < 50; ++sweep) {
        for (std::size_t p = 0; p + 1 < kSize; ++p) {
            for (std::size_t q = p + 1; q < kSize; ++q) {
                if (std::abs(m[p][q]) <= 1e-20 * (std::abs(m[p][p]) + std::abs(m[q][q])))
                    continue;
                const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
                const double c = 1.0 / std::hypot(1.0, t), s = t * c;
                for (std::size_t k = 0; k < kSize; ++k) {
                    const double kp = m[k][p], kq = m[k][q];
                    m[k][p] = c * kp - s * kq;
                    m[k][q] = s * kp + c * kq;
                }
                for (std::size_t k = 0; k < kSize; ++k) {
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
    for (std::size_t i = 0; i < kSize; ++i)
        eigen.values[i] = m[i][i];
    return eigen;
}

} // namespace

glm::dmat3 rotationOfSums(const glm::dmat3 &m)
{
    const auto s = [&m](int i, int j) { return m[j][i]; };
    const Eigen eigen = eigenOf({{
        {s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0)},
        {s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2)},
        {s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1)},
        {s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1)},
    }});
    const auto largest = std::max_element(eigen.values.begin(), eigen.values.end()) - eigen.values.begin();
    const std::array<double, 4> &q = eigen.vectors[static_cast<std::size_t>(largest)];
    return glm::mat3_cast(glm::normalize(glm::dquat(q[0], q[1], q[2], q[3])));
}

} // namespace unprojector::geometry
