#pragma once

#include "core/clouds/depth_numbers.h"
#include "core/unproject/answers.h"
#include "core/unproject/batch/batch_unproject.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::clouds {

/// Computes a point for each pixel of a depth image, row by row, for arrays in memory. Digits are
/// those of DepthCloud and DistanceCloud. Any thread may call it.
class OrganizedCloud {
public:
    /// @param method  Formula or Matrix
    /// @return the message about the numbers or the setup, in the language of base::tr()
    static geometry::Result<OrganizedCloud, std::string> of(const geometry::Setup &setup, const DepthNumbers &numbers,
                                                            const DepthValues::Type &type, unproject::Method method);

    /// Computes the points of a row; NaN for a pixel without one.
    /// @param j       row index from the top
    /// @param first   column of the first pixel
    /// @param values  the image's numbers; scratch afterwards
    /// @param points  x, y, z of each pixel
    template <class Scalar>
    void row(std::size_t j, std::size_t first, std::vector<double> &values, Scalar *points) const;

    /// The same of numbers in single precision that are not converted first, if canTakeFloats().
    template <class Scalar>
    void row(std::size_t j, std::size_t first, std::span<const float> values, Scalar *points) const;
    bool canTakeFloats() const { return m_kept.has_value(); }

    /// Adds the kinds of a row's pixels.
    /// @param values  as above
    void count(std::size_t j, const std::vector<double> &values, PixelCounts &counts) const;

    /// The distances that the setup shows; empty for window depths.
    const std::optional<unproject::ClipDistances> &clip() const { return m_clip; }

private:
    OrganizedCloud(const unproject::BatchUnprojection &unprojection, const unproject::PixelLines &lines)
        : m_unprojection(unprojection), m_lines(std::make_shared<const unproject::PixelLines>(lines))
    {
    }

    template <class Line, class Scalar>
    void line(const Line &line, Scalar *points) const;

    unproject::BatchUnprojection m_unprojection;
    std::shared_ptr<const unproject::PixelLines> m_lines; ///< at an address that m_values keeps
    std::optional<unproject::ClipDistances> m_clip;
    std::shared_ptr<const DepthValues> m_values;
    std::optional<DepthValues::Kept> m_kept;
    bool m_canOverflow = true; ///< a point may have a coordinate beyond the range of floats
};

/// The fault of numbers and their unit, as a sentence about the named options; empty if there is
/// none.
struct DepthOptionNames {
    const char *meaning = "depth_is", *scale = "scale", *baseline = "baseline", *offset = "disparity_offset";
};
std::string faultOf(const DepthNumbers &numbers, const DepthOptionNames &names = {});

} // namespace unprojector::clouds
