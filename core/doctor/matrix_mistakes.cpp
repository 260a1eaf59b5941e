#include "core/base/translation.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/variants.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace unprojector::doctor {
using base::marked;
namespace {

struct NamedAxes {
    std::string_view axes;
    const char *words, *sentence;
};
constexpr NamedAxes kUsualAxes[] = {
    {"x,-z,y", marked("%1: z up given for y up"), marked("Your program's axes are %1: z is up in place of y.")},
    {"x,z,-y", marked("%1: y up given for z up"), marked("Your program's axes are %1: y is up in place of z.")},
    {"x,z,y", marked("%1: y and z exchanged"), marked("Your program's axes are %1: y and z are exchanged.")},
};
constexpr NamedAxes kOpenCvAxes{"x,-y,-z", marked("%1: OpenCV's axes for OpenGL's, or the reverse"),
                                marked("Your program's axes are %1: OpenCV's in place of OpenGL's, or the reverse.")};
constexpr NamedAxes kMirroredAxes{{}, marked("%1, mirrored"), marked("Your program's axes are %1: a mirror image.")};
constexpr NamedAxes kOtherAxes{{}, nullptr, marked("Your program's axes are %1.")};

void addAxes(VariantList &list)
{
    for (const auto &[matrix, axes] : axisPermutations().subspan(1)) {
        const auto *usual = std::find_if(std::begin(kUsualAxes), std::end(kUsualAxes),
                                         [&axes = axes](const NamedAxes &each) { return each.axes == axes; });
        const bool isUsual = usual != std::end(kUsualAxes);
        const NamedAxes &named = isUsual                          ? *usual
                                 : axes == kOpenCvAxes.axes       ? kOpenCvAxes
                                 : glm::determinant(matrix) < 0.0 ? kMirroredAxes
                                                                  : kOtherAxes;
        list.add("axes-differ", Variant{.stage = Stage::Point,
                                        .apply = [](Run &run) { run.point = transformed(*run.matrix, run.point); },
                                        .matrix = glm::dmat4(matrix),
                                        .name = {named.words, {axes}, named.sentence},
                                        .values = {{"axes", {}, axes}},
                                        .isAlone = !isUsual});
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
/// The run's parameter is the index of the end.
void mixEnds(Run &run)
{
    run.isLost = run.isLost || run.isClosedForm;
    const std::array<glm::dvec4, 2> ends = undividedEnds(run);
    const glm::dvec4 &own = ends[std::size_t(run.parameter)], &other = ends[1 - std::size_t(run.parameter)];
    run.point = glm::dvec3(own.x, own.y, other.z) / own.w;
}

void addModel(VariantList &list, std::string_view id, VariantList::Apply apply, const PlacedModel &model, bool isAlone)
{
    Variant &variant = list.add(id, Stage::Point, apply, {marked("of %1"), {model.name}});
    variant.matrix = model.worldFromObject.rounded();
    variant.isAlone = isAlone;
}

void addPointMistakes(VariantList &list, std::span<const PlacedModel> models)
{
    constexpr std::size_t kMostInPairs = 200; // the pairs, and their memory, grow with the square
    for (std::size_t i = 0; i < models.size(); ++i) {
        const bool isAlone = i >= kMostInPairs;
        addModel(
            list, "model-left-in", [](Run &run) { run.point = transformed(glm::inverse(*run.matrix), run.point); },
            models[i], isAlone);
        addModel(
            list, "model-left-out", [](Run &run) { run.point = transformed(*run.matrix, run.point); }, models[i],
            isAlone);
    }
    list.add("eye-added", Stage::Point, [](Run &run) { run.point += run.given.eyePosition; });
    list.add("eye-subtracted", Stage::Point, [](Run &run) { run.point -= run.given.eyePosition; });
    addAxes(list);
    for (const auto &[end, words] : {std::pair(1.0, marked("z of the near end with the far end's w")),
                                     std::pair(0.0, marked("z of the far end with the near end's w"))})
        list.add("w-of-another-point", Stage::Point, mixEnds, words, end).isAlone = true;
}

} // namespace

void addMatrixMistakes(VariantList &list, const Given &, const Case &scene)
{
    list.add("projection-transposed", Stage::Factors,
             [](Run &run) { run.clipFromEye = glm::transpose(run.clipFromEye); });
    list.add("view-transposed", Stage::Factors, [](Run &run) { run.eyeFromWorld = glm::transpose(run.eyeFromWorld); });
    list.add("both-transposed", Stage::Factors, [](Run &run) {
        run.clipFromEye = glm::transpose(run.clipFromEye);
        run.eyeFromWorld = glm::transpose(run.eyeFromWorld);
    });
    list.add("view-inverse-as-view", Stage::Factors,
             [](Run &run) { run.eyeFromWorld = glm::inverse(run.eyeFromWorld); });
    list.add("view-left-out", Stage::Factors, [](Run &run) { run.eyeFromWorld = glm::dmat4(1.0); });
    list.add("projection-left-out", Stage::Factors, [](Run &run) { run.clipFromEye = glm::dmat4(1.0); });
    list.add("product-transposed", Stage::Product, [](Run &run) { run.order = Run::Order::InverseOfTransposed; });
    list.add("inverse-order", Stage::Product, [](Run &run) { run.order = Run::Order::InversesInTheOrderOfTheFactors; });
    list.add("not-inverted", Stage::Product, [](Run &run) { run.order = Run::Order::NotInverted; });
    list.add("overwritten-in-place", Stage::Divide, [](Run &run) { run.isInPlace = true; });
    list.add("no-w-divide", Stage::Divide, [](Run &run) { run.divisions = 0; });
    list.add("w-divided-twice", Stage::Divide, [](Run &run) { run.divisions = 2; });
    addPointMistakes(list, scene.models);
}

} // namespace unprojector::doctor
