#include "core/landmarks/protocol.h"

#include "core/base/translation.h"
#include "core/geometry/numbers.h"
#include "core/landmarks/name_key.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace unprojector::landmarks {
using base::tr;

namespace {

/// Returns whether a name, in this spelling or another, means several landmarks of a set.
bool isNameOfSeveral(const std::string &name, const std::string &found, const LandmarkSet &set)
{
    const std::string key = nameKey(name);
    return std::count_if(set.landmarks.begin(), set.landmarks.end(),
                         [&](const Landmark &landmark) {
                             return found == name ? landmark.name == name : nameKey(landmark.name) == key;
                         })
           > 1;
}

std::string absenceOf(const Landmark &landmark)
{
    switch (landmark.absence) {
    case Absence::Missing: return tr("\"%1\" is missing on this specimen", landmark.name);
    case Absence::Skipped: return tr("\"%1\" is skipped and not placed yet", landmark.name);
    case Absence::NotPlaced: break;
    }
    return tr("\"%1\" has no position yet", landmark.name);
}

std::string reasonOf(const MeasureError &error, std::span<const Landmark *const> points)
{
    switch (error.code) {
    case MeasureError::Code::Missing: return absenceOf(*points[error.point]);
    case MeasureError::Code::TooFew: return tr("it needs two landmarks");
    case MeasureError::Code::SamePoint: return tr("two of its landmarks are at the same position");
    case MeasureError::Code::NoPlane: return tr("its first three landmarks may lie on one line");
    }
    return {};
}

Measured measured(MeasureKind kind, std::span<const Landmark *const> points)
{
    switch (kind) {
    case MeasureKind::Distance: return distanceOf(*points[0], *points[1]);
    case MeasureKind::Angle: return angleAt(*points[1], *points[0], *points[2]);
    case MeasureKind::Height: return heightOver(*points[0], *points[1], *points[2], *points[3]);
    case MeasureKind::Length:
    case MeasureKind::Surface: break;
    }
    return lengthAlong(points);
}

} // namespace

MeasureSize sizeOf(MeasureKind kind)
{
    constexpr std::array<MeasureSize, kMeasureKinds.size()> kSizes{{{2, 2}, {3, 3}, {4, 4}}}; // others: 2 or more
    return kSizes[static_cast<std::size_t>(kind)];
}

ProtocolValue valueOf(const KeptMeasure &measure, const LandmarkSet &set, const SurfaceLength &surface)
{
    std::vector<const Landmark *> points;
    for (const std::string &name : measure.landmarks) {
        const std::optional<std::size_t> index = indexOfName(set.landmarks, name);
        if (!index)
            return {std::nullopt, tr("no landmark has the name \"%1\"", name)};
        if (isNameOfSeveral(name, set.landmarks[*index].name, set))
            return {std::nullopt, tr("several landmarks have the name \"%1\"", name)};
        points.push_back(&set.landmarks[*index]);
    }
    const MeasureSize size = sizeOf(measure.kind);
    if (points.size() < size.fewest || points.size() > size.most)
        return {std::nullopt, tr("it has the wrong number of landmarks")};
    // Absent landmarks are the better reason, and need no mesh.
    if (measure.kind == MeasureKind::Surface
        && std::all_of(points.begin(), points.end(), [](const Landmark *point) { return point->isPlaced(); })) {
        if (!surface)
            return {std::nullopt, tr("the mesh is not open")};
        geometry::Result<Measure, std::string> length = surface(points);
        return length ? ProtocolValue{*length, {}} : ProtocolValue{std::nullopt, std::move(length).error()};
    }
    const Measured value = measured(measure.kind, points);
    if (!value)
        return {std::nullopt, reasonOf(value.error(), points)};
    Measure known = *value;
    if (measure.kind == MeasureKind::Angle) {
        known.value = geometry::degreesFromRadians(known.value);
        if (known.error)
            known.error = geometry::degreesFromRadians(*known.error);
    }
    return {known, {}};
}

} // namespace unprojector::landmarks
