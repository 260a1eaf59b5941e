#include "core/landmarks/point_template.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace unprojector::landmarks {
namespace {

/// The name with ASCII letters in lower case; other characters must match exactly.
std::string inLowerCase(std::string_view name)
{
    std::string lower(name);
    for (char &c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

const Landmark *find(std::string_view name, std::span<const Landmark> names)
{
    const std::string wanted = nameKey(name);
    auto found =
        std::find_if(names.begin(), names.end(), [&](const Landmark &landmark) { return landmark.name == name; });
    if (found == names.end() && !wanted.empty())
        found = std::find_if(names.begin(), names.end(),
                             [&](const Landmark &landmark) { return nameKey(landmark.name) == wanted; });
    return found != names.end() ? &*found : nullptr;
}

Landmark toPlaceOf(const Landmark &wanted)
{
    Landmark toPlace;
    toPlace.name = wanted.name;
    toPlace.color = wanted.color;
    return toPlace;
}

} // namespace

std::string nameKey(std::string_view name)
{
    constexpr std::string_view kWrittenOtherwise = " _#\"'\\\x7f";
    std::string key;
    bool isApart = false;
    for (const char c : inLowerCase(name)) {
        if (static_cast<unsigned char>(c) < ' ' || kWrittenOtherwise.find(c) != kWrittenOtherwise.npos) {
            isApart = !key.empty();
            continue;
        }
        if (std::exchange(isApart, false))
            key += '_';
        key += c;
    }
    return key;
}

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
        landmarks.push_back(toPlaceOf(wanted));
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
