#include "core/landmarks/repeatability.h"

#include "core/landmarks/distinct_names.h"
#include "core/landmarks/procrustes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace unprojector::landmarks {
namespace {

struct Placed {
    int placing = 1;
    glm::dvec3 offset{0.0}; ///< from the specimen's mean, scan's frame
};

/// A landmark of one specimen with all its placings.
struct Repeats {
    glm::dvec3 mean{0.0};
    std::vector<Placed> placings;
    std::optional<Similarity> aligning; ///< of the specimen

    double count() const { return static_cast<double>(placings.size()); }
    glm::dvec3 alignedMean() const { return aligning->mapped(mean); }
    glm::dvec3 alignedOffset(const Placed &placed) const
    {
        return aligning->scale * (aligning->rotation * placed.offset);
    }
};

double square(const glm::dvec3 &v)
{
    return glm::dot(v, v);
}

/// A sum of squares with its degrees of freedom.
struct Squares {
    double sum = 0.0, freedom = 0.0;

    void add(const Squares &other)
    {
        sum += other.sum;
        freedom += other.freedom;
    }
    double mean() const { return sum / freedom; }
};

std::optional<double> ifFinite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The one-way analysis of variance: placings within specimens.
struct OneWay {
    Squares between, within;
    double placings = 0.0; ///< k0 times the degrees of freedom between specimens

    void add(const OneWay &other)
    {
        between.add(other.between);
        within.add(other.within);
        placings += other.placings;
    }
    std::optional<double> icc() const
    {
        if (between.freedom < 1.0 || within.freedom < 1.0)
            return std::nullopt;
        const double k0 = placings / between.freedom;
        return ifFinite((between.mean() - within.mean()) / (between.mean() + (k0 - 1.0) * within.mean()));
    }
};

OneWay oneWayOf(const std::vector<Repeats> &specimens)
{
    OneWay found;
    double count = 0.0, squaredCounts = 0.0, groups = 0.0;
    glm::dvec3 sum(0.0);
    for (const Repeats &specimen : specimens) {
        if (!specimen.aligning)
            continue;
        ++groups;
        count += specimen.count();
        squaredCounts += specimen.count() * specimen.count();
        sum += specimen.count() * specimen.alignedMean();
        found.within.freedom += specimen.count() - 1.0;
        for (const Placed &placed : specimen.placings)
            found.within.sum += square(specimen.alignedOffset(placed));
    }
    if (groups < 2.0)
        return {};
    for (const Repeats &specimen : specimens) {
        if (specimen.aligning)
            found.between.sum += specimen.count() * square(specimen.alignedMean() - sum / count);
    }
    found.between.freedom = groups - 1.0;
    found.placings = count - squaredCounts / count;
    return found;
}

/// The two-way analysis of variance: specimens by placings, each specimen with all placings.
struct TwoWay {
    Squares specimens, placings, error;
    double counted = 0.0; ///< n times the degrees of freedom of specimens

