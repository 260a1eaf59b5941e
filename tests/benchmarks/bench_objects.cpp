// Identifiers for the matrices and the code of scenes with many objects: the time of each object is
// the same in a scene of ten objects and of a hundred thousand.

#include "core/base/identifier.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace unprojector::base;

namespace {

void identifiers(benchmark::State &state, bool isOneName)
{
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<std::string> names(count, "part");
    for (std::size_t i = 0; !isOneName && i < count; ++i)
        names[i] += std::to_string(i);
    for (auto _ : state) {
        DistinctIdentifiers given;
        for (const std::string &name : names)
            benchmark::DoNotOptimize(given.next(name));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(identifiers, oneName, true)->RangeMultiplier(10)->Range(10, 100000);
BENCHMARK_CAPTURE(identifiers, distinctNames, false)->RangeMultiplier(10)->Range(10, 100000);

} // namespace

BENCHMARK_MAIN();
