#pragma once

#include <optional>
#include <string>

namespace unprojector::cli {

/// Pixels.
struct SizeGiven {
    int width;
    int height;
};

/// What an option says as in 800x600; whether any picture has that size is not asked. Errors are printed on stderr.
std::optional<SizeGiven> sizeGiven(const std::string &option, const std::string &text);

} // namespace unprojector::cli