    void add(const TwoWay &other)
    {
        specimens.add(other.specimens);
        placings.add(other.placings);
        error.add(other.error);
        counted += other.counted;
    }
    /// @param k  number of placings
    std::optional<double> icc(double k) const
    {
        if (specimens.freedom < 1.0 || placings.freedom < 1.0 || error.freedom < 1.0)
            return std::nullopt;
        const double n = counted / specimens.freedom;
        const double off = error.mean();
        return ifFinite((specimens.mean() - off)
                        / (specimens.mean() + (k - 1.0) * off + k * (placings.mean() - off) / n));
    }
};

/// Returns whether a specimen has all placings, each once.
bool isComplete(const Repeats &specimen, const std::vector<int> &placings)
{
    return specimen.aligning && specimen.placings.size() == placings.size()
           && std::equal(placings.begin(), placings.end(), specimen.placings.begin(),
                         [](int number, const Placed &placed) { return placed.placing == number; });
}

TwoWay twoWayOf(const std::vector<Repeats> &specimens, const std::vector<int> &placings)
{
    std::vector<const Repeats *> complete;
    for (const Repeats &specimen : specimens) {
        if (isComplete(specimen, placings))
            complete.push_back(&specimen);
    }
    const auto n = static_cast<double>(complete.size()), k = static_cast<double>(placings.size());
    if (n < 2.0 || k < 2.0)
        return {};
    glm::dvec3 sum(0.0);
    std::vector<glm::dvec3> offsets(placings.size(), glm::dvec3(0.0)); ///< of each placing, the mean
    for (const Repeats *specimen : complete) {
        sum += specimen->alignedMean();
        for (std::size_t j = 0; j < offsets.size(); ++j)
            offsets[j] += specimen->alignedOffset(specimen->placings[j]) / n;
    }
    TwoWay found;
    found.specimens.freedom = n - 1.0;
    found.placings.freedom = k - 1.0;
    found.error.freedom = (n - 1.0) * (k - 1.0);
    found.counted = n * found.specimens.freedom;
    for (const glm::dvec3 &offset : offsets)
        found.placings.sum += n * square(offset);
    for (const Repeats *specimen : complete) {
        found.specimens.sum += k * square(specimen->alignedMean() - sum / n);
        for (std::size_t j = 0; j < offsets.size(); ++j)
            found.error.sum += square(specimen->alignedOffset(specimen->placings[j]) - offsets[j]);
    }
    return found;
}

/// The sums of one landmark, from which the sums of all follow.
struct Sums {
    Squares within; ///< scan's frame
    OneWay oneWay;
    TwoWay twoWay;
    std::vector<Squares> byPlacing; ///< scan's frame; degrees of freedom: specimens

    void add(const Sums &other)
    {
        within.add(other.within);
        oneWay.add(other.oneWay);
        twoWay.add(other.twoWay);
        for (std::size_t j = 0; j < byPlacing.size(); ++j)
            byPlacing[j].add(other.byPlacing[j]);
    }
};

std::optional<double> rootOf(const Squares &squares)
{
    return squares.freedom > 0.0 ? ifFinite(std::sqrt(squares.mean())) : std::nullopt;
}

/// The distance of a placing's mean from that of all, in the scans' unit.
std::optional<double> biasOf(const std::vector<Repeats> &specimens, const std::vector<int> &placings, std::size_t j)
{
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const Repeats &specimen : specimens) {
        if (!isComplete(specimen, placings))
            continue;
        sum += specimen.aligning->rotation * specimen.placings[j].offset;
        ++count;
    }
    return count > 0.0 && placings.size() > 1 ? ifFinite(glm::length(sum / count)) : std::nullopt;
}

void takeSums(LandmarkError &error, const Sums &sums, const std::vector<int> &placings)
{
    error.error = rootOf(sums.within);
    error.icc1 = sums.oneWay.icc();
    error.icc2 = sums.twoWay.icc(static_cast<double>(placings.size()));
    error.byPlacing.resize(placings.size());
    for (std::size_t j = 0; j < placings.size(); ++j) {
        error.byPlacing[j].placing = placings[j];
        error.byPlacing[j].specimens = static_cast<std::size_t>(sums.byPlacing[j].freedom);
        error.byPlacing[j].error = rootOf(sums.byPlacing[j]);
    }
}

Sums sumsOf(const std::vector<Repeats> &specimens, const std::vector<int> &placings)
{
    Sums sums;
    sums.oneWay = oneWayOf(specimens);
    sums.twoWay = twoWayOf(specimens, placings);
    sums.byPlacing.resize(placings.size());
    for (const Repeats &specimen : specimens) {
        if (specimen.placings.size() < 2)
            continue;
        sums.within.freedom += specimen.count() - 1.0;
        for (const Placed &placed : specimen.placings) {
            sums.within.sum += square(placed.offset);
            const auto j = std::lower_bound(placings.begin(), placings.end(), placed.placing) - placings.begin();
            Squares &own = sums.byPlacing[static_cast<std::size_t>(j)];
            own.sum += specimen.count() / (specimen.count() - 1.0) * square(placed.offset);
            ++own.freedom;
        }
    }
    return sums;
}

