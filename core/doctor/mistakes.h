#pragma once

#include "core/doctor/program.h"

#include <span>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

/// What a mistake spoils. Those of the depth leave the point on its ray.
enum class Family { Pixel, Lens, Depth, Matrix, Point };

struct Mistake {
    std::string_view id;
    Family family = Family::Pixel;
    int reports = 0; ///< public threads found on its kind; decides between equals
};

/// Every mistake that is known, by the way of a click; in this order the ids of two are put together.
std::span<const Mistake> mistakes();

/// Every way to make each of them on what was given, by mistake.
std::vector<Variant> variants(const Given &given, std::span<const PlacedModel> models);

} // namespace unprojector::doctor
