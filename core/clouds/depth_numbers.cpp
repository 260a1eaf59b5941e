#include "core/clouds/depth_numbers.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::clouds {
using namespace geometry;
using namespace unproject;
using base::tr;
namespace {

/// True if the file's numbers are in single precision, and compared with numbers of the scene: a
/// renderer rounds its far plane and its depth range too.
bool isRounded(const DepthValues::Type &type, const DepthNumbers &numbers)
{
    return type.isSingle && (numbers.meaning == DepthMeaning::Z || numbers.meaning == DepthMeaning::Buffer);
}

double asFloat(double number)
{
    return static_cast<double>(static_cast<float>(number));
}

} // namespace

std::string leftOutText(const PixelCounts &counts, const std::optional<ClipDistances> &clip)
{
    std::string list;
    const auto add = [&](PixelKind kind, const char *pattern, double plane = 0.0) {
        if (const std::size_t count = counts[static_cast<std::size_t>(kind)]; count > 0)
            list += (list.empty() ? "" : ", ") + tr(pattern, count, base::shortestText(plane));
    };
    add(PixelKind::NoData, base::marked("%1 with a number that means no measurement"));
    add(PixelKind::Zero, base::marked("%1 with 0"));
    add(PixelKind::NotANumber, base::marked("%1 with NaN"));
    add(PixelKind::Infinite, base::marked("%1 infinite"));
    add(PixelKind::Negative, base::marked("%1 below 0"));
    add(PixelKind::OutsideRange, base::marked("%1 outside the depth range"));
    if (clip) {
        add(PixelKind::BeforeNear, base::marked("%1 before the near plane (%2)"), clip->atNear);
        add(PixelKind::AtFar, base::marked("%1 on the far plane (%2) or behind it"), clip->atFar);
    } else {
        add(PixelKind::AtFar, base::marked("%1 with the background's depth"));
    }
    return list;
}

DepthValues::DepthValues(const Type &type, const DepthNumbers &numbers, const Setup &setup, const PixelLines &lines,
                         const ClipDistances &clip)
    : m_type(type), m_numbers(numbers), m_lines(lines), m_clip(clip),
      m_low(std::min(setup.depthRange.atNear, setup.depthRange.atFar)),
      m_high(std::max(setup.depthRange.atNear, setup.depthRange.atFar)), m_lowest(m_low), m_highest(m_high),
      m_background(setup.depthRange.atFar)
{
    if (type.isSingle)
        std::ranges::transform(m_numbers.noData, m_numbers.noData.begin(), asFloat);
    if (!isRounded(type, numbers))
        return;
    for (double *compared : {&m_lowest, &m_highest, &m_background})
        *compared = asFloat(*compared);
    for (double *compared : {&m_clip.atNear, &m_clip.atFar})
        *compared = std::min(*compared, asFloat(*compared));
}

bool DepthValues::isNoData(double number) const
{
    return std::ranges::find(m_numbers.noData, number) != m_numbers.noData.end();
}

PixelKind DepthValues::kindOfDepth(double depth) const
{
    if (std::isnan(depth))
        return PixelKind::NotANumber;
    if (std::isinf(depth))
        return PixelKind::Infinite;
    if (depth == m_background)
        return PixelKind::AtFar;
    return depth >= m_lowest && depth <= m_highest ? PixelKind::Kept : PixelKind::OutsideRange;
}

PixelKind DepthValues::kindOfNumber(double number) const
{
    if (std::isnan(number))
        return PixelKind::NotANumber;
    if (std::isinf(number))
        return PixelKind::Infinite;
    if (m_clip.atNear < 0.0 && m_numbers.meaning != DepthMeaning::Disparity) // a box around the eye
        return PixelKind::Kept;
    return number > 0.0 ? PixelKind::Kept : number < 0.0 ? PixelKind::Negative : PixelKind::Zero;
}

PixelKind DepthValues::kindOfDistance(double z) const
{
    if (z < m_clip.atNear)
        return PixelKind::BeforeNear;
    return z < m_clip.atFar ? PixelKind::Kept : PixelKind::AtFar;
}