/// The placings of each landmark of a specimen.
/// @param places  of DistinctNames, for each set
std::vector<Repeats> repeatsOf(const std::vector<LandmarkSet> &sets, std::span<const std::vector<std::size_t>> places,
                               std::size_t landmarks)
{
    std::vector<Repeats> repeats(landmarks);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (std::size_t k = 0; k < sets[i].landmarks.size(); ++k) {
            if (const auto &world = sets[i].landmarks[k].world)
                repeats[places[i][k]].placings.push_back({sets[i].placing, world->coordinates()});
        }
    }
    for (Repeats &each : repeats) {
        if (each.placings.empty())
            continue;
        std::stable_sort(each.placings.begin(), each.placings.end(),
                         [](const Placed &a, const Placed &b) { return a.placing < b.placing; });
        // Relative to the first one, because sums far from the origin would lose digits.
        const glm::dvec3 first = each.placings.front().offset;
        glm::dvec3 sum(0.0);
        for (const Placed &placed : each.placings)
            sum += placed.offset - first;
        each.mean = first + sum / each.count();
        for (Placed &placed : each.placings)
            placed.offset = (placed.offset - first) - sum / each.count();
    }
    return repeats;
}

} // namespace

MeasurementError measurementErrorOf(std::span<const std::vector<LandmarkSet>> specimens)
{
    std::vector<LandmarkSet> sets;
    std::set<int> placings;
    for (const std::vector<LandmarkSet> &specimen : specimens) {
        for (const LandmarkSet &set : specimen) {
            sets.push_back(set);
            placings.insert(set.placing);
        }
    }
    const DistinctNames distinct = distinctNames(sets);
    const std::size_t landmarks = distinct.names.size();
    MeasurementError found;
    std::vector<std::vector<Repeats>> ofLandmarks(landmarks); ///< for each landmark, the specimens with it
    std::vector<std::vector<Repeats>> ofSpecimens;
    std::vector<Configuration> means;
    std::span<const std::vector<std::size_t>> places(distinct.places);
    for (const std::vector<LandmarkSet> &specimen : specimens) {
        ofSpecimens.push_back(repeatsOf(specimen, places.first(specimen.size()), landmarks));
        places = places.subspan(specimen.size());
        Configuration &mean = means.emplace_back(landmarks);
        const auto isRepeated = [](const Repeats &repeats) { return repeats.placings.size() > 1; };
        if (std::any_of(ofSpecimens.back().begin(), ofSpecimens.back().end(), isRepeated)) {
            ++found.all.specimens;
            found.all.placings += specimen.size();
        }
        for (std::size_t k = 0; k < landmarks; ++k) {
            if (!ofSpecimens.back()[k].placings.empty())
                mean[k] = ofSpecimens.back()[k].mean;
        }
    }
    const Superimposition aligned = superimposed(means);
    found.placings.assign(placings.begin(), placings.end());
    found.specimens = specimens.size();
    for (std::size_t i = 0; i < ofSpecimens.size(); ++i) {
        found.notAligned += aligned.meanFromSpecimen[i] ? 0U : 1U;
        for (std::size_t k = 0; k < landmarks; ++k) {
            Repeats &repeats = ofSpecimens[i][k];
            repeats.aligning = aligned.meanFromSpecimen[i];
            if (!repeats.placings.empty())
                ofLandmarks[k].push_back(std::move(repeats));
        }
    }
    Sums all;
    all.byPlacing.resize(placings.size());
    for (std::size_t k = 0; k < landmarks; ++k) {
        LandmarkError &error = found.landmarks.emplace_back();
        error.name = distinct.names[k];
        for (const Repeats &specimen : ofLandmarks[k]) {
            if (specimen.placings.size() < 2)
                continue;
            ++error.specimens;
            error.placings += specimen.placings.size();
        }
        const Sums sums = sumsOf(ofLandmarks[k], found.placings);
        takeSums(error, sums, found.placings);
        for (std::size_t j = 0; j < found.placings.size(); ++j)
            error.byPlacing[j].bias = biasOf(ofLandmarks[k], found.placings, j);
        all.add(sums);
    }
    takeSums(found.all, all, found.placings);
    return found;
}

} // namespace unprojector::landmarks
