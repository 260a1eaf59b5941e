#pragma once

#include "core/ray/click_ray.h"
#include "core/unproject/batch/batch_unproject.h"

#include <vector>

namespace unprojector::maps {

/// The rays through the centres of many pixels: the rays of ray::ClickRays, computed row by row in
/// plain double. Their ends may be off by some units in the last place.
class PixelRays {
public:
    /// @return the errors of BatchUnprojection::byFormula or, for a matrix that is no known
    ///         projection, byMatrix
    static geometry::Result<PixelRays> of(const ray::ClickRays &rays);

    /// @param row  counted from the top
    /// @return one ray for each pixel of the width; not finite where there is none
    std::vector<ray::Ray<geometry::WorldSpace>> ofRow(int row) const;

private:
    PixelRays(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup,
              const geometry::DepthRange &depths);

    unproject::BatchUnprojection m_unprojection;
    std::size_t m_width;
    geometry::DepthRange m_depths; ///< depths of the rays' ends
    double m_high;                 ///< largest t of the rays: infinity if the far plane is at infinity
};

} // namespace unprojector::maps
