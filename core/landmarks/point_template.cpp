#include "core/landmarks/point_template.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace unprojector::landmarks {
namespace {

/// Only of ASCII: what else there is has to be written the same.
std::string inLowerCase(std::string_view name)
{
    std::string lower(name);
    for (char &c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

const Landmark *find(std::string_view name, std::span<const Landmark> names)
{
    const std::string wanted = inLowerCase(name);
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&wanted](const Landmark &point) { return inLowerCase(point.name) == wanted; });
    return found != names.end() ? &*found : nullptr;
}

Landmark missingOf(const Landmark &wanted)
{
    Landmark missing;
    missing.name = wanted.name;
    missing.color = wanted.color;
    return missing;
}

} // namespace

std::vector<Landmark> withTemplate(std::vector<Landmark> landmarks, std::span<const Landmark> names)
{
    std::map<std::string, std::size_t> there;
    for (const Landmark &landmark : landmarks)
        ++there[inLowerCase(landmark.name)];
    for (const Landmark &wanted : names) {
        if (std::size_t &count = there[inLowerCase(wanted.name)]; count > 0) {
            --count;
            continue;
        }
        landmarks.push_back(missingOf(wanted));
    }
    return landmarks;
}

std::vector<Landmark> inTemplateOrder(std::vector<Landmark> landmarks, std::span<const Landmark> names)
{
    std::multimap<std::string, std::size_t> there; // those of one name in their order
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        there.emplace(inLowerCase(landmarks[i].name), i);
    std::vector<Landmark> ordered;
    std::vector<bool> isTaken(landmarks.size(), false);
    for (const Landmark &wanted : names) {
        const auto [found, end] = there.equal_range(inLowerCase(wanted.name));
        if (found == end) {
            ordered.push_back(missingOf(wanted));
            continue;
        }
        isTaken[found->second] = true;
        ordered.push_back(std::move(landmarks[found->second]));
        there.erase(found);
    }
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (!isTaken[i])
            ordered.push_back(std::move(landmarks[i]));
    }
    return ordered;
}

std::string_view hintFor(std::string_view name, std::span<const Landmark> names)
{
    const Landmark *found = find(name, names);
    return found ? std::string_view(found->note) : std::string_view();
}

std::string_view pictureFor(std::string_view name, std::span<const Landmark> names)
{
    const Landmark *found = find(name, names);
    if (!found || !found->extra.is_object())
        return {};
    const auto picture = found->extra.find(kPictureColumn);
    return picture != found->extra.end() && picture->is_string() ? picture->get_ref<const std::string &>()
                                                                 : std::string_view();
}

} // namespace unprojector::landmarks
