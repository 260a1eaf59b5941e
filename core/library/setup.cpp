#include "unprojector/setup.h"

#include "core/geometry/setup.h"
#include "core/library/internal.h"

#include <utility>

namespace unprojector {
namespace {

/// Calls a function by the type of a variant's value.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

geometry::Projection internalProjection(const Projection &projection, const geometry::Viewport &viewport)
{
    return std::visit(
        Overloaded{[&](const Perspective &p) -> geometry::Projection {
                       return geometry::Perspective{geometry::radiansFromDegrees(p.verticalFovDegrees),
                                                    p.aspect.value_or(viewport.width / viewport.height), p.nearDistance,
                                                    p.farDistance};
                   },
                   [](const Frustum &f) -> geometry::Projection {
                       return geometry::Frustum{f.left, f.right, f.bottom, f.top, f.nearDistance, f.farDistance};
                   },
                   [](const Ortho &o) -> geometry::Projection {
                       return geometry::Ortho{o.left, o.right, o.bottom, o.top, o.nearDistance, o.farDistance};
                   }},
        projection);
}

} // namespace

Result<Setup> Setup::of(const Projection &projection, const Camera &camera, const Window &window)
{
    geometry::Setup setup;
    setup.surface = {window.width, window.height, 1.0};
    setup.viewport = geometry::wholeSurface(setup.surface);
    if (window.viewport)
        setup.viewport = {window.viewport->x, window.viewport->y, window.viewport->width, window.viewport->height};
    setup.depthRange = {window.depthRange.atNear, window.depthRange.atFar};
    setup.lens = internalProjection(projection, setup.viewport);
    setup.pose = geometry::LookAt{geometry::WorldPoint(camera.eye), geometry::WorldPoint(camera.center),
                                  geometry::WorldVector(camera.up)};
    if (const geometry::Check valid = check(setup); !valid)
        return valueError(valid.error());
    return Setup(std::make_shared<const geometry::Setup>(setup));
}

int Setup::width() const
{
    return m_setup->surface.widthPixels;
}

int Setup::height() const
{
    return m_setup->surface.heightPixels;
}

} // namespace unprojector
