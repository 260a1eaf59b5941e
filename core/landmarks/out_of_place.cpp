#include "core/landmarks/out_of_place.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::landmarks {

namespace {

constexpr double kPooledCount = 4.0;
constexpr double kSwapBefore = 2.0, kSwapAfter = 2.0; // spreads
constexpr int kMostRounds = 8;

/// Medians of a landmark's positions with one or two specimens left out.
class MediansWithout {
public:
    /// @param points  the specimens' positions of the landmark; the empty ones count nowhere
    explicit MediansWithout(const std::vector<std::optional<glm::dvec3>> &points)
    {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<std::pair<double, std::size_t>> &sorted = m_sorted[std::size_t(axis)];
            for (std::size_t k = 0; k < points.size(); ++k) {
                if (points[k])
                    sorted.emplace_back((*points[k])[axis], k);
            }
            std::sort(sorted.begin(), sorted.end());
            std::vector<std::size_t> &rank = m_rank[std::size_t(axis)];
            rank.assign(points.size(), kNone);
            for (std::size_t i = 0; i < sorted.size(); ++i)
                rank[sorted[i].second] = i;
        }
    }
    /// @return empty if no other specimen has the landmark
    std::optional<glm::dvec3> without(std::size_t one, std::size_t other) const
    {
        glm::dvec3 median(0.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::size_t a = m_rank[axis][one], b = other == one ? kNone : m_rank[axis][other];
            if (b < a)
                std::swap(a, b);
            const std::size_t left = m_sorted[axis].size() - (a != kNone ? 1 : 0) - (b != kNone ? 1 : 0);
            if (left == 0)
                return std::nullopt;
            const auto at = [&](std::size_t rank) {
                rank += rank >= a ? 1 : 0;
                rank += rank >= b ? 1 : 0;
                return m_sorted[axis][rank].first;
            };
            median[int(axis)] = 0.5 * (at((left - 1) / 2) + at(left / 2));
        }
        return median;
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::array<std::vector<std::pair<double, std::size_t>>, 3> m_sorted; ///< value and specimen
    std::array<std::vector<std::size_t>, 3> m_rank;
};

double rootMeanSquareOf(const std::vector<double> &values)
{
    double squares = 0.0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Where the others put a landmark of a specimen, in the mean's space.
struct Expected {
    glm::dvec3 place{0.0};
    double spread = 0.0;
};
using ExpectedTable = std::vector<std::vector<std::optional<Expected>>>; ///< [specimen][landmark]

/// @param reference  the aligned specimens, without landmarks out of place
/// @param judged     the specimens; with all landmarks
/// @param isMedian   the spread comes from the median of the distances, not from their squares
ExpectedTable expectedOf(const std::vector<Configuration> &reference, const std::vector<Configuration> &judged,
                         bool isMedian)
{
    const std::size_t specimens = judged.size(), landmarks = specimens > 0 ? judged.front().size() : 0;
    ExpectedTable table(specimens, std::vector<std::optional<Expected>>(landmarks));
    for (std::size_t j = 0; j < landmarks; ++j) {
        std::vector<std::optional<glm::dvec3>> points(specimens);
        for (std::size_t k = 0; k < specimens; ++k)
            points[k] = reference[k][j];
        const MediansWithout medians(points);
        for (std::size_t i = 0; i < specimens; ++i) {
            const std::optional<glm::dvec3> place = judged[i][j] ? medians.without(i, i) : std::nullopt;
            std::vector<double> distances;
            for (std::size_t k = 0; place && k < specimens; ++k) {
                if (k == i || !points[k])
                    continue;
                if (const std::optional<glm::dvec3> center = medians.without(k, i))
                    distances.push_back(glm::distance(*points[k], *center));
            }
            if (distances.size() + 1 >= kFewestSpecimens)
                table[i][j] = Expected{*place, isMedian ? kSpreadPerMedian * medianOf(std::move(distances))
                                                        : rootMeanSquareOf(distances)};
        }
    }
    // The spread of few specimens is averaged with the usual one.
    for (std::size_t i = 0; i < specimens; ++i) {
        std::vector<double> spreads;
        for (const std::optional<Expected> &expected : table[i]) {
            if (expected)
                spreads.push_back(expected->spread);
        }
        if (spreads.empty())
            continue;
        const double usual = medianOf(spreads);
        for (std::size_t j = 0; j < landmarks; ++j) {
            if (!table[i][j])
                continue;
            double count = 0.0;
            for (std::size_t k = 0; k < specimens; ++k)
                count += k != i && reference[k][j] ? 1.0 : 0.0;
            double &spread = table[i][j]->spread;
            spread = std::sqrt((count * spread * spread + kPooledCount * usual * usual) / (count + kPooledCount));
            constexpr double kRounding = 1e-12; // of the mean's size, 1
            spread = std::max(spread, kRounding);
        }
    }
    return table;
}

double spreadsOff(const std::optional<glm::dvec3> &point, const Expected &expected)
{
    return glm::distance(*point, expected.place) / expected.spread;
}

Configuration withPairsSwapped(Configuration points, std::span<const Pair> pairs)
{
    for (const Pair &pair : pairs)
        std::swap(points[pair.left], points[pair.right]);
    return points;
}

/// How a specimen fits the others.
struct Fit {
    std::optional<Similarity> meanFromSpecimen;
    std::vector<bool> isOff; ///< for each landmark: it is out of place and has no part in the fit
    std::size_t offCount = 0;
    double unusual = 1.0; ///< factor of its spreads: 1.126 times the median of its distances, at least 1
    double median = 0.0;  ///< of the distances of its judged landmarks, in spreads
};

/// Takes the landmark farthest off from the fit, fits again, and so on until none is out of place.
/// Then a landmark that fits after all gets its part back.
Fit fitWithout(Fit fit, const Configuration &specimen, const Configuration &places,
               const std::vector<std::optional<Expected>> &expected)
{
    std::vector<double> weights(places.size(), 0.0), spreads(places.size(), 0.0);
    const std::size_t most = 2 * places.size();
    for (std::size_t step = 0; step < most; ++step) {
        for (std::size_t j = 0; j < places.size(); ++j)
            weights[j] = fit.isOff[j] ? 0.0 : 1.0;
        const std::optional<Similarity> similarity = similarityOf(specimen, places, Scaling::Sizes, weights);
        if (!similarity) // too few are left
            break;
        fit.meanFromSpecimen = similarity;
        // A specimen that differs from the others as a whole has larger spreads.
        std::vector<double> all;
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (places[j] && specimen[j])
                all.push_back(spreadsOff(similarity->mapped(*specimen[j]), *expected[j]));
        }
        fit.unusual = std::max(1.0, kSpreadPerMedian * medianOf(std::move(all)));
        std::size_t worst = places.size(), back = places.size();
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (!places[j] || !specimen[j])
                continue;
            spreads[j] = spreadsOff(similarity->mapped(*specimen[j]), *expected[j]) / fit.unusual;
            if (!fit.isOff[j] && spreads[j] > kSpreadsOutOfPlace
                && (worst == places.size() || spreads[j] > spreads[worst]))
                worst = j;
            if (fit.isOff[j] && spreads[j] <= kSpreadsOutOfPlace
                && (back == places.size() || spreads[j] < spreads[back]))
                back = j;
        }
        if (worst == places.size() && back == places.size())
            break;
        if (worst < places.size())
            fit.isOff[worst] = true;
        else
            fit.isOff[back] = false;
    }
    fit.offCount = static_cast<std::size_t>(std::count(fit.isOff.begin(), fit.isOff.end(), true));
    return fit;
}

