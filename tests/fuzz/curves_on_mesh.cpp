#include "tests/fuzz/curves_on_mesh.h"

#include "core/curves/curve_line.h"
#include "tests/fuzz/fuzzing.h"
#include "tests/support/cube_sphere.h"

#include <algorithm>
#include <cmath>

namespace fuzz {
namespace {

using namespace unprojector;
using landmarks::Curve;
using landmarks::Landmark;

const curves::SurfaceMesh &surface()
{
    static const auto built = curves::SurfaceMesh::build(*cubeSphere(3), {});
    return *built;
}

} // namespace

void leadCurves(const landmarks::LandmarkSet &set)
{
    constexpr std::size_t kMostCurves = 4, kMostPoints = 6;
    constexpr int kMostSteps = 100'000; // of a mesh of 108 triangles: a path with more goes around in circles
    for (std::size_t i = 0; i < std::min(set.curves.size(), kMostCurves); ++i) {
        const Curve &curve = set.curves[i];
        std::vector<const Landmark *> points;
        for (const std::string &name : curve.points) {
            const auto found = std::find_if(set.landmarks.begin(), set.landmarks.end(),
                                            [&](const Landmark &landmark) { return landmark.name == name; });
            if (found != set.landmarks.end() && points.size() < kMostPoints)
                points.push_back(&*found);
        }
        int steps = 0;
        const auto line = curves::lineThrough(surface(), points, curve.kind, glm::dmat4(1.0),
                                              [&steps](double) { return ++steps < kMostSteps; });
        if (!line)
            continue;
        require(std::isfinite(line->length.value) && line->length.value >= 0.0, "a curve has a length");
        for (const geometry::WorldPoint &place : curves::resampled(line->path, curve.count)) {
            const double radius = glm::length(place.coordinates());
            require(radius > 0.5 && radius < 1.1, "a curve stays on the mesh");
        }
    }
}

} // namespace fuzz
