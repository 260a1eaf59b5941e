#include "gui/landmarks/expected_marks.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/proportions.h"
#include "gui/document/scene_document.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::ExpectedMark)
};

constexpr double kLargestRadius = 4000.0;    // logical pixels
constexpr double kGap = 8.0;                 // from the place to its label
constexpr double kNextArm = 6.0, kArm = 3.0; // of a cross

double armOf(const ExpectedMark &mark)
{
    return mark.isNext ? kNextArm : kArm;
}

} // namespace

std::vector<ExpectedMark> expectedMarks(const SceneDocument &document, const std::vector<ExpectedLandmark> &expected)
{
    std::vector<ExpectedMark> marks;
    const Setup &g = document.setup();
    const Result<glm::dmat4> matrix = expected.empty() ? Result<glm::dmat4>(glm::dmat4(1.0)) : clipFromWorld(g);
    if (!matrix)
        return marks;
    for (const ExpectedLandmark &place : expected) {
        const glm::dvec4 clip = *matrix * glm::dvec4(place.world.coordinates(), 1.0);
        if (!(clip.w > 0.0) || !(std::abs(clip.x) <= clip.w) || !(std::abs(clip.y) <= clip.w))
            continue;
        const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
        const WidgetPoint widget = widgetFromDevice(
            g.surface, deviceFromWindow(g.surface, windowFromNdc(g.viewport, g.depthRange, ndc, ndcDepthOf(g))));
        ExpectedMark mark;
        mark.at = QPointF(widget.x, widget.y);
        const double radius = place.spread.value_or(0.0) / worldPerLogicalPixel(g, place.world);
        mark.radius = radius < kLargestRadius ? radius : 0.0;
        mark.isNext = place.isNext;
        if (place.isNext)
            mark.label = Texts::tr("%1 expected here", "a landmark")
                             .arg(SceneLandmarks::shownNameOf(document.landmarks(), place.index));
        marks.push_back(std::move(mark));
    }
    // The next one is drawn over the others.
    std::stable_partition(marks.begin(), marks.end(), [](const ExpectedMark &mark) { return !mark.isNext; });
    return marks;
}

QRectF expectedLabelBox(const std::vector<ExpectedMark> &marks, const QFontMetricsF &metrics, const QRectF &area,
                        const std::vector<QRectF> &taken)
{
    if (marks.empty() || !marks.back().isNext)
        return {};
    const ExpectedMark &next = marks.back();
    const QSizeF size(metrics.horizontalAdvance(next.label) + metrics.height() * 0.5, metrics.height() * 1.12);
    const double right = next.at.x() + kGap, left = next.at.x() - kGap - size.width();
    const double below = next.at.y() + kGap, above = next.at.y() - kGap - size.height();
    const std::array corners{QPointF(right, below), QPointF(left, below), QPointF(right, above), QPointF(left, above)};
    const auto isFree = [&](const QPointF &corner) {
        const QRectF box(corner, size);
        return area.contains(box)
               && std::none_of(taken.begin(), taken.end(), [&](const QRectF &other) { return other.intersects(box); });
    };
    const auto free = std::find_if(corners.begin(), corners.end(), isFree);
    return {free != corners.end() ? *free : corners.front(), size};
}

QRectF boxOf(const ExpectedMark &mark)
{
    const double arm = armOf(mark);
    return {mark.at - QPointF(arm, arm), QSizeF(2.0 * arm, 2.0 * arm)};
}

void drawExpected(QPainter &painter, const std::vector<ExpectedMark> &marks, const QRectF &labelBox)
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ExpectedMark &mark : marks) {
        // Light on dark, so that they show on any surface; without a brush, so that it stays visible.
        const int alpha = mark.isNext ? 230 : 120;
        const QColor dark(0x18, 0x1a, 0x1c, alpha), light(0x7f, 0xd4, 0xff, alpha);
        painter.setBrush(Qt::NoBrush);
        if (mark.radius > 0.0) {
            painter.setPen(QPen(QColor(0x18, 0x1a, 0x1c, alpha / 2), mark.isNext ? 3.0 : 2.0));
            painter.drawEllipse(mark.at, mark.radius, mark.radius);
            painter.setPen(QPen(light, mark.isNext ? 1.5 : 1.0, Qt::DashLine));
            painter.drawEllipse(mark.at, mark.radius, mark.radius);
        }
        const double arm = armOf(mark);
        for (const QColor &color : {dark, light}) {
            painter.setPen(QPen(color, color == dark ? 3.0 : 1.2));
            painter.drawLine(mark.at - QPointF(arm, 0.0), mark.at + QPointF(arm, 0.0));
            painter.drawLine(mark.at - QPointF(0.0, arm), mark.at + QPointF(0.0, arm));
        }
    }
    if (labelBox.isNull())
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x18, 0x1a, 0x1c, 190));
    painter.drawRoundedRect(labelBox, 3.0, 3.0);
    painter.setPen(QColor(0x7f, 0xd4, 0xff));
    painter.drawText(labelBox, Qt::AlignCenter | Qt::TextSingleLine | Qt::TextDontClip, marks.back().label);
}

} // namespace unprojector::gui
