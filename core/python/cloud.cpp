#include "core/python/bindings.h"

namespace unprojector::python {

void bindCloud(SetupClass &) {}

} // namespace unprojector::python
