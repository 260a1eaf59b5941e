#include "core/python/bindings.h"

namespace unprojector::python {

void bindDiagnose(py::module_ &) {}

} // namespace unprojector::python
