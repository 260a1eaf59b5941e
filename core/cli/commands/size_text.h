#pragma once

#include <optional>
#include <string>

namespace unprojector::cli {

/// Pixels.
struct SizeGiven {
    int width;
    int height;
};

/// Parses an option such as 800x600, without checking whether a view can have that size. Errors are
/// printed on stderr.
std::optional<SizeGiven> sizeGiven(const std::string &option, const std::string &text);

} // namespace unprojector::cli
