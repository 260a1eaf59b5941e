// Stubs for builds without Embree.

#include "core/ray/triangle_tree.h"

namespace unprojector::ray {

std::unique_ptr<const TriangleTree> embreeTriangleTree(const TrianglePackets &, const Progress &, bool &)
{
    return nullptr;
}

bool hasEmbree()
{
    return false;
}

} // namespace unprojector::ray
