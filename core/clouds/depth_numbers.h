#pragma once

#include "core/images/number_image.h"
#include "core/unproject/batch/pixel_lines.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::clouds {

/// The meaning of a depth image's numbers, in every format.
enum class DepthMeaning {
    Buffer,   ///< depths of the window, in the scene's depth range
    Range,    ///< 0 to 1 over the scene's depth range, from its lower end on
    Z,        ///< distances from the eye along the view axis
    Distance, ///< distances from the eye along the pixel's ray; of a box from the plane of the eye
    Disparity ///< pixels between two cameras side by side: z = fx baseline / (disparity + offset)
};

/// The meaning and the unit of a depth image's numbers.
struct DepthNumbers {
    DepthMeaning meaning = DepthMeaning::Buffer;
    bool isMeaningGiven = false; ///< else the meaning is assumed
    /// The numbers are divided by it: 1000 for millimetres in a scene in metres. Not for buffer and
    /// range.
    std::optional<double> scale;
    std::optional<double> baseline; ///< of disparities, world units
    /// Added to disparities, pixels: the difference cx' - cx of the second camera's principal point
    /// and the first's. A disparity of 0 stays "not measured".
    std::optional<double> disparityOffset = std::nullopt;
    std::vector<double> noData = {}; ///< numbers of the image that mean no measurement, before the scale
};

/// Why a pixel has a point, or none.
enum class PixelKind : unsigned char {
    Kept,
    Zero, ///< nothing was measured
    NotANumber,
    Infinite,
    Negative,
    BeforeNear,
    AtFar,        ///< on the far plane or behind it: background
    OutsideRange, ///< no depth of the window
    NoData        ///< a number that means no measurement
};
using PixelCounts = std::array<std::size_t, 9>;

/// The pixels that have no point: "12 with 0, 3 on the far plane (100) or behind it".
/// @param clip  empty for window depths
std::string leftOutText(const PixelCounts &counts, const std::optional<unproject::ClipDistances> &clip);

/// The distances and kinds of the pixels of a row.
struct DistanceRow {
    std::vector<double> values; ///< window depths, or z; scratch where a pixel is not kept
    std::vector<PixelKind> kinds;
};

/// Converts the numbers of a depth image to window depths (Buffer, Range) or to z (all others), in
/// double precision.
class DepthValues {
public:
    /// The type of an image's numbers.
    struct Type {
        bool isSingle = false; ///< single precision
        double greatest = 0.0; ///< of whole numbers: the greatest possible one; 0: fractions
        /// The number that stands for 1 in depths of the window: whole numbers are shares.
        double one() const { return greatest > 0.0 ? greatest : 1.0; }
    };
    /// @param lines  kept by reference; lines and clip are not used for window depths
    DepthValues(const Type &type, const DepthNumbers &numbers, const geometry::Setup &setup,
                const unproject::PixelLines &lines, const unproject::ClipDistances &clip);

    /// True for window depths.
    bool isOfWindow() const
    {
        return m_numbers.meaning == DepthMeaning::Buffer || m_numbers.meaning == DepthMeaning::Range;
    }
    /// Converts the numbers of a row in place.
    /// @param j      row index from the top
    /// @param first  column of the first number
    /// @param row    its values are the image's numbers
    void convert(std::size_t j, std::size_t first, DistanceRow &row) const;
    /// The same without kinds and fast; a pixel that is not kept becomes NaN.
    void convert(std::size_t j, std::size_t first, std::span<double> values) const;
    /// The numbers in single precision that are kept, where these are an interval and need no
    /// conversion but a division: [lowest, highest].
    struct Kept {
        float lowest, highest;
        double divisor;
    };
    std::optional<Kept> kept() const;

private:
    bool isNoData(double number) const;
    PixelKind kindOfDepth(double depth) const;
    PixelKind kindOfNumber(double number) const;
    PixelKind kindOfDistance(double z) const;

    Type m_type;
    DepthNumbers m_numbers;
    const unproject::PixelLines &m_lines;
    unproject::ClipDistances m_clip;
    double m_low, m_high;                           ///< ends of the depth range
    double m_lowest, m_highest, m_background = 1.0; ///< the window depths to compare with
};

/// The rows of a depth image.
class DepthRows {
public:
    /// @param image, lines  kept by reference
    DepthRows(const images::NumberImage &image, const DepthNumbers &numbers, const geometry::Setup &setup,
              const unproject::PixelLines &lines, const unproject::ClipDistances &clip);

    bool isOfWindow() const { return m_values.isOfWindow(); }
    /// @param j  row index from the top
    void read(std::size_t j, DistanceRow &row) const;
    /// The pixels of a row that are kept as distances, and have the greatest possible whole number.
    /// @param row  as read() gives it
    std::size_t saturated(std::size_t j, const DistanceRow &row) const;

private:
    const images::NumberImage &m_image;
    DepthValues m_values;
};

} // namespace unprojector::clouds
