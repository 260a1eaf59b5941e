#include "unprojector/scene.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
