#pragma once

#include "core/doctor/diagnosis.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// A number with the digits it was written with.
struct WrittenNumber {
    double value = 0.0;
    double lastDigit = 1.0; ///< its unit: 0.01 of 1.50, 1000 of 3e3
};

/// Nothing for what is no finite number.
std::optional<WrittenNumber> writtenNumber(std::string_view text);

/// A depth of fewer digits than this after its point is taken for exact, as 0.5 is; one of more for rounded.
constexpr int kRoundedDepthDecimals = 4;

/// The point of the options --pixel, --depth and --got. What is wrong with them is said on stderr.
/// @param depth  empty where it is not known
std::optional<doctor::WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth,
                                             const std::string &got);

/// The points of a table, and whether some of its rows were left out.
struct WrongPoints {
    std::vector<doctor::WrongPoint> points;
    bool isComplete = true;
};

/// So many points of one program are looked at; more would tell nothing new.
constexpr std::size_t kMostWrongPoints = 100;

/// CSV with the columns px,py,depth,x,y,z, found by their names; without a header in this order. What is wrong is said on stderr.
/// @param file  UTF-8; "-" for stdin
/// @return nothing where there is no point to look at
std::optional<WrongPoints> wrongPoints(const std::string &file);

} // namespace unprojector::cli
