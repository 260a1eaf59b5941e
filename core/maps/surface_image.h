#pragma once

#include "core/maps/pixel_rays.h"
#include "core/ray/scene_rays.h"
#include "core/unproject/depth_sample.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::maps {

/// Rows of a view, counted from the top, each once.
using Rows = std::vector<int>;
Rows allRows(const geometry::Setup &setup);

/// The surface visible at the centre of each pixel of a view, or of some of its rows.
struct SurfaceImage {
    int widthPixels = 0, heightPixels = 0; ///< of the view
    std::vector<int> rowPlaces;            ///< for each row of the view its index in the arrays below; -1: missing
    unproject::DepthFormat format;
    std::vector<double> depths; ///< in the depth range, with the rounding of that depth buffer format; NaN: no surface
    // Data of surfaces hit by rays; empty if only a depth was given:
    std::vector<double> ts;               ///< parameter on the pixel's ray, see PixelRays
    std::vector<std::uint32_t> objects;   ///< indices in the scene's list
    std::vector<std::uint32_t> triangles; ///< triangle numbers in the object's model

    bool has(int row) const { return row >= 0 && row < heightPixels && rowPlaces[static_cast<std::size_t>(row)] >= 0; }
    /// @pre has(row)
    std::size_t indexOf(int column, int row) const
    {
        return static_cast<std::size_t>(rowPlaces[static_cast<std::size_t>(row)])
                   * static_cast<std::size_t>(widthPixels)
               + static_cast<std::size_t>(column);
    }
    bool isMet() const { return !ts.empty(); }
};

/// The first hits of the rays. It needs no window, no OpenGL and no rasteriser. The hit's depth is
/// rounded as a depth buffer does it. Points of point clouds are skipped.
/// @param format    of the depth buffer
/// @param rows      rows to compute
/// @param progress  called with the share done, on the calling thread; may be empty
/// @return empty if progress requests a stop. Throws std::bad_alloc.
std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels,
                                        const unproject::DepthFormat &format, const Rows &rows,
                                        const ray::Progress &progress);
/// The first hits for all rows of the view.
std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels,
                                        const unproject::DepthFormat &format, const ray::Progress &progress);

/// A surface of the same depth everywhere in the viewport.
/// @pre the depth lies in the depth range. Throws std::bad_alloc.
SurfaceImage surfacesAt(const geometry::Setup &setup, double depth, const Rows &rows);

} // namespace unprojector::maps
