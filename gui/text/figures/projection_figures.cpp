// Projections: from the eye to clip coordinates.

#include "gui/text/figures/drawing.h"
#include "gui/text/figures/figures.h"

#include <algorithm>

namespace unprojector::gui::figures {
namespace {

using Stroke = Drawing::Stroke;
using Side = Drawing::Side;

} // namespace

/// A section along z: the box is moved to the origin, scaled, and its near end becomes the other
/// one.
void drawOrtho(Drawing &d)
{
    constexpr double kAxis = 5.4, kPitch = 10.7, kHalf = 1.7, kTopOfAxis = 1.2, kEnd = 8.6;
    const auto axes = [&](double origin, double left, double right) {
        d.arrow({left, kAxis}, {right, kAxis}, Stroke::Quiet);
        d.label({right, kAxis}, text("z"), Side::Below);
        d.arrow({origin, kEnd}, {origin, kTopOfAxis}, Stroke::Quiet);
        d.label({origin, kTopOfAxis}, text("y"), Side::Above);
    };
    const auto box = [&](double left, double top, double right, double bottom, bool isNearAtLeft) {
        d.area(rectangle(left, top, right, bottom));
        d.outline(rectangle(left, top, right, bottom));
        const double nearEnd = isNearAtLeft ? left : right;
        d.line({nearEnd, top}, {nearEnd, bottom}, Stroke::Second);
        d.line({nearEnd + 0.04, top}, {nearEnd + 0.04, bottom}, Stroke::Second);
        d.label({nearEnd, bottom}, Words::tr("near"), Side::Below, Stroke::Second);
    };
    const auto step = [&](double at, const char *letter) {
        d.arrow({at - 0.9, 2.0}, {at + 0.9, 2.0}, Stroke::Accent);
        d.label({at, 1.9}, text(letter), Side::Above, Stroke::Accent);
    };
    constexpr double kEye = 8.2, kLeft = 1.2, kRight = 5.8, kTop = 2.4, kBottom = 6.2;
    axes(kEye, 0.4, 9.4);
    box(kLeft, kTop, kRight, kBottom, false);
    d.label({kLeft, kTop}, text("−f"), Side::Above);
    d.label({kRight, kTop}, text("−n"), Side::Above);
    d.label({kRight, kTop + 0.5}, text("t"), Side::Right);
    d.label({kRight, kBottom - 0.2}, text("b"), Side::Right);
    d.dot({kEye, kAxis});
    step(10.6, "T");
    constexpr double kHalfWide = (kRight - kLeft) / 2.0, kHalfHigh = (kBottom - kTop) / 2.0;
    const double second = 5.2 + kPitch;
    axes(second, second - 3.6, second + 3.9);
    box(second - kHalfWide, kAxis - kHalfHigh, second + kHalfWide, kAxis + kHalfHigh, false);
    step(20.8, "S");
    for (int i = 0; i < 2; ++i) {
        const double origin = 25.6 + kPitch * i;
        axes(origin, origin - 3.2, origin + 3.4);
        box(origin - kHalf, kAxis - kHalf, origin + kHalf, kAxis + kHalf, i == 1);
        d.label({origin - kHalf, kAxis - kHalf}, text("−1"), Side::Above);
        d.label({origin + kHalf, kAxis - kHalf}, text("1"), Side::Above);
    }
    step(30.9, "Z");
}

/// The view volume, the x axis drawn towards the reader.
void drawFrustum(Drawing &d)
{
    constexpr double kNear = 8.0, kFar = 18.0;
    const QPointF eye(2.2, 7.0);
    const auto at = [eye](double x, double y, double distance) {
        return eye + QPointF(distance - 0.5 * x, -y + 0.35 * x);
    };
    constexpr double kL = -2.4, kR = 2.8, kB = -1.6, kT = 2.2;
    const auto corners = [&](double distance) {
        const double s = distance / kNear;
        return std::vector<QPointF>{at(kL * s, kT * s, distance), at(kR * s, kT * s, distance),
                                    at(kR * s, kB * s, distance), at(kL * s, kB * s, distance)};
    };
    const std::vector<QPointF> nearEnd = corners(kNear), farEnd = corners(kFar);
    d.line(eye, at(0, 0, 22.8), Stroke::Quiet);
    d.arrow(at(0, 0, 20.0), at(0, 0, 22.8), Stroke::Quiet);
    d.label(at(0, 0, 22.8), text("−z"), Side::Below);
    for (std::size_t i = 0; i < nearEnd.size(); ++i) {
        d.line(eye, nearEnd[i], Stroke::Dashed);
        d.line(nearEnd[i], farEnd[i]);
    }
    d.area(farEnd);
    d.outline(farEnd);
    d.area(nearEnd, Stroke::Second);
    d.outline(nearEnd, Stroke::Second);
    d.arrow(eye, at(2.4, 0, 0), Stroke::Quiet);
    d.label(at(2.4, 0, 0), text("x"), Side::Left);
    d.arrow(eye, at(0, 2.6, 0), Stroke::Quiet);
    d.label(at(0, 2.5, 0), text("y"), Side::Left);
    d.dot(eye);
    d.dot(at(0, 0, kNear), Stroke::Second);
    // The label is at a position that no line from the eye crosses.
    const auto edge = [&](std::size_t one, std::size_t other, double share, const char *name, Side side) {
        d.label(between(nearEnd[one], nearEnd[other], share), text(name), side, Stroke::Second);
    };
    d.label(between(nearEnd[0], nearEnd[1], 0.5) - QPointF(0.0, 0.5), text("t"), Side::Above, Stroke::Second);
    d.label(between(nearEnd[2], nearEnd[3], 0.78) + QPointF(0.1, 0.25), text("b"), Side::Below, Stroke::Second);
    edge(1, 2, 0.75, "r", Side::Left);
    edge(3, 0, 0.5, "l", Side::Right);
    constexpr double kFirst = 14.6, kSecond = 15.9;
    const double nearAt = eye.x() + kNear, farAt = eye.x() + kFar;
    d.line(eye, {eye.x(), kSecond}, Stroke::Dashed);
    d.line(at(0, 0, kNear), {nearAt, kFirst}, Stroke::Dashed);
    d.line(at(0, 0, kFar), {farAt, kSecond}, Stroke::Dashed);
    d.measure({eye.x(), kFirst}, {nearAt, kFirst}, text("n"), Side::Above);
    d.measure({eye.x(), kSecond}, {farAt, kSecond}, text("f"), Side::Above);
}

/// A section along z: the view volume's rays become parallel, then its window a square.
void drawFrustumSteps(Drawing &d)
{
    constexpr double kAxis = 5.4, kHalf = 1.7, kTop = 1.3, kBottom = -0.9, kNear = 2.6, kFar = 7.2;
    const auto axes = [&](double origin, double left, double right, const char *across, const char *up) {
        d.arrow({left, kAxis}, {right, kAxis}, Stroke::Quiet);
        d.label({right, kAxis}, text(across), Side::Below);
        d.arrow({origin, 8.6}, {origin, 1.2}, Stroke::Quiet);
        d.label({origin, 1.2}, text(up), Side::Above);
    };
    // Corners: the far end's top and bottom, the near end's bottom and top.
    const auto volume = [&](const std::vector<QPointF> &corners) {
        d.area(corners);
        for (const double share : {0.25, 0.5, 0.75})
            d.line(between(corners[0], corners[1], share), between(corners[3], corners[2], share), Stroke::Quiet);
        d.outline(corners);
        d.line(corners[2], corners[3], Stroke::Second);
        d.line(corners[2] + QPointF(0.04, 0.0), corners[3] + QPointF(0.04, 0.0), Stroke::Second);
        const double aside = corners[1].y() > corners[2].y() ? 0.8 : 0.0; // of the edge that ends there
        d.label({corners[2].x() + aside, std::max(corners[2].y(), corners[3].y())}, Words::tr("near"), Side::Below,
                Stroke::Second);
    };
    const auto step = [&](double at, const char *letter) {
        d.arrow({at - 0.9, 2.0}, {at + 0.9, 2.0}, Stroke::Accent);
        d.label({at, 1.9}, text(letter), Side::Above, Stroke::Accent);
    };
    const QPointF eye(10.0, kAxis);
    const auto at = [&eye](double slope, double distance) {
        return eye + QPointF(-distance, -slope * distance / kNear);
    };
    axes(eye.x(), 0.6, 11.4, "z", "y");
    for (const double slope : {kTop, kBottom})
        d.line(eye, at(slope, kNear), Stroke::Dashed);
    volume({at(kTop, kFar), at(kBottom, kFar), at(kBottom, kNear), at(kTop, kNear)});
    d.label(at(kTop, kFar), text("−f"), Side::Above);
    d.label(at(kTop, kNear), text("−n"), Side::Above);
    d.dot(eye);
    step(13.0, "N");
    const double second = 18.6, third = 29.4;
    axes(second, second - 3.2, second + 3.6, "z<sub>n</sub>", "y<sub>w</sub>");
    volume({{second + kHalf, kAxis - kTop},
            {second + kHalf, kAxis - kBottom},
            {second - kHalf, kAxis - kBottom},
            {second - kHalf, kAxis - kTop}});
    d.label({second + kHalf, kAxis - kTop + 0.3}, text("t"), Side::Right);
    d.label({second + kHalf, kAxis - kBottom}, text("b"), Side::Right);
    d.label({second - kHalf, kAxis - kTop}, text("−1"), Side::Above);
    d.label({second + kHalf, kAxis - kTop}, text("1"), Side::Above);
    step(23.8, "B");
    axes(third, third - 3.2, third + 3.6, "z<sub>n</sub>", "y<sub>n</sub>");
    volume({{third + kHalf, kAxis - kHalf},
            {third + kHalf, kAxis + kHalf},
            {third - kHalf, kAxis + kHalf},
            {third - kHalf, kAxis - kHalf}});
    d.label({third - kHalf, kAxis - kHalf}, text("−1"), Side::Above);
    d.label({third + kHalf, kAxis - kHalf}, text("1"), Side::Above);
}

/// (1): the ray through a point, cut by the near plane.
void drawSimilarTriangles(Drawing &d)
{
    const QPointF eye(1.6, 6.6);
    constexpr double kNear = 8.6, kPoint = 20.6, kHeight = 5.2;
    const double height = kHeight * (kNear - eye.x()) / (kPoint - eye.x());
    const QPointF onNear(kNear, eye.y() - height), point(kPoint, eye.y() - kHeight);
    const QPointF nearFoot(kNear, eye.y()), foot(kPoint, eye.y());
    d.area({eye, foot, point});
    d.area({eye, nearFoot, onNear}, Stroke::Second);
    d.arrow({0.6, eye.y()}, {24.8, eye.y()}, Stroke::Quiet);
    d.label({24.6, eye.y()}, text("−z"), Side::Below);
    d.line({kNear, 0.8}, {kNear, 8.0}, Stroke::Dashed);
    d.line(eye, between(eye, point, 1.12), Stroke::Accent);
    d.line(foot, point, Stroke::Accent);
    d.line(nearFoot, onNear, Stroke::Second);
    d.rightAngle(nearFoot, onNear, foot);
    d.rightAngle(foot, point, eye);
    d.label(between(nearFoot, onNear, 0.5), text("x<sub>w</sub>"), Side::Right, Stroke::Second);
    d.label(between(foot, point, 0.5), text("x"), Side::Right, Stroke::Accent);
    d.dot(eye);
    d.dot(onNear, Stroke::Second);
    d.dot(point, Stroke::Accent);
    d.measure({eye.x(), 7.7}, {kNear, 7.7}, text("n"), Side::Below);
    d.measure({eye.x(), 9.0}, {kPoint, 9.0}, text("z"), Side::Below);
    d.label({5.0, 2.6}, text("{x | x<sub>w</sub>} = {z | n}"));
}

/// The depth over the distance, for a far plane ten times as far as the near one.
void drawDepth(Drawing &d)
{
    constexpr double kNear = 1.0, kFar = 10.0;
    const auto at = [](double distance, double ndc) { return QPointF(4.0 + 2.0 * distance, 5.6 - 4.4 * ndc); };
    d.arrow({at(0, 0).x(), at(0, -1).y() + 0.9}, {at(0, 1.2).x(), at(0, 1).y() - 0.9}, Stroke::Quiet);
    d.label({at(0, 0).x(), 0.6}, text("z<sub>n</sub>"), Side::Right);
    d.arrow(at(0, 0), at(11.3, 0), Stroke::Quiet);
    d.label(at(11.1, 0), text("−z"), Side::Below);
    const double half = 2.0 * kNear * kFar / (kFar + kNear);
    for (const double ndc : {-1.0, 1.0}) {
        d.line(at(0, ndc), at(kFar, ndc), Stroke::Dashed);
        d.label(at(0, ndc), text(ndc < 0.0 ? "−1" : "1"), Side::Left);
    }
    d.label(at(0, 0), text("0"), Side::Left);
    d.line(at(kNear, -1), at(kNear, 0), Stroke::Dashed);
    d.line(at(kFar, 0), at(kFar, 1), Stroke::Dashed);
    d.label(at(kNear, 0), text("n"), Side::Above);
    d.label(at(kFar, 0), text("f"), Side::Below);
    d.line(at(kNear, -1), at(kFar, 1), Stroke::SecondDashed);
    d.label(at(7.0, 0.31) + QPointF(0.3, 0.3), text("glOrtho"), Side::Right, Stroke::Second);
    std::vector<QPointF> curve;
    constexpr int kPieces = 80;
    for (int i = 0; i <= kPieces; ++i) {
        const double distance = kNear + (kFar - kNear) * i / kPieces;
        curve.push_back(at(distance, (kFar + kNear - 2.0 * kFar * kNear / distance) / (kFar - kNear)));
    }
    d.path(curve, Stroke::Accent);
    d.label(at(6.2, 0.6), text("glFrustum"), Side::Center, Stroke::Accent);
    d.dot(at(half, 0), Stroke::Accent);
    d.line(at(half, 0), at(half, -1.06), Stroke::Dashed);
    d.label(at(half, -1.06) + QPointF(0.2, 0.0), text("{2 n f | f + n}"), Side::Below);
}

/// Half the window's height and width on the near plane, from the side and from above.
void drawPerspective(Drawing &d)
{
    const auto view = [&d](double left, double half, const char *angle, const char *upper, const char *lower) {
        const QPointF eye(left, 4.4), middle(left + 8.6, 4.4);
        const QPointF top = middle - QPointF(0.0, half), bottom = middle + QPointF(0.0, half);
        d.area({eye, top, bottom});
        d.line(eye, between(eye, top, 1.2));
        d.line(eye, between(eye, bottom, 1.2));
        d.line(eye, middle + QPointF(3.0, 0.0), Stroke::Quiet);
        d.line(top, bottom, Stroke::Second);
        d.rightAngle(middle, top, eye);
        d.angle(eye, middle, top, 4.2, text(angle));
        d.label(between(middle, top, 0.5), text(upper), Side::Right, Stroke::Second);
        d.label(between(middle, bottom, 0.5), text(lower), Side::Right, Stroke::Second);
        d.dot(eye);
        constexpr double kMeasure = 9.1;
        d.line(eye, {eye.x(), kMeasure}, Stroke::Dashed);
        d.line(bottom, {middle.x(), kMeasure}, Stroke::Dashed);
        d.measure({eye.x(), kMeasure - 0.3}, {middle.x(), kMeasure - 0.3}, text("n"), Side::Above);
    };
    view(1.0, 2.5, "θ/2", "t = n tan {θ | 2}", "b");
    view(18.4, 3.3, "θ<sub>h</sub>/2", "r = t · aspect", "l");
}

/// Two sections with an angle each, and a cube for two pairs of angles.
void drawOblique(Drawing &d)
{
    const auto section = [&d](double left, const char *axis, const char *angle, const char *shift) {
        constexpr double kAxis = 3.4, kDistance = 5.6, kShift = 3.2;
        const QPointF origin(left, kAxis), point(left + kDistance, kAxis), hit(left, kAxis + kShift);
        d.arrow({left, 9.0}, {left, 0.8}, Stroke::Quiet);
        d.label({left, 0.9}, text(axis), Side::Right);
        d.arrow(origin, {left + kDistance + 2.2, kAxis}, Stroke::Quiet);
        d.label({left + kDistance + 2.0, kAxis}, text("−z"), Side::Above);
        d.line(point, hit, Stroke::Accent);
        d.arrow(between(point, hit, 0.4), between(point, hit, 0.62), Stroke::Accent);
        d.angle(hit, origin, point, 1.5, text(angle));
        d.dot(point);
        d.dot(hit, Stroke::Accent);
        d.measure({left, kAxis - 0.7}, {left + kDistance, kAxis - 0.7}, text("z"), Side::Above);
        d.label(between(origin, hit, 0.5), text(shift), Side::Left);
    };
    section(3.4, "x", "θ", "z cot θ");
    section(16.2, "y", "φ", "z cot φ");
    const auto cube = [&d](double left, double cotangent, const QString &name) {
        constexpr double kSide = 3.6, kTop = 1.2;
        const QPointF back(-cotangent * kSide, cotangent * kSide);
        const std::vector<QPointF> front = rectangle(left, kTop, left + kSide, kTop + kSide);
        std::vector<QPointF> behind;
        behind.reserve(front.size());
        for (const QPointF &corner : front)
            behind.push_back(corner + back);
        // The back corner at the upper right is hidden.
        for (const std::size_t other : {std::size_t{0}, std::size_t{2}})
            d.line(behind[1], behind[other], Stroke::Dashed);
        d.line(front[1], behind[1], Stroke::Dashed);
        d.area(front);
        d.outline(front);
        d.path({behind[0], behind[3], behind[2]});
        for (const std::size_t i : {std::size_t{0}, std::size_t{2}})
            d.line(front[i], behind[i]);
        d.line(front[3], behind[3], Stroke::Second);
        d.label({left + (1.0 - cotangent) * kSide / 2.0, 8.9}, name);
    };
    constexpr double kCavalier = 0.70710678, kCabinet = kCavalier / 2.0;
    cube(29.2, kCavalier, Words::tr("cavalier: 1"));
    cube(36.6, kCabinet, Words::tr("cabinet: ½"));
}

} // namespace unprojector::gui::figures