/// Two ways of finding what is out of place: from all landmarks, and from those that a robust fit
/// keeps. The one that needs fewer landmarks out of place explains the specimen better.
Fit fitOf(const Configuration &specimen, const std::vector<std::optional<Expected>> &expected)
{
    Configuration places(expected.size());
    for (std::size_t j = 0; j < places.size(); ++j) {
        if (expected[j])
            places[j] = expected[j]->place;
    }
    Fit start;
    start.isOff.assign(places.size(), false);
    Fit fit = fitWithout(start, specimen, places, expected);
    if (const std::optional<Similarity> robust = robustSimilarityOf(specimen, places)) {
        for (std::size_t j = 0; j < places.size(); ++j)
            start.isOff[j] =
                places[j] && specimen[j] && spreadsOff(robust->mapped(*specimen[j]), *expected[j]) > kSpreadsOutOfPlace;
        Fit other = fitWithout(std::move(start), specimen, places, expected);
        if (other.meanFromSpecimen && (!fit.meanFromSpecimen || other.offCount < fit.offCount))
            fit = std::move(other);
    }
    return fit;
}

} // namespace

Deviations deviationsOf(std::span<const Configuration> specimens, std::span<const Pair> pairs)
{
    Deviations result;
    std::vector<Configuration> all(specimens.begin(), specimens.end());
    std::size_t landmarks = 0;
    for (const Configuration &points : all)
        landmarks = std::max(landmarks, points.size());
    // A landmark that few specimens have aligns none and judges none.
    std::vector<std::size_t> counts(landmarks, 0);
    for (Configuration &points : all) {
        points.resize(landmarks);
        for (std::size_t j = 0; j < landmarks; ++j)
            counts[j] += points[j] ? std::size_t(1) : 0;
    }
    for (std::size_t j = 0; j < landmarks; ++j) {
        if (counts[j] >= kFewestSpecimens)
            continue;
        if (counts[j] > 0)
            result.tooRare.push_back(j);
        for (Configuration &points : all)
            points[j].reset();
    }
    std::vector<Configuration> reference = all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto count =
            std::count_if(all[k].begin(), all[k].end(), [](const auto &point) { return point.has_value(); });
        if (static_cast<std::size_t>(count) < kFewestToAlign)
            reference[k].assign(landmarks, std::nullopt);
    }
    const std::vector<Configuration> usable = reference;
    std::vector<bool> isSwapped(all.size(), false); // all left and right landmarks
    std::vector<std::optional<Similarity>> fits(all.size());
    std::vector<Configuration> aligned(all.size(), Configuration(landmarks));
    ExpectedTable expected;
    for (int round = 0; round < kMostRounds; ++round) {
        const bool isFirst = round == 0;
        const Superimposition mean = superimposed(reference, isFirst ? Estimate::Robust : Estimate::LeastSquares);
        expected = expectedOf(mean.aligned, usable, isFirst);
        std::vector<Configuration> next = usable;
        for (std::size_t k = 0; k < all.size(); ++k) {
            Fit fit = fitOf(usable[k], expected[k]);
            if (!pairs.empty()) {
                Fit swapped = fitOf(withPairsSwapped(usable[k], pairs), expected[k]);
                isSwapped[k] = swapped.meanFromSpecimen && 2.0 * swapped.unusual < fit.unusual;
                if (isSwapped[k])
                    fit = std::move(swapped);
            }
            if (isSwapped[k])
                next[k] = withPairsSwapped(usable[k], pairs);
            fits[k] = fit.meanFromSpecimen;
            for (std::optional<Expected> &one : expected[k]) {
                if (one)
                    one->spread *= fit.unusual;
            }
            aligned[k] = fits[k] ? fits[k]->mapped(usable[k]) : Configuration(landmarks);
            for (std::size_t j = 0; j < landmarks; ++j) {
                if (fit.isOff[j])
                    next[k][j].reset();
            }
        }
        if (next == reference && !isFirst)
            break;
        reference = std::move(next);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool isAny =
            std::any_of(all[k].begin(), all[k].end(), [](const auto &point) { return point.has_value(); });
        if (isAny && !fits[k])
            result.notAligned.push_back(k);
        if (isSwapped[k])
            result.swappedSpecimens.push_back(k);
        std::vector<std::size_t> position(landmarks, 0);
        for (std::size_t j = 0; fits[k] && j < landmarks; ++j) {
            if (!aligned[k][j] || !expected[k][j])
                continue;
            const double unit = 1.0 / fits[k]->scale;
            Deviation deviation{k,
                                j,
                                unit * glm::distance(*aligned[k][j], expected[k][j]->place),
                                unit * expected[k][j]->spread,
                                false,
                                std::nullopt};
            deviation.isOutOfPlace = deviation.spreads() > kSpreadsOutOfPlace;
            position[j] = result.worstFirst.size();
            result.worstFirst.push_back(deviation);
        }
        const auto isJudged = [&](std::size_t j) { return fits[k] && aligned[k][j] && expected[k][j]; };
        for (std::size_t a = 0; a < landmarks; ++a) {
            for (std::size_t b = a + 1; b < landmarks && isJudged(a); ++b) {
                if (!isJudged(b))
                    continue;
                Deviation &one = result.worstFirst[position[a]], &other = result.worstFirst[position[b]];
                if (std::min(one.spreads(), other.spreads()) > kSwapBefore
                    && spreadsOff(aligned[k][a], *expected[k][b]) < kSwapAfter
                    && spreadsOff(aligned[k][b], *expected[k][a]) < kSwapAfter) {
                    one.isOutOfPlace = other.isOutOfPlace = true;
                    one.swappedWith = b;
                    other.swappedWith = a;
                }
            }
        }
    }
    std::stable_sort(result.worstFirst.begin(), result.worstFirst.end(),
                     [](const Deviation &a, const Deviation &b) { return a.spreads() > b.spreads(); });
    return result;
}

} // namespace unprojector::landmarks
