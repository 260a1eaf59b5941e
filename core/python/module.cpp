#include "core/python/bindings.h"

PYBIND11_MODULE(_core, module)
{
    using namespace unprojector;
    using namespace unprojector::python;
    module.attr("__version__") = UNPROJECTOR_VERSION;
    module.doc() = "World coordinates under pixels, by closed-form inverse formulas and by the inverted matrix.";
    module.def("conventions", &conventionKeys, "The names of the conventions that matrices can have: a list of str.");
    py::options options;
    options.disable_function_signatures();
    SetupClass setup = bindSetup(module);
    bindUnproject(setup);
    bindProject(module, setup);
    bindCloud(module, setup);
    bindScene(module);
    bindDiagnose(module);
    bindLandmarks(module);
}
