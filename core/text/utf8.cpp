#include "core/text/utf8.h"

namespace unprojector::text {

std::size_t firstNotUtf8(std::string_view text)
{
    const auto byte = [&text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const auto isBetween = [](unsigned char value, unsigned lowest, unsigned highest) {
        return value >= lowest && value <= highest;
    };
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char first = byte(i);
        std::size_t length = 1;
        // The second byte tells what is overlong, a surrogate or too large.
        unsigned lowest = 0x80, highest = 0xbf;
        if (first >= 0x80) {
            if (isBetween(first, 0xc2, 0xdf))
                length = 2;
            else if (isBetween(first, 0xe0, 0xef))
                length = 3;
            else if (isBetween(first, 0xf0, 0xf4))
                length = 4;
            else
                return i;
            lowest = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : lowest;
            highest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : highest;
        }
        for (std::size_t k = 1; k < length; ++k) {
            if (!isBetween(byte(i + k), k == 1 ? lowest : 0x80, k == 1 ? highest : 0xbf))
                return i;
        }
        i += length;
    }
    return text.npos;
}

} // namespace unprojector::text
