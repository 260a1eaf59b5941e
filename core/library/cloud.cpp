#include "unprojector/cloud.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
