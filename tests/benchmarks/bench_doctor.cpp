// One diagnosis: every mistake and every pair of them on one point, on several points, and by the
// ray alone. It may take 50 ms.
#include "core/doctor/diagnosis.h"
#include "core/geometry/transform.h"

#include <benchmark/benchmark.h>

#include <numbers>

namespace {
using namespace unprojector;
using namespace unprojector::doctor;
using namespace unprojector::geometry;

Case scene()
{
    Case result;
    result.setup = {{1000, 700, 1.5},
                    {100, 40, 800, 600},
                    {0.1, 0.9},
                    Projection(Perspective{std::numbers::pi / 4, 800.0 / 600.0, 1, 100}),
                    LookAt{WorldPoint(3, 2, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
    result.models = {{"box", worldFromObject({Translate{{2, 0, -1}}})},
                     {"ball", worldFromObject({Rotate{30, {1, 2, 3}}, Scale{{2, 2, 2}}})}};
    return result;
}

std::vector<WrongPoint> points(std::size_t count)
{
    std::vector<WrongPoint> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i].pixel = DevicePoint(400.5 + 7.0 * double(i), 300.5);
        result[i].depth = 0.8;
        result[i].got = {1.1234, 2.2345, 0.3456};
    }
    return result;
}

void fewPoints(benchmark::State &state)
{
    const Case of = scene();
    const std::vector<WrongPoint> given = points(std::size_t(state.range(0)));
    std::size_t tried = 0;
    for ([[maybe_unused]] auto _ : state)
        tried = diagnose(of, given).value().tried;
    state.counters["tried"] = double(tried);
}
BENCHMARK(fewPoints)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

void roundedDepth(benchmark::State &state)
{
    const Case of = scene();
    std::vector<WrongPoint> given = points(1);
    given[0].depthLastDigit = 1e-6;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(diagnose(of, given));
}
BENCHMARK(roundedDepth)->Unit(benchmark::kMillisecond);

void byRay(benchmark::State &state)
{
    const Case of = scene();
    std::vector<WrongPoint> given = points(1);
    given[0].depth.reset();
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(diagnose(of, given));
}
BENCHMARK(byRay)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
