#include "core/maps/surface_image.h"

#include "core/maps/rows_in_parallel.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The window depth of world points, by the matrix.
auto windowDepths(const Setup &setup)
{
    const glm::dmat4 rows = glm::transpose(clipFromWorld(setup).value());
    const bool isZeroToOne = ndcDepthOf(setup) == NdcDepth::ZeroToOne;
    return [z = rows[2], w = rows[3], range = setup.depthRange, isZeroToOne](const WorldPoint &point) {
        const glm::dvec4 place(point.coordinates(), 1.0);
        const double ndc = glm::dot(z, place) / glm::dot(w, place);
        const double share = isZeroToOne ? ndc : (ndc + 1.0) / 2.0;
        return range.atNear + share * (range.atFar - range.atNear);
    };
}

SurfaceImage emptyImage(const Setup &setup, const Rows &rows)
{
    SurfaceImage image{setup.surface.widthPixels, setup.surface.heightPixels, {}, {}, {}, {}, {}, {}};
    image.rowPlaces.assign(static_cast<std::size_t>(image.heightPixels), -1);
    int index = 0;
    for (const int row : rows)
        image.rowPlaces[static_cast<std::size_t>(row)] = index++;
    image.depths.assign(rows.size() * static_cast<std::size_t>(image.widthPixels), kNone);
    return image;
}

/// True if the centre of a pixel lies in the viewport.
bool isInViewport(const Setup &setup, const DevicePixel &pixel)
{
    const Viewport &v = setup.viewport;
    const WindowPoint center = windowFromDevice(setup.surface, pixelCenter(pixel), 0.0);
    return center.x >= v.x && center.x <= v.x + v.width && center.y >= v.y && center.y <= v.y + v.height;
}

} // namespace

Rows allRows(const Setup &setup)
{
    Rows rows(static_cast<std::size_t>(setup.surface.heightPixels));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels, const DepthFormat &format,
                                        const Rows &rowsMet, const ray::Progress &progress)
{
    const Setup &setup = rays.rays().setup();
    const auto depthOf = windowDepths(setup);
    const double low = std::min(setup.depthRange.atNear, setup.depthRange.atFar);
    const double high = std::max(setup.depthRange.atNear, setup.depthRange.atFar);
    SurfaceImage image = emptyImage(setup, rowsMet);
    image.format = format;
    image.ts.assign(image.depths.size(), kNone);
    image.objects.assign(image.depths.size(), 0);
    image.triangles.assign(image.depths.size(), 0);
    const bool isWhole = rowsInParallel(rowsMet, image.widthPixels, progress, [&](std::span<const int> some) {
        for (const int j : some) {
            const std::vector<ray::Ray<WorldSpace>> row = pixels.ofRow(j);
            for (int i = 0; i < image.widthPixels; ++i) {
                if (!isInViewport(setup, {i, j}))
                    continue;
                const ray::Ray<WorldSpace> &ray = row[static_cast<std::size_t>(i)];
                const std::optional<ray::FirstTriangle> met = rays.firstTriangle(ray);
                if (!met)
                    continue;
                const std::size_t index = image.indexOf(i, j);
                // Rounding to whole steps can leave the range, where no surface is drawn.
                image.depths[index] = std::clamp(format.kept(depthOf(ray.at(met->hit.t))), low, high);
                image.ts[index] = met->hit.t;
                image.objects[index] = static_cast<std::uint32_t>(met->object);
                image.triangles[index] = met->hit.triangle;
            }
        }
    });
    return isWhole ? std::optional(std::move(image)) : std::nullopt;
}

std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels, const DepthFormat &format,
                                        const ray::Progress &progress)
{
    return surfacesMet(rays, pixels, format, allRows(rays.rays().setup()), progress);
}

SurfaceImage surfacesAt(const Setup &setup, double depth, const Rows &rows)
{
    SurfaceImage image = emptyImage(setup, rows);
    for (const int j : rows) {
        for (int i = 0; i < image.widthPixels; ++i) {
            if (isInViewport(setup, {i, j}))
                image.depths[image.indexOf(i, j)] = depth;
        }
    }
    return image;
}

} // namespace unprojector::maps
