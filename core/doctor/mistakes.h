#pragma once

#include "core/doctor/program.h"

#include <span>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

struct Target;

struct Mistake {
    std::string_view id;
    int reports = 0;           ///< public threads found about this kind; ranks equal candidates
    bool isOnlySolved = false; ///< it has free values only, see addSolvedMistakes
};

/// All known mistakes, in the order of the stages from a click to a point. The id of two mistakes
/// follows this order.
std::span<const Mistake> mistakes();

/// All variants of all mistakes for this input, sorted by mistake.
/// @param points  the points from which free values are solved; none: mistakes of fixed form only
std::vector<Variant> variants(const Given &given, const Case &scene, std::span<const Target> points = {});

} // namespace unprojector::doctor
