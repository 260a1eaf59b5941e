#include "unprojector/project.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
