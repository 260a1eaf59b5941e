#pragma once

#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// `unproject doctor`: which mistake of a program makes its wrong point.
struct DoctorOptions {
    std::string scene;              ///< a model, a scene or clicks; "-" is a scene from stdin
    std::string pixel;              ///< "X,Y", continuous device pixels
    std::string depth;              ///< empty: not known
    std::string got;                ///< "X,Y,Z", as the program printed them
    std::string gotSpace = "world"; ///< world, eye, object or object:NAME
    std::string points;             ///< CSV px,py,depth,x,y,z instead of the three; "-" is stdin
    std::string otherSize;          ///< "WxH"; empty: none
    bool isJson = false;
};

ExitCode runDoctor(const DoctorOptions &options);

} // namespace unprojector::cli
