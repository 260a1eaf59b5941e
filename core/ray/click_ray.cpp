#include "core/ray/click_ray.h"

#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"

#include <limits>
#include <utility>
#include <variant>

namespace unprojector::ray {
using namespace geometry;
using namespace unproject;

namespace {

std::optional<WorldPoint> eyeOf(const Setup &setup)
{
    if (const auto *camera = std::get_if<LookAt>(&setup.pose))
        return camera->eye;
    const Result<PreciseAxes> axes = preciseAxes(std::get<glm::dmat4>(setup.pose));
    if (!axes)
        return std::nullopt;
    return WorldPoint(axes->origin[0].value, axes->origin[1].value, axes->origin[2].value);
}

} // namespace

ClickRays::ClickRays(const Unprojector &unprojector)
    : m_unprojector(unprojector), m_depthAtNear(unprojector.setup().depthRange.atNear),
      m_depthAtFar(unprojector.setup().depthRange.atFar)
{
    const Setup &setup = unprojector.setup();
    bool hasEye = false;
    if (const auto *projection = std::get_if<Projection>(&setup.lens)) {
        hasEye = isPerspective(*projection);
    } else if (const auto form = recognised(std::get<MatrixProjection>(setup.lens))) {
        hasEye = form->coefficients.perspective;
        if (form->reversed)
            std::swap(m_depthAtNear, m_depthAtFar);
    } else {
        m_method = Method::Matrix;
    }
    if (const auto *pose = std::get_if<glm::dmat4>(&setup.pose); pose && !axesOff(*pose))
        m_method = Method::Matrix;
    if (hasEye)
        m_eye = eyeOf(setup);
}

Result<Ray<WorldSpace>> ClickRays::at(const DevicePoint &position) const
{
    const auto pointAt = [&](double depth) {
        return m_unprojector.worldAt(m_method, windowFromDevice(setup().surface, position, depth));
    };
    const Result<WorldPoint> from = pointAt(m_depthAtNear);
    if (!from)
        return from.error();
    Ray<WorldSpace> ray{*from, {}, 0.0, 1.0};
    Result<WorldPoint> to = pointAt(m_depthAtFar);
    if (!to) { // at infinity
        to = pointAt(m_depthAtNear / 2.0 + m_depthAtFar / 2.0);
        ray.high = std::numeric_limits<double>::infinity();
    }
    if (!to)
        return to.error();
    ray.along = *to - *from;
    return ray;
}

bool ClickRays::isInPicture(const DevicePoint &position) const
{
    const Viewport &viewport = setup().viewport;
    const Surface &surface = setup().surface;
    const WindowPoint window = windowFromDevice(surface, position, 0.0);
    const auto isWithin = [](double x, double low, double high) { return x >= low && x <= high; };
    return isWithin(window.x, viewport.x, viewport.x + viewport.width)
           && isWithin(window.y, viewport.y, viewport.y + viewport.height)
           && isWithin(position.x, 0.0, double(surface.widthPixels))
           && isWithin(position.y, 0.0, double(surface.heightPixels));
}

} // namespace unprojector::ray
