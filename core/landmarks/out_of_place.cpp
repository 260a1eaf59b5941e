#include "core/landmarks/out_of_place.h"

#include "core/landmarks/shape_variation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::landmarks {

namespace {

constexpr double kPooledCount = 8.0;
constexpr double kSwapBefore = 2.0, kSwapAfter = kSpreadsOutOfPlace; // spreads
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

/// One way to judge a specimen.
struct Judgement {
    ShapeVariation variation;
    std::vector<double> spreads; ///< for each landmark; 0: it cannot be judged
};

/// What the other specimens tell about one, in the mean's space.
struct Usual {
    Configuration places;
    Judgement alone;    ///< each landmark alone, against its place
    Judgement together; ///< each landmark against what the specimen's other landmarks predict
};

/// The aligned specimens without landmarks out of place, seen from one or two specimens fewer.
class Reference {
public:
    Reference(const std::vector<Configuration> &aligned, const Configuration &mean)
        : m_aligned(aligned), m_smooth(smoothFunctionsOver(mean))
    {
        std::vector<std::optional<glm::dvec3>> points(aligned.size());
        for (std::size_t j = 0; j < mean.size(); ++j) {
            for (std::size_t k = 0; k < aligned.size(); ++k)
                points[k] = aligned[k][j];
            m_medians.emplace_back(points);
        }
    }

