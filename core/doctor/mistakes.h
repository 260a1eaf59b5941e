#pragma once

#include "core/doctor/program.h"

#include <span>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

struct Mistake {
    std::string_view id;
    int reports = 0; ///< public threads found on its kind; decides between equals
};

/// Every mistake that is known, by the way of a click; in this order the ids of two are put together.
std::span<const Mistake> mistakes();

/// Every way to make each of them on what was given, by mistake.
std::vector<Variant> variants(const Given &given, const Case &scene);

} // namespace unprojector::doctor
