#pragma once

#include "unprojector/setup.h"
#include "unprojector/unproject.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector {

/// The meaning of a depth image's numbers.
enum class DepthIs {
    Buffer,   ///< window depths, in the setup's depth range; whole numbers are shares of the greatest possible
    Range,    ///< 0 to 1 over the setup's depth range, from its lower end on
    Z,        ///< distances from the eye along the view axis
    Distance, ///< distances from the eye along the pixel's ray
    Disparity ///< pixels between two cameras side by side: z = fx baseline / (disparity + offset)
};

enum class NumberType { Uint8, Uint16, Int32, Float32, Float64 };

struct CloudOptions {
    DepthIs depthIs = DepthIs::Buffer;
    std::optional<double> scale = std::nullopt;    ///< the numbers are divided by it: 1000 for millimetres
    std::optional<double> baseline = std::nullopt; ///< of disparities, world units
    /// Added to disparities, pixels: the second camera's cx less the first's, as doffs of Middlebury.
    std::optional<double> disparityOffset = std::nullopt;
    std::vector<double> noData = {}; ///< numbers of the image that mean no measurement, before the scale
    Method method = Method::Formula;
    NumberType type = NumberType::Float32; ///< of the image's numbers
};

/// The number of pixels without a point, by their reason.
struct CloudCounts {
    std::size_t kept = 0, zero = 0, notANumber = 0, infinite = 0, negative = 0, beforeNear = 0;
    std::size_t atFar = 0;        ///< on the far plane or behind it: background
    std::size_t outsideRange = 0; ///< no depth of the window
    std::size_t noData = 0;       ///< a number of CloudOptions::noData
};

/// Computes a point for each pixel of a depth image, prepared once for a setup. Any thread may call
/// it. Its digits are those of `unproject cloud`: plain double.
class UNPROJECTOR_PUBLIC Cloud {
public:
    /// @return Value: options that contradict each other, a setup that has no distances
    static Result<Cloud> of(const Setup &setup, const CloudOptions &options = {});

    int width() const;  ///< of the setup's window, which is the image's
    int height() const; ///< the same

    /// Computes the points of a part of a row, world space; NaN for a pixel without one.
    /// @param row      from the top
    /// @param first    column of the first pixel
    /// @param numbers  the image's numbers, as doubles; scratch afterwards
    /// @param points   x, y, z of each pixel, one after the other
    void row(std::size_t row, std::size_t first, std::vector<double> &numbers, double *points) const;
    void row(std::size_t row, std::size_t first, std::vector<double> &numbers, float *points) const;

    /// The same of an image in single precision, without a copy. Other numbers whose type floats
    /// hold, as of 8 and 16 bits, may be given as floats too. @pre canTakeFloats()
    void row(std::size_t row, std::size_t first, std::span<const float> numbers, double *points) const;
    void row(std::size_t row, std::size_t first, std::span<const float> numbers, float *points) const;
    bool canTakeFloats() const;

    /// Adds the pixels of a row to the counts.
    void count(std::size_t row, const std::vector<double> &numbers, CloudCounts &counts) const;

private:
    struct Data;
    explicit Cloud(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

/// An image of numbers.
struct DepthImage {
    std::size_t width = 0, height = 0;
    /// Row after row from the top.
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>, std::vector<double>>
        numbers;
    std::vector<std::string> notes; ///< what was chosen or ignored, one sentence each
};

/// Reads a depth image: PNG, TIFF, OpenEXR, PFM, PGM, COLMAP's .bin or NumPy's .npy.
/// @param channel    of OpenEXR; empty: the one named Z or depth
/// @param byteOrder  of a PGM of 16 bits; empty: big, as the format has it, and a note if the other one is far
///                   smoother
/// @return MissingFile, File; Value: contents that are no such image
UNPROJECTOR_PUBLIC Result<DepthImage> readDepth(const std::filesystem::path &file, const std::string &channel = {},
                                                std::optional<std::endian> byteOrder = std::nullopt);

} // namespace unprojector
