#include "core/python/bindings.h"

#include <array>

namespace unprojector::python {
namespace {

using Triple = std::array<double, 3>;

glm::dvec3 vectorOf(const Triple &t)
{
    return {t[0], t[1], t[2]};
}

} // namespace

SetupClass bindSetup(py::module_ &module)
{
    SetupClass setup(module, "Setup");
    setup.def_static(
        "perspective",
        [](double fovy, double nearDistance, double farDistance, const Triple &eye, const Triple &center,
           const Triple &up, std::pair<int, int> size) {
            Perspective projection;
            projection.verticalFovDegrees = fovy;
            projection.nearDistance = nearDistance;
            projection.farDistance = farDistance;
            Window window;
            window.width = size.first;
            window.height = size.second;
            return valueOrRaise(Setup::of(projection, {vectorOf(eye), vectorOf(center), vectorOf(up)}, window));
        },
        py::kw_only(), py::arg("fovy"), py::arg("near"), py::arg("far"), py::arg("eye"), py::arg("center"),
        py::arg("up") = Triple{0, 1, 0}, py::arg("size"));
    return setup;
}

} // namespace unprojector::python
