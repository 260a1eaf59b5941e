#pragma once

#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// `unproject doctor`: finds the mistake in a program that explains its wrong point.
struct DoctorOptions {
    std::string scene;              ///< a model, a scene or clicks; "-" is a scene from stdin
    std::string pixel;              ///< "X,Y", continuous device pixels
    std::string depth;              ///< empty: unknown
    std::string got;                ///< "X,Y,Z", as the program printed them
    std::string gotSpace = "world"; ///< world, eye, object or object:NAME
    std::string points;             ///< CSV px,py,depth,x,y,z, replaces pixel, depth and got; "-" is stdin
    std::string otherSize;          ///< "WxH"; empty: none
    std::string distortion;         ///< see SceneLens; empty: none
    bool isJson = false;
};

ExitCode runDoctor(const DoctorOptions &options);

} // namespace unprojector::cli
