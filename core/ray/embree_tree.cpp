// The tree on Embree 3 or 4. Embree only handles boxes; the hit triangle and its position are
// computed in double, as without it.

#include "core/ray/triangle_tree.h"

#if UNPROJECTOR_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <new>
#include <utility>

namespace unprojector::ray {
namespace {

#if UNPROJECTOR_EMBREE == 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

/// A query in progress. The callback recovers it from Embree's context, its first member.
struct Search {
    Context context;
    PacketSearch *packets;
};

void giveBounds(const RTCBoundsFunctionArguments *arguments)
{
    const auto &packets = *static_cast<const TrianglePackets *>(arguments->geometryUserPtr);
    const auto [lowest, highest] = packets.boxOf(arguments->primID);
    *arguments->bounds_o = {lowest.x, lowest.y, lowest.z, 0.0f, highest.x, highest.y, highest.z, 0.0f};
}

void intersect(const RTCIntersectFunctionNArguments *arguments)
{
    if (arguments->valid[0] == 0)
        return;
    const auto &packets = *static_cast<const TrianglePackets *>(arguments->geometryUserPtr);
    const auto &search = *reinterpret_cast<const Search *>(arguments->context);
    if (packets.take(arguments->primID, *search.packets))
        reinterpret_cast<RTCRayHit *>(arguments->rayhit)->ray.tfar = search.packets->length();
}

bool showPacket(RTCPointQueryFunctionArguments *arguments)
{
    (*static_cast<const std::function<void(std::uint32_t)> *>(arguments->userPtr))(arguments->primID);
    return false; // the ball keeps its size
}

class EmbreeTree : public TriangleTree {
public:
    // Threads are not bound to processors: where that is impossible, Embree prints to stderr.
    explicit EmbreeTree(const TrianglePackets &packets) : m_packets(packets), m_device(rtcNewDevice("set_affinity=0"))
    {
        if (m_device == nullptr)
            return;
        m_scene = rtcNewScene(m_device);
        rtcSetSceneBuildQuality(m_scene, RTC_BUILD_QUALITY_MEDIUM);
        rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, packets.count());
        rtcSetGeometryUserData(geometry, const_cast<TrianglePackets *>(&packets)); // returned as const
        rtcSetGeometryBoundsFunction(geometry, giveBounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, intersect);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    ~EmbreeTree() override
    {
        if (m_scene != nullptr)
            rtcReleaseScene(m_scene);
        if (m_device != nullptr)
            rtcReleaseDevice(m_device);
    }

    /// @return whether the tree is ready
    bool build(const Progress &progress)
    {
        if (m_device == nullptr)
            return false;
        constexpr double kStep = 0.01;
        SharedProgress shared(progress, kStep);
        const auto report = [](void *to, double share) { return static_cast<SharedProgress *>(to)->report(share); };
        rtcSetSceneProgressMonitorFunction(m_scene, report, &shared);
        rtcCommitScene(m_scene);
        rtcSetSceneProgressMonitorFunction(m_scene, nullptr, nullptr);
        const RTCError error = rtcGetDeviceError(m_device);
        if (shared.isStopped())
            throw base::Stopped{};
        if (error == RTC_ERROR_OUT_OF_MEMORY)
            throw std::bad_alloc();
        if (error == RTC_ERROR_NONE)
            return true;
        // The system has no thread for it. Releasing the rest of Embree's scheduler now would crash the program.
        m_scene = nullptr;
        m_device = nullptr;
        return false;
    }

    void search(const UnitRay &ray, PacketSearch &packets) const override
    {
        Search search{{}, &packets};
        RTCRayHit hit{};
        hit.ray.org_x = ray.from.x;
        hit.ray.org_y = ray.from.y;
        hit.ray.org_z = ray.from.z;
        hit.ray.dir_x = ray.along.x;
        hit.ray.dir_y = ray.along.y;
        hit.ray.dir_z = ray.along.z;
        hit.ray.tfar = ray.length;
        hit.ray.mask = 0xFFFFFFFFu;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if UNPROJECTOR_EMBREE == 4
        rtcInitRayQueryContext(&search.context);
        RTCIntersectArguments arguments;
        rtcInitIntersectArguments(&arguments);
        arguments.context = &search.context;
        rtcIntersect1(m_scene, &hit, &arguments);
#else
        rtcInitIntersectContext(&search.context);
        rtcIntersect1(m_scene, &search.context, &hit);
#endif
        m_packets.finish(packets);
    }

    void within(const Ball &ball, const std::function<void(std::uint32_t)> &visit) const override
    {
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        RTCPointQuery query{ball.center.x, ball.center.y, ball.center.z, 0.0f, ball.radius};
        rtcPointQuery(m_scene, &query, &context, showPacket,
                      const_cast<std::function<void(std::uint32_t)> *>(&visit)); // returned as const
    }

private:
    const TrianglePackets &m_packets;
    RTCDevice m_device = nullptr;
    RTCScene m_scene = nullptr;
};

} // namespace

std::unique_ptr<const TriangleTree> embreeTriangleTree(const TrianglePackets &packets, const Progress &progress)
{
    auto tree = std::make_unique<EmbreeTree>(packets);
    return tree->build(progress) ? std::move(tree) : nullptr;
}

} // namespace unprojector::ray
