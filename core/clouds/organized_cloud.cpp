#include "core/clouds/organized_cloud.h"

#include "core/text/error_text.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::clouds {
using namespace geometry;
using namespace unproject;
using text::tr;

std::string faultOf(const DepthNumbers &numbers, const DepthOptionNames &names)
{
    const bool isOfWindow = numbers.meaning == DepthMeaning::Buffer || numbers.meaning == DepthMeaning::Range;
    if (numbers.scale && isOfWindow)
        return tr("%1 goes with %2 z, distance or disparity; depths of the window have no unit", names.scale,
                  names.meaning);
    if (numbers.meaning == DepthMeaning::Disparity && !numbers.baseline)
        return tr("%1 disparity needs %2, the distance of the two cameras in world units", names.meaning,
                  names.baseline);
    if (numbers.meaning != DepthMeaning::Disparity && numbers.baseline)
        return tr("%1 goes with %2 disparity", names.baseline, names.meaning);
    for (const auto &[name, value] :
         {std::pair(names.scale, numbers.scale), std::pair(names.baseline, numbers.baseline)}) {
        if (value && !(*value > 0.0 && std::isfinite(*value)))
            return tr("%1 is %2; it must be greater than 0", name, text::shortestText(*value));
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
        return text::errorText(unprojection.error());
    Result<PixelLines> lines = PixelLines();
    std::optional<ClipDistances> clip;
    if (numbers.meaning != DepthMeaning::Buffer && numbers.meaning != DepthMeaning::Range) {
        lines = isMatrix ? PixelLines::byMatrix(setup) : PixelLines::byFormula(setup);
        const Result<ClipDistances> distances = clipDistances(setup);
        if (!lines || !distances)
            return text::errorText(lines ? distances.error() : lines.error());
        clip = *distances;
        if (numbers.meaning == DepthMeaning::Disparity && !lines->isPerspective())
            return tr("a parallel projection has no disparities; give distances along the view axis");
    }
    OrganizedCloud cloud(*unprojection, *lines);
    cloud.m_clip = clip;
    cloud.m_values =
        std::make_shared<const DepthValues>(type, numbers, setup, *cloud.m_lines, clip.value_or(ClipDistances{}));
    return cloud;
}

template <class Scalar>
void OrganizedCloud::row(std::size_t j, std::size_t first, std::vector<double> &values, Scalar *points) const
{
    m_values->convert(j, first, values);
    const double px = static_cast<double>(first) + kHalfPixel, py = static_cast<double>(j) + kHalfPixel;
    const batch::DepthLine line{values.data(), values.size(), px, py};
    if (m_values->isOfWindow())
        m_unprojection(line, points);
    else
        (*m_lines)(line, points);
    // A coordinate beyond the range of numbers has no point.
    Scalar sum = 0;
    for (std::size_t i = 0; i < 3 * values.size(); ++i)
        sum += points[i] * Scalar(0);
    if (sum == Scalar(0))
        return;
    constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN();
    for (std::size_t i = 0; i < values.size(); ++i, points += 3) {
        if (!std::isfinite(points[0]) || !std::isfinite(points[1]) || !std::isfinite(points[2]))
            points[0] = points[1] = points[2] = kNaN;
    }
}

template void OrganizedCloud::row<double>(std::size_t, std::size_t, std::vector<double> &, double *) const;
template void OrganizedCloud::row<float>(std::size_t, std::size_t, std::vector<double> &, float *) const;

void OrganizedCloud::count(std::size_t j, const std::vector<double> &values, PixelCounts &counts) const
{
    DistanceRow row{values, {}};
    m_values->convert(j, 0, row);
    for (const PixelKind kind : row.kinds)
        ++counts[static_cast<std::size_t>(kind)];
}

} // namespace unprojector::clouds
