#include "core/cameras/lens.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::cameras {
using base::shortestText;
using base::tr;
namespace {

/// The derivative of distorted(), columns by x and y.
glm::dmat2 derivative(const Distortion &d, const glm::dvec2 &at)
{
    const double x = at.x, y = at.y, r2 = x * x + y * y;
    const double c = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3)), slope = d.k1 + r2 * (2.0 * d.k2 + 3.0 * r2 * d.k3);
    const double mixed = 2.0 * x * y * slope + 2.0 * d.p1 * x + 2.0 * d.p2 * y;
    return {{c + 2.0 * x * x * slope + 2.0 * d.p1 * y + 6.0 * d.p2 * x, mixed},
            {mixed, c + 2.0 * y * y * slope + 6.0 * d.p1 * y + 2.0 * d.p2 * x}};
}

glm::dvec2 positionOf(const Intrinsics &k, const glm::dvec2 &pixel)
{
    const double y = (pixel.y - cornerToCentre(k.centres) - k.cy) / k.fy;
    return {(pixel.x - cornerToCentre(k.centres) - k.cx - k.skew * y) / k.fx, y};
}

glm::dvec2 pixelOf(const Intrinsics &k, const glm::dvec2 &position)
{
    return {k.fx * position.x + k.skew * position.y + k.cx + cornerToCentre(k.centres),
            k.fy * position.y + k.cy + cornerToCentre(k.centres)};
}

} // namespace

glm::dvec2 distorted(const Distortion &d, const glm::dvec2 &position)
{
    const double x = position.x, y = position.y, r2 = x * x + y * y;
    const double c = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
    return {c * x + 2.0 * d.p1 * x * y + d.p2 * (r2 + 2.0 * x * x),
            c * y + d.p1 * (r2 + 2.0 * y * y) + 2.0 * d.p2 * x * y};
}

std::optional<glm::dvec2> undistorted(const Distortion &lens, const glm::dvec2 &position)
{
    constexpr int kMostSteps = 100;
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    glm::dvec2 at = position;
    // Far out, the first step from the position itself may cross the fold; its centre never does.
    if (!(glm::determinant(derivative(lens, at)) > 0.0))
        at = glm::dvec2(0.0);
    const auto missOf = [&](const glm::dvec2 &p) { return distorted(lens, p) - position; };
    double miss = glm::length(missOf(at));
    for (int step = 0; step < kMostSteps; ++step) {
        const glm::dmat2 slope = derivative(lens, at);
        if (!(glm::determinant(slope) > 0.0))
            return std::nullopt;
        const glm::dvec2 move = glm::inverse(slope) * missOf(at);
        // Half a step is taken where a whole one does not come closer or crosses the fold.
        double share = 1.0;
        glm::dvec2 next = at - move;
        while (share > 1e-3
               && (!(glm::determinant(derivative(lens, next)) > 0.0) || glm::length(missOf(next)) > miss)) {
            share /= 2.0;
            next = at - share * move;
        }
        const double nextMiss = glm::length(missOf(next));
        if (!(nextMiss < miss)) // rounding is reached, or no way leads closer
            break;
        at = next;
        miss = nextMiss;
    }
    const double size = std::max({1.0, std::abs(position.x), std::abs(position.y)});
    if (!(miss <= 16.0 * kRounding * size))
        return std::nullopt;
    return at;
}

glm::dvec2 distortedPixel(const Distortion &lens, const Intrinsics &k, const glm::dvec2 &pixel)
{
    return pixelOf(k, distorted(lens, positionOf(k, pixel)));
}

std::optional<glm::dvec2> undistortedPixel(const Distortion &lens, const Intrinsics &k, const glm::dvec2 &pixel)
{
    const std::optional<glm::dvec2> position = undistorted(lens, positionOf(k, pixel));
    return position ? std::optional(pixelOf(k, *position)) : std::nullopt;
}

geometry::Result<Distortion, std::string> distortionOf(std::span<const double> coefficients)
{
    const auto &c = coefficients;
    if (!std::ranges::all_of(c, [](double value) { return std::isfinite(value); }))
        return tr("a distortion coefficient is not finite");
    if (std::ranges::all_of(c, [](double value) { return value == 0.0; }))
        return Distortion{};
    if (c.size() == 1)
        return tr("there is 1 distortion coefficient; give four or five: k1, k2, p1, p2, k3");
    if (c.size() < 4 || c.size() > kCoefficients.size())
        return tr("there are %1 distortion coefficients; give four or five: k1, k2, p1, p2, k3", c.size());
    std::string others;
    for (std::size_t i = 5; i < c.size(); ++i) {
        if (c[i] != 0.0)
            others += (others.empty() ? "" : ", ") + std::string(kCoefficients[i]) + " = " + shortestText(c[i]);
    }
    if (!others.empty())
        return tr("the distortion has %1; only k1, k2, p1, p2 and k3 are known. Undistort the image with its own "
                  "program, then give --undistorted",
                  others);
    return Distortion{c[0], c[1], c[2], c[3], c.size() > 4 ? c[4] : 0.0};
}

std::string coefficientsText(const Distortion &lens)
{
    std::string text;
    const std::array values{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != 0.0)
            text += (text.empty() ? "" : ", ") + std::string(kCoefficients[i]) + " = " + shortestText(values[i]);
    }
    return text;
}

} // namespace unprojector::cameras
