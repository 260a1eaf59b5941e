#include "core/doctor/chance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace unprojector::doctor {
namespace {

/// The range of m. A larger m would include distant hypotheses, whose density differs.
constexpr std::size_t kFewest = 4, kMost = 64;

bool isSameMistakes(const Hypothesis &a, const Hypothesis &b)
{
    for (std::size_t i = 0; i < a.count; ++i) {
        if (a.parts[i]->mistake != b.parts[i]->mistake)
            return false;
    }
    return a.count == b.count;
}

} // namespace

double chanceOf(std::span<const Hypothesis> all, const Hypothesis &best, double within, int agreeing)
{
    std::vector<double> distances;
    distances.reserve(all.size());
    for (const Hypothesis &other : all) {
        if (other.count > best.count || other.isSolved() || isSameMistakes(other, best)
            || isSameAnswer(other.point, best.point))
            continue;
        distances.push_back(other.distance);
    }
    std::sort(distances.begin(), distances.end());
    double chance = 0.0;
    for (std::size_t m = kFewest; m <= std::min(kMost, distances.size()); m *= 2) {
        const double share = std::min(1.0, within / distances[m - 1]);
        chance = std::max(chance, double(m) * std::pow(share, agreeing));
    }
    return std::min(chance, 1.0);
}

double chanceOfSolved(const Hypothesis &best, std::size_t families, double apart, double within, int agreeing)
{
    const Variant &solved = *best.parts[0];
    const double share = std::min(1.0, 2.0 * within / apart);
    const int left = std::max(0, agreeing - solved.unknowns);
    return std::min(1.0, double(families) * solved.coincidence * std::pow(share, left));
}

} // namespace unprojector::doctor
