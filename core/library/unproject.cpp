#include "unprojector/unproject.h"

#include "core/library/internal.h"
#include "core/unproject/batch/click_batch.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace unprojector {

struct Unprojection::Data {
    unproject::ClickBatch batch;
    double lowest, highest; ///< ends of the depth range
};

Result<Unprojection> Unprojection::of(const Setup &setup, Method method, Space space)
{
    unproject::BatchSpace target;
    target.kind = space == Space::World ? unproject::BatchSpace::Kind::World : unproject::BatchSpace::Kind::Eye;
    const auto batch = unproject::ClickBatch::of(
        method == Method::Formula ? unproject::Method::Formula : unproject::Method::Matrix, setup.internal(), target);
    if (!batch)
        return valueError(batch.error());
    const auto &[atNear, atFar] = setup.internal().depthRange;
    return Unprojection(std::make_shared<const Data>(Data{*batch, std::min(atNear, atFar), std::max(atNear, atFar)}));
}

void Unprojection::operator()(const double *px, const double *py, const double *depth, double *points,
                              std::size_t count) const
{
    constexpr std::size_t kBlock = 1024; // its six arrays fit the processor's first cache
    std::array<std::array<double, kBlock>, 3> results;
    for (std::size_t begin = 0; begin < count; begin += kBlock) {
        const std::size_t size = std::min(kBlock, count - begin);
        m_data->batch({px + begin, py + begin, depth + begin},
                      {results[0].data(), results[1].data(), results[2].data()}, size);
        for (std::size_t i = 0; i < size; ++i) {
            const double d = depth[begin + i];
            const bool isValid = d >= m_data->lowest && d <= m_data->highest;
            for (std::size_t k = 0; k < 3; ++k)
                points[3 * (begin + i) + k] = isValid ? results[k][i] : std::numeric_limits<double>::quiet_NaN();
        }
    }
}

} // namespace unprojector
