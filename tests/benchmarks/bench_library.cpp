// Batches of the library for other programs, beside memcpy of the same bytes.
#include "unprojector/unproject.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

namespace {

using namespace unprojector;

constexpr std::size_t kCount = 10'000'000;

struct Pixels {
    Pixels() : px(kCount), py(kCount), depth(kCount), points(3 * kCount)
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (std::size_t i = 0; i < kCount; ++i) {
            px[i] = 800.0 * share(random);
            py[i] = 600.0 * share(random);
            depth[i] = share(random);
        }
    }
    std::vector<double> px, py, depth, points;
};

Pixels &pixels()
{
    static Pixels instance;
    return instance;
}

void unprojectBatch(benchmark::State &state, Digits digits)
{
    Pixels &p = pixels();
    Perspective perspective;
    perspective.nearDistance = 0.1;
    perspective.farDistance = 10000.0;
    const Camera camera{{3.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const auto setup = Setup::of(perspective, camera, {800, 600, {}, {}}).value();
    const auto unprojection = Unprojection::of(setup, {Method::Formula, Space::World, digits, {}}).value();
    for (auto _ : state) {
        unprojection(p.px.data(), p.py.data(), p.depth.data(), p.points.data(), kCount, nullptr,
                     static_cast<unsigned>(state.range(0)));
        benchmark::ClobberMemory();
    }
}

void copyTheSameBytes(benchmark::State &state)
{
    Pixels &p = pixels();
    for (auto _ : state) {
        std::memcpy(p.points.data(), p.px.data(), kCount * sizeof(double));
        std::memcpy(p.points.data() + kCount, p.py.data(), kCount * sizeof(double));
        std::memcpy(p.points.data() + 2 * kCount, p.depth.data(), kCount * sizeof(double));
        benchmark::ClobberMemory();
    }
}

} // namespace

// The argument is the number of threads; 0: all cores.
BENCHMARK_CAPTURE(unprojectBatch, exact, Digits::Exact)->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(unprojectBatch, double, Digits::Double)->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(copyTheSameBytes)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
