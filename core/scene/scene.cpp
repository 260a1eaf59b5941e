#include "core/scene/scene.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/drawable.h"
#include "core/geometry/finite.h"
#include "core/scene/reach.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::scene {
using namespace mesh;
using namespace geometry;

Check check(const ViewportRule &rule)
{
    switch (rule.kind) {
    case ViewportRule::Kind::Fixed: return check(rule.fixed);
    case ViewportRule::Kind::KeepAspect:
        if (!std::isfinite(rule.aspect))
            return Error{ErrorCode::NotFinite, rule.aspect};
        if (!(rule.aspect > 0.0))
            return Error{ErrorCode::AspectNotPositive, rule.aspect};
        break;
    case ViewportRule::Kind::WholeWindow:
    case ViewportRule::Kind::Quarter: break;
    }
    return std::monostate{};
}

Viewport viewportIn(const ViewportRule &rule, const Surface &surface)
{
    const Viewport whole = wholeSurface(surface);
    switch (rule.kind) {
    case ViewportRule::Kind::WholeWindow: return whole;
    case ViewportRule::Kind::Fixed: return rule.fixed;
    case ViewportRule::Kind::KeepAspect: {
        const double width = std::max(1.0, std::min(whole.width, std::round(whole.height * rule.aspect)));
        const double height = std::max(1.0, std::min(whole.height, std::round(whole.width / rule.aspect)));
        return {std::floor((whole.width - width) / 2.0), std::floor((whole.height - height) / 2.0), width, height};
    }
    case ViewportRule::Kind::Quarter: {
        // Integer divisions, as in the C code of the tutorial; a window of one pixel keeps one.
        const double width = std::max(1.0, std::floor(whole.width / 2.0));
        const double height = std::max(1.0, std::floor(whole.height / 2.0));
        return {std::floor(whole.width / 2.0), 0.0, width, height};
    }
    }
    return whole;
}

Box boundsOf(const SceneObject &object)
{
    return object.model->bounds.transformed(worldFromObject(object.transform));
}

Box boundsOf(const Scene &scene)
{
    Box bounds;
    for (const SceneObject &object : scene.objects) {
        if (!object.isHidden)
            bounds.add(boundsOf(object));
    }
    return bounds;
}

void add(Framing &framing, const SceneObject &object)
{
    const glm::dmat4 worldFromSource = worldFromObject(object.transform);
    for (const Mesh &mesh : object.model->meshes)
        framing.add(glm::translate(worldFromSource, mesh.origin), mesh.positions, mesh.indices);
}

Check check(const Scene &scene)
{
    if (scene.windowSize) {
        if (const Check valid = check(*scene.windowSize); !valid)
            return valid;
    }
    if (const Result<EyeFrame> frame = eyeFrame(scene.camera); !frame)
        return frame.error();
    for (const Check &valid : {check(*scene.projection), check(scene.viewport), check(scene.depthRange)}) {
        if (!valid)
            return valid;
    }
    for (const SceneObject &object : scene.objects) {
        for (const TransformStep &step : object.transform) {
            if (const Check valid = check(step); !valid)
                return valid;
        }
        if (const Check valid = reachable(object); !valid)
            return valid;
    }
    std::vector<glm::dvec4> planes = scene.clipPlanes;
    for (const ClipPlaneOff &off : scene.clipPlanesOff)
        planes.push_back(off.plane);
    for (const glm::dvec4 &plane : planes) {
        if (const auto value = firstNotFinite(plane))
            return Error{ErrorCode::NotFinite, *value};
        if (plane.x == 0.0 && plane.y == 0.0 && plane.z == 0.0)
            return Error{ErrorCode::ClipPlaneHasNoNormal};
    }
    if (scene.givenPoint) {
        const auto value = std::visit([](const auto &point) { return firstNotFinite(point); }, scene.givenPoint->point);
        if (value)
            return Error{ErrorCode::NotFinite, *value};
    }
    return std::monostate{};
}

Result<Setup> setupOf(const Scene &scene, const Surface &surface, const Box &reach)
{
    if (const Check valid = check(scene); !valid)
        return valid.error();
    if (const Check valid = check(surface); !valid)
        return valid.error();
    Setup setup{surface, viewportIn(scene.viewport, surface), scene.depthRange, *scene.projection, *scene.camera};
    if (scene.projectionFollowsViewport)
        setup.projection() = withAspect(setup.projection(), aspectOf(setup.viewport));
    else if (auto *p = std::get_if<Perspective>(&setup.projection()); p && !hasAspectOf(*p, setup.viewport))
        p->aspect = p->aspect.value; // the number that the panel shows and that a file has
    if (scene.clipDistancesFitObjects)
        setup.projection() = withFittedClipDistances(setup, boundsOf(scene), reach);
    const Result<Drawable> drawn = drawable(setup);
    if (!drawn)
        return drawn.error();
    return drawn->setup;
}

} // namespace unprojector::scene
