#pragma once

#include "core/cli/commands/points_command.h"
#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// The precision of the numbers in the file. Computations are in double either way.
enum class PointPrecision { Float, Double };

/// The meaning of a depth image's numbers, in every image format: window depths, or 0 to 1 over the
/// scene's depth range, from its lower end on.
enum class DepthNumbers { Window, Range };

/// `unproject cloud`: converts a whole depth image to a point cloud in world space.
struct CloudOptions {
    std::string scene;
    std::string depth;  ///< raw floats, PFM or PGM
    std::string size;   ///< "WxH", for raw floats
    std::string output; ///< a PLY file, "-" for stdout
    DepthNumbers depths = DepthNumbers::Window;
    unproject::Method method = unproject::Method::Formula;
    PointPrecision precision = PointPrecision::Float;
};

ExitCode runCloud(const CloudOptions &options);

} // namespace unprojector::cli
