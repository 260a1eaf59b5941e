#pragma once

#include "core/ray/scene_rays.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

/// Steps of the surface's distance inside a pixel by brute force: a grid of rays, and bisection
/// between neighbours with different distances until a slope would have vanished. It knows rays,
/// but neither triangles nor edges.
class DensePixel {
public:
    using Rays = unprojector::ray::SceneRays;
    using Place = glm::dvec2; ///< device pixels

    explicit DensePixel(const Rays &rays) : m_rays(rays) {}

    /// The largest step in a square, in widths of a pixel at that distance; infinity against the
    /// background.
    double largestStep(const Place &middle, double half, int perSide) const
    {
        std::vector<double> row(static_cast<std::size_t>(perSide) + 1), above;
        double most = 0.0;
        for (int j = 0; j <= perSide; ++j) {
            above = row;
            for (int i = 0; i <= perSide; ++i) {
                const auto k = static_cast<std::size_t>(i);
                const Place here = middle + half * (2.0 * glm::dvec2(i, j) / double(perSide) - 1.0);
                row[k] = distanceAt(here);
                const double one = 2.0 * half / perSide;
                if (i > 0)
                    most = std::max(most, stepBetween(here - Place(one, 0.0), row[k - 1], here, row[k]));
                if (j > 0)
                    most = std::max(most, stepBetween(here - Place(0.0, one), above[k], here, row[k]));
                if (std::isinf(most))
                    return most;
            }
        }
        return most;
    }

    /// The distance along the ray in widths of a pixel there; infinity on the background.
    double distanceAt(const Place &place) const
    {
        const auto ray = m_rays.rays().at(unprojector::geometry::DevicePoint(place.x, place.y));
        const std::optional<unprojector::ray::FirstTriangle> first = m_rays.firstTriangle(*ray);
        return first ? first->hit.t * length(ray->along) / m_pixel : std::numeric_limits<double>::infinity();
    }

    /// Sets the width of a pixel, world units.
    void setPixel(double width) { m_pixel = width; }

private:
    double stepBetween(Place a, double atA, Place b, double atB) const
    {
        constexpr double kLeast = 0.25; // of a pixel's width
        const auto step = [](double one, double other) { return one == other ? 0.0 : std::abs(one - other); };
        for (int i = 0; i < 24 && step(atA, atB) > kLeast; ++i) {
            const Place middle = (a + b) / 2.0;
            const double at = distanceAt(middle);
            if (step(atA, at) >= step(at, atB)) {
                b = middle;
                atB = at;
            } else {
                a = middle;
                atA = at;
            }
        }
        return step(atA, atB) > kLeast ? step(atA, atB) : 0.0;
    }

    const Rays &m_rays;
    double m_pixel = 1.0;
};
