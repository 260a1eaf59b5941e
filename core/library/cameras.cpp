#include "unprojector/cameras.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
