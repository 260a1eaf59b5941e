#pragma once

#include "core/scene_file/scene_file.h"

#include <QString>
#include <QTest>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

/// Core's results for the scenes whose code is compiled.
namespace core_clicks {

inline unprojector::scene_file::SceneFile sceneNamed(const char *name)
{
    const std::string file = std::string(UNPROJECTOR_SCENES "/") + name + ".json";
    auto scene = unprojector::scene_file::readSceneFile(std::filesystem::path(file));
    if (!scene)
        qFatal("%s cannot be read", file.c_str());
    return std::move(scene).value();
}

struct Click {
    int i, j;
    double depth;
    glm::dvec3 world;
};

/// A hundred pixels of the viewport with random depths of the depth range, the same in each run.
/// The formulas unproject them, or the inverted matrix if it has no known form.
inline std::vector<Click> hundredClicks(const unprojector::scene_file::SceneFile &scene)
{
    const unprojector::geometry::Setup setup = setupOf(scene);
    const auto unprojector = unprojector::unproject::Unprojector::of(setup);
    if (!unprojector)
        qFatal("no picture");
    std::mt19937 engine(7);
    const auto share = [&engine] { return double(engine()) / 4294967296.0; };
    std::vector<Click> clicks;
    while (clicks.size() < 100) {
        const unprojector::geometry::Viewport &v = setup.viewport;
        const unprojector::geometry::DevicePoint at = deviceFromWindow(
            setup.surface, unprojector::geometry::WindowPoint(v.x + share() * v.width, v.y + share() * v.height, 0.0));
        const unprojector::geometry::DevicePixel pixel{int(std::floor(at.x)), int(std::floor(at.y))};
        const double depth = setup.depthRange.atNear + share() * (setup.depthRange.atFar - setup.depthRange.atNear);
        const unprojector::geometry::WindowPoint window =
            windowFromDevice(setup.surface, unprojector::geometry::pixelCenter(pixel), depth);
        auto world = unprojector->worldAt(unprojector::unproject::Method::Formula, window);
        if (!world)
            world = unprojector->worldAt(unprojector::unproject::Method::Matrix, window);
        if (!world)
            qFatal("no point");
        clicks.push_back({pixel.i, pixel.j, depth, glm::dvec3(world->x, world->y, world->z)});
    }
    return clicks;
}

/// Verifies that every number of a matrix is off by at most this share of its largest.
inline void compareMatrices(const glm::dmat4 &found, const glm::dmat4 &expected, double share)
{
    double largest = 0.0, off = 0.0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            largest = std::max(largest, std::abs(expected[column][row]));
            off = std::max(off, std::abs(found[column][row] - expected[column][row]));
        }
    }
    QVERIFY2(off <= share * largest, qPrintable(QStringLiteral("off by %1 of %2").arg(off).arg(largest)));
}

using Screen2World = std::function<glm::dvec3(int, int, double)>;

/// Verifies that a hundred clicks equal core's. Every mistake moves points by half a pixel or more:
/// the tolerance must be far less. @param share  of a point's size and its distance
inline void compareClicks(const unprojector::scene_file::SceneFile &scene, const Screen2World &screen2world,
                          double share)
{
    for (const Click &click : hundredClicks(scene)) {
        const glm::dvec3 found = screen2world(click.i, click.j, click.depth);
        const double tolerance = share * (10.0 + glm::length(click.world));
        const double pixel = glm::distance(screen2world(click.i + 1, click.j, click.depth), found);
        QVERIFY2(tolerance < 0.25 * pixel,
                 qPrintable(QStringLiteral("%1 is no less than a quarter of the pixel, %2").arg(tolerance).arg(pixel)));
        QVERIFY2(glm::distance(found, click.world) <= tolerance,
                 qPrintable(QStringLiteral("pixel %1 %2, depth %3: off by %4")
                                .arg(click.i)
                                .arg(click.j)
                                .arg(click.depth)
                                .arg(glm::distance(found, click.world))));
    }
}

} // namespace core_clicks
