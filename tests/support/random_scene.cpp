#include "tests/support/random_scene.h"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

using Triple = std::array<double, 3>;

/// A direction: uniform in the unit ball by rejection, not normalised (gluLookAt does that itself).
Triple randomDirection(Random &random)
{
    for (;;) {
        const Triple v{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
        const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (square <= 1.0 && square > 0.01)
            return v;
    }
}

double sineBetween(const Triple &a, const Triple &b)
{
    const Triple c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return std::hypot(c[0], c[1], c[2]) / (std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]));
}

View randomView(Random &random, const SceneLimits &limits)
{
    View view;
    const double scale = random.logUniform(1e-3, limits.eyeHigh);
    for (double &coordinate : view.eye)
        coordinate = random.uniform(-scale, scale);
    const Triple direction = randomDirection(random);
    const double distance = random.logUniform(1e-2, limits.eyeHigh);
    for (std::size_t k = 0; k < 3; ++k)
        view.center[k] = view.eye[k] + distance * direction[k];
    do {
        view.up = random.chance(0.5) ? Triple{0.0, 1.0, 0.0} : randomDirection(random);
        if (sineBetween(direction, view.up) < limits.leastUpSine)
            view.up = randomDirection(random);
    } while (!(sineBetween(direction, view.up) > std::max(limits.leastUpSine, 1e-6)));
    return view;
}

/// Two edges: symmetric, off-centre, or wholly on one side, and mirrored one time in four.
std::array<double, 2> randomEdges(Random &random, double extent)
{
    std::array<double, 2> edges{};
    do {
        const double a = random.uniform(0.01, 1.0) * extent;
        edges = random.chance(0.5) ? std::array<double, 2>{-a, a}
                                   : std::array<double, 2>{random.uniform(-extent, extent), a};
    } while (std::abs(edges[1] - edges[0]) < 0.01 * extent);
    if (random.chance(0.25) == (edges[0] < edges[1]))
        std::swap(edges[0], edges[1]);
    return edges;
}

Projection randomProjection(Random &random, RandomKind kind, const SceneLimits &limits)
{
    const bool perspective = kind == RandomKind::Frustum || kind == RandomKind::Perspective;
    Projection p;
    p.kind = kind;
    p.nearDistance = limits.nearLow;
    p.farDistance = limits.farHigh;
    while (!limits.fixedClipDistances) {
        p.nearDistance = random.logUniform(limits.nearLow, limits.farHigh);
        p.farDistance = random.logUniform(limits.nearLow, limits.farHigh);
        if (p.nearDistance > p.farDistance)
            std::swap(p.nearDistance, p.farDistance);
        if (p.farDistance > 1.01 * p.nearDistance)
            break;
    }
    if (!perspective && !limits.fixedClipDistances && random.chance(0.25))
        p.nearDistance = -p.nearDistance;
    const double extent =
        perspective ? p.nearDistance * random.logUniform(0.01, limits.largestTangent) : random.logUniform(1e-2, 1e5);
    const auto horizontal = randomEdges(random, extent);
    const auto vertical = randomEdges(random, extent);
    p.left = horizontal[0];
    p.right = horizontal[1];
    p.bottom = vertical[0];
    p.top = vertical[1];
    p.verticalFovRadians = random.uniform(0.01, 2.8);
    p.aspect = random.uniform(0.25, 4.0);
    p.thetaRadians = random.uniform(0.2, 2.9);
    p.phiRadians = random.uniform(0.2, 2.9);
    return p;
}

Target randomTarget(Random &random, const SceneLimits &limits)
{
    Target t;
    t.width = random.integer(1, 4096);
    t.height = random.integer(1, 4096);
    if (limits.plainTarget)
        return t;
    if (random.chance(0.5)) {
        t.x = random.integer(-500, 500);
        t.y = random.integer(-500, 500);
    }
    const double dice = random.unit();
    if (dice < 0.2) {
        t.depthAtNear = 1.0;
        t.depthAtFar = 0.0;
    } else if (dice < 0.5) {
        do {
            t.depthAtNear = random.unit();
            t.depthAtFar = random.unit();
        } while (std::abs(t.depthAtFar - t.depthAtNear) < 0.01);
    }
    return t;
}

} // namespace

double Random::unit()
{
    return std::ldexp(static_cast<double>(m_engine() >> 11), -53);
}

double Random::uniform(double low, double high)
{
    return low + (high - low) * unit();
}

int Random::integer(int low, int high)
{
    return low + static_cast<int>(std::floor(unit() * (high - low + 1)));
}

double Random::logUniform(double low, double high)
{
    const int lowExponent = std::ilogb(low), highExponent = std::ilogb(high);
    for (;;) {
        const double mantissa = 1.0 + unit(); // not inside the call, where the evaluation order is unspecified
        const double value = std::ldexp(mantissa, integer(lowExponent, highExponent));
        if (value >= low && value <= high)
            return value;
    }
}

SceneLimits everydayScenes(double nearDistance, double farDistance)
{
    SceneLimits limits;
    limits.fixedClipDistances = true;
    limits.nearLow = nearDistance;
    limits.farHigh = farDistance;
    limits.eyeHigh = farDistance;
    limits.leastUpSine = 0.1;
    limits.largestTangent = 2.0;
    limits.plainTarget = true;
    return limits;
}

Scene randomScene(Random &random, RandomKind kind, const SceneLimits &limits)
{
    Scene scene;
    scene.view = randomView(random, limits);
    scene.projection = randomProjection(random, kind, limits);
    scene.target = randomTarget(random, limits);
    return scene;
}

std::array<double, 3> randomClick(Random &random, const Target &t)
{
    const auto along = [&](double start, double size) {
        return random.chance(0.75) ? start + random.integer(0, static_cast<int>(size) - 1) + 0.5
                                   : start + size * random.unit();
    };
    const double x = along(t.x, t.width);
    const double y = along(t.y, t.height);
    const double low = std::min(t.depthAtNear, t.depthAtFar), high = std::max(t.depthAtNear, t.depthAtFar);
    const double dice = random.unit();
    double depth = random.uniform(low, high);
    if (dice < 0.1)
        depth = low;
    else if (dice < 0.2)
        depth = high;
    else if (dice < 0.4)
        depth = low + (high - low) * random.logUniform(1e-12, 0.5);
    else if (dice < 0.6)
        depth = high - (high - low) * random.logUniform(1e-12, 0.5);
    return {x, y, std::clamp(depth, low, high)};
}

} // namespace oracle
