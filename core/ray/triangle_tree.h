#pragma once

#include "core/ray/box_tree.h"
#include "core/ray/ray_bundle.h"
#include "core/ray/triangle_packets.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace unprojector::ray {

/// Picks the packets of triangles that a ray may meet, far fewer than there are. Immutable: any thread may ask.
class TriangleTree {
public:
    TriangleTree() = default;
    virtual ~TriangleTree() = default;
    TriangleTree(const TriangleTree &) = delete;
    TriangleTree &operator=(const TriangleTree &) = delete;

    /// Tests them, until no other can be nearer.
    virtual void search(const UnitRay &ray, PacketSearch &search) const = 0;
    /// Shows the packets whose boxes reach into a ball.
    virtual void within(const Ball &ball, const std::function<void(std::uint32_t)> &visit) const = 0;
};

/// By a BoxTree.
/// @param packets  outlive the tree
/// @return null when progress says stop
std::unique_ptr<const TriangleTree> plainTriangleTree(const TrianglePackets &packets, const Progress &progress);

/// By Embree, which is faster to build and to search.
/// @param packets  outlive the tree
/// @param isCancelled  set when progress says stop
/// @return null then, and where the program was built without Embree or Embree does not run on this computer
/// Throws std::bad_alloc.
std::unique_ptr<const TriangleTree> embreeTriangleTree(const TrianglePackets &packets, const Progress &progress,
                                                       bool &isCancelled);

/// Whether the program was built with Embree.
bool hasEmbree();

} // namespace unprojector::ray
