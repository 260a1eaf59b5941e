#pragma once

#include "core/doctor/diagnosis.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// The point of the options --pixel, --depth and --got. Errors are printed on stderr.
/// @param depth  empty: unknown
std::optional<doctor::WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth,
                                             const std::string &got);

/// The points of a table, and whether all its rows were used.
struct WrongPoints {
    std::vector<doctor::WrongPoint> points;
    std::vector<std::string> names; ///< name of each point, for messages: "wrong.csv:3", "--pixel"
    bool isComplete = true;
};

/// The size limit of the input, far above the need of that many points.
constexpr std::size_t kMostPointBytes = std::size_t{1} << 24;

/// Reads CSV with the columns px,py,depth,x,y,z, found by name, or in this order without a header.
/// Errors are printed on stderr.
/// @param file  UTF-8; "-" for stdin
/// @return empty if there is no point to examine
std::optional<WrongPoints> wrongPoints(const std::string &file);

} // namespace unprojector::cli
