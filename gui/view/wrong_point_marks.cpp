#include "gui/view/wrong_point_marks.h"

#include "gui/document/picks.h"

#include <vector>

namespace unprojector::gui {

void drawWrongPoints(std::span<const WrongPointMark> points, const glm::dmat4 &clipFromWorld,
                     const glm::vec2 &viewportPixels, float pixelRatio, LinePainter &lines, PickPainter &marks)
{
    // Light around dark: visible on any surface.
    std::vector<LineSegment> ways, rims;
    for (const WrongPointMark &point : points) {
        if (!point.right)
            continue;
        ways.push_back({point.right->coordinates(), point.got.coordinates(), {0.76f, 0.28f, 0.0f, 1.0f}});
        rims.push_back({point.right->coordinates(), point.got.coordinates(), {1.0f, 1.0f, 1.0f, 0.7f}});
    }
    lines.draw(rims, clipFromWorld, viewportPixels, 3.5f * pixelRatio);
    lines.draw(ways, clipFromWorld, viewportPixels, 1.5f * pixelRatio);
    for (const WrongPointMark &point : points) {
        if (point.right)
            marks.draw(*point.right, clipFromWorld, viewportPixels, pixelRatio, PickPainter::Mark::Right);
        marks.draw(point.got, clipFromWorld, viewportPixels, pixelRatio, PickPainter::Mark::Wrong);
    }
}

} // namespace unprojector::gui
