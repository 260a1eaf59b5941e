#include "core/maps/uncertainty_row.h"

#include "core/ray/nearest_triangle.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

namespace {

/// The slope as gui's frame computes it: the steeper one of both sides, on the same object.
std::optional<DepthSlope> slopeAt(const SurfaceImage &s, const DevicePixel &pixel)
{
    const std::size_t here = s.indexOf(pixel.i, pixel.j);
    const auto slopeTo = [&](const DevicePixel &before, const DevicePixel &after) {
        std::optional<double> slope;
        for (const DevicePixel &beside : {before, after}) {
            if (beside.i < 0 || beside.i >= s.widthPixels || !s.has(beside.j))
                continue;
            const std::size_t index = s.indexOf(beside.i, beside.j);
            if (!std::isnan(s.depths[index]) && s.objects[index] == s.objects[here])
                slope = std::max(slope.value_or(0.0), std::abs(s.depths[index] - s.depths[here]));
        }
        return slope;
    };
    const std::optional<double> alongX = slopeTo({pixel.i - 1, pixel.j}, {pixel.i + 1, pixel.j});
    const std::optional<double> alongY = slopeTo({pixel.i, pixel.j - 1}, {pixel.i, pixel.j + 1});
    return alongX && alongY ? std::optional(DepthSlope{*alongX, *alongY}) : std::nullopt;
}

} // namespace

UncertaintyRow::UncertaintyRow(const Setup &setup, std::span<const scene::SceneObject> objects,
                               double cornerShiftPixels)
    : m_setup(setup), m_cornerShiftPixels(cornerShiftPixels), m_certainties(setup)
{
    for (const scene::SceneObject &object : objects) {
        std::vector<PreparedMesh> &meshes = m_meshes.emplace_back();
        std::size_t before = 0;
        for (const mesh::Mesh &mesh : object.model->meshes) {
            meshes.push_back(
                {&mesh, before,
                 DepthErrors(setup, glm::translate(geometry::worldFromObject(object.transform), mesh.origin),
                             !mesh.remainders.empty())});
            before += mesh.triangleCount();
        }
    }
}

double UncertaintyRow::at(const SurfaceImage &s, const DevicePixel &pixel, const EyePoint &eye,
                          const WorldPoint &world) const
{
    const std::size_t index = s.indexOf(pixel.i, pixel.j);
    const std::vector<PreparedMesh> &meshes = m_meshes[s.objects[index]];
    const std::size_t number = s.triangles[index];
    const auto after = std::upper_bound(meshes.begin(), meshes.end(), number,
                                        [](std::size_t n, const PreparedMesh &mesh) { return n < mesh.before; });
    const PreparedMesh &own = *(after - 1);
    const DepthSample sample{s.depths[index], s.objects[index], s.format, slopeAt(s, pixel), m_cornerShiftPixels};
    const WindowPoint window = windowFromDevice(m_setup.surface, pixelCenter(pixel), sample.depth);
    const DepthError error = own.errors.at(window, world, sample,
                                           ray::cornersOf(*own.mesh, static_cast<std::uint32_t>(number - own.before)));
    return length(m_certainties.of(eye, world, m_certainties.at(-eye.z, error)).world);
}

} // namespace unprojector::maps
