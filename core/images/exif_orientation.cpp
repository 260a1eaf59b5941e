#include "core/images/exif_orientation.h"

#include <array>
#include <cstddef>
#include <cstring>

namespace unprojector::images {
namespace {

/// The whole numbers of a TIFF header; 0 behind its end.
class TiffNumbers {
public:
    explicit TiffNumbers(std::span<const std::uint8_t> bytes)
        : m_bytes(bytes), m_isBigEndian(!bytes.empty() && bytes[0] == 'M')
    {
    }

    unsigned of16(std::size_t at) const
    {
        return m_isBigEndian ? byte(at) << 8 | byte(at + 1) : byte(at + 1) << 8 | byte(at);
    }
    unsigned of32(std::size_t at) const
    {
        return m_isBigEndian ? of16(at) << 16 | of16(at + 2) : of16(at + 2) << 16 | of16(at);
    }

private:
    unsigned byte(std::size_t at) const { return at < m_bytes.size() ? m_bytes[at] : 0; }

    std::span<const std::uint8_t> m_bytes;
    bool m_isBigEndian;
};

} // namespace

std::optional<int> exifOrientation(std::span<const std::uint8_t> segment)
{
    constexpr std::array<std::uint8_t, 6> kStart{'E', 'x', 'i', 'f', 0, 0};
    if (segment.size() <= kStart.size() || std::memcmp(segment.data(), kStart.data(), kStart.size()) != 0)
        return std::nullopt;
    const TiffNumbers numbers(segment.subspan(kStart.size()));
    constexpr unsigned kOrientation = 0x0112, kShort = 3;
    constexpr std::size_t kEntry = 12;
    const std::size_t directory = numbers.of32(4), count = numbers.of16(directory);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + 2 + i * kEntry;
        const unsigned value = numbers.of16(entry + 8);
        if (numbers.of16(entry) == kOrientation && numbers.of16(entry + 2) == kShort && value >= 1 && value <= 8)
            return static_cast<int>(value);
    }
    return std::nullopt;
}

} // namespace unprojector::images
