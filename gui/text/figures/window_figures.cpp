// Clipping, the window's pixels, and the way back from one of them.

#include "gui/text/figures/drawing.h"
#include "gui/text/figures/figures.h"

namespace unprojector::gui::figures {
namespace {

using Stroke = Drawing::Stroke;
using Side = Drawing::Side;

/// The rectangle of the window around the viewport in drawViewport.
constexpr double kWindowLeft = 19.6, kWindowTop = 1.8, kWindowRight = 36.0, kWindowBottom = 11.6;
constexpr double kViewLeft = 23.4, kViewTop = 3.4, kViewRight = 33.8, kViewBottom = 9.6;

/// @param up     distance by which it is higher than there
/// @param share  of the viewport's width and height from its lower left corner, where a point is
/// marked
QPointF drawViewportInWindow(Drawing &d, double up, const QPointF &share)
{
    const double top = kWindowTop - up, bottom = kWindowBottom - up, viewTop = kViewTop - up,
                 viewBottom = kViewBottom - up;
    d.outline(rectangle(kWindowLeft, top, kWindowRight, bottom));
    const auto viewport = rectangle(kViewLeft, viewTop, kViewRight, viewBottom);
    d.area(viewport);
    d.outline(viewport, Stroke::Accent);
    d.measure({kWindowLeft, viewBottom - 0.9}, {kViewLeft, viewBottom - 0.9}, text("v<sub>x</sub>"), Side::Above);
    d.measure({kViewLeft + 1.0, bottom}, {kViewLeft + 1.0, viewBottom}, text("v<sub>y</sub>"), Side::Right);
    d.measure({kViewLeft, viewBottom - 0.5}, {kViewRight, viewBottom - 0.5}, text("width"), Side::Above);
    d.measure({kViewRight - 0.6, viewBottom}, {kViewRight - 0.6, viewTop}, text("height"), Side::Left);
    const QPointF point(kViewLeft + share.x() * (kViewRight - kViewLeft),
                        viewBottom - share.y() * (viewBottom - viewTop));
    d.dot(point, Stroke::Accent);
    return point;
}

} // namespace

void drawClipPlane(Drawing &d)
{
    // The plane from the side, and a rectangle that it cuts at (11, 2.2) and (8.25, 7.7).
    const QPointF top(12.0, 0.2), bottom(7.1, 10.0);
    d.area({top, {24.6, 0.2}, {24.6, 10.0}, bottom});
    d.line(top, bottom, Stroke::Accent);
    const QPointF upper(11.0, 2.2), lower(8.25, 7.7);
    d.path({upper, {17.4, 2.2}, {17.4, 7.7}, lower});
    d.path({upper, {3.4, 2.2}, {3.4, 7.7}, lower}, Stroke::Dashed);
    const QPointF middle = between(upper, lower, 0.5), normal = middle + QPointF(3.4, 1.7);
    d.arrow(middle, normal, Stroke::Second);
    d.rightAngle(middle, upper, normal);
    d.label(normal, text("(A, B, C)"), Side::Right, Stroke::Second);
    d.label({18.4, 1.1}, text("A x + B y + C z + D ≥ 0"), Side::Center);
    d.label({14.6, 4.0}, Words::tr("kept"));
    d.label({6.0, 5.0}, Words::tr("cut off"), Side::Center, Stroke::Quiet);
    d.label(between(top, bottom, 0.95) + QPointF(-0.1, 0.0), text("= 0"), Side::Left, Stroke::Accent);
}

/// NDC's square, and the viewport in the window.
void drawViewport(Drawing &d)
{
    const QPointF middle(5.4, 6.8);
    constexpr double kHalf = 3.2;
    const auto ndc = rectangle(middle.x() - kHalf, middle.y() - kHalf, middle.x() + kHalf, middle.y() + kHalf);
    d.area(ndc);
    d.outline(ndc);
    d.arrow(middle - QPointF(4.4, 0.0), middle + QPointF(4.8, 0.0), Stroke::Quiet);
    d.label(middle + QPointF(4.7, 0.0), text("x<sub>n</sub>"), Side::Below);
    d.arrow(middle + QPointF(0.0, 4.4), middle - QPointF(0.0, 4.6), Stroke::Quiet);
    d.label(middle - QPointF(0.0, 4.4), text("y<sub>n</sub>"), Side::Right);
    d.label({middle.x() - kHalf - 0.7, middle.y()}, text("−1"), Side::Above);
    d.label({middle.x() + kHalf + 0.4, middle.y()}, text("1"), Side::Above);
    const QPointF share(0.45, 0.5);
    d.dot(middle + QPointF(share.x(), -share.y()) * kHalf, Stroke::Accent);

    d.arrow({11.0, 6.8}, {18.4, 6.8}, Stroke::Accent);
    d.label({14.6, 6.7}, text("glViewport"), Side::Above, Stroke::Accent);
    drawViewportInWindow(d, 0.0, (QPointF(1.0, 1.0) + share) / 2.0);
    // Window coordinates from below, the widget's from above.
    d.arrow({kWindowLeft, kWindowBottom}, {kWindowLeft + 3.0, kWindowBottom}, Stroke::Second);
    d.arrow({kWindowLeft, kWindowBottom}, {kWindowLeft, kWindowBottom - 3.0}, Stroke::Second);
    d.label({kWindowLeft + 2.4, kWindowBottom}, text("x"), Side::Below, Stroke::Second);
    d.label({kWindowLeft, kWindowBottom - 2.4}, text("y"), Side::Left, Stroke::Second);
    d.label({kWindowLeft - 0.2, kWindowBottom + 0.8}, Words::tr("window"), Side::Left, Stroke::Second);
    d.arrow({kWindowLeft, kWindowTop}, {kWindowLeft + 3.0, kWindowTop}, Stroke::Quiet);
    d.arrow({kWindowLeft, kWindowTop}, {kWindowLeft, kWindowTop + 3.0}, Stroke::Quiet);
    d.label({kWindowLeft + 2.4, kWindowTop}, text("px"), Side::Above, Stroke::Quiet);
    d.label({kWindowLeft, kWindowTop + 2.4}, text("py"), Side::Left, Stroke::Quiet);
    d.label({kWindowLeft - 0.2, kWindowTop - 0.8}, Words::tr("widget"), Side::Left, Stroke::Quiet);
}

/// The paper's figure 5, (3) and (4): one share of the near plane's window and of the viewport.
void drawNearWindow(Drawing &d)
{
    constexpr double kL = 2.4, kR = 10.0, kB = 9.2, kT = 3.2;
    const QPointF axis(5.0, 6.8), share(0.64, 0.7);
    const QPointF point(kL + share.x() * (kR - kL), kB - share.y() * (kB - kT));
    d.area(rectangle(kL, kT, kR, kB), Stroke::Second);
    d.outline(rectangle(kL, kT, kR, kB), Stroke::Second);
    d.arrow({0.6, axis.y()}, {12.4, axis.y()}, Stroke::Quiet);
    d.label({12.2, axis.y()}, text("x<sub>w</sub>"), Side::Below);
    d.arrow({axis.x(), 10.4}, {axis.x(), 1.6}, Stroke::Quiet);
    d.label({axis.x(), 1.8}, text("y<sub>w</sub>"), Side::Right);
    d.label({kL, kB - 1.0}, text("l"), Side::Left, Stroke::Second);
    d.label({kR, kB - 1.0}, text("r"), Side::Right, Stroke::Second);
    d.label({(axis.x() + kR) / 2.0, kT}, text("t"), Side::Above, Stroke::Second);
    d.label({(axis.x() + kR) / 2.0, kB}, text("b"), Side::Below, Stroke::Second);
    d.dot(point, Stroke::Accent);
    d.label(point, text("(x<sub>w</sub>, y<sub>w</sub>)"), Side::Above, Stroke::Accent);
    d.arrow({13.0, 5.2}, {18.4, 5.2}, Stroke::Accent);
    d.label({15.6, 5.1}, text("(3), (4)"), Side::Above, Stroke::Accent);
    constexpr double kUp = 1.0;
    const QPointF inViewport = drawViewportInWindow(d, kUp, share);
    d.label(inViewport, text("(x<sub>v</sub>, y<sub>v</sub>)"), Side::Left, Stroke::Accent);
    d.arrow({kWindowLeft, kWindowBottom - kUp}, {kWindowLeft + 3.0, kWindowBottom - kUp}, Stroke::Quiet);
    d.arrow({kWindowLeft, kWindowBottom - kUp}, {kWindowLeft, kWindowBottom - kUp - 3.0}, Stroke::Quiet);
    d.label({kWindowLeft + 2.4, kWindowBottom - kUp - 0.1}, text("x"), Side::Above, Stroke::Quiet);
    d.label({kWindowLeft, kWindowBottom - kUp - 2.4}, text("y"), Side::Left, Stroke::Quiet);
}

/// The same share of each.
void drawScales(Drawing &d)
{
    struct Scale {
        double y, left, right;
        const char *from, *at, *to;
        Stroke stroke;
    };
    constexpr double kShare = 0.62;
    constexpr double kRaised = 0.3; // labels above the lines to the next scale
    const std::vector<Scale> scales{
        {1.6, 7.0, 17.0, "l", "x", "r", Stroke::Second},
        {3.8, 4.0, 16.0, "−1", "x<sub>n</sub>", "1", Stroke::Ink},
        {6.0, 3.0, 24.0, "v<sub>x</sub>", "x<sub>v</sub>", "v<sub>x</sub> + width", Stroke::Accent}};
    std::vector<QPointF> places;
    for (const Scale &scale : scales) {
        places.push_back(between({scale.left, scale.y}, {scale.right, scale.y}, kShare));
        d.line({scale.left, scale.y}, {scale.right, scale.y}, scale.stroke);
        for (const double end : {scale.left, scale.right})
            d.line({end, scale.y - 0.35}, {end, scale.y + 0.35}, scale.stroke);
        d.label({scale.left - 0.1, scale.y - kRaised}, text(scale.from), Side::Left);
        d.label({scale.right + 0.25, scale.y - kRaised}, text(scale.to), Side::Right);
    }
    for (std::size_t i = 0; i + 1 < scales.size(); ++i) {
        d.line({scales[i].left, scales[i].y}, {scales[i + 1].left, scales[i + 1].y}, Stroke::Dashed);
        d.line({scales[i].right, scales[i].y}, {scales[i + 1].right, scales[i + 1].y}, Stroke::Dashed);
        d.line(places[i], places[i + 1], Stroke::Dashed);
    }
    for (std::size_t i = 0; i < scales.size(); ++i) {
        d.dot(places[i], scales[i].stroke);
        const bool isFromLeft = i > 0 && places[i - 1].x() < places[i].x(); // the line to this point
        d.label(places[i] + QPointF(isFromLeft ? 0.7 : -0.5, 0.0), text(scales[i].at), Side::Above);
    }
}

/// (8): y_v counts from below, py from above.
void drawFlip(Drawing &d)
{
    constexpr double kLeft = 6.0, kTop = 1.0, kRight = 19.0, kBottom = 9.0;
    const QPointF point(12.6, 3.6);
    d.area(rectangle(kLeft, kTop, kRight, kBottom));
    d.outline(rectangle(kLeft, kTop, kRight, kBottom));
    d.line({kLeft, point.y()}, {kRight, point.y()}, Stroke::Dashed);
    d.line({point.x(), kTop}, {point.x(), kBottom}, Stroke::Dashed);
    d.measure({kLeft, kBottom + 0.5}, {point.x(), kBottom + 0.5}, text("x<sub>v</sub> = px"), Side::Below);
    d.arrow({kRight - 2.0, kTop}, {kRight - 2.0, point.y()}, Stroke::Second);
    d.label({kRight - 2.0, (kTop + point.y()) / 2.0}, text("py"), Side::Left, Stroke::Second);
    d.arrow({kRight - 2.0, kBottom}, {kRight - 2.0, point.y()}, Stroke::Accent);
    d.label({kRight - 2.0, (kBottom + point.y()) / 2.0}, text("y<sub>v</sub>"), Side::Left, Stroke::Accent);
    d.measure({kRight + 1.0, kTop}, {kRight + 1.0, kBottom}, text("rect.bottom"), Side::Right);
    d.dot(point);
    d.arrow({kLeft - 1.2, kBottom}, {kLeft - 1.2, kBottom - 3.0}, Stroke::Accent);
    d.label({kLeft - 1.2, kBottom - 2.0}, Words::tr("window"), Side::Left, Stroke::Accent);
    d.arrow({kLeft - 1.2, kTop}, {kLeft - 1.2, kTop + 3.0}, Stroke::Second);
    d.label({kLeft - 1.2, kTop + 2.0}, Words::tr("widget"), Side::Left, Stroke::Second);
}

/// A pixel, its centre and the two ways to count its row.
void drawHalfPixel(Drawing &d)
{
    constexpr double kLeft = 3.4, kTop = 1.4, kPixel = 3.0;
    constexpr int kColumns = 3, kRows = 3;
    const auto at = [](double i, double j) { return QPointF(kLeft + kPixel * i, kTop + kPixel * j); };
    d.area(rectangle(at(1, 1).x(), at(1, 1).y(), at(2, 2).x(), at(2, 2).y()));
    for (int i = 0; i <= kColumns; ++i)
        d.line(at(i, 0), at(i, kRows), Stroke::Quiet);
    for (int j = 0; j <= kRows; ++j)
        d.line(at(0, j), at(kColumns, j), Stroke::Quiet);
    d.outline(rectangle(at(1, 1).x(), at(1, 1).y(), at(2, 2).x(), at(2, 2).y()), Stroke::Accent);
    d.dot(at(1.5, 1.5), Stroke::Accent);
    d.line(at(1.5, 1.5), at(3.4, 1.5), Stroke::Dashed);
    d.label(at(3.4, 1.5), text("(i + ½, j + ½)"), Side::Right, Stroke::Accent);
    d.label(at(1, 0), text("i"), Side::Above);
    d.label(at(2, 0), text("i + 1"), Side::Above);
    d.label(at(0, 1), text("j"), Side::Left);
    d.label(at(0, 2), text("j + 1"), Side::Left);
    d.line(at(1, 1), at(2, 1), Stroke::Second);
    d.line(at(2, 1), at(3.4, 0.7), Stroke::Dashed);
    d.label(at(3.4, 0.7), text("rect.bottom − j"), Side::Right, Stroke::Second);
    d.label(at(1.5, kRows) + QPointF(0.0, 0.1), text("glReadPixels(i, H − 1 − j)"), Side::Below, Stroke::Accent);
}

/// The pixel of a click, the ray through it, and the distance along it given by the depth.
void drawRay(Drawing &d)
{
    constexpr double kNear = 8.0, kFar = 26.0, kPoint = 17.0;
    const QPointF eye(1.8, 8.4);
    const auto at = [eye](double x, double y, double distance) {
        return eye + QPointF(distance - 0.5 * x, -y + 0.35 * x);
    };
    const auto window = [&](double distance) {
        const double s = distance / kNear;
        return std::vector<QPointF>{at(-1.5 * s, 1.3 * s, distance), at(1.5 * s, 1.3 * s, distance),
                                    at(1.5 * s, -1.1 * s, distance), at(-1.5 * s, -1.1 * s, distance)};
    };
    const auto onRay = [&](double distance) { return at(0.2 * distance / kNear, 0.75 * distance / kNear, distance); };
    d.arrow(eye, at(0, 0, 30.6), Stroke::Quiet);
    d.label(at(0, 0, 30.6), text("−z"), Side::Below);
    d.outline(window(kFar), Stroke::Quiet);
    d.label(window(kFar)[0] + QPointF(0.0, 0.3), text("d = 1"), Side::Above);
    d.area(window(kNear), Stroke::Second);
    d.outline(window(kNear), Stroke::Second);
    d.label(window(kNear)[0], text("d = 0"), Side::Above);
    // A piece of the hit surface.
    const QPointF met = onRay(kPoint);
    const std::vector<QPointF> surface{met + QPointF(-1.5, 2.5), met + QPointF(1.9, 1.5), met + QPointF(1.5, -2.5),
                                       met + QPointF(-1.9, -1.5)};
    d.line(eye, onRay(kNear), Stroke::Dashed);
    d.area(surface);
    d.outline(surface, Stroke::Quiet);
    d.arrow(onRay(kNear), met, Stroke::Accent);
    d.line(met, onRay(kFar), Stroke::Dashed);
    const QPointF pixel = onRay(kNear);
    d.outline({pixel + QPointF(0.2, -0.42), pixel + QPointF(-0.2, -0.14), pixel + QPointF(-0.2, 0.42),
               pixel + QPointF(0.2, 0.14)},
              Stroke::Accent);
    d.label(pixel + QPointF(-0.75, -0.75), text("(x<sub>v</sub>, y<sub>v</sub>)"), Side::Left, Stroke::Second);
    d.dot(met, Stroke::Accent);
    d.label(met + QPointF(-0.1, -0.4), text("p"), Side::Above, Stroke::Accent);
    d.dot(eye);
    constexpr double kMeasure = 12.7;
    d.line(eye, {eye.x(), kMeasure}, Stroke::Dashed);
    d.line(met, {met.x(), kMeasure}, Stroke::Dashed);
    d.measure({eye.x(), kMeasure - 0.3}, {met.x(), kMeasure - 0.3}, text("z"), Side::Above);
}

/// The uncertainty from one pixel and one step of the depth, from the side.
void drawCertainty(Drawing &d)
{
    const QPointF eye(0.8, 5.0);
    constexpr double kSlope = 0.085;
    const auto at = [eye](double distance, double side) { return eye + QPointF(distance, side * kSlope * distance); };
    d.area({eye, at(28.6, -1), at(28.6, 1)});
    d.line(eye, at(28.6, -1), Stroke::Quiet);
    d.line(eye, at(28.6, 1), Stroke::Quiet);
    d.line(eye, at(28.6, 0), Stroke::Dashed);
    // Steps of equal depth between a near plane at 4 and a far one at 29.
    constexpr double kNear = 4.0, kFar = 29.0;
    constexpr int kSteps = 20;
    const auto distanceOf = [](int i) { return kNear * kFar / (kFar - i * (kFar - kNear) / kSteps); };
    for (int i = 0; i < kSteps; ++i)
        d.line(at(distanceOf(i), -1), at(distanceOf(i), 1), Stroke::Quiet);
    constexpr int kStep = 17;
    const double from = distanceOf(kStep), to = distanceOf(kStep + 1), middle = (from + to) / 2.0;
    constexpr double kAbove = 1.6;
    d.line(at(from, -1), {at(from, 0).x(), kAbove}, Stroke::Dashed);
    d.line(at(to, -1), {at(to, 0).x(), kAbove}, Stroke::Dashed);
    d.measure({at(from, 0).x(), kAbove + 0.3}, {at(to, 0).x(), kAbove + 0.3}, text("Δz"), Side::Above);
    d.measure(at(from - 0.5, 1), at(from - 0.5, -1), QString(), Side::Left);
    d.label({at(from, 0).x() - 1.0, 8.6}, text("{(t − b) z | n · height}"), Side::Left);
    d.line(at(from - 0.5, 1), {at(from, 0).x() - 1.2, 8.4}, Stroke::Dashed);
    d.line(at(middle - 1.7, 2.2), at(middle + 1.7, -2.2), Stroke::Accent);
    d.line(at(middle, 0), at(middle, 2.2), Stroke::Dashed);
    d.angle(at(middle, 0), at(middle, 2.2), at(middle - 1.7, 2.2), 2.6, text("α"));
    d.dot(at(middle, 0), Stroke::Accent);
    d.dot(eye);
}

} // namespace unprojector::gui::figures
