#include "core/python/bindings.h"

namespace unprojector::python {

void bindLandmarks(py::module_ &) {}

} // namespace unprojector::python
