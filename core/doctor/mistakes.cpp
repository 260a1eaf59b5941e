#include "core/doctor/mistakes.h"

#include "core/base/translation.h"
#include "core/doctor/solved_mistakes.h"
#include "core/doctor/variant_list.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

constexpr Mistake kMistakes[] = {
    {"y-not-flipped", 10},
    {"row-above", 6},
    {"pixel-corner", 6},
    {"ratio-logical-in-device", 18},
    {"ratio-logical-both", 18},
    {"ratio-device-in-logical", 18},
    {"viewport-origin-ignored", 18},
    {"flipped-with-viewport-height", 18},
    {"viewport-is-window", 18},
    {"aspect-integer", 9},
    {"aspect-inverted", 9},
    {"fov-degrees-as-radians", 9},
    {"fov-half", 9},
    {"fov-double", 9},
    {"fov-horizontal", 9},
    {"depth-not-remapped", 11},
    {"depth-remapped-twice", 11},
    {"depth-linear", 7},
    {"depth-zero", 11},
    {"depth-one", 11},
    {"depth-is-eye-distance", 7},
    {"depth-reversed", 5},
    {"depth-range-is-planes", 1},
    {"near-differs", 13},
    {"far-differs", 13},
    {"ray-length-as-z", 7},
    {"z-as-ray-length", 7},
    {"linear-angle", 1},
    {"no-w-divide", 4},
    {"projection-transposed", 11},
    {"view-transposed", 11},
    {"both-transposed", 11},
    {"product-transposed", 11},
    {"inverse-order", 11},
    {"not-inverted", 11},
    {"view-inverse-as-view", 11},
    {"view-left-out", 11},
    {"model-left-in", 3},
    {"model-left-out", 3},
    {"eye-added", 3},
    {"eye-z-positive", 3},
    {"eye-xy-mirrored", 3},
    {"xy-swapped", 3},
    {"ortho-formula", 13},
    {"divided-by-far", 13},
    {"overwritten-in-place", 11},
    {"viewport-y-from-top", 1},
    {"row-below", 1},
    {"aspect-of-window", 9},
    {"aspect-stale", 8},
    {"viewport-stale", 8},
    {"aspect-left-out", 1},
    {"fov-radians-as-degrees", 9},
    {"frustum-centred", 1},
    {"perspective-formula", 13},
    {"depth-of-another-row", 1},
    {"depth-rounded", 1},
    {"depth-range-ignored", 1},
    {"w-divided-twice", 4},
    {"projection-left-out", 1},
    {"eye-subtracted", 1},
    {"axes-differ", 3},
    {"opencv-axes", 8},
    {"camera-axes-differ", 1},
    {"translation-not-inverted", 3},
    {"quaternion-order", 3},
    {"euler-order", 1},
    {"euler-degrees", 1},
    {"focal-lengths-swapped", 1},
    {"centre-swapped", 1},
    {"intrinsics-of-another-size", 3},
    {"half-pixel-twice", 3},
    {"distortion-ignored", 8},
    {"distortion-added", 1},
    {"w-of-another-point", 1},
    {"y-is-depth", 1},
    {"pixel-in-size-minus-one", 1},
    {"focal-length-not-in-pixels", 1},
    {"fovy-differs", 9, true},
    {"box-size-differs", 9, true},
    {"pixel-shifted", 6, true},
    {"pixel-scaled-and-moved", 3, true},
    {"viewport-size-differs", 8, true},
    {"ratio-differs", 18, true},
    {"scaled", 3, true},
    {"depth-scaled", 1, true},
    {"near-far-differ", 13, true},
    {"principal-point-differs", 3, true},
    {"focal-lengths-differ", 3, true},
    {"frame-differs", 3, true},
};

} // namespace

std::span<const Mistake> mistakes()
{
    return kMistakes;
}

void VariantList::add(std::string_view id, Variant variant)
{
    const auto *place = std::find_if(std::begin(kMistakes), std::end(kMistakes),
                                     [&](const Mistake &mistake) { return mistake.id == id; });
    assert(place != std::end(kMistakes));
    variant.mistake = std::size_t(place - kMistakes);
    m_variants.push_back(std::move(variant));
}

void VariantList::add(std::string_view id, Stage stage, Apply apply, double parameter, VariantName name)
{
    Variant variant;
    variant.stage = stage;
    variant.apply = apply;
    variant.parameter = parameter;
    variant.name = std::move(name);
    add(id, std::move(variant));
}

void VariantList::add(std::string_view id, Stage stage, Apply apply, const Surface &size, VariantName name)
{
    add(id, stage, apply, double(size.widthPixels), std::move(name));
    m_variants.back().second = size.heightPixels;
}

void VariantList::addAlone(std::string_view id, Stage stage, Apply apply, VariantName name, double parameter,
                           double second)
{
    add(id, stage, apply, parameter, std::move(name));
    m_variants.back().second = second;
    m_variants.back().isAlone = true;
}

void VariantList::add(std::string_view id, Apply apply, const PlacedModel &model, bool isAlone)
{
    add(id, Stage::Point, apply, 0.0, {marked("of %1"), model.name});
    m_variants.back().matrix = model.worldFromObject.rounded();
    m_variants.back().isAlone = isAlone;
}

std::vector<Variant> VariantList::sorted() &&
{
    std::stable_sort(m_variants.begin(), m_variants.end(),
                     [](const Variant &a, const Variant &b) { return a.mistake < b.mistake; });
    return std::move(m_variants);
}

std::vector<Variant> variants(const Given &given, const Case &scene, std::span<const Target> points)
{
    VariantList list;
    addPixelMistakes(list, given, scene.otherSize);
    addDepthMistakes(list, given);
    addLensMistakes(list, given, scene.otherSize);
    addMatrixMistakes(list);
    addCameraMistakes(list, given, scene.otherSize);
    addPointMistakes(list, scene.models);
    if (!points.empty())
        addSolvedMistakes(list, given, scene, points);
    return std::move(list).sorted();
}

} // namespace unprojector::doctor
