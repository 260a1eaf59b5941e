#pragma once

#include "core/ray/box_tree.h"
#include "core/ray/ray_bundle.h"
#include "core/ray/triangle_packets.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace unprojector::ray {

/// Finds the packets of triangles that a ray may hit. Immutable: any thread may query it.
class TriangleTree {
public:
    TriangleTree() = default;
    virtual ~TriangleTree() = default;
    TriangleTree(const TriangleTree &) = delete;
    TriangleTree &operator=(const TriangleTree &) = delete;

    /// Tests the packets that the ray may hit, until no other can be nearer.
    virtual void search(const UnitRay &ray, PacketSearch &search) const = 0;
    /// Calls `visit` with the packets whose boxes reach into a ball.
    virtual void within(const Ball &ball, const std::function<void(std::uint32_t)> &visit) const = 0;
};

/// Builds a tree on a BoxTree.
/// @param packets  outlive the tree
/// Throws base::Stopped.
std::unique_ptr<const TriangleTree> plainTriangleTree(const TrianglePackets &packets, const Progress &progress);

/// Builds a tree on Embree, which is faster to build and to search. Only builds with Embree have it.
/// @param packets  outlive the tree
/// @return null if Embree does not run on this computer
/// Throws base::Stopped, std::bad_alloc.
std::unique_ptr<const TriangleTree> embreeTriangleTree(const TrianglePackets &packets, const Progress &progress);

} // namespace unprojector::ray
