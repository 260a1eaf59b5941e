#include "core/doctor/solved_mistakes.h"

#include <algorithm>
#include <utility>

namespace unprojector::doctor {

Variant &VariantList::add(std::string_view id, Variant variant)
{
    variant.mistake = std::size_t(&mistakeOf(id) - mistakes().data());
    return all.emplace_back(std::move(variant));
}

Variant &VariantList::add(std::string_view id, Stage stage, Apply apply, VariantName name, double parameter,
                          double second)
{
    return add(
        id, Variant{.stage = stage, .apply = apply, .parameter = parameter, .second = second, .name = std::move(name)});
}

std::vector<Variant> variants(const Given &given, const Case &scene, bool hasSolved)
{
    VariantList list;
    for (const auto add : {addPixelMistakes, addDepthMistakes, addLensMistakes, addMatrixMistakes, addCameraMistakes})
        add(list, given, scene);
    if (hasSolved) {
        addSolvedFromOne(list, given, scene);
        addSolvedFromSeveral(list, given);
    }
    std::stable_sort(list.all.begin(), list.all.end(),
                     [](const Variant &a, const Variant &b) { return a.mistake < b.mistake; });
    return std::move(list.all);
}

} // namespace unprojector::doctor
