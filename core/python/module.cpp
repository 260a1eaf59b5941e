#include "core/python/bindings.h"

PYBIND11_MODULE(_core, module)
{
    using namespace unprojector::python;
    module.attr("__version__") = UNPROJECTOR_VERSION;
    module.doc() = "World coordinates under pixels, by closed-form inverse formulas and by the inverted matrix.";
    SetupClass setup = bindSetup(module);
    bindUnproject(setup);
    bindProject(module, setup);
    bindCloud(module, setup);
    bindScene(module);
    bindDiagnose(module);
    bindLandmarks(module);
}
