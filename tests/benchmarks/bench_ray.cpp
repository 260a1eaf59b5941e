// Rays on a mesh, next to Embree's own tree and intersection of the same mesh in the same run:
//   bench_ray [--plain] [--double] [triangles …], 1000000 without any
// --plain: our own tree instead of the one by Embree
// --double: positions that are not floats
#include "core/ray/ray_caster.h"
#include "tests/support/cube_sphere.h"

#if UNPROJECTOR_EMBREE == 4
#include <embree4/rtcore.h>
#elif UNPROJECTOR_EMBREE
#include <embree3/rtcore.h>
#endif

#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

namespace {

using namespace unprojector;
using namespace unprojector::ray;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Rays from eyes all around to points on the surface, as clicks.
std::vector<Ray<ObjectSpace>> clicks(std::size_t count)
{
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine))); };
    std::vector<Ray<ObjectSpace>> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 eye = 3.0 * direction(), target = 0.9 * direction();
        rays.push_back({ObjectPoint(eye), Vector<ObjectSpace>(target - eye), 0.0, 10.0});
    }
    return rays;
}

struct Times {
    double median = 0.0, p99 = 0.0; ///< microseconds
    std::size_t hits = 0;
};

class Watch {
public:
    template <class Pick>
    void time(const Ray<ObjectSpace> &ray, const Pick &pick)
    {
        const Clock::time_point start = Clock::now();
        m_hits += pick(ray) ? 1 : 0;
        m_times.push_back(1e6 * secondsSince(start));
    }
    Times times()
    {
        std::sort(m_times.begin(), m_times.end());
        return {m_times[m_times.size() / 2], m_times[m_times.size() * 99 / 100], m_hits};
    }

private:
    std::vector<double> m_times;
    std::size_t m_hits = 0;
};

void print(const char *what, double build, const Times &times)
{
    std::printf("  %-12s build %7.3f s   pick p50 %6.2f us, p99 %6.2f us   %zu hits\n", what, build, times.median,
                times.p99, times.hits);
}

#if UNPROJECTOR_EMBREE
/// Embree with triangles of its own.
struct Peer {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);

    explicit Peer(const Mesh &mesh)
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                                   sizeof(glm::vec3), mesh.positions.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                                   3 * sizeof(std::uint32_t), mesh.triangleCount());
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
    ~Peer()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Peer(const Peer &) = delete;
    Peer &operator=(const Peer &) = delete;

    bool pick(const Ray<ObjectSpace> &ray) const
    {
        RTCRayHit hit{};
        const glm::vec3 from(ray.from.coordinates()), along(ray.along.coordinates());
        hit.ray.org_x = from.x;
        hit.ray.org_y = from.y;
        hit.ray.org_z = from.z;
        hit.ray.dir_x = along.x;
        hit.ray.dir_y = along.y;
        hit.ray.dir_z = along.z;
        hit.ray.tfar = static_cast<float>(ray.high);
        hit.ray.mask = 0xFFFFFFFFu;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if UNPROJECTOR_EMBREE == 4
        rtcIntersect1(scene, &hit, nullptr);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene, &context, &hit);
#endif
        return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
};
#endif

struct Ratios {
    std::vector<double> build, median;

    static double middle(std::vector<double> values)
    {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    }
};

void makeDouble(Model &model)
{
    Mesh &mesh = model.meshes.front();
    std::vector<glm::dvec3> positions;
    positions.reserve(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
        positions.push_back(mesh.position(vertex) * 1.0000000123);
    setPositions(mesh, glm::dvec3(0.0), positions);
    model.bounds = boundsOf(model.meshes);
}

void measure(double wanted, RayCaster::Tree tree, bool areDoubles)
{
    const auto model = cubeSphere(static_cast<std::uint32_t>(std::lround(std::sqrt(wanted / 12.0))));
    if (areDoubles)
        makeDouble(*model);
    std::printf("%zu triangles\n", model->triangleCount());
    const std::vector<Ray<ObjectSpace>> rays = clicks(100000);
    Ratios ratios;
    for (int round = 0; round < 5; ++round) {
        Clock::time_point start = Clock::now();
        const auto caster = RayCaster::build(model, {}, tree);
        const double build = secondsSince(start);
        Watch watch;
        const auto pick = [&](const Ray<ObjectSpace> &ray) { return caster->nearestTriangle(ray).has_value(); };
#if UNPROJECTOR_EMBREE
        start = Clock::now();
        const Peer peer(model->meshes.front());
        const double peerBuild = secondsSince(start);
        Watch peerWatch;
        const auto peerPick = [&](const Ray<ObjectSpace> &ray) { return peer.pick(ray); };
#endif
        // The two take turns, so that other load of the computer falls on both.
        constexpr std::size_t kTurn = 1000;
        for (std::size_t first = 0; first < rays.size(); first += kTurn) {
            for (std::size_t i = first; i < std::min(first + kTurn, rays.size()); ++i)
                watch.time(rays[i], pick);
#if UNPROJECTOR_EMBREE
            for (std::size_t i = first; i < std::min(first + kTurn, rays.size()); ++i)
                peerWatch.time(rays[i], peerPick);
#endif
        }
        const Times times = watch.times();
        print("this program", build, times);
#if UNPROJECTOR_EMBREE
        const Times peerTimes = peerWatch.times();
        print("Embree", peerBuild, peerTimes);
        ratios.build.push_back(build / peerBuild);
        ratios.median.push_back(times.median / peerTimes.median);
#endif
    }
    if (!ratios.build.empty())
        std::printf("  to Embree, middle of %zu rounds: build %.2f, pick p50 %.2f\n", ratios.build.size(),
                    Ratios::middle(ratios.build), Ratios::middle(ratios.median));
}

} // namespace

int main(int argc, char **argv)
{
    RayCaster::Tree tree = RayCaster::Tree::Fastest;
    bool hasCount = false, areDoubles = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--plain") == 0) {
            tree = RayCaster::Tree::Plain;
            continue;
        }
        if (std::strcmp(argv[i], "--double") == 0) {
            areDoubles = true;
            continue;
        }
        hasCount = true;
        measure(std::max(12.0, std::atof(argv[i])), tree, areDoubles);
    }
    if (!hasCount)
        measure(1e6, tree, areDoubles);
}
