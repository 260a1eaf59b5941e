#include "core/doctor/ranking.h"

#include "core/doctor/mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace unprojector::doctor {
namespace {

/// 0: explains as rounded, 1: as cut off, 2: does not.
int tierOf(const Hypothesis &hypothesis)
{
    return hypothesis.worst <= kRounded ? 0 : hypothesis.worst <= kCutOff ? 1 : 2;
}

double reportsOf(const Hypothesis &hypothesis)
{
    double product = 1.0;
    for (std::size_t i = 0; i < hypothesis.count; ++i)
        product *= mistakes()[hypothesis.parts[i]->mistake].reports;
    return product;
}

/// The indices of mistakes, as a key.
using Key = std::array<std::size_t, 2>;
constexpr std::size_t kNone = ~std::size_t{0};

Key keyOf(const Hypothesis &hypothesis)
{
    Key key{kNone, kNone};
    for (std::size_t i = 0; i < hypothesis.count; ++i)
        key[i] = hypothesis.parts[i]->mistake;
    return key;
}

/// The groups of ranked(), the best first. The first two tiers have three groups each.
constexpr int kOfTier = 3, kExpected = 2 * kOfTier, kUnexpected = kExpected + 1, kOther = kExpected + 2;

int rankOf(const Hypothesis &hypothesis)
{
    const int tier = tierOf(hypothesis);
    if (tier == 2)
        return kOther;
    if (hypothesis.isSolved())
        return hypothesis.isExpected() ? kExpected : kUnexpected;
    return kOfTier * tier + int(hypothesis.count);
}

/// True if solved values are fewer, fit better or are rounder. Equal ones stay in their order: the
/// first are written with fewer digits.
bool isBetterSolved(const Hypothesis &a, const Hypothesis &b)
{
    const auto keyOfSolved = [](const Hypothesis &each) {
        const Variant &solved = *each.parts[0];
        return std::tuple(solved.unknowns, tierOf(each), solved.coincidence, -reportsOf(each));
    };
    return keyOfSolved(a) < keyOfSolved(b);
}

bool isBetter(const Hypothesis &a, const Hypothesis &b)
{
    const int rank = rankOf(a), rankB = rankOf(b);
    if (rank != rankB)
        return rank < rankB;
    if (a.isSolved() && b.isSolved())
        return isBetterSolved(a, b);
    if (tierOf(a) < 2) {
        if (const double reportsA = reportsOf(a), reportsB = reportsOf(b); reportsA != reportsB)
            return reportsA > reportsB;
    }
    return std::pair(a.distance, a.count) < std::pair(b.distance, b.count);
}

/// The range of m. A larger m would include distant hypotheses, whose density differs.
constexpr std::size_t kFewest = 4, kMost = 64;

/// Measures the chance near the point. Let m hypotheses lie within a distance R of it, evenly spread.
/// Then one of them comes as close as t with a chance of m (t / R)^k. The result is the greatest of
/// these for m = 4, 8, … 64. More complicated hypotheses than the best one and ones with its answer do
/// not count.
double chanceOfFixed(std::span<const Hypothesis> all, const Hypothesis &best, double within, int agreeing)
{
    std::vector<double> distances;
    distances.reserve(all.size());
    for (const Hypothesis &other : all) {
        if (other.count > best.count || other.isSolved() || keyOf(other) == keyOf(best)
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

/// Each value uses up one of the numbers that had to agree. For the others, an answer of the mistake
/// comes as close as t to a point at a distance D from the right one with a chance of (2 t / D)^k. The
/// roundness of the values is further evidence.
double chanceOfSolved(const Hypothesis &best, double apart, double within, int agreeing)
{
    constexpr std::size_t kClipPlanes = 2; // near and far, which have a fixed form besides
    const auto families = kClipPlanes
                          + std::size_t(std::count_if(mistakes().begin(), mistakes().end(),
                                                      [](const Mistake &mistake) { return mistake.isOnlySolved; }));
    const Variant &solved = *best.parts[0];
    const double share = std::min(1.0, 2.0 * within / apart);
    const int left = std::max(0, agreeing - solved.unknowns);
    return std::min(1.0, double(families) * solved.coincidence * std::pow(share, left));
}

} // namespace

std::string idOf(const Hypothesis &hypothesis)
{
    if (hypothesis.count == 0)
        return "right";
    const std::string id = mistakes()[hypothesis.parts[0]->mistake].id;
    return hypothesis.count == 1 ? id : id + '+' + mistakes()[hypothesis.parts[1]->mistake].id;
}

std::vector<Hypothesis> ranked(std::span<const Hypothesis> all)
{
    std::map<Key, const Hypothesis *> best;
    for (const Hypothesis &hypothesis : all) {
        const Hypothesis *&held = best[keyOf(hypothesis)];
        if (!held || isBetter(hypothesis, *held))
            held = &hypothesis;
    }
    const auto explainsAsWell = [&](const Key &key, int tier) {
        const auto found = best.find(key);
        return found != best.end() && tierOf(*found->second) < 2 && tierOf(*found->second) <= tier
               && rankOf(*found->second) != kUnexpected;
    };
    int tierOfFixedForm = 2;
    for (const Hypothesis &hypothesis : all) {
        if (hypothesis.count < 2 && !hypothesis.isSolved())
            tierOfFixedForm = std::min(tierOfFixedForm, tierOf(hypothesis));
    }
    int fewestValues = std::numeric_limits<int>::max();
    for (const Hypothesis &hypothesis : all) {
        if (hypothesis.isSolved() && tierOf(hypothesis) < 2)
            fewestValues = std::min(fewestValues, hypothesis.parts[0]->unknowns);
    }
    std::vector<Hypothesis> result;
    result.reserve(best.size());
    for (const auto &[key, hypothesis] : best) {
        const int tier = tierOf(*hypothesis);
        if (hypothesis->count == 2
            && (explainsAsWell({key[0], kNone}, tier) || explainsAsWell({key[1], kNone}, tier)
                || explainsAsWell({kNone, kNone}, tier)))
            continue;
        if (hypothesis->isSolved() && tierOfFixedForm < (hypothesis->isExpected() ? 1 : 2))
            continue;
        if (hypothesis->isSolved() && hypothesis->parts[0]->unknowns > fewestValues)
            continue;
        result.push_back(*hypothesis);
    }
    std::stable_sort(result.begin(), result.end(), isBetter);
    return result;
}

int digitsOf(double coordinate, double lastDigit)
{
    // Digits beyond a double's precision do not count.
    const double units = std::min(std::round(std::abs(coordinate) / lastDigit), 1e17);
    return units < 1.0 ? 1 : int(std::floor(std::log10(units) + 1e-9)) + 1;
}

int digitsExplained(double coordinate, double lastDigit, double off)
{
    const int given = digitsOf(coordinate, lastDigit);
    if (off <= kCutOff)
        return given;
    // An error of 5 units of a digit spoils the next digit too.
    const double lost = std::ceil(std::log10(2.0 * off));
    return lost >= given ? 0 : given - int(lost);
}

double chanceOf(const Evidence &evidence, const Hypothesis &best)
{
    const double within = best.worst <= kRounded ? kRounded : kCutOff;
    return best.isSolved() ? chanceOfSolved(best, evidence.apart, within, evidence.agreeing)
                           : chanceOfFixed(evidence.all, best, within, evidence.agreeing);
}

} // namespace unprojector::doctor
