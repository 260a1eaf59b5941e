#include "core/lessons/slips.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace unprojector::lessons {

namespace {

constexpr double kHalfPixel = 0.5;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// The number that a slip gives.
struct Candidate {
    SlipKind kind;
    double value;
};
using Candidates = std::vector<Candidate>;
using enum SlipKind;

bool isPixelCoordinate(AskedKind kind)
{
    return kind == AskedKind::WindowX || kind == AskedKind::WindowY || kind == AskedKind::DeviceX
           || kind == AskedKind::DeviceY;
}

void addPixels(const Asked &asked, Candidates &all)
{
    const double a = asked.answer;
    switch (asked.kind) {
    case AskedKind::WindowX:
    case AskedKind::DeviceX:
        all.push_back({LeftEdge, a - kHalfPixel});
        all.push_back({RightEdge, a + kHalfPixel});
        break;
    case AskedKind::WindowY:
        all.push_back({UpperEdge, a + kHalfPixel});
        all.push_back({LowerEdge, a - kHalfPixel});
        break;
    case AskedKind::DeviceY:
        all.push_back({UpperEdge, a - kHalfPixel});
        all.push_back({LowerEdge, a + kHalfPixel});
        break;
    case AskedKind::Row:
        all.push_back({RowAbove, a + 1.0});
        all.push_back({RowCentre, a + kHalfPixel});
        all.push_back({NotFlipped, asked.height - 1.0 - a});
        break;
    default: break;
    }
    if (asked.kind == AskedKind::WindowY || asked.kind == AskedKind::DeviceY) {
        const SlipKind kind = asked.kind == AskedKind::WindowY ? NotFlipped : Flipped;
        const double other = asked.height - a;
        for (const double way : {0.0, -kHalfPixel, kHalfPixel, -1.0})
            all.push_back({kind, other + way});
    }
    if (isPixelCoordinate(asked.kind)) {
        all.push_back({TimesRatio, a * asked.ratio});
        all.push_back({OverRatio, a / asked.ratio});
    }
}

/// The distance at a position t of the depth range, 0 at the near plane and 1 at the far one.
double distanceAt(const Asked &asked, double t)
{
    const double n = *asked.nearDistance, f = *asked.farDistance;
    return asked.isPerspective ? n * f / (f * (1.0 - t) + n * t) : n + t * (f - n);
}

/// The inverse of distanceAt.
double placeOf(const Asked &asked, double distance)
{
    const double n = *asked.nearDistance, f = *asked.farDistance;
    return asked.isPerspective ? f * (distance - n) / (distance * (f - n)) : (distance - n) / (f - n);
}

void addDepths(const Asked &asked, Candidates &all)
{
    const double a = asked.answer;
    const double span = asked.depthAtFar - asked.depthAtNear;
    const auto ndc = [](double t) { return 2.0 * t - 1.0; };
    const bool hasPlanes = asked.nearDistance && asked.farDistance && *asked.nearDistance != *asked.farDistance;
    if (asked.kind == AskedKind::WindowDepth && span != 0.0) {
        const double t = (a - asked.depthAtNear) / span;
        all.push_back({NearFarSwapped, asked.depthAtFar - t * span});
        all.push_back({NdcForDepth, ndc(t)});
        if (hasPlanes && asked.isPerspective) {
            const double even =
                (distanceAt(asked, t) - *asked.nearDistance) / (*asked.farDistance - *asked.nearDistance);
            all.push_back({EvenDepth, asked.depthAtNear + even * span});
        }
    } else if (asked.kind == AskedKind::NdcZ) {
        all.push_back({DepthForNdc, asked.depthAtNear + (a + 1.0) / 2.0 * span});
    } else if ((asked.kind == AskedKind::EyeZ || asked.kind == AskedKind::Distance) && hasPlanes) {
        const double sign = asked.kind == AskedKind::EyeZ ? -1.0 : 1.0;
        const double t = placeOf(asked, sign * a);
        all.push_back({NearFarSwapped, sign * distanceAt(asked, 1.0 - t)});
        all.push_back({NdcForDepth, sign * distanceAt(asked, ndc(t))});
        all.push_back({DepthForNdc, sign * distanceAt(asked, (t + 1.0) / 2.0)});
        if (asked.isPerspective)
            all.push_back({EvenDepth, sign * (*asked.nearDistance + t * (*asked.farDistance - *asked.nearDistance))});
    }
}

void addAngles(const Asked &asked, Candidates &all)
{
    const double a = asked.answer;
    for (const double degrees : asked.anglesDegrees) {
        const double right = std::tan(degrees / kDegrees), wrong = std::tan(degrees);
        all.push_back({DegreesForRadians, a * wrong / right});
        all.push_back({DegreesForRadians, a * right / wrong});
    }
    all.push_back({DegreesForRadians, a * kDegrees});
    all.push_back({RadiansForDegrees, a / kDegrees});
}

} // namespace

