#include "core/landmarks/distinct_names.h"

#include <map>
#include <set>
#include <utility>

namespace unprojector::landmarks {

DistinctNames distinctNames(std::span<const LandmarkSet> sets)
{
    std::set<std::string> taken;
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks)
            taken.insert(landmark.name);
    }
    DistinctNames distinct;
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
            const std::string &name = set.landmarks[i].name;
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