void DepthValues::convert(std::size_t j, std::size_t first, DistanceRow &row) const
{
    const std::size_t width = row.values.size();
    row.kinds.resize(width);
    if (isOfWindow()) {
        const double one = m_type.one();
        for (std::size_t i = 0; i < width; ++i) {
            const bool isMeasured = !isNoData(row.values[i]);
            row.values[i] /= one;
            if (m_numbers.meaning == DepthMeaning::Range)
                row.values[i] = std::lerp(m_low, m_high, row.values[i]);
            row.kinds[i] = isMeasured ? kindOfDepth(row.values[i]) : PixelKind::NoData;
        }
        return;
    }
    const double scale = m_numbers.scale.value_or(1.0);
    const double fxBaseline = m_lines.focalPixels() * m_numbers.baseline.value_or(0.0);
    const double offset = m_numbers.disparityOffset.value_or(0.0);
    for (std::size_t i = 0; i < width; ++i) {
        double &value = row.values[i];
        const bool isMeasured = !isNoData(value);
        value /= scale;
        if (value != 0.0)
            value += offset;
        row.kinds[i] = isMeasured ? kindOfNumber(value) : PixelKind::NoData;
        if (row.kinds[i] != PixelKind::Kept)
            continue;
        if (m_numbers.meaning == DepthMeaning::Disparity) {
            value = fxBaseline / value;
        } else if (m_numbers.meaning == DepthMeaning::Distance) {
            const DevicePoint center = pixelCenter({static_cast<int>(first + i), static_cast<int>(j)});
            value /= glm::length(m_lines.at(center.x, center.y).ahead);
        }
        row.kinds[i] = kindOfDistance(value);
    }
}

void DepthValues::convert(std::size_t j, std::size_t first, std::span<double> values) const
{
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    if (!m_numbers.noData.empty())
        std::ranges::replace_if(
            values, [this](double number) { return isNoData(number); }, kNaN);
    if (m_numbers.meaning == DepthMeaning::Buffer) {
        const double one = m_type.one();
        for (double &value : values) {
            const double depth = value / one;
            value = depth >= m_lowest && depth <= m_highest && depth != m_background ? depth : kNaN;
        }
        return;
    }
    if (m_numbers.meaning == DepthMeaning::Z && m_clip.atNear >= 0.0) {
        const double scale = m_numbers.scale.value_or(1.0), atNear = m_clip.atNear, atFar = m_clip.atFar;
        for (double &value : values) {
            const double z = value / scale;
            value = z > 0.0 && z >= atNear && z < atFar && z <= std::numeric_limits<double>::max() ? z : kNaN;
        }
        return;
    }
    DistanceRow row{{values.begin(), values.end()}, {}};
    convert(j, first, row);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = row.kinds[i] == PixelKind::Kept ? row.values[i] : kNaN;
}

std::optional<DepthValues::Kept> DepthValues::kept() const
{
    const bool isBuffer = m_numbers.meaning == DepthMeaning::Buffer;
    if (!m_numbers.noData.empty() || (!isBuffer && (m_numbers.meaning != DepthMeaning::Z || m_clip.atNear < 0.0)))
        return std::nullopt;
    const double divisor = isBuffer ? m_type.one() : m_numbers.scale.value_or(1.0);
    const auto isKept = [&](float number) {
        std::array<double, 1> value{static_cast<double>(number)};
        convert(0, 0, value);
        return !std::isnan(value[0]);
    };
    // The ends of the interval lie within a few floats of the planes.
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const double low = isBuffer ? m_lowest : std::max(0.0, m_clip.atNear), high = isBuffer ? m_highest : m_clip.atFar;
    const auto endAt = [&](double plane, float outwards) {
        auto end = static_cast<float>(std::clamp(plane * divisor, -double(std::numeric_limits<float>::max()),
                                                 double(std::numeric_limits<float>::max())));
        constexpr int kMostSteps = 8;
        for (int step = 0; step < kMostSteps && std::nextafter(end, outwards) != outwards; ++step)
            end = std::nextafter(end, outwards);
        for (int step = 0; step < 3 * kMostSteps && !isKept(end); ++step)
            end = std::nextafter(end, -outwards);
        return end;
    };
    const Kept kept{endAt(low, -kInfinity), endAt(high, kInfinity), divisor};
    if (!isKept(kept.lowest) || !isKept(kept.highest))
        return std::nullopt;
    return kept;
}

DepthRows::DepthRows(const images::NumberImage &image, const DepthNumbers &numbers, const Setup &setup,
                     const PixelLines &lines, const ClipDistances &clip)
    : m_image(image), m_values({std::holds_alternative<std::unique_ptr<float[]>>(image.numbers), image.greatest},
                               numbers, setup, lines, clip)
{
}

void DepthRows::read(std::size_t j, DistanceRow &row) const
{
    const std::size_t width = m_image.size.width;
    row.values.resize(width);
    std::visit([&](const auto &numbers) { std::copy_n(numbers.get() + m_image.start(j), width, row.values.begin()); },
               m_image.numbers);
    m_values.convert(j, 0, row);
}

std::size_t DepthRows::saturated(std::size_t j, const DistanceRow &row) const
{
    if (!(m_image.greatest > 0.0) || isOfWindow())
        return 0;
    return std::visit(
        [&](const auto &numbers) {
            const auto *of = numbers.get() + m_image.start(j);
            std::size_t count = 0;
            for (std::size_t i = 0; i < m_image.size.width; ++i)
                count += row.kinds[i] == PixelKind::Kept && static_cast<double>(of[i]) == m_image.greatest
                             ? std::size_t{1}
                             : 0;
            return count;
        },
        m_image.numbers);
}

} // namespace unprojector::clouds
