// Maps of 1920 x 1080 pixels on all cores, over a ball of 98,304 triangles that fills the picture's
// height: the hit of each pixel, and each of its quantities.
#include "core/maps/pixel_map.h"
#include "tests/support/cube_sphere.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::maps;
using namespace unprojector::ray;
using namespace unprojector::unproject;
using namespace unprojector::scene;

namespace {

struct Shown {
    Setup setup;
    std::vector<SceneObject> objects;
    std::unique_ptr<const Unprojector> unprojector;
    std::unique_ptr<const SceneRays> rays;

    Shown()
    {
        setup.surface = {1920, 1080, 1.0};
        setup.viewport = wholeSurface(setup.surface);
        setup.lens = Projection(Frustum{-1.0, 1.0, -0.5625, 0.5625, 1.5, 30.0});
        setup.pose = LookAt{WorldPoint(1.0, 2.0, 2.5), WorldPoint(0, 0, 0), {0, 1, 0}};
        objects.push_back({"ball", {}, cubeSphere(90), {}});
        unprojector = std::make_unique<const Unprojector>(*Unprojector::of(setup));
        const std::vector<std::shared_ptr<const RayCaster>> casters{RayCaster::build(objects[0].model, {})};
        rays = std::make_unique<const SceneRays>(*unprojector, objects, casters, std::vector<glm::dvec4>());
    }
    std::optional<SurfaceImage> surfaces() const { return surfacesMet(*rays, *PixelRays::of(rays->rays()), {}, {}); }
};

const Shown &shown()
{
    static const Shown one;
    return one;
}

void finish(benchmark::State &state, const SurfaceImage &surfaces)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(surfaces.depths.size()));
}

void met(benchmark::State &state)
{
    std::optional<SurfaceImage> surfaces;
    for (auto step : state)
        surfaces = shown().surfaces();
    finish(state, *surfaces);
    const auto count = statisticsOf(**pixelMap({}, *shown().unprojector, *surfaces, shown().objects, {})).count;
    state.counters["covered"] = double(count) / double(surfaces->depths.size());
}
BENCHMARK(met)->Unit(benchmark::kMillisecond)->UseRealTime();

void map(benchmark::State &state, const Question &question)
{
    static const SurfaceImage surfaces = *shown().surfaces();
    for (auto step : state)
        benchmark::DoNotOptimize(pixelMap(question, *shown().unprojector, surfaces, shown().objects, {}));
    finish(state, surfaces);
}

} // namespace

int main(int argc, char **argv)
{
    benchmark::Initialize(&argc, argv);
    for (const Quantity quantity : kQuantities) {
        if (quantity != Quantity::Displacement)
            benchmark::RegisterBenchmark(std::string(keyOf(quantity)).c_str(), map, Question{quantity, Unit::Ulps, {}})
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
    }
    for (const char *key : {"meshlab", "pixel-corner"})
        benchmark::RegisterBenchmark(key, map,
                                     Question{Quantity::Displacement, Unit::World, conventionNamed(key)->other})
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    benchmark::RunSpecifiedBenchmarks();
}
