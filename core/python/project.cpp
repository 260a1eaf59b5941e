#include "core/python/bindings.h"

namespace unprojector::python {

void bindProject(SetupClass &) {}

} // namespace unprojector::python
