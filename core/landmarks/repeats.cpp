#include "core/landmarks/repeats.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace unprojector::landmarks {

std::vector<RepeatedLandmark> repeatsOf(std::span<const LandmarkSet> placings)
{
    std::vector<RepeatedLandmark> repeats;
    std::vector<std::vector<glm::dvec3>> places;
    std::map<std::pair<std::string, std::size_t>, std::size_t> known; ///< a name and which of that name
    for (const LandmarkSet &placing : placings) {
        std::map<std::string, std::size_t> sameName;
        for (std::size_t i = 0; i < placing.landmarks.size(); ++i) {
            const Landmark &landmark = placing.landmarks[i];
            const std::string name = landmark.name.empty() ? std::to_string(i + 1) : landmark.name;
            const std::size_t number = ++sameName[name];
            const auto [at, isNew] = known.try_emplace({name, number}, repeats.size());
            if (isNew) {
                repeats.emplace_back().name = number > 1 ? name + " (" + std::to_string(number) + ')' : name;
                places.emplace_back();
            }
            if (landmark.world)
                places[at->second].push_back(landmark.world->coordinates());
        }
    }
    for (std::size_t i = 0; i < repeats.size(); ++i) {
        RepeatedLandmark &repeated = repeats[i];
        repeated.count = places[i].size();
        if (places[i].empty())
            continue;
        // About the first one: far from the origin the sum of many would lose digits.
        const glm::dvec3 first = places[i].front();
        const auto count = static_cast<double>(places[i].size());
        glm::dvec3 sum(0.0);
        for (const glm::dvec3 &place : places[i])
            sum += place - first;
        const glm::dvec3 mean = first + sum / count;
        double squares = 0.0;
        for (const glm::dvec3 &place : places[i]) {
            const double distance = glm::distance(place, mean);
            squares += distance * distance;
            repeated.farthest = std::max(repeated.farthest, distance);
        }
        repeated.mean = WorldPoint(mean);
        if (places[i].size() > 1)
            repeated.error = std::sqrt(squares / (count - 1.0));
    }
    return repeats;
}

} // namespace unprojector::landmarks
