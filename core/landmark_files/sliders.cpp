#include "core/landmark_files/sliders.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace unprojector::landmark_files {
using namespace landmarks;
using namespace base;
namespace {

constexpr const char *kSuffix = ".sliders.csv";

/// The numbers of the points before and after a semilandmark, by the semilandmark's own.
using Neighbours = std::map<std::size_t, std::pair<std::size_t, std::size_t>>;

/// The points of a curve in a file, by their names: the landmark at an end that is left out, the
/// semilandmarks, the landmark at the other end.
std::vector<std::string> chainOf(const LandmarkSet &set, std::size_t index)
{
    const Curve &curve = set.curves[index];
    const CurvePart part = partOf(curve, set);
    std::vector<std::string> chain;
    if (part.before)
        chain.push_back(set.landmarks[*part.before].name);
    for (std::size_t i = part.begin; i < part.end; ++i)
        chain.push_back(semilandmarkName(nameOf(curve, index), i, curve.semilandmarks.size()));
    if (part.behind)
        chain.push_back(set.landmarks[*part.behind].name);
    return chain;
}

/// Adds the sliders of a specimen. Fails if the table lacks a point, or if an earlier specimen has other
/// sliders.
/// @param numbers  of the table's points by their names, from 1
void addSliders(Neighbours &sliders, const LandmarkSet &set, const std::map<std::string, std::size_t> &numbers)
{
    const auto numberOf = [&](const std::string &name) {
        const auto found = numbers.find(name);
        if (found == numbers.end())
            fail(0, tr("\"%1\" of \"%2\" is not in the table, so there are no sliders", name, set.name));
        return found->second;
    };
    for (std::size_t k = 0; k < set.curves.size(); ++k) {
        const std::vector<std::string> chain = chainOf(set, k);
        for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
            const std::pair neighbours(numberOf(chain[i - 1]), numberOf(chain[i + 1]));
            const auto known = sliders.emplace(numberOf(chain[i]), neighbours).first;
            if (known->second != neighbours)
                fail(0, tr("\"%1\" lies between other points on \"%2\" than on another specimen, so there are no "
                           "sliders for both",
                           chain[i], set.name));
        }
    }
}

} // namespace

std::vector<std::string> writtenNames(const LandmarkSet &set)
{
    Notes unused;
    const std::vector<LandmarkSet> plain = withCurvesAsPoints({&set, 1}, unused);
    std::vector<std::string> names;
    for (const Landmark &landmark : plain.front().landmarks)
        names.push_back(landmark.name);
    return names;
}

Expected<Sliders, Error> slidersOf(std::span<const LandmarkSet> sets, std::span<const std::string> names)
{
    return caught([&] {
        std::map<std::string, std::size_t> numbers;
        for (std::size_t i = 0; i < names.size(); ++i)
            numbers.emplace(names[i], i + 1);
        Neighbours sliders;
        for (const LandmarkSet &set : sets)
            addSliders(sliders, set, numbers);
        Sliders table{"before,slide,after\n", sliders.size()};
        for (const auto &[slide, neighbours] : sliders)
            table.text += std::to_string(neighbours.first) + ',' + std::to_string(slide) + ','
                          + std::to_string(neighbours.second) + '\n';
        return table;
    });
}

Expected<Sliders, Error> slidersOf(std::span<const LandmarkSet> sets)
{
    if (std::all_of(sets.begin(), sets.end(), [](const LandmarkSet &set) { return set.curves.empty(); }))
        return slidersOf(sets, {});
    const std::vector<std::string> names = writtenNames(sets.front());
    for (const LandmarkSet &set : sets) {
        if (writtenNames(set) != names)
            return Error{tr("\"%1\" and \"%2\" have different points, or the same in another order: their "
                            "semilandmarks have different numbers, so there are no sliders for both",
                            sets.front().name, set.name)};
    }
    return slidersOf(sets, names);
}

std::filesystem::path slidersBeside(const std::filesystem::path &table)
{
    std::filesystem::path file = table;
    file.replace_extension();
    file += kSuffix;
    return file;
}

bool isSlidersFile(const std::filesystem::path &file)
{
    return lowerCase(utf8FromPath(file.filename())).ends_with(kSuffix);
}

Expected<std::optional<std::filesystem::path>, Error> writeSlidersBeside(const std::filesystem::path &table,
                                                                         const Expected<Sliders, Error> &sliders)
{
    const std::filesystem::path file = slidersBeside(table);
    const auto write = [&] {
        if (!sliders)
            throw sliders.error();
        if (sliders->count == 0)
            return std::optional<std::filesystem::path>();
        if (const Done written = replaceFile(file, sliders->text); !written)
            throw written.error();
        return std::optional(file);
    };
    return caught(write, utf8FromPath(file));
}

} // namespace unprojector::landmark_files
