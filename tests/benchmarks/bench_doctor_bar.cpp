// The doctor's success rate and time on wrong programs: every single mistake and the pairs of the
// most common ones, and wrong values from one point and from three, over random scenes; right points,
// random points.
//
//   bench_doctor_bar [SCENES [GARBAGE]]    2000 and 10000

#include "tests/support/doctor_bar.h"
#include "tests/support/value_bar.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace doctor_bar;
using oracle::Random;

namespace {

double percent(int part, int whole)
{
    return 100.0 * part / std::max(whole, 1);
}

void print(const char *name, const Count &c)
{
    std::printf("%-48s %7d %8.2f %8.2f %8.2f\n", name, c.asked, percent(c.first, c.asked),
                percent(c.firstOrTwin, c.asked), percent(c.firstThree, c.asked));
}

void report(const char *title, const Tally &tally)
{
    constexpr std::size_t kMostMissed = 12;
    std::printf("%-48s %7s %8s %8s %8s\n", title, "asked", "first %", "or twin", "three %");
    for (const auto &[id, count] : tally.ofId)
        print(id.c_str(), count);
    print("all", tally.all);
    std::puts("");
    std::map<std::string, std::size_t> shown;
    for (const std::string &miss : tally.missed) {
        if (++shown[miss.substr(0, miss.find(' '))] <= kMostMissed / 4)
            std::puts(miss.c_str());
    }
    std::puts("");
}

void report(const char *title, const value_bar::Tally &tally)
{
    constexpr std::size_t kMostMissed = 4;
    std::printf("%-48s %7s %8s %8s %8s\n", title, "asked", "verdict%", "three %", "open");
    for (const auto &[id, c] : tally.ofId)
        std::printf("%-48s %7d %8.2f %8.2f %8d\n", id.c_str(), c.asked, percent(c.verdicts, c.asked),
                    percent(c.firstThree, c.asked), c.undetermined);
    std::puts("");
    std::map<std::string, std::size_t> shown;
    for (const std::string &miss : tally.missed) {
        if (++shown[miss.substr(0, miss.find(' '))] <= kMostMissed)
            std::puts(miss.c_str());
    }
    std::puts("");
}

} // namespace

int main(int count, char **words)
{
    const int scenes = count > 1 ? std::atoi(words[1]) : 2000;
    const int garbage = count > 2 ? std::atoi(words[2]) : 5 * scenes;
    Random random(2026);
    Tally singles, pairs;
    const auto start = std::chrono::steady_clock::now();
    addSingles(singles, random, scenes);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    report("one mistake", singles);
    std::printf("a diagnosis with its simulation: %.2f ms\n\n", took.count() / std::max(singles.all.asked, 1));
    addPairs(pairs, random, std::max(scenes / 10, 1));
    report("two mistakes", pairs);
    report("a wrong value, one point", value_bar::tested(random, scenes, 1));
    report("a wrong value, three points", value_bar::tested(random, scenes, 3));
    report("a wrong value, four points", value_bar::tested(random, scenes, 4));
    std::printf("triples of random points explained: %d of %d\n", value_bar::garbageExplained(random, scenes), scenes);
    std::printf("right points not called right: %d of %d\n", rightsMissed(random, scenes), scenes);
    std::printf("random points explained: %d of %d\n", garbageExplained(random, garbage), garbage);
    return 0;
}
