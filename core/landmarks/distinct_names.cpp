#include "core/landmarks/distinct_names.h"

#include "core/landmarks/name_key.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace unprojector::landmarks {
namespace {

/// Finds the spellings that count as an earlier one of the same nameKey, where no set has both, and
/// those that do not.
void findSpellings(std::span<const LandmarkSet> sets, DistinctNames &distinct)
{
    std::map<std::string, std::vector<std::string>> spellings; ///< by key, in order of first appearance
    std::map<std::string, KeptSpellings> kept;                 ///< by key
    std::set<std::string> single;                              ///< keys of which a set has one spelling
    for (std::size_t i = 0; i < sets.size(); ++i) {
        std::map<std::string, std::string> ofSet;
        std::set<std::string> keptHere;
        for (const Landmark &landmark : sets[i].landmarks) {
            const std::string key = nameKey(landmark.name);
            if (key.empty())
                continue;
            if (const std::string &first = ofSet.try_emplace(key, landmark.name).first->second;
                first != landmark.name) {
                kept.try_emplace(key, KeptSpellings{i, first, landmark.name});
                keptHere.insert(key);
            }
            std::vector<std::string> &known = spellings[key];
            if (std::find(known.begin(), known.end(), landmark.name) == known.end())
                known.push_back(landmark.name);
        }
        for (const auto &[key, name] : ofSet) {
            if (!keptHere.contains(key))
                single.insert(key);
        }
    }
    for (const auto &[key, names] : spellings) {
        for (std::size_t i = 1; i < names.size() && !kept.contains(key); ++i)
            distinct.respelled.emplace_back(names[i], names.front());
    }
    for (const auto &[key, both] : kept) {
        if (single.contains(key))
            distinct.kept.push_back(both);
    }
}

} // namespace

DistinctNames distinctNames(std::span<const LandmarkSet> sets)
{
    DistinctNames distinct;
    findSpellings(sets, distinct);
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
