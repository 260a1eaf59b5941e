#include "unprojector/project.h"

#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/library/internal.h"
#include "core/unproject/pixel_projection.h"

#include <cmath>
#include <limits>

namespace unprojector {
namespace {

/// Stores the numbers of a stage, if it has an answer.
template <class Values, class Vector>
bool take(const Values &values, Vector &stage)
{
    Vector rounded;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!std::isfinite(values[k].value))
            return false;
        rounded[static_cast<glm::length_t>(k)] = values[k].value;
    }
    stage = rounded;
    return true;
}

} // namespace

struct ForwardProjection::Data {
    unproject::PixelProjection projection;

    /// @return whether the point has a pixel
    bool stagesOf(const glm::dvec3 &point, Stages &stages) const
    {
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        stages = {glm::dvec3(kNaN), glm::dvec4(kNaN), glm::dvec3(kNaN), glm::dvec3(kNaN), glm::dvec3(kNaN)};
        const unproject::PixelProjection::Point p = projection.at(point);
        if (!take(p.way.eye, stages.eye) || !take(p.way.clip, stages.clip) || stages.clip.w == 0.0
            || !take(p.way.ndc, stages.ndc) || !take(p.way.window, stages.window))
            return false;
        stages.pixel = {p.px.value, p.py.value, p.depth};
        return true;
    }
};

Result<ForwardProjection> ForwardProjection::of(const Setup &setup, Space space)
{
    unproject::BatchSpace source;
    source.kind = space == Space::World ? unproject::BatchSpace::Kind::World : unproject::BatchSpace::Kind::Eye;
    const auto projection = unproject::PixelProjection::of(SetupAccess::of(setup), source);
    if (!projection)
        return valueError(projection.error());
    return ForwardProjection(std::make_shared<const Data>(Data{*projection}));
}

Result<Stages> ForwardProjection::at(const glm::dvec3 &point) const
{
    Stages stages;
    if (m_data->stagesOf(point, stages))
        return stages;
    return valueError(base::tr("the point has no window position: it lies in the plane of the eye, or too far away"));
}

void ForwardProjection::operator()(const double *points, Stages *stages, std::size_t count, unsigned threads) const
{
    constexpr std::size_t kTask = std::size_t{1} << 12; // about a millisecond
    base::inParallelRanges(
        count, kTask, {},
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_data->stagesOf({points[3 * i], points[3 * i + 1], points[3 * i + 2]}, stages[i]);
        },
        threads);
}

} // namespace unprojector