    Configuration placesWithout(std::size_t i) const
    {
        Configuration places;
        for (const MediansWithout &medians : m_medians)
            places.push_back(medians.without(i, i));
        return places;
    }
    /// The offsets of a specimen from the medians without two others.
    Offsets offsetsOf(std::size_t specimen, std::size_t one, std::size_t other) const
    {
        Offsets offsets(m_medians.size());
        for (std::size_t j = 0; j < offsets.size(); ++j) {
            const std::optional<glm::dvec3> &point = m_aligned[specimen][j];
            if (const auto place = point ? m_medians[j].without(one, other) : std::nullopt)
                offsets[j] = *point - *place;
        }
        return offsets;
    }
    ShapeVariation variationWithout(std::size_t one, std::size_t other, const VarianceShares &shares) const
    {
        if (shares.own >= 1.0)
            return {};
        std::vector<Offsets> others;
        for (std::size_t k = 0; k < m_aligned.size(); ++k) {
            if (k != one && k != other)
                others.push_back(offsetsOf(k, one, other));
        }
        return ShapeVariation(others, m_smooth, shares);
    }
    /// What a specimen's landmarks leave unexplained, if it and another one have no part in the
    /// rest.
    Offsets restsOf(std::size_t specimen, std::size_t other, const VarianceShares &shares) const
    {
        return variationWithout(specimen, other, shares)
            .rests(offsetsOf(specimen, specimen, other), std::vector<bool>(m_medians.size(), false));
    }
    std::vector<Offsets> allRests(const VarianceShares &shares) const
    {
        std::vector<Offsets> all;
        for (std::size_t k = 0; k < m_aligned.size(); ++k)
            all.push_back(restsOf(k, k, shares));
        return all;
    }
    /// The shares with which landmarks predict each other best: cross-validation over all
    /// specimens.
    VarianceShares bestShares() const
    {
        constexpr std::size_t kMostForSmooth = 20; // more specimens show themselves what varies together
        VarianceShares best;
        double least = std::numeric_limits<double>::infinity();
        for (const double own : {1.0, 0.7, 0.4, 0.2, 0.1, 0.05}) {
            for (const double smooth : {0.0, 0.5, 1.0}) {
                if (smooth > 0.0 && (own >= 1.0 || m_aligned.size() > kMostForSmooth))
                    continue;
                const VarianceShares shares{own, smooth * (1.0 - own)};
                std::vector<double> lengths;
                for (const Offsets &rests : allRests(shares)) {
                    for (const std::optional<glm::dvec3> &rest : rests) {
                        if (rest)
                            lengths.push_back(glm::length(*rest));
                    }
                }
                const double typical = lengths.empty() ? 0.0 : medianOf(std::move(lengths));
                if (typical < least) {
                    least = typical;
                    best = shares;
                }
            }
        }
        return best;
    }

private:
    const std::vector<Configuration> &m_aligned;
    std::vector<std::vector<double>> m_smooth;
    std::vector<MediansWithout> m_medians;
};

/// The spread of each landmark of specimen i, from the others' rests.
/// @param isMedian  from the median of the rests, not from their squares
std::vector<double> spreadsOf(std::size_t i, const std::vector<Offsets> &rests, bool isMedian)
{
    const std::size_t landmarks = rests[i].size();
    std::vector<double> spreads(landmarks, 0.0), counts(landmarks, 0.0), known;
    for (std::size_t j = 0; j < landmarks; ++j) {
        std::vector<double> lengths;
        for (std::size_t k = 0; k < rests.size(); ++k) {
            if (k != i && rests[k][j])
                lengths.push_back(glm::length(*rests[k][j]));
        }
        counts[j] = static_cast<double>(lengths.size());
        if (lengths.size() + 1 >= kFewestSpecimens) {
            spreads[j] = isMedian ? kSpreadPerMedian * medianOf(std::move(lengths)) : rootMeanSquareOf(lengths);
            known.push_back(spreads[j]);
        }
    }
    if (known.empty())
        return spreads;
    // The spread of few specimens is averaged with the usual one.
    const double usual = medianOf(known);
    for (std::size_t j = 0; j < landmarks; ++j) {
        if (counts[j] + 1.0 < double(kFewestSpecimens))
            continue;
        const double squares = counts[j] * spreads[j] * spreads[j] + kPooledCount * usual * usual;
        constexpr double kRounding = 1e-12; // of the mean's size, 1
        spreads[j] = std::max(std::sqrt(squares / (counts[j] + kPooledCount)), kRounding);
    }
    return spreads;
}

/// @param shares  of the variance, for the judgement of landmarks together
std::vector<Usual> usualOf(const Reference &reference, std::size_t specimens, const VarianceShares &shares,
                           bool isMedian)
{
    // Among few specimens, one out of place would hide in the others' spreads.
    constexpr std::size_t kFew = 8;
    const std::vector<Offsets> all = reference.allRests(shares);
    std::vector<Usual> usual(specimens);
    for (std::size_t i = 0; i < specimens; ++i) {
        std::vector<Offsets> alone(specimens), together = all;
        for (std::size_t k = 0; k < specimens; ++k) {
            alone[k] = reference.offsetsOf(k, k, i);
            if (specimens <= kFew)
                together[k] = reference.restsOf(k, i, shares);
        }
        usual[i].places = reference.placesWithout(i);
        usual[i].alone.spreads = spreadsOf(i, alone, isMedian);
        usual[i].together = {reference.variationWithout(i, i, shares), spreadsOf(i, together, isMedian)};
        for (std::size_t j = 0; j < usual[i].places.size(); ++j) {
            if (!(usual[i].alone.spreads[j] > 0.0 && usual[i].together.spreads[j] > 0.0))
                usual[i].places[j].reset();
        }
    }
    return usual;
}

/// How a specimen fits the others.
struct Fit {
    std::optional<Similarity> meanFromSpecimen;
    std::vector<bool> isOff; ///< for each landmark: it is out of place and has no part in the fit
    std::size_t offCount = 0;
    double unusual = 1.0;   ///< factor of its spreads: 1.126 times the median of its distances, at least 1
    Configuration expected; ///< where its landmarks should be, in the mean's space
    /// The sum of log(1 + r^2) over all landmarks, r spreads off: Cauchy's log likelihood. A landmark far off
    /// counts little more than one off, wherever it is.
    double mismatch = std::numeric_limits<double>::infinity();
};

/// Takes the landmark farthest off from the fit, fits again, and so on until none is out of place.
/// Then a landmark that fits after all gets its part back.
Fit fitWithout(Fit fit, const Configuration &specimen, const Configuration &places, const Judgement &judgement)
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
        Offsets offsets(places.size());
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (places[j] && specimen[j])
                offsets[j] = similarity->mapped(*specimen[j]) - *places[j];
        }
        const Offsets rests = judgement.variation.rests(offsets, fit.isOff);
        // A specimen that differs from the others as a whole has larger spreads.
        std::vector<double> all;
        fit.mismatch = 0.0;
        fit.expected.assign(places.size(), std::nullopt);
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (!offsets[j])
                continue;
            spreads[j] = glm::length(*rests[j]) / judgement.spreads[j];
            all.push_back(spreads[j]);
            fit.mismatch += std::log1p(spreads[j] * spreads[j]);
            fit.expected[j] = *places[j] + *offsets[j] - *rests[j];
        }
        fit.unusual = std::max(1.0, kSpreadPerMedian * medianOf(std::move(all)));
        std::size_t worst = places.size(), back = places.size();
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (!offsets[j])
                continue;
            spreads[j] /= fit.unusual;
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
/// keeps. The one that needs fewer landmarks out of place explains the specimen better. Each
/// landmark counts alone here, so that one far off spoils no prediction.
Fit fitAlone(const Configuration &specimen, const Usual &usual)
{
    const Configuration &places = usual.places;
    Fit start;
    start.isOff.assign(places.size(), false);
    Fit fit = fitWithout(start, specimen, places, usual.alone);
    if (const std::optional<Similarity> robust = robustSimilarityOf(specimen, places)) {
        for (std::size_t j = 0; j < places.size(); ++j)
            start.isOff[j] = places[j] && specimen[j]
                             && glm::distance(robust->mapped(*specimen[j]), *places[j])
                                    > kSpreadsOutOfPlace * usual.alone.spreads[j];
        Fit other = fitWithout(std::move(start), specimen, places, usual.alone);
        if (other.meanFromSpecimen && (!fit.meanFromSpecimen || other.offCount < fit.offCount))
            fit = std::move(other);
    }
    return fit;
}

