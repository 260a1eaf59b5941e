#include "core/landmarks/point_template.h"

#include "core/landmarks/name_key.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace unprojector::landmarks {
namespace {

const Landmark *find(std::string_view name, std::span<const Landmark> names)
{
    const std::optional<std::size_t> found = indexOfName(names, name);
    return found ? &names[*found] : nullptr;
}

/// The nameKey; a name without one has only its own spelling.
std::string keyOrName(const std::string &name)
{
    std::string key = nameKey(name);
    return key.empty() ? name : key;
}

Landmark toPlaceOf(const Landmark &wanted)
{
    Landmark toPlace;
    toPlace.name = wanted.name;
    toPlace.color = wanted.color;
    return toPlace;
}

} // namespace

std::vector<Landmark> withTemplate(std::vector<Landmark> landmarks, std::span<const Landmark> names)
{
    std::map<std::string, std::size_t> spelled, there; // by name, and by its key without those spelled so
    for (const Landmark &landmark : landmarks) {
        ++spelled[landmark.name];
        ++there[keyOrName(landmark.name)];
    }
    std::vector<const Landmark *> others; // "a b" must not stand for "a_b" if that is there too
    for (const Landmark &wanted : names) {
        if (std::size_t &count = spelled[wanted.name]; count > 0) {
            --count;
            --there[keyOrName(wanted.name)];
        } else {
            others.push_back(&wanted);
        }
    }
    for (const Landmark *wanted : others) {
        if (std::size_t &count = there[keyOrName(wanted->name)]; count > 0)
            --count;
        else
            landmarks.push_back(toPlaceOf(*wanted));
    }
    return landmarks;
}

std::vector<Landmark> inTemplateOrder(std::vector<Landmark> landmarks, std::span<const Landmark> names)
{
    std::multimap<std::string, std::size_t> there; // landmarks of one name stay in their order
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        there.emplace(nameKey(landmarks[i].name), i);
    std::vector<Landmark> ordered;
    std::vector<bool> isTaken(landmarks.size(), false);
    for (const Landmark &wanted : names) {
        const auto range = there.equal_range(nameKey(wanted.name));
        if (range.first == range.second) {
            ordered.push_back(toPlaceOf(wanted));
            continue;
        }
        auto found = std::find_if(range.first, range.second, [&](const std::pair<const std::string, std::size_t> &one) {
            return landmarks[one.second].name == wanted.name;
        });
        if (found == range.second)
            found = range.first;
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
    if (!found || !found->extra.json().is_object())
        return {};
    const auto picture = found->extra.json().find(kPictureColumn);
    return picture != found->extra.json().end() && picture->is_string() ? picture->get_ref<const std::string &>()
                                                                        : std::string_view();
}

} // namespace unprojector::landmarks
