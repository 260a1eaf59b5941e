#include "unprojector/diagnose.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
