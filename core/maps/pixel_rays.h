#pragma once

#include "core/ray/click_ray.h"
#include "core/unproject/batch/batch_unproject.h"

#include <vector>

namespace unprojector::maps {

/// The rays through the centres of many pixels, those of ray::ClickRays computed row by row in plain double: their ends may
/// be off by some units in the last place.
class PixelRays {
public:
    /// @return the errors of BatchUnprojection::byFormula or, for a matrix that is no known projection, byMatrix
    static geometry::Result<PixelRays> of(const ray::ClickRays &rays);

    /// @param row   counted from the top
    /// @param rays  becomes one for each pixel of the picture's width; not finite where there is none
    void ofRow(int row, std::vector<ray::Ray<geometry::WorldSpace>> &rays) const;

private:
    PixelRays(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup,
              const geometry::DepthRange &depths);

    unproject::BatchUnprojection m_unprojection;
    std::size_t m_width;
    geometry::DepthRange m_depths; ///< of the ends of the rays
    double m_high;                 ///< of the rays: infinity where the far plane is there
};

} // namespace unprojector::maps
