#include "gui/document/document_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

/// Relative to a length: the error of a few roundings, and far less than a manual move.
constexpr double kRounding = 1e-12;

/// Returns whether the settings differ in nothing but camera and projection.
bool differOnlyInLook(const SceneSettings &a, const SceneSettings &b)
{
    SceneSettings same = b;
    same.camera = a.camera;
    same.projection = a.projection;
    return !changesBetween(a, same);
}

bool isNearlySame(const LookAt &a, const LookAt &b)
{
    // Far from the origin a coordinate itself is only as exact as its last digits.
    const double size = std::max(distance(a.eye, WorldPoint()), distance(a.center, WorldPoint()));
    const double tolerance =
        kRounding * distance(a.center, a.eye) + 8.0 * std::numeric_limits<double>::epsilon() * size;
    return distance(b.eye, a.eye) <= tolerance && distance(b.center, a.center) <= tolerance
           && length(b.up - a.up) <= kRounding * length(a.up);
}

bool isNearlySame(const Projection &a, const Projection &b)
{
    if (kindOf(a) != kindOf(b))
        return false;
    if (const auto *sheared = std::get_if<Oblique>(&a)) {
        const auto &other = std::get<Oblique>(b);
        if (sheared->theta != other.theta || sheared->phi != other.phi)
            return false;
    }
    const ProjectionWindow v = projectionWindow(a), w = projectionWindow(b);
    if (v.skew != w.skew)
        return false;
    const auto isNear = [](double x, double y, double size) { return std::abs(x - y) <= kRounding * size; };
    const double width = std::abs(v.left) + std::abs(v.right), height = std::abs(v.bottom) + std::abs(v.top);
    const double depth = isPerspective(a) ? v.nearDistance : std::abs(v.nearDistance) + std::abs(v.farDistance);
    return isNear(v.left, w.left, width) && isNear(v.right, w.right, width) && isNear(v.bottom, w.bottom, height)
           && isNear(v.top, w.top, height) && isNear(v.nearDistance, w.nearDistance, depth)
           && isNear(v.farDistance, w.farDistance, std::abs(v.farDistance));
}

/// Returns whether exactly one object has another name. If more have, objects of one model may have
/// swapped places.
bool isRenaming(const std::vector<SceneObject> &a, const std::vector<SceneObject> &b)
{
    if (a.size() != b.size())
        return false;
    int renamed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].model != b[i].model || a[i].file != b[i].file)
            return false;
        renamed += a[i].name == b[i].name ? 0 : 1;
    }
    return renamed == 1;
}

} // namespace

bool isSameObject(const SceneObject &a, const SceneObject &b)
{
    return a.model == b.model && a.name == b.name && a.file == b.file;
}

Changes changesBetween(const SceneSettings &a, const SceneSettings &b)
{
    Changes changes;
    if (a.clipPlanes != b.clipPlanes || a.clipPlanesOff != b.clipPlanesOff)
        changes |= Change::ClipPlanes;
    if (a.windowSize != b.windowSize || a.camera != b.camera || a.home != b.home || a.projection != b.projection
        || a.projectionFollowsViewport != b.projectionFollowsViewport
        || a.clipDistancesFitObjects != b.clipDistancesFitObjects || a.viewport != b.viewport
        || a.depthRange != b.depthRange)
        changes |= Change::Setup;
    if (a.givenPoint != b.givenPoint)
        changes |= Change::GivenPoint;
    if (a.conventions != b.conventions)
        changes |= Change::Conventions;
    return changes;
}

std::optional<std::size_t> indexAfter(const std::vector<SceneObject> &before, std::size_t index,
                                      const std::vector<SceneObject> &after)
{
    const SceneObject &object = before[index];
    const auto isIt = [&object](const SceneObject &other) {
        return isSameObject(object, other) && object.transform == other.transform;
    };
    // Among several identical objects, the one at the same index.
    if (index < after.size() && isIt(after[index]))
        return index;
    if (const auto found = std::find_if(after.begin(), after.end(), isIt); found != after.end())
        return static_cast<std::size_t>(found - after.begin());
    return isRenaming(before, after) ? std::optional(index) : std::nullopt;
}

Changes changesBetween(const std::vector<SceneObject> &a, const std::vector<SceneObject> &b)
{
    Changes changes;
    if (isRenaming(a, b))
        changes |= Change::Names;
    else if (!std::equal(a.begin(), a.end(), b.begin(), b.end(), isSameObject))
        return Change::Objects | Change::Placement | Change::Visibility;
    const auto differ = [&a, &b](auto SceneObject::*member) {
        return !std::equal(a.begin(), a.end(), b.begin(), b.end(),
                           [member](const SceneObject &x, const SceneObject &y) { return x.*member == y.*member; });
    };
    if (differ(&SceneObject::transform))
        changes |= Change::Placement;
    if (differ(&SceneObject::isHidden))
        changes |= Change::Visibility;
    return changes;
}

bool isSameLook(const SceneSettings &a, const SceneSettings &b)
{
    return differOnlyInLook(a, b) && isNearlySame(*a.camera, *b.camera) && isNearlySame(*a.projection, *b.projection);
}

} // namespace unprojector::gui
