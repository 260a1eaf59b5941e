#include "gui/view/painters/snap_shapes.h"

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace ray;

const glm::vec4 kSnapColor{1.0f, 0.75f, 0.10f, 1.0f};

namespace {

LineSegment lineBetween(const WorldPoint &from, const WorldPoint &to)
{
    return {from.coordinates(), to.coordinates(), kSnapColor};
}

} // namespace

SnapShape snapShape(const SnapMark &mark)
{
    SnapShape shape;
    const std::optional<TriangleDetail> &triangle = mark.hit.triangle;
    if (!triangle) {
        shape.point = mark.hit.vertex.world;
        return shape;
    }
    const auto cornerOf = [&](std::uint32_t id) {
        const auto found = std::find(triangle->ids.begin(), triangle->ids.end(), id);
        return mark.corners[static_cast<std::size_t>(found - triangle->ids.begin()) % 3];
    };
    switch (mark.snap) {
    case Snap::Surface: break;
    case Snap::Vertex: shape.point = mark.hit.vertex.world; break;
    case Snap::Edge:
        shape.lines = {lineBetween(cornerOf(triangle->edge.ids[0]), cornerOf(triangle->edge.ids[1]))};
        break;
    case Snap::Face: {
        const auto &[a, b, c] = mark.corners;
        glm::vec4 area = kSnapColor;
        area.a = 0.35f;
        // A face has four corners, of which two coincide.
        shape.faces = {{{a.coordinates(), b.coordinates(), c.coordinates(), c.coordinates()}, area}};
        shape.lines = {lineBetween(a, b), lineBetween(b, c), lineBetween(c, a)};
        break;
    }
    }
    return shape;
}

std::vector<LineSegment> dark(std::vector<LineSegment> lines)
{
    for (LineSegment &line : lines)
        line.color = {0.0f, 0.0f, 0.0f, 0.75f};
    return lines;
}

} // namespace unprojector::gui