/// A specimen with the left and right landmarks of some pairs exchanged, and how it fits then.
struct Exchange {
    std::vector<bool> isExchanged; ///< for each pair
    Configuration specimen;
    Fit fit;
    double cost = std::numeric_limits<double>::infinity(); ///< its mismatch, and what its exchanges cost
};

/// Finds the pairs of left and right landmarks to exchange, so that a specimen fits the others. A pair at
/// the outside turns the whole specimen, so each pair is tried with an alignment of its own. The search starts
/// with none and with all, and exchanges the pair that lessens the cost most, until none does. Every exchange
/// has its price. All at once are one mistake, but they have to explain more than a pair: they cost like two.
class ExchangeSearch {
public:
    /// @param pairs  those that the specimen and the others have
    /// @param isCancelled  ends the search early
    ExchangeSearch(const Configuration &specimen, const Usual &usual, std::span<const Pair> pairs,
                   const std::function<bool()> &isCancelled)
        : m_specimen(specimen), m_usual(usual), m_pairs(pairs), m_isCancelled(isCancelled)
    {
    }

    void run()
    {
        const Exchange none = exchanged(std::vector<bool>(m_pairs.size(), false));
        m_best = none;
        // An exchange puts two landmarks out of place, or turns the whole specimen, which makes it unusual.
        constexpr double kUsual = 1.2;
        if (m_pairs.empty() || (none.fit.offCount == 0 && none.fit.unusual < kUsual))
            return;
        descend(none);
        if (m_pairs.size() < 2)
            return;
        const Exchange all = exchanged(std::vector<bool>(m_pairs.size(), true));
        take(all);
        if (all.fit.mismatch < none.fit.mismatch)
            descend(all);
    }
    Exchange &best() { return m_best; }
    /// True if other exchanges explain the specimen nearly as well, so that the data cannot tell which ones were made.
    bool isUndecided() const { return isAny(m_best.isExchanged) && m_next - m_best.cost < kDecided; }

private:
    static constexpr double kPrice = 3.0;   ///< of a pair; in log likelihood
    static constexpr double kDecided = 1.5; ///< in log likelihood

    static bool isAny(const std::vector<bool> &flags)
    {
        return std::find(flags.begin(), flags.end(), true) != flags.end();
    }

    Exchange exchanged(std::vector<bool> isExchanged)
    {
        Exchange exchange{std::move(isExchanged), m_specimen, {}, {}};
        double count = 0.0;
        for (std::size_t i = 0; i < m_pairs.size(); ++i) {
            if (exchange.isExchanged[i]) {
                std::swap(exchange.specimen[m_pairs[i].left], exchange.specimen[m_pairs[i].right]);
                count += 1.0;
            }
        }
        exchange.fit = fitAlone(exchange.specimen, m_usual);
        if (count == static_cast<double>(m_pairs.size()))
            count = std::min(count, 2.0);
        exchange.cost = exchange.fit.mismatch + kPrice * count;
        return exchange;
    }
    void take(const Exchange &exchange)
    {
        if (exchange.isExchanged == m_best.isExchanged)
            return;
        m_next = std::min(m_next, std::max(exchange.cost, m_best.cost));
        if (exchange.cost < m_best.cost)
            m_best = exchange;
    }
    void descend(Exchange here)
    {
        for (bool isBetter = true; isBetter;) {
            isBetter = false;
            const std::vector<bool> from = here.isExchanged;
            for (std::size_t i = 0; i < m_pairs.size() && !m_isCancelled(); ++i) {
                std::vector<bool> flipped = from;
                flipped[i] = !flipped[i];
                Exchange other = exchanged(std::move(flipped));
                take(other);
                if (other.cost < here.cost) {
                    here = std::move(other);
                    isBetter = true;
                }
            }
        }
    }

    const Configuration &m_specimen;
    const Usual &m_usual;
    std::span<const Pair> m_pairs;
    const std::function<bool()> &m_isCancelled;
    Exchange m_best;
    double m_next = std::numeric_limits<double>::infinity(); ///< the least cost of other exchanges than the best
};

} // namespace

