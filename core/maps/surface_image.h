#pragma once

#include "core/maps/pixel_rays.h"
#include "core/ray/scene_rays.h"
#include "core/unproject/depth_sample.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::maps {

/// Rows of a picture, counted from the top, each once.
using Rows = std::vector<int>;
Rows allRows(const geometry::Setup &setup);

/// What is seen at the centre of each pixel of a picture, or of some of its rows.
struct SurfaceImage {
    int widthPixels = 0, heightPixels = 0; ///< of the picture
    std::vector<int> rowPlaces;            ///< of each row of the picture: where it lies below; -1: it is not here
    unproject::DepthFormat format;
    std::vector<double> depths; ///< in the depth range, as a depth buffer of that format keeps them; NaN: no surface
    // Of surfaces that rays have met; empty where only a depth was given:
    std::vector<double> ts;               ///< where on the pixel's ray, see PixelRays
    std::vector<std::uint32_t> objects;   ///< places in the scene's list
    std::vector<std::uint32_t> triangles; ///< numbers in the object's model

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

/// What the rays meet first: no window and no OpenGL is needed, and no rasteriser is in between. The depth of what is met is
/// rounded as a depth buffer does it. Points of clouds are passed over.
/// @param format    of the depth buffer
/// @param rows      that are looked at
/// @param progress  with the share done, on the calling thread; may be empty
/// @return nothing when progress says stop. Throws std::bad_alloc.
std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels,
                                        const unproject::DepthFormat &format, const Rows &rows,
                                        const ray::Progress &progress);
/// Those of the whole picture.
std::optional<SurfaceImage> surfacesMet(const ray::SceneRays &rays, const PixelRays &pixels,
                                        const unproject::DepthFormat &format, const ray::Progress &progress);

/// The same depth everywhere in the viewport.
/// @pre the depth lies in the depth range. Throws std::bad_alloc.
SurfaceImage surfacesAt(const geometry::Setup &setup, double depth, const Rows &rows);
SurfaceImage surfacesAt(const geometry::Setup &setup, double depth);

} // namespace unprojector::maps
