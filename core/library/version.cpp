#include "unprojector/version.h"

#include <string>

namespace unprojector {

std::string version()
{
    return std::to_string(UNPROJECTOR_VERSION_MAJOR) + '.' + std::to_string(UNPROJECTOR_VERSION_MINOR) + '.'
           + std::to_string(UNPROJECTOR_VERSION_PATCH);
}

} // namespace unprojector
