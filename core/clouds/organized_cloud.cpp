#include "core/clouds/organized_cloud.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/clouds/depth_cloud.h"
#include "core/geometry/error_text.h"

#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::clouds {
using namespace geometry;
using namespace unproject;
using base::tr;

std::string faultOf(const DepthNumbers &numbers, const DepthOptionNames &names)
{
    const bool isOfWindow = numbers.meaning == DepthMeaning::Buffer || numbers.meaning == DepthMeaning::Range;
    if (numbers.scale && isOfWindow)
        return tr("%1 goes with %2 z, distance or disparity; depths of the window have no unit", names.scale,
                  names.meaning);
    if (numbers.meaning == DepthMeaning::Disparity && !numbers.baseline)
        return tr("%1 disparity needs %2, the distance of the two cameras in world units", names.meaning,
                  names.baseline);
    for (const auto &[name, value] :
         {std::pair(names.baseline, numbers.baseline), std::pair(names.offset, numbers.disparityOffset)}) {
        if (value && numbers.meaning != DepthMeaning::Disparity)
            return tr("%1 goes with %2 disparity", name, names.meaning);
    }
    if (numbers.disparityOffset && !std::isfinite(*numbers.disparityOffset))
        return tr("%1 is %2; it must be a finite number", names.offset, base::shortestText(*numbers.disparityOffset));
    for (const auto &[name, value] :
         {std::pair(names.scale, numbers.scale), std::pair(names.baseline, numbers.baseline)}) {
        if (value && !(*value > 0.0 && std::isfinite(*value)))
            return tr("%1 is %2; it must be greater than 0", name, base::shortestText(*value));
    }
    return {};
}

Result<OrganizedCloud, std::string> OrganizedCloud::of(const Setup &setup, const DepthNumbers &numbers,
                                                       const DepthValues::Type &type, Method method)
{
    if (std::string fault = faultOf(numbers); !fault.empty())
        return fault;
    const bool isMatrix = method == Method::Matrix;
    const Result<BatchUnprojection> unprojection =
        isMatrix ? BatchUnprojection::byMatrix(setup, {}) : BatchUnprojection::byFormula(setup, {});
    if (!unprojection)
        return geometry::errorText(unprojection.error());
    Result<PixelLines> lines = PixelLines();
    std::optional<ClipDistances> clip;
    if (numbers.meaning != DepthMeaning::Buffer && numbers.meaning != DepthMeaning::Range) {
        lines = isMatrix ? PixelLines::byMatrix(setup) : PixelLines::byFormula(setup);
        const Result<ClipDistances> distances = clipDistances(setup);
        if (!lines || !distances)
            return geometry::errorText(lines ? distances.error() : lines.error());
        clip = *distances;
        if (numbers.meaning == DepthMeaning::Disparity && !lines->isPerspective())
            return tr("a parallel projection has no disparities; give distances along the view axis");
    }
    OrganizedCloud cloud(*unprojection, *lines);
    cloud.m_clip = clip;
    cloud.m_values =
        std::make_shared<const DepthValues>(type, numbers, setup, *cloud.m_lines, clip.value_or(ClipDistances{}));
    if (cloud.m_values->isOfWindow() || cloud.m_lines->canTakeFloats())
        cloud.m_kept = cloud.m_values->kept();
    cloud.m_canOverflow =
        clip ? canOverflow<float>(*cloud.m_lines, setup, *clip) : canOverflow<float>(*unprojection, setup);
    return cloud;
}

template <class Line, class Scalar>
void OrganizedCloud::line(const Line &line, Scalar *points) const
{
    if (m_values->isOfWindow())
        m_unprojection.line(line, points);
    else
        m_lines->line(line, points);
    // A point with a coordinate beyond the range of numbers is none.
    constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN();
    for (std::size_t i = 0; m_canOverflow && i < line.count; ++i, points += 3) {
        if (!std::isfinite(points[0]) || !std::isfinite(points[1]) || !std::isfinite(points[2]))
            points[0] = points[1] = points[2] = kNaN;
    }
}

template <class Scalar>
void OrganizedCloud::row(std::size_t j, std::size_t first, std::vector<double> &values, Scalar *points) const
{
    m_values->convert(j, first, values);
    const DevicePoint at = pixelCenter({static_cast<int>(first), static_cast<int>(j)});
    line(batch::DepthLine{values.data(), values.size(), at.x, at.y}, points);
}

template <class Scalar>
void OrganizedCloud::row(std::size_t j, std::size_t first, std::span<const float> values, Scalar *points) const
{
    const DevicePoint at = pixelCenter({static_cast<int>(first), static_cast<int>(j)});
    line(batch::FloatLine{values.data(), values.size(), at.x, at.y, m_kept->lowest, m_kept->highest, m_kept->divisor},
         points);
}

template void OrganizedCloud::row(std::size_t, std::size_t, std::vector<double> &, double *) const;
template void OrganizedCloud::row(std::size_t, std::size_t, std::vector<double> &, float *) const;
template void OrganizedCloud::row(std::size_t, std::size_t, std::span<const float>, double *) const;
template void OrganizedCloud::row(std::size_t, std::size_t, std::span<const float>, float *) const;

void OrganizedCloud::count(std::size_t j, const std::vector<double> &values, PixelCounts &counts) const
{
    DistanceRow row{values, {}};
    m_values->convert(j, 0, row);
    for (const PixelKind kind : row.kinds)
        ++counts[static_cast<std::size_t>(kind)];
}

} // namespace unprojector::clouds