Deviations deviationsOf(std::span<const Configuration> specimens, std::span<const Pair> pairs,
                        const std::function<bool()> &isCancelled)
{
    const std::function<bool()> isEnded = isCancelled ? isCancelled : [] { return false; };
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
    for (Configuration &points : reference) {
        if (placedCount(points) < kFewestToAlign)
            points.assign(landmarks, std::nullopt);
    }
    const std::vector<Configuration> usable = reference;
    std::vector<bool> isSwapped(all.size(), false); // all left and right landmarks
    std::vector<bool> isUndecided(all.size(), false);
    std::vector<Fit> fits(all.size());
    std::vector<std::vector<bool>> wasOff(all.size(), std::vector<bool>(landmarks, false)); // in the round before
    std::vector<Configuration> aligned(all.size(), Configuration(landmarks));
    std::vector<Usual> usual;
    VarianceShares shares;
    for (int round = 0; round < kMostRounds; ++round) {
        const bool isFirst = round == 0;
        const Superimposition mean = superimposed(reference, isFirst ? Estimate::Robust : Estimate::LeastSquares);
        const Reference others(mean.aligned, mean.mean);
        if (round == 1) // what is far out of place is left out by now
            shares = others.bestShares();
        usual = usualOf(others, all.size(), shares, isFirst);
        std::vector<Configuration> next = usable;
        for (std::size_t k = 0; k < all.size(); ++k) {
            std::vector<Pair> present;
            for (const Pair &pair : pairs) {
                const auto isJudged = [&](std::size_t j) { return usable[k][j] && usual[k].places[j]; };
                if (isJudged(pair.left) && isJudged(pair.right))
                    present.push_back(pair);
            }
            ExchangeSearch search(usable[k], usual[k], present, isEnded);
            search.run();
            if (isEnded())
                return {};
            const std::vector<bool> &flags = search.best().isExchanged;
            isUndecided[k] = search.isUndecided();
            isSwapped[k] =
                !isUndecided[k] && flags.size() > 1 && std::find(flags.begin(), flags.end(), false) == flags.end();
            Fit fit = std::move(search.best().fit);
            next[k] = std::move(search.best().specimen);
            if (fit.meanFromSpecimen)
                fit = fitWithout(std::move(fit), next[k], usual[k].places, usual[k].together);
            aligned[k] = fit.meanFromSpecimen ? fit.meanFromSpecimen->mapped(usable[k]) : Configuration(landmarks);
            for (std::size_t j = 0; j < landmarks; ++j) {
                // Otherwise two mistakes of a landmark could hide each other in turns.
                if (fit.isOff[j] || wasOff[k][j])
                    next[k][j].reset();
            }
            wasOff[k] = fit.isOff;
            fits[k] = std::move(fit);
        }
        if (next == reference && !isFirst)
            break;
        reference = std::move(next);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Fit &fit = fits[k];
        if (placedCount(all[k]) > 0 && !fit.meanFromSpecimen)
            result.notAligned.push_back(k);
        if (isSwapped[k])
            result.swappedSpecimens.push_back(k);
        if (isUndecided[k])
            result.undecidedSpecimens.push_back(k);
        std::vector<std::size_t> position(landmarks, 0);
        const auto isJudged = [&](std::size_t j) { return fit.meanFromSpecimen && aligned[k][j] && fit.expected[j]; };
        const auto spread = [&](std::size_t j) { return fit.unusual * usual[k].together.spreads[j]; };
        const auto spreadsOff = [&](std::size_t j, std::size_t place) {
            return glm::distance(*aligned[k][j], *fit.expected[place]) / spread(place);
        };
        for (std::size_t j = 0; j < landmarks; ++j) {
            if (!isJudged(j))
                continue;
            const double unit = 1.0 / fit.meanFromSpecimen->scale;
            Deviation deviation{
                k, j, unit * glm::distance(*aligned[k][j], *fit.expected[j]), unit * spread(j), false, std::nullopt};
            deviation.isOutOfPlace = deviation.spreads() > kSpreadsOutOfPlace;
            position[j] = result.worstFirst.size();
            result.worstFirst.push_back(deviation);
        }
        for (std::size_t a = 0; a < landmarks; ++a) {
            for (std::size_t b = a + 1; b < landmarks && isJudged(a); ++b) {
                if (!isJudged(b))
                    continue;
                Deviation &one = result.worstFirst[position[a]], &other = result.worstFirst[position[b]];
                if (std::min(one.spreads(), other.spreads()) > kSwapBefore && spreadsOff(a, b) < kSwapAfter
                    && spreadsOff(b, a) < kSwapAfter) {
                    one.isOutOfPlace = other.isOutOfPlace = true;
                    if (isUndecided[k])
                        continue;
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
