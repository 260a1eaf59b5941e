#pragma once

#include "tests/support/oracle.h"

#include <cstdint>
#include <random>

/// Random cameras that are the same on every platform. std::mt19937_64 is, but the standard
/// library's distributions are not, so these are our own and use no function of libm.
namespace oracle {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    double unit(); ///< [0, 1), a multiple of 2^-53
    double uniform(double low, double high);
    int integer(int low, int high); ///< both ends included
    bool chance(double probability) { return unit() < probability; }
    double logUniform(double low, double high); ///< 0 < low < high; the binary exponent is uniform
    double sign() { return chance(0.5) ? 1.0 : -1.0; }

private:
    std::mt19937_64 m_engine;
};

/// The limits of a random scene. The defaults are the widest: near : far up to 0.01 : 10^6, eyes up
/// to 10^6 away.
struct SceneLimits {
    double nearLow = 0.01, farHigh = 1e6;
    bool fixedClipDistances = false; ///< near and far are exactly nearLow and farHigh
    double eyeHigh = 1e6;
    double leastUpSine = 0.0;     ///< sine between up and the view direction
    double largestTangent = 20.0; ///< of a frustum's edges: 2.9 degrees short of a right angle
    bool plainTarget = false;     ///< viewport at the origin, depth range [0, 1]
};

/// Everyday scenes: the eye within the far distance of the origin, edges within 63 degrees (a
/// frustum's), up at least 6 degrees off the view, the viewport the window.
SceneLimits everydayScenes(double nearDistance, double farDistance);

struct Scene {
    View view;
    Projection projection;
    Target target;
};

Scene randomScene(Random &random, RandomKind kind, const SceneLimits &limits);

/// A pixel's centre inside the viewport, or (one in four) any position in it; a depth in the
/// target's range: either end, near either end, or anywhere.
std::array<double, 3> randomClick(Random &random, const Target &target);

} // namespace oracle
