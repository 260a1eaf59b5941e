#pragma once

#include "core/doctor/diagnosis.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// The point of the options --pixel, --depth and --got. Errors are printed on stderr.
/// @param depth  empty where it is not known
std::optional<doctor::WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth,
                                             const std::string &got);

/// The points of a table, and whether some of its rows were left out.
struct WrongPoints {
    std::vector<doctor::WrongPoint> points;
    std::vector<std::string> names; ///< of each, for messages: "wrong.csv:3", "--pixel"
    bool isComplete = true;
};

/// So many points of one program are looked at; more would tell nothing new.
constexpr std::size_t kMostWrongPoints = 100;

/// Far more than so many points need.
constexpr std::size_t kMostPointBytes = std::size_t{1} << 24;

/// CSV with the columns px,py,depth,x,y,z, found by their names; without a header in this order. Errors are printed on stderr.
/// @param file  UTF-8; "-" for stdin
/// @return nothing where there is no point to look at
std::optional<WrongPoints> wrongPoints(const std::string &file);

} // namespace unprojector::cli
