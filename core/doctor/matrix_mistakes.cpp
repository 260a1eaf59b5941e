#include "core/base/translation.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/variant_list.h"

#include <glm/matrix.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace unprojector::doctor {
using base::marked;
namespace {

glm::dvec3 transformed(const glm::dmat4 &m, const glm::dvec3 &point)
{
    const glm::dvec4 result = m * glm::dvec4(point, 1.0);
    return glm::dvec3(result) / result.w;
}

/// The words for a permutation: its axes, and what it comes from.
VariantName nameOf(const AxisPermutation &permutation)
{
    const std::string &axes = permutation.axes;
    if (axes == "x,-z,y")
        return {
            marked("%1: z up given for y up"), axes, {}, marked("Your program's axes are %1: z is up in place of y.")};
    if (axes == "x,z,-y")
        return {
            marked("%1: y up given for z up"), axes, {}, marked("Your program's axes are %1: y is up in place of z.")};
    if (axes == "x,z,y")
        return {
            marked("%1: y and z exchanged"), axes, {}, marked("Your program's axes are %1: y and z are exchanged.")};
    if (axes == "x,-y,-z")
        return {marked("%1: OpenCV's axes for OpenGL's, or the reverse"),
                axes,
                {},
                marked("Your program's axes are %1: OpenCV's in place of OpenGL's, or the reverse.")};
    const bool isMirrored = glm::determinant(permutation.matrix) < 0.0;
    return isMirrored
               ? VariantName(marked("%1, mirrored"), axes, {}, marked("Your program's axes are %1: a mirror image."))
               : VariantName(nullptr, axes, {}, marked("Your program's axes are %1."));
}

void addAxes(VariantList &list)
{
    for (const AxisPermutation &permutation : axisPermutations().subspan(1)) {
        Variant variant;
        variant.stage = Stage::Point;
        variant.apply = [](Run &run, const Variant &v) { run.point = transformed(v.matrix, run.point); };
        variant.matrix = glm::dmat4(permutation.matrix);
        variant.name = nameOf(permutation);
        variant.values = {{"axes", {}, permutation.axes}};
        const bool isUsual =
            permutation.axes == "x,-z,y" || permutation.axes == "x,z,-y" || permutation.axes == "x,z,y";
        variant.isAlone = !isUsual;
        list.add("axes-differ", std::move(variant));
    }
}

/// The ends of the pixel's ray, on the near and the far plane, before the division by w.
std::array<glm::dvec4, 2> undividedEnds(const Run &run)
{
    const double nearest = run.given.ndcDepth == geometry::NdcDepth::ZeroToOne ? 0.0 : -1.0;
    return {run.spaceFromClip * glm::dvec4(run.ndc.x, run.ndc.y, nearest, 1.0),
            run.spaceFromClip * glm::dvec4(run.ndc.x, run.ndc.y, 1.0, 1.0)};
}

/// Mixes the ends: x and y of one end, and the other's z divided by its w.
template <std::size_t Own>
void mixEnds(Run &run, const Variant &)
{
    run.isLost = run.isLost || run.isClosedForm;
    const std::array<glm::dvec4, 2> ends = undividedEnds(run);
    const glm::dvec4 &own = ends[Own], &other = ends[1 - Own];
    run.point = glm::dvec3(own.x, own.y, other.z) / own.w;
}

void addEnds(VariantList &list)
{
    list.addAlone("w-of-another-point", Stage::Point, mixEnds<1>, marked("z of the near end with the far end's w"));
    list.addAlone("w-of-another-point", Stage::Point, mixEnds<0>, marked("z of the far end with the near end's w"));
}

} // namespace

void addMatrixMistakes(VariantList &list)
{
    list.add("projection-transposed", Stage::Factors,
             [](Run &run, const Variant &) { run.clipFromEye = glm::transpose(run.clipFromEye); });
    list.add("view-transposed", Stage::Factors,
             [](Run &run, const Variant &) { run.eyeFromWorld = glm::transpose(run.eyeFromWorld); });
    list.add("both-transposed", Stage::Factors, [](Run &run, const Variant &) {
        run.clipFromEye = glm::transpose(run.clipFromEye);
        run.eyeFromWorld = glm::transpose(run.eyeFromWorld);
    });
    list.add("view-inverse-as-view", Stage::Factors,
             [](Run &run, const Variant &) { run.eyeFromWorld = glm::inverse(run.eyeFromWorld); });
    list.add("view-left-out", Stage::Factors, [](Run &run, const Variant &) { run.eyeFromWorld = glm::dmat4(1.0); });
    list.add("projection-left-out", Stage::Factors,
             [](Run &run, const Variant &) { run.clipFromEye = glm::dmat4(1.0); });
    list.add("product-transposed", Stage::Product,
             [](Run &run, const Variant &) { run.order = Run::Order::InverseOfTransposed; });
    list.add("inverse-order", Stage::Product,
             [](Run &run, const Variant &) { run.order = Run::Order::InversesInTheOrderOfTheFactors; });
    list.add("not-inverted", Stage::Product, [](Run &run, const Variant &) { run.order = Run::Order::NotInverted; });
    list.add("overwritten-in-place", Stage::Divide, [](Run &run, const Variant &) { run.isInPlace = true; });
    list.add("no-w-divide", Stage::Divide, [](Run &run, const Variant &) { run.divisions = 0; });
    list.add("w-divided-twice", Stage::Divide, [](Run &run, const Variant &) { run.divisions = 2; });
}

void addPointMistakes(VariantList &list, std::span<const PlacedModel> models)
{
    constexpr std::size_t kMostInPairs = 200; // the pairs, and their memory, grow with the square
    for (std::size_t i = 0; i < models.size(); ++i) {
        const bool isAlone = i >= kMostInPairs;
        list.add(
            "model-left-in",
            [](Run &run, const Variant &v) { run.point = transformed(glm::inverse(v.matrix), run.point); }, models[i],
            isAlone);
        list.add(
            "model-left-out", [](Run &run, const Variant &v) { run.point = transformed(v.matrix, run.point); },
            models[i], isAlone);
    }
    list.add("eye-added", Stage::Point, [](Run &run, const Variant &) { run.point += run.given.eyePosition; });
    list.add("eye-subtracted", Stage::Point, [](Run &run, const Variant &) { run.point -= run.given.eyePosition; });
    addAxes(list);
    addEnds(list);
}

} // namespace unprojector::doctor
