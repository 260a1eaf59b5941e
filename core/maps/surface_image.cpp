#include "core/maps/surface_image.h"

#include "core/maps/rows_in_parallel.h"

#include <glm/mat4x4.hpp>

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
class WindowDepths {
public:
    explicit WindowDepths(const Setup &setup)
        : m_range(setup.depthRange), m_isZeroToOne(ndcDepthOf(setup) == NdcDepth::ZeroToOne)
    {
        const glm::dmat4 matrix = clipFromWorld(setup).value();
        for (int column = 0; column < 4; ++column) {
            m_z[column] = matrix[column][2];
            m_w[column] = matrix[column][3];
        }
    }

    double of(const WorldPoint &point) const
    {
        const glm::dvec4 place(point.coordinates(), 1.0);
        const double ndc = glm::dot(m_z, place) / glm::dot(m_w, place);
        const double share = m_isZeroToOne ? ndc : (ndc + 1.0) / 2.0;
        return m_range.atNear + share * (m_range.atFar - m_range.atNear);
    }

private:
    DepthRange m_range;
    bool m_isZeroToOne;
    glm::dvec4 m_z, m_w;
};

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
    const WindowDepths depths(setup);
    const auto [lowest, highest] = std::minmax({setup.depthRange.atNear, setup.depthRange.atFar});
    SurfaceImage image = emptyImage(setup, rowsMet);
    image.format = format;
    image.ts.assign(image.depths.size(), kNone);
    image.objects.assign(image.depths.size(), 0);
    image.triangles.assign(image.depths.size(), 0);
    const double low = lowest, high = highest;
    const bool isWhole = rowsInParallel(rowsMet, image.widthPixels, progress, [&](std::span<const int> some) {
        std::vector<ray::Ray<WorldSpace>> row;
        for (const int j : some) {
            pixels.ofRow(j, row);
            for (int i = 0; i < image.widthPixels; ++i) {
                if (!isInViewport(setup, {i, j}))
                    continue;
                const ray::Ray<WorldSpace> &ray = row[static_cast<std::size_t>(i)];
                const std::optional<ray::FirstTriangle> met = rays.firstTriangle(ray);
                if (!met)
                    continue;
                const std::size_t index = image.indexOf(i, j);
                // Rounding to whole steps can leave the range, where no surface is drawn.
                image.depths[index] = std::clamp(format.kept(depths.of(ray.at(met->hit.t))), low, high);
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

SurfaceImage surfacesAt(const Setup &setup, double depth)
{
    return surfacesAt(setup, depth, allRows(setup));
}

} // namespace unprojector::maps
