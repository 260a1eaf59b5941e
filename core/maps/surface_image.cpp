#include "core/maps/surface_image.h"

#include "core/maps/rows_in_parallel.h"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace unprojector::maps {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The window depth of world points, by the matrix.
class WindowDepths {
public:
    explicit WindowDepths(const Picture &picture)
        : m_range(picture.depthRange), m_isZeroToOne(ndcDepthOf(picture) == NdcDepth::ZeroToOne)
    {
        const glm::dmat4 matrix = clipFromWorld(picture).value();
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

SurfaceImage emptyImage(const Picture &picture, const Rows &rows)
{
    SurfaceImage image{picture.surface.widthPixels, picture.surface.heightPixels, {}, {}, {}, {}, {}, {}};
    image.rowPlaces.assign(static_cast<std::size_t>(image.heightPixels), -1);
    int place = 0;
    for (const int row : rows)
        image.rowPlaces[static_cast<std::size_t>(row)] = place++;
    image.depths.assign(rows.size() * static_cast<std::size_t>(image.widthPixels), kNone);
    return image;
}

/// Whether the centre of a pixel lies in the viewport.
bool isInViewport(const Picture &picture, const DevicePixel &pixel)
{
    const Viewport &v = picture.viewport;
    const WindowPoint center = windowFromDevice(picture.surface, pixelCenter(pixel), 0.0);
    return center.x >= v.x && center.x <= v.x + v.width && center.y >= v.y && center.y <= v.y + v.height;
}

} // namespace

Rows allRows(const Picture &picture)
{
    Rows rows(static_cast<std::size_t>(picture.surface.heightPixels));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels, const DepthFormat &format,
                                        const Rows &rowsMet, const ray::Progress &progress)
{
    const Picture &picture = rays.rays().picture();
    const WindowDepths depths(picture);
    const auto [lowest, highest] = std::minmax({picture.depthRange.atNear, picture.depthRange.atFar});
    SurfaceImage image = emptyImage(picture, rowsMet);
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
                if (!isInViewport(picture, {i, j}))
                    continue;
                const ray::Ray<WorldSpace> &ray = row[static_cast<std::size_t>(i)];
                const std::optional<ray::FirstTriangle> met = rays.firstTriangle(ray);
                if (!met)
                    continue;
                const std::size_t place = image.place(i, j);
                // Rounding to whole steps can lead out of the range, where no surface is drawn.
                image.depths[place] = std::clamp(format.kept(depths.of(ray.at(met->hit.t))), low, high);
                image.ts[place] = met->hit.t;
                image.objects[place] = static_cast<std::uint32_t>(met->object);
                image.triangles[place] = met->hit.triangle;
            }
        }
    });
    return isWhole ? std::optional(std::move(image)) : std::nullopt;
}

std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels, const DepthFormat &format,
                                        const ray::Progress &progress)
{
    return surfacesMet(rays, pixels, format, allRows(rays.rays().picture()), progress);
}

SurfaceImage surfacesAt(const Picture &picture, double depth, const Rows &rows)
{
    SurfaceImage image = emptyImage(picture, rows);
    for (const int j : rows) {
        for (int i = 0; i < image.widthPixels; ++i) {
            if (isInViewport(picture, {i, j}))
                image.depths[image.place(i, j)] = depth;
        }
    }
    return image;
}

SurfaceImage surfacesAt(const Picture &picture, double depth)
{
    return surfacesAt(picture, depth, allRows(picture));
}

} // namespace unprojector::maps
