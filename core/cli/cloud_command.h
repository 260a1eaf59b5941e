#pragma once

#include "core/cli/exit_code.h"
#include "core/cli/points_command.h"

#include <string>

namespace unprojector::cli {

/// What the file holds. Computed in double either way.
enum class PointPrecision { Float, Double };

/// `unproject cloud`: a whole depth image to a point cloud in world space.
struct CloudOptions {
    std::string scene;
    std::string depth;  ///< raw floats, PFM or PGM
    std::string size;   ///< "WxH", for raw floats
    std::string output; ///< a PLY file, "-" for stdout
    Method method = Method::Formula;
    PointPrecision precision = PointPrecision::Float;
};

ExitCode runCloud(const CloudOptions &options);

} // namespace unprojector::cli
