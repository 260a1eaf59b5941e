#include "core/python/bindings.h"

namespace unprojector::python {

void bindScene(py::module_ &) {}

} // namespace unprojector::python
