#include "core/python/bindings.h"

namespace unprojector::python {

void bindUnproject(SetupClass &) {}

} // namespace unprojector::python
