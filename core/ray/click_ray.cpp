#include "core/ray/click_ray.h"

#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"

#include <glm/common.hpp>

#include <cmath>
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
    : m_unprojector(unprojector), m_wayBack(Error{ErrorCode::SingularMatrix}),
      m_depthAtNear(unprojector.setup().depthRange.atNear), m_depthAtFar(unprojector.setup().depthRange.atFar)
{
    const Setup &setup = unprojector.setup();
    bool hasEye = false, isKnown = true;
    if (const auto *projection = std::get_if<Projection>(&setup.lens)) {
        hasEye = isPerspective(*projection);
    } else {
        const auto &matrix = std::get<MatrixProjection>(setup.lens);
        m_wInFront = wInFront(matrix);
        const auto form = recognised(matrix);
        isKnown = form.hasValue();
        hasEye = isKnown && form->coefficients.perspective;
        if (isKnown && form->reversed)
            std::swap(m_depthAtNear, m_depthAtFar);
    }
    if (const Result<glm::dmat4> matrix = geometry::clipFromWorld(setup))
        m_clipFromWorld = m_wInFront * *matrix;
    const auto *pose = std::get_if<glm::dmat4>(&setup.pose);
    if (!isKnown || (pose && !axesOff(*pose))) {
        m_method = Method::Matrix;
        m_wayBack = WayBack::of(setup);
    }
    if (!isKnown)
        orderDepths();
    if (!isKnown && m_wayBack)
        m_eye = m_wayBack->eye();
    else if (hasEye)
        m_eye = eyeOf(setup);
}

/// Exchanges near and far if the depth range begins at the far end. 1 / w is linear in the depth,
/// so one line of sight decides for all.
void ClickRays::orderDepths()
{
    const Setup &setup = m_unprojector.setup();
    const auto at = [&](double depth) {
        const Viewport &v = setup.viewport;
        return m_wayBack->solution(WindowPoint(v.x + v.width / 2.0, v.y + v.height / 2.0, depth));
    };
    const auto first = m_wayBack ? at(m_depthAtNear) : m_wayBack.error();
    const auto last = m_wayBack ? at(m_depthAtFar) : m_wayBack.error();
    if (!first || !last)
        return;
    const DoubleDouble one = first->point[3], other = last->point[3];
    const bool haveOneSign = one.value * other.value > 0.0;
    double ahead = (one - other).value * (haveOneSign ? one.value : m_wInFront);
    const bool isBox = std::abs((one - other).value) <= first->error.w + last->error.w;
    if (isBox) {
        const Result<WayBack::Bounded> from = m_wayBack->world(*first), to = m_wayBack->world(*last);
        const Result<glm::dmat4> eyeFromWorld = geometry::eyeFromWorld(setup);
        if (!from || !to || !eyeFromWorld)
            return;
        ahead = -(*eyeFromWorld * glm::dvec4((to->point - from->point).coordinates(), 0.0)).z;
    }
    if (ahead < 0.0)
        std::swap(m_depthAtNear, m_depthAtFar);
}

Result<ClickRays::End> ClickRays::endAt(const DevicePoint &position, double depth) const
{
    const WindowPoint window = windowFromDevice(setup().surface, position, depth);
    if (m_method == Method::Formula) {
        const Result<WorldPoint> point = m_unprojector.worldAt(m_method, window);
        return point ? Result<End>(End{*point}) : point.error();
    }
    if (!m_wayBack)
        return m_wayBack.error();
    const Result<WayBack::Solution> solution = m_wayBack->solution(window);
    if (!solution)
        return solution.error();
    const Result<WayBack::Bounded> world = m_wayBack->world(*solution);
    return world ? Result<End>(End{world->point, world->error, solution->point[3].value}) : world.error();
}

Result<Ray<WorldSpace>> ClickRays::at(const DevicePoint &position) const
{
    const Result<End> from = endAt(position, m_depthAtNear);
    if (!from)
        return from.error();
    Ray<WorldSpace> ray{from->point, {}, 0.0, 1.0};
    Result<End> to = endAt(position, m_depthAtFar);
    constexpr double kLeastShare = 0x1p-60;
    const auto isBehindInfinity = [&] { return !to || (to->inverseW < 0.0) != (from->inverseW < 0.0); };
    for (double share = 0.5; isBehindInfinity() && share > kLeastShare; share /= 2.0) {
        to = endAt(position, m_depthAtNear * (1.0 - share) + m_depthAtFar * share);
        ray.high = std::numeric_limits<double>::infinity();
    }
    if (!to)
        return to.error();
    ray.along = to->point - from->point;
    ray.error = WorldVector(glm::max(from->error.coordinates(), to->error.coordinates()));
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
