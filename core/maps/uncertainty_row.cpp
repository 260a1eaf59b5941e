#include "core/maps/uncertainty_row.h"

#include "core/ray/nearest_triangle.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::maps {

UncertaintyRow::UncertaintyRow(const Picture &picture, const SurfaceImage &surfaces,
                               std::span<const ray::SceneObject> objects, double cornerShiftPixels)
    : m_picture(picture), m_surfaces(&surfaces), m_cornerShiftPixels(cornerShiftPixels), m_certainties(picture)
{
    for (const ray::SceneObject &object : objects) {
        std::vector<PreparedMesh> &meshes = m_meshes.emplace_back();
        std::size_t before = 0;
        for (const ray::Mesh &mesh : object.model->meshes) {
            meshes.push_back(
                {&mesh, before,
                 DepthErrors(picture, glm::translate(scene::worldFromObject(object.transform), mesh.origin),
                             !mesh.remainders.empty())});
            before += mesh.triangleCount();
        }
    }
}

/// As gui's frame reads it: the steeper of both sides, of the same object.
std::optional<DepthSlope> UncertaintyRow::slopeAt(const DevicePixel &pixel) const
{
    const SurfaceImage &s = *m_surfaces;
    const std::size_t here = s.place(pixel.i, pixel.j);
    const auto slopeTo = [&](bool isBefore, bool isAfter, std::size_t step) {
        std::optional<double> slope;
        const auto add = [&](std::size_t place) {
            if (!std::isnan(s.depths[place]) && s.objects[place] == s.objects[here])
                slope = std::max(slope.value_or(0.0), std::abs(s.depths[place] - s.depths[here]));
        };
        if (isBefore)
            add(here - step);
        if (isAfter)
            add(here + step);
        return slope;
    };
    const std::optional<double> alongX = slopeTo(pixel.i > 0, pixel.i + 1 < s.widthPixels, 1);
    const std::optional<double> alongY =
        slopeTo(pixel.j > 0, pixel.j + 1 < s.heightPixels, static_cast<std::size_t>(s.widthPixels));
    return alongX && alongY ? std::optional(DepthSlope{*alongX, *alongY}) : std::nullopt;
}

double UncertaintyRow::at(const DevicePixel &pixel, const EyePoint &eye, const WorldPoint &world) const
{
    const SurfaceImage &s = *m_surfaces;
    const std::size_t place = s.place(pixel.i, pixel.j);
    const std::vector<PreparedMesh> &meshes = m_meshes[s.objects[place]];
    const std::size_t number = s.triangles[place];
    const auto after = std::upper_bound(meshes.begin(), meshes.end(), number,
                                        [](std::size_t n, const PreparedMesh &mesh) { return n < mesh.before; });
    const PreparedMesh &own = *(after - 1);
    const DepthSample sample{s.depths[place], s.objects[place], s.format, slopeAt(pixel), m_cornerShiftPixels};
    const WindowPoint window = windowFromDevice(m_picture.surface, pixelCenter(pixel), sample.depth);
    const DepthError error = own.errors.at(window, world, sample,
                                           ray::cornersOf(*own.mesh, static_cast<std::uint32_t>(number - own.before)));
    return length(m_certainties.of(eye, world, m_certainties.at(-eye.z, error)).world);
}

} // namespace unprojector::maps
