#pragma once

#include "core/geometry/framing.h"
#include "core/geometry/proportions.h"
#include "core/ray/pixel_edge.h"
#include "core/unproject/unprojector.h"
#include "tests/support/dense_pixel.h"

#include <chrono>
#include <memory>
#include <random>

/// How often edges in pixels are found, by DensePixel's judgement.
struct EdgeRates {
    int withEdge = 0, found = 0;     ///< pixels with a step of more than 1.5 widths of a pixel
    int plain = 0, wronglyFound = 0; ///< pixels without a step of 0.5 within two pixels around
    int wrongDistance = 0;           ///< of the found ones: no ray of the pixel hits anything at the told distance
    double seconds = 0.0;            ///< of the search, all pixels
    int searched = 0;
};

/// Measures random pixels on a model, seen from random sides: half of them beside an outline.
inline EdgeRates edgeRates(const std::shared_ptr<const unprojector::mesh::Model> &model, int views, int pixelsPerView,
                           std::uint64_t seed, int perSide = 64)
{
    EdgeRates rates;
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    const auto caster = unprojector::ray::RayCaster::build(model, {});
    const std::vector<unprojector::scene::SceneObject> objects{{"model", {}, model, {}}};
    const unprojector::geometry::Surface surface{800, 600, 1.0};
    const glm::dvec3 center = model->bounds.center();
    const double size = model->bounds.diagonal();
    for (int view = 0; view < views; ++view) {
        const glm::dvec3 side = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        const glm::dvec3 up = std::abs(side.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const glm::dvec3 eye = center + 1.2 * size * side;
        const unprojector::geometry::Projection projection =
            view % 3 == 2 ? unprojector::geometry::Projection(
                unprojector::geometry::Ortho{-0.6 * size, 0.6 * size, -0.45 * size, 0.45 * size, 0.1 * size, 3 * size})
                          : unprojector::geometry::Projection(unprojector::geometry::Perspective{
                              unprojector::geometry::radiansFromDegrees(40.0), 4.0 / 3.0, 0.1 * size, 3 * size});
        const unprojector::geometry::Setup setup{
            surface,
            unprojector::geometry::wholeSurface(surface),
            {},
            projection,
            unprojector::geometry::LookAt{unprojector::geometry::WorldPoint(eye),
                                          unprojector::geometry::WorldPoint(center),
                                          unprojector::geometry::WorldVector(up)}};
        const unprojector::ray::SceneRays rays(*unprojector::unproject::Unprojector::of(setup), objects, {{caster}},
                                               {});
        DensePixel dense(rays);
        dense.setPixel(unprojector::geometry::pixelFootprint(setup, 1.2 * size).x);
        int besideEdges = 0, anywhere = 0;
        for (int tries = 0; tries < 200'000 && besideEdges + anywhere < 2 * pixelsPerView; ++tries) {
            const glm::dvec2 at(double(engine() % 796) + 2.5, double(engine() % 596) + 2.5);
            const double here = dense.distanceAt(at), beside = dense.distanceAt(at + glm::dvec2(1.0, 0.0));
            if (std::isinf(here))
                continue;
            const bool isBeside = std::isinf(beside) || std::abs(beside - here) > 4.0;
            int &count = isBeside ? besideEdges : anywhere;
            if (count >= pixelsPerView)
                continue;
            ++count;
            const unprojector::geometry::DevicePoint position(at.x, at.y);
            const std::optional<unprojector::ray::SceneHit> hit = *rays.at(position);
            const auto start = std::chrono::steady_clock::now();
            const std::optional<unprojector::ray::PixelEdge> edge = unprojector::ray::edgeInPixel(rays, position, hit);
            rates.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            ++rates.searched;
            const double step = dense.largestStep(at, 0.5, perSide);
            if (step > 1.5) {
                ++rates.withEdge;
                rates.found += edge ? 1 : 0;
            } else if (dense.largestStep(at, 2.5, perSide) < 0.5) {
                ++rates.plain;
                rates.wronglyFound += edge ? 1 : 0;
            }
            if (edge && edge->object) {
                const double told = here + edge->behind / unprojector::geometry::pixelFootprint(setup, 1.2 * size).x;
                bool isThere = false;
                for (int j = 0; j <= perSide && !isThere; ++j) {
                    for (int i = 0; i <= perSide && !isThere; ++i)
                        isThere =
                            std::abs(dense.distanceAt(at - 0.5 + glm::dvec2(i, j) / double(perSide)) - told) < 2.0;
                }
                rates.wrongDistance += isThere ? 0 : 1;
            }
        }
    }
    return rates;
}
