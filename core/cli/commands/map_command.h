#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/maps/pixel_map.h"

#include <string>

namespace unprojector::cli {

/// `unproject map`: computes a number for each pixel of the view of a scene or a model.
struct MapOptions {
    std::string scene; ///< a model, a scene or clicks; "-" is a scene from stdin
    maps::Quantity quantity = maps::Quantity::FormulaMatrix;
    std::string convention; ///< convention of a displacement; empty for the other quantities
    maps::Unit unit = maps::Unit::World;
    std::string size; ///< size of the view, "WxH"; empty: its own
    bool isDepthGiven = false;
    double depth = 0.0;
    unproject::DepthFormat format; ///< format of the surfaces' depths
    bool isJson = false;
    std::string output; ///< a PFM file, "-" for stdout
};

ExitCode runMap(const MapOptions &options);

} // namespace unprojector::cli
