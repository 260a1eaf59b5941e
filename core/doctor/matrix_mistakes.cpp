#include "core/doctor/frame_fit.h"
#include "core/doctor/variant_list.h"
#include "core/text/translation.h"

#include <glm/matrix.hpp>

#include <utility>

namespace unprojector::doctor {
using text::marked;
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
        return {marked("%1: z up given for y up"), axes};
    if (axes == "x,z,-y")
        return {marked("%1: y up given for z up"), axes};
    if (axes == "x,z,y")
        return {marked("%1: y and z exchanged"), axes};
    if (axes == "x,-y,-z")
        return {marked("%1: OpenCV's axes for OpenGL's, or the reverse"), axes};
    const bool isMirrored = glm::determinant(permutation.matrix) < 0.0;
    return isMirrored ? VariantName(marked("%1, mirrored"), axes) : VariantName(nullptr, axes);
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
    for (const PlacedModel &model : models) {
        list.add(
            "model-left-in",
            [](Run &run, const Variant &v) { run.point = transformed(glm::inverse(v.matrix), run.point); }, model);
        list.add(
            "model-left-out", [](Run &run, const Variant &v) { run.point = transformed(v.matrix, run.point); }, model);
    }
    list.add("eye-added", Stage::Point, [](Run &run, const Variant &) { run.point += run.given.eyePosition; });
    list.add("eye-subtracted", Stage::Point, [](Run &run, const Variant &) { run.point -= run.given.eyePosition; });
    addAxes(list);
}

} // namespace unprojector::doctor
