// Landmarks out of place in simulated series: how many are found, and how many reports are false.
//   bench_out_of_place [first seed [series]]; 1000 and 200 without them
// The goal for 12 scans: at least 95 % of the displaced landmarks, and below 2 % false reports.

#include "core/landmarks/out_of_place.h"
#include "tests/core/landmarks/simulated_series.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <set>

namespace {

using namespace unprojector::landmarks;

void measure(const char *name, const simulated::Kind &kind, std::uint64_t seed, int count)
{
    std::size_t displaced = 0, displacedFound = 0, swapped = 0, swappedFound = 0, good = 0, falseReports = 0;
    double seconds = 0.0;
    for (int i = 0; i < count; ++i) {
        simulated::Random random(seed + static_cast<std::uint64_t>(i));
        const simulated::Series series = simulated::series(random, kind);
        std::set<simulated::Place> ofSwaps;
        for (const auto &[scan, a, b] : series.swapped) {
            ofSwaps.insert({scan, a});
            ofSwaps.insert({scan, b});
        }
        const auto start = std::chrono::steady_clock::now();
        const Deviations deviations = deviationsOf(series.scans, series.pairs);
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (const Deviation &one : deviations.worstFirst) {
            const simulated::Place place{one.specimen, one.landmark};
            const std::size_t reported = one.isOutOfPlace ? 1 : 0;
            if (ofSwaps.contains(place)) {
                swappedFound += reported;
            } else if (series.wrong.contains(place)) {
                displacedFound += reported;
            } else {
                ++good;
                falseReports += reported;
            }
        }
        swapped += ofSwaps.size();
        displaced += series.wrong.size() - ofSwaps.size();
    }
    const auto percent = [](std::size_t part, std::size_t whole) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    };
    std::printf("%-22s displaced %6.2f %% of %zu, swapped %6.2f %% of %zu, false %5.2f %% of reports, %.4f %% of good; "
                "%.1f ms a series\n",
                name, percent(displacedFound, displaced), displaced, percent(swappedFound, swapped), swapped,
                percent(falseReports, falseReports + displacedFound + swappedFound), percent(falseReports, good),
                1e3 * seconds / count);
}

/// The first scan of each series has left and right swapped on some pairs.
void measureSides(const char *name, const simulated::FewLandmarks &kind, std::uint64_t seed, int count)
{
    int right = 0, open = 0, wrong = 0, missed = 0;
    std::set<simulated::Place> swapped;
    for (const Pair &pair : kind.swapped)
        swapped.insert({{0, pair.left}, {0, pair.right}});
    for (int i = 0; i < count; ++i) {
        simulated::Random random(seed + static_cast<std::uint64_t>(i));
        const Deviations deviations = deviationsOf(simulated::seriesOfFew(random, kind), simulated::kPairsOfFew);
        std::set<simulated::Place> named;
        for (const Deviation &one : deviations.worstFirst) {
            if (one.swappedWith)
                named.insert({one.specimen, one.landmark});
        }
        const bool isRight = named == swapped;
        right += isRight ? 1 : 0;
        open += !isRight && !deviations.undecidedSpecimens.empty() ? 1 : 0;
        if (!isRight && deviations.undecidedSpecimens.empty())
            ++(std::includes(swapped.begin(), swapped.end(), named.begin(), named.end()) ? missed : wrong);
    }
    const auto percent = [count](int part) { return 100.0 * part / count; };
    std::printf(
        "%zu scans, differing by %.1f, %-13s named %5.1f %%, cannot tell %5.1f %%, missed %5.1f %%, others named "
        "%5.1f %%\n",
        kind.scans, kind.deviation, name, percent(right), percent(open), percent(missed), percent(wrong));
}

} // namespace

int main(int argc, char **argv)
{
    const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
    const int count = argc > 2 ? std::atoi(argv[2]) : 200;
    const auto row = [&](const char *name, std::size_t scans, double missing, double modeDeviation) {
        simulated::Kind kind;
        kind.scans = scans;
        kind.missing = missing;
        kind.modeDeviation = modeDeviation;
        measure(name, kind, seed, count);
    };
    row("3 scans", 3, 0.0, 2.0);
    row("5 scans", 5, 0.0, 2.0);
    row("6 scans", 6, 0.0, 2.0);
    row("12 scans", 12, 0.0, 2.0);
    row("12, a tenth missing", 12, 0.1, 2.0);
    row("12, little shape", 12, 0.0, 1.0);
    row("40 scans", 40, 0.0, 2.0);
    for (const double deviation : {0.3, 0.6}) {
        for (const std::size_t scans : std::initializer_list<std::size_t>{3, 4, 5, 8}) {
            const auto sides = [&](const char *name, const std::vector<Pair> &swapped) {
                measureSides(name, {scans, swapped, deviation}, seed, count);
            };
            sides("outer pair", {{4, 5}});
            sides("mouth", {{8, 9}});
            sides("inner pair", {{6, 7}});
            sides("two pairs", {{4, 5}, {6, 7}});
            sides("all pairs", {{4, 5}, {8, 9}, {6, 7}});
        }
    }
    return 0;
}
