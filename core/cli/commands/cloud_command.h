#pragma once

#include "core/cli/commands/points_command.h"
#include "core/cli/terminal/exit_code.h"
#include "core/clouds/depth_numbers.h"

#include <bit>
#include <optional>
#include <string>

namespace unprojector::cli {

/// The precision of the numbers in the file. Computations are in double either way.
enum class PointPrecision { Float, Double };

/// `unproject cloud`: converts a whole depth image to a point cloud in world space.
struct CloudOptions {
    std::string scene;
    std::string depth;                    ///< a depth image, see images::readNumberImage
    std::string color;                    ///< PNG or JPEG of the same pixels; empty: points without colors
    std::string size;                     ///< "WxH", for raw floats
    std::string channel;                  ///< of OpenEXR; empty: by its name
    std::optional<std::endian> byteOrder; ///< of PGM and raw floats; empty: the usual one
    std::string output;                   ///< a PLY file, "-" for stdout
    clouds::DepthNumbers numbers;
    unproject::Method method = unproject::Method::Formula;
    PointPrecision precision = PointPrecision::Float;
};

ExitCode runCloud(const CloudOptions &options);

} // namespace unprojector::cli