AskedKind askedKind(std::string_view source)
{
    const bool isRow =
        source.find("surface.height") != std::string_view::npos && source.find(".pixel[1]") != std::string_view::npos;
    if (isRow)
        return AskedKind::Row;
    const bool isNegative = !source.empty() && source.front() == '-';
    if (isNegative)
        source.remove_prefix(1);
    if (source.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") != std::string_view::npos)
        return AskedKind::Other;
    struct Coordinate {
        std::string_view path;
        AskedKind kind;
    };
    constexpr Coordinate kCoordinates[] = {
        {"eye.z", AskedKind::EyeZ},           {"window.x", AskedKind::WindowX}, {"window.y", AskedKind::WindowY},
        {"window.z", AskedKind::WindowDepth}, {"device.x", AskedKind::DeviceX}, {"widget.x", AskedKind::DeviceX},
        {"device.y", AskedKind::DeviceY},     {"widget.y", AskedKind::DeviceY}, {"ndc.z", AskedKind::NdcZ}};
    for (const auto &[path, kind] : kCoordinates) {
        if (source != path && !source.ends_with('.' + std::string(path)))
            continue;
        if (isNegative)
            return kind == AskedKind::EyeZ ? AskedKind::Distance : AskedKind::Other;
        return kind;
    }
    return AskedKind::Other;
}

std::optional<Asked> askedIn(const LessonNumbers &numbers, const Step &step)
{
    if (!step.question)
        return std::nullopt;
    const std::vector<double> values = numbers.values(step.id, step.question->answer);
    if (values.size() != 1)
        return std::nullopt;
    const auto number = [&](std::string_view path) -> std::optional<double> {
        const std::vector<double> all = numbers.step(step.id).at(path);
        return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
    };
    Asked asked;
    asked.kind = askedKind(step.question->answer);
    asked.answer = values.front();
    asked.tolerance = step.question->tolerance;
    asked.height = number("surface.height").value_or(0.0);
    asked.ratio = number("surface.ratio").value_or(1.0);
    asked.nearDistance = number("scene.projection.near");
    asked.farDistance = number("scene.projection.far");
    // Only a perspective's last row is nonzero there.
    asked.isPerspective = number("projection[3][2]").value_or(0.0) != 0.0;
    asked.depthAtNear = number("scene.depthRange[0]").value_or(0.0);
    asked.depthAtFar = number("scene.depthRange[1]").value_or(1.0);
    if (const auto fovy = number("scene.projection.fovy"))
        asked.anglesDegrees.push_back(*fovy / 2.0);
    for (const char *path : {"scene.projection.theta", "scene.projection.phi"}) {
        if (const auto angle = number(path))
            asked.anglesDegrees.push_back(*angle);
    }
    return asked;
}

bool isRight(const Asked &asked, double given)
{
    return std::fabs(given - asked.answer) <= asked.tolerance;
}

std::optional<SlipKind> slipOf(const Asked &asked, double given)
{
    if (isRight(asked, given))
        return std::nullopt;
    Candidates all;
    addPixels(asked, all);
    all.push_back({asked.kind == AskedKind::EyeZ ? SlipKind::DistanceForZ : SlipKind::Sign, -asked.answer});
    addDepths(asked, all);
    addAngles(asked, all);
    // The answer's own tolerance, limited so that it separates two slips half a pixel apart.
    const double tolerance = std::min(asked.tolerance, kHalfPixel / 4.0);
    std::optional<SlipKind> found;
    for (const Candidate &candidate : all) {
        const bool leadsThere = std::isfinite(candidate.value) && !isRight(asked, candidate.value)
                                && std::fabs(candidate.value - given) <= tolerance;
        if (leadsThere && (!found || candidate.kind < *found))
            found = candidate.kind;
    }
    return found;
}

} // namespace unprojector::lessons
