#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/lens_changes.h"
#include "core/doctor/variants.h"
#include "core/doctor/written_value.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

/// The factors by which another frustum's near and far differ.
constexpr std::array kClipFactors{0.1, 10.0, 0.01, 100.0};

/// The distance of the right point.
double rightDistance(const Run &run)
{
    return run.given.side * run.click.eye.z;
}

/// Takes the depth of another pixel, if there is one.
void takeDepth(Run &run, const std::optional<double> &depth)
{
    run.isLost = !depth;
    run.depth = run.given.unitDepth(depth.value_or(0.0));
}

void addMeaningOfDepth(VariantList &list)
{
    list.add(
        "depth-linear", Stage::Depth,
        [](Run &run) {
            const double n = run.given.nearDistance, f = run.given.farDistance;
            run.depth = (rightDistance(run) - n) / (f - n);
        },
        marked("a share of the way is passed for the depth"));
    list.add(
        "depth-linear", Stage::Eye,
        [](Run &run) {
            const double n = run.nearDistance, f = run.farDistance;
            run.setDistance(n + run.given.shareFromNear(run.depth) * (f - n));
        },
        marked("the depth is taken for a share of the way"));
    list.add(
        "depth-linear", Stage::Eye, [](Run &run) { run.setDistance(run.depth * run.farDistance); },
        marked("the depth is taken for a share of far"));
    list.add(
        "depth-is-eye-distance", Stage::Depth, [](Run &run) { run.depth = run.given.unitDepth(rightDistance(run)); },
        marked("the distance is passed for the depth"));
    list.add(
        "depth-is-eye-distance", Stage::Depth,
        [](Run &run) { run.depth = run.given.unitDepth(glm::length(run.click.eye)); },
        marked("the length of the ray is passed for the depth"));
    list.add(
        "depth-is-eye-distance", Stage::Eye, [](Run &run) { run.setDistance(run.click.depth); },
        marked("the depth is taken for the distance"));
    list.add("ray-length-as-z", Stage::Eye, [](Run &run) { run.setDistance(glm::length(run.eye)); });
    list.add("z-as-ray-length", Stage::Eye, [](Run &run) {
        const double distance = run.distance();
        run.setDistance(distance * distance / glm::length(run.eye));
    });
}

void addClipDistances(VariantList &list, const Given &given)
{
    for (const double factor : kClipFactors) {
        const double n = withoutNoise(factor * given.nearDistance), f = withoutNoise(factor * given.farDistance);
        list.add("near-differs", withOtherNear(given, n));
        list.add("far-differs", withOtherFar(given, f));
        if (given.isFrustum)
            list.add("near-differs", withOtherNearOfFrustum(given, n));
    }
}

} // namespace

void addDepthMistakes(VariantList &list, const Given &given, const Case &)
{
    list.add("depth-not-remapped", Stage::Depth, [](Run &run) { run.depth = (1.0 + run.depth) / 2.0; });
    list.add("depth-remapped-twice", Stage::Depth, [](Run &run) { run.depth = 2.0 * run.depth - 1.0; });
    list.add("depth-zero", Stage::Depth, [](Run &run) { run.depth = run.given.unitDepth(0.0); });
    list.add("depth-one", Stage::Depth, [](Run &run) { run.depth = run.given.unitDepth(1.0); });
    list.add("depth-reversed", Stage::Depth, [](Run &run) { run.depth = 1.0 - run.depth; });
    if (given.depthRange != DepthRange{}) {
        list.add(
            "depth-not-remapped", Stage::Depth, [](Run &run) { run.depth = (1.0 + run.click.depth) / 2.0; },
            marked("nor mapped by the depth range"));
        list.add("depth-range-ignored", Stage::Depth, [](Run &run) { run.depth = run.click.depth; });
        list.add(
            "depth-zero", Stage::Depth, [](Run &run) { run.depth = 0.0; }, marked("in the depth range"));
        list.add(
            "depth-one", Stage::Depth, [](Run &run) { run.depth = 1.0; }, marked("in the depth range"));
        list.add(
            "depth-reversed", Stage::Depth, [](Run &run) { run.depth = run.given.unitDepth(1.0 - run.click.depth); },
            marked("before the depth range"));
    }
    // Vector3.Unproject of SharpDX and Viewport.Unproject of XNA take a depth range. The depth comes
    // close to 0, where other mistakes of the depth make it 0: in pairs they would pass for depth 0.
    if (std::isfinite(given.farDistance))
        list.add("depth-range-is-planes", Stage::Depth,
                 [](Run &run) {
                     const double n = run.given.nearDistance, f = run.given.farDistance;
                     run.depth = (run.click.depth - n) / (f - n);
                 })
            .isAlone = true;
    for (const int bits : {16, 24, 8}) {
        list.add(
            "depth-rounded", Stage::Depth,
            [](Run &run) { run.depth = std::round(run.depth * run.parameter) / run.parameter; },
            {marked("to %1 bits"), {std::to_string(bits)}}, double((std::int64_t{1} << bits) - 1));
    }
    list.add(
        "depth-of-another-row", Stage::Depth, [](Run &run) { takeDepth(run, run.click.depthAbove); },
        marked("the row above"));
    list.add(
        "depth-of-another-row", Stage::Depth, [](Run &run) { takeDepth(run, run.click.depthBelow); },
        marked("the row below"));
    addMeaningOfDepth(list);
    addClipDistances(list, given);
}

} // namespace unprojector::doctor
