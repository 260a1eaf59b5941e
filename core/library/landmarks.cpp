#include "unprojector/landmarks.h"

#include "core/library/internal.h"

namespace unprojector {

} // namespace unprojector
