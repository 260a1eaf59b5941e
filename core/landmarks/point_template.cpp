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
        Landmark missing;
        missing.name = wanted.name;
        missing.color = wanted.color;
        landmarks.push_back(std::move(missing));
    }
    return landmarks;
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
