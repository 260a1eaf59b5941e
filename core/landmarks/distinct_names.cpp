#include "core/landmarks/distinct_names.h"

#include "core/landmarks/point_template.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace unprojector::landmarks {
namespace {

/// Spellings that count as an earlier one of the same nameKey: no set has both.
std::vector<std::pair<std::string, std::string>> respelledIn(std::span<const LandmarkSet> sets)
{
    std::map<std::string, std::vector<std::string>> spellings; ///< by key, in order of first appearance
    std::set<std::string> ambiguous;                           ///< keys
    for (const LandmarkSet &set : sets) {
        std::map<std::string, std::string> ofSet;
        for (const Landmark &landmark : set.landmarks) {
            const std::string key = nameKey(landmark.name);
            if (key.empty())
                continue;
            if (ofSet.try_emplace(key, landmark.name).first->second != landmark.name)
                ambiguous.insert(key);
            std::vector<std::string> &known = spellings[key];
            if (std::find(known.begin(), known.end(), landmark.name) == known.end())
                known.push_back(landmark.name);
        }
    }
    std::vector<std::pair<std::string, std::string>> respelled;
    for (const auto &[key, names] : spellings) {
        for (std::size_t i = 1; i < names.size() && !ambiguous.contains(key); ++i)
            respelled.emplace_back(names[i], names.front());
    }
    return respelled;
}

} // namespace

DistinctNames distinctNames(std::span<const LandmarkSet> sets)
{
    DistinctNames distinct;
    distinct.respelled = respelledIn(sets);
    const std::map<std::string, std::string> respelled(distinct.respelled.begin(), distinct.respelled.end());
    std::set<std::string> taken;
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks)
            taken.insert(landmark.name);
    }
    std::map<std::pair<std::string, std::size_t>, std::size_t> known; ///< key: a name and its occurrence
    std::map<std::string, std::size_t> next;                          ///< next number for a name that was used before
    const auto freeName = [&](const std::string &name) {
        std::size_t &number = next.try_emplace(name, 2).first->second;
        std::string candidate;
        do
            candidate = name + " (" + std::to_string(number++) + ')';
        while (!taken.insert(candidate).second);
        return candidate;
    };
    for (const LandmarkSet &set : sets) {
        std::vector<std::size_t> &indices = distinct.places.emplace_back();
        std::map<std::string, std::size_t> counts;
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            const auto other = respelled.find(set.landmarks[i].name);
            const std::string &name = other != respelled.end() ? other->second : set.landmarks[i].name;
            const std::size_t number = name.empty() ? i + 1 : ++counts[name];
            const auto [place, isNew] = known.try_emplace({name, number}, distinct.names.size());
            if (isNew) {
                const std::string shown = name.empty() ? std::to_string(number) : name;
                const bool isFree = name.empty() ? taken.insert(shown).second : number == 1;
                distinct.names.push_back(isFree ? shown : freeName(shown));
            }
            indices.push_back(place->second);
        }
    }
    return distinct;
}

} // namespace unprojector::landmarks
