// The error of each way to unproject, as a table: units in the last place of the largest world
// component, against 50 digits, over random cameras. All ways get the same clicks.

#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"
#include "tests/support/core_scene.h"
#include "tests/support/unprojecting.h"

#include <glm/gtc/matrix_transform.hpp>
#ifdef UNPROJECTOR_GLU
#include <GL/glu.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using oracle::Extended;
using oracle::RandomKind;

namespace {

constexpr int kCamerasPerKind = 1500, kClicksPerCamera = 4;

glm::dvec3 byBatch(const Result<BatchUnprojection> &unprojection, const Setup &g, const WindowPoint &window)
{
    const DevicePoint device = deviceFromWindow(g.surface, window);
    const double px = device.x, py = device.y, depth = window.z;
    glm::dvec3 p;
    (*unprojection)(BatchInput<double>{&px, &py, &depth}, BatchOutput<double>{&p.x, &p.y, &p.z}, 1);
    return p;
}

template <class Scalar>
glm::dvec3 byGlm(const Setup &g, const WindowPoint &window)
{
    using Vector = glm::vec<3, Scalar>;
    using Matrix = glm::mat<4, 4, Scalar>;
    const glm::vec<4, Scalar> viewport(g.viewport.x, g.viewport.y, g.viewport.width, g.viewport.height);
    return glm::dvec3(glm::unProject(Vector(window.coordinates()), Matrix(eyeFromWorld(g).value()),
                                     Matrix(clipFromEye(g).value()), viewport));
}

/// The formulas as they are mostly programmed: in double, with z = n f / (f - d (f - n)).
glm::dvec3 byUsualFormula(const Setup &g, const WindowPoint &window)
{
    const Projection &projection = std::get<Projection>(g.lens);
    const ProjectionWindow w = projectionWindow(projection);
    const double n = w.nearDistance, f = w.farDistance, d = window.z;
    const bool perspective = isPerspective(projection);
    const double z = perspective ? n * f / (f - d * (f - n)) : n + d * (f - n);
    const double spread = perspective ? z / n : 1.0;
    double x = ((window.x - g.viewport.x) * (w.right - w.left) / g.viewport.width + w.left) * spread;
    double y = ((window.y - g.viewport.y) * (w.top - w.bottom) / g.viewport.height + w.bottom) * spread;
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        x += cotangent(oblique->theta) * z;
        y += cotangent(oblique->phi) * z;
    }
    const EyeFrame frame = eyeFrame(std::get<LookAt>(g.pose)).value();
    return (frame.eye + x * frame.side + y * frame.upward + z * frame.forward).coordinates();
}

#ifdef UNPROJECTOR_GLU
glm::dvec3 byGlu(const Setup &g, const WindowPoint &window)
{
    const glm::dmat4 view = eyeFromWorld(g).value(), projection = clipFromEye(g).value();
    const GLint viewport[4] = {GLint(g.viewport.x), GLint(g.viewport.y), GLint(g.viewport.width),
                               GLint(g.viewport.height)};
    glm::dvec3 p;
    gluUnProject(window.x, window.y, window.z, &view[0][0], &projection[0][0], viewport, &p.x, &p.y, &p.z);
    return p;
}
#endif

double percentile(const std::vector<double> &sorted, double share)
{
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

void printRow(double nearDistance, double farDistance)
{
    const oracle::SceneLimits limits = oracle::everydayScenes(nearDistance, farDistance);
    oracle::Random random(7);
    std::vector<std::pair<std::string, std::vector<double>>> methods;
    const auto add = [&](std::size_t index, const char *name, double error) {
        if (index == methods.size())
            methods.push_back({name, {}});
        methods[index].second.push_back(error);
    };
    for (const auto kind : {RandomKind::Frustum, RandomKind::Perspective, RandomKind::Ortho, RandomKind::Oblique}) {
        for (int camera = 0; camera < kCamerasPerKind; ++camera) {
            const oracle::Scene s = oracle::randomScene(random, kind, limits);
            const oracle::Oracle exact(s.view, s.projection, s.target);
            const Setup g = oracle::corePicture(s);
            const auto formula = BatchUnprojection::byFormula(g, {}), matrix = BatchUnprojection::byMatrix(g, {});
            for (int click = 0; click < kClicksPerCamera; ++click) {
                const std::array<double, 3> at = oracle::randomClick(random, s.target);
                const WindowPoint window(at[0], at[1], at[2]);
                const oracle::Vector3 truth = exact.worldUnder(at);
                const double largest = static_cast<double>(oracle::maxNorm(truth));
                const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
                const auto error = [&](const auto &p) {
                    return static_cast<double>(oracle::maxNorm(oracle::difference(oracle::extended(p), truth)) / ulp);
                };
                std::size_t index = 0;
                add(index++, "a click, by the formulas", error(*unprojectedAt(g, window).world[Method::Formula]));
                add(index++, "a batch, by the formulas", error(byBatch(formula, g, window)));
                add(index++, "the formulas as mostly programmed", error(byUsualFormula(g, window)));
                add(index++, "a batch, by the inverted matrix", error(byBatch(matrix, g, window)));
                add(index++, "glm::unProject, double", error(byGlm<double>(g, window)));
#ifdef UNPROJECTOR_GLU
                add(index++, "gluUnProject", error(byGlu(g, window)));
#endif
                add(index++, "glm::unProject, float", error(byGlm<float>(g, window)));
            }
        }
    }
    char title[64];
    std::snprintf(title, sizeof title, "near : far = %g : %g", nearDistance, farDistance);
    std::printf("\n%-38s%12s%12s%12s%12s\n", title, "median", "99 %", "99.99 %", "worst");
    for (auto &[name, errors] : methods) {
        std::sort(errors.begin(), errors.end());
        std::printf("  %-36s%12.2g%12.2g%12.2g%12.2g\n", name.c_str(), percentile(errors, 0.5),
                    percentile(errors, 0.99), percentile(errors, 0.9999), errors.back());
    }
}

} // namespace

int main()
{
    std::printf("Errors in units in the last place (of double) of the largest world component, %d clicks each\n",
                4 * kCamerasPerKind * kClicksPerCamera);
    printRow(5.0, 80000.0);
    printRow(0.1, 10000.0);
    printRow(1.0, 100.0);
    return 0;
}
