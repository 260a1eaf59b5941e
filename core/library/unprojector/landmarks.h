#pragma once

#include "unprojector/setup.h"

namespace unprojector {

} // namespace unprojector
