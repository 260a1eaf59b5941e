// Spaces and the transformations between them.

#include "gui/text/figures/drawing.h"
#include "gui/text/figures/figures.h"

#include <array>
#include <cmath>

namespace unprojector::gui::figures {
namespace {

using Stroke = Drawing::Stroke;
using Side = Drawing::Side;

} // namespace

/// The paper's figure 1, with the call of each step and the way back below.
void drawPipeline(Drawing &d)
{
    constexpr double kBox = 4.0, kPitch = 6.2, kLeft = 0.2, kTop = 4.5, kBottom = 7.3, kMiddle = (kTop + kBottom) / 2.0;
    constexpr double kClipping = 5.0; // the room of the station between clip and NDC
    constexpr int kClip = 3;
    const auto left = [](int space) { return kLeft + kPitch * space + (space > kClip ? kClipping : 0.0); };
    struct Space {
        QString name;
        const char *inPaper;
    };
    const std::array spaces{Space{Words::tr("object"), "MC"},    Space{Words::tr("world"), "WC"},
                            Space{Words::tr("eye"), "VC"},       Space{Words::tr("clip"), "CC"},
                            Space{QStringLiteral("NDC"), "CVV"}, Space{Words::tr("window"), "DC"},
                            Space{Words::tr("widget"), ""}};
    for (int i = 0; i < static_cast<int>(spaces.size()); ++i) {
        const auto &[name, inPaper] = spaces[static_cast<std::size_t>(i)];
        const double x = left(i), middle = x + kBox / 2.0;
        const std::vector<QPointF> box{{x, kTop}, {x + kBox, kTop}, {x + kBox, kBottom}, {x, kBottom}};
        d.area(box, i == 1 ? Stroke::Second : Stroke::Accent);
        d.outline(box);
        const bool isInPaper = *inPaper != '\0';
        d.label({middle, isInPaper ? kMiddle - 0.55 : kMiddle}, name);
        if (isInPaper)
            d.label({middle, kMiddle + 0.6}, text(inPaper), Side::Center, Stroke::Quiet);
    }
    // A station of its own, which changes no coordinates.
    constexpr double kGap = 1.0;
    const double gate = left(kClip) + kBox + kGap, gateEnd = left(kClip + 1) - (kPitch - kBox);
    const std::vector<QPointF> clipping = rectangle(gate, kTop, gateEnd, kBottom);
    d.outline(clipping, Stroke::Dashed);
    d.label({(gate + gateEnd) / 2.0, kMiddle - 0.55}, Words::tr("clipping"));
    d.label({(gate + gateEnd) / 2.0, kMiddle + 0.6}, text("−w … w"), Side::Center, Stroke::Quiet);
    d.label({(gate + gateEnd) / 2.0, kTop - 0.9}, text("glClipPlane"));
    d.arrow({left(kClip) + kBox, kMiddle}, {gate, kMiddle}, Stroke::Accent);
    struct Step {
        const char *above;
        std::vector<const char *> calls; ///< one below the other
    };
    const std::array steps{Step{"M", {"glTranslate,", "glRotate,", "glScale"}},
                           Step{"V", {"gluLookAt"}},
                           Step{"P", {"glFrustum,", "glOrtho"}},
                           Step{"÷ w", {}},
                           Step{"W", {"glViewport"}},
                           Step{"", {"H − y"}}};
    for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
        const auto &[above, calls] = steps[static_cast<std::size_t>(i)];
        const double from = i == kClip ? gateEnd : left(i) + kBox, to = left(i + 1), middle = (from + to) / 2.0;
        d.arrow({from, kMiddle}, {to, kMiddle}, Stroke::Accent);
        d.label({middle, kMiddle}, text(above), Side::Above, Stroke::Accent);
        constexpr double kLine = 1.1;
        double line = kTop - 0.9 - kLine * static_cast<double>(calls.size());
        for (const char *call : calls)
            d.label({middle, line += kLine}, text(call));
    }
    // The way back: from below one box to below another one on its left.
    const auto back = [&](double from, double to, double y, const char *name) {
        d.path({{from, kBottom}, {from, y}, {to, y}, {to, kBottom + 0.5}}, Stroke::Second);
        d.arrow({to, y}, {to, kBottom}, Stroke::Second);
        d.label({(from + to) / 2.0, y}, text(name), Side::Above, Stroke::Second);
    };
    constexpr double kFirst = 9.1, kSecond = 11.1, kIn = 0.8;
    back(left(6) + kBox / 2.0, left(5) + kBox - kIn, kFirst, "(7), (8)");
    back(left(5) + kIn, left(2) + kBox - kIn, kFirst, "(9) … (14)");
    back(left(2) + kIn, left(1) + kBox - kIn, kFirst, "(16)");
    back(left(5) + kBox / 2.0, left(1) + kIn, kSecond, "gluUnProject: (W · P · V)<sup>−1</sup>");
}

/// One dimension of x, and w: all points of a line through the origin are one.
void drawHomogeneous(Drawing &d)
{
    const QPointF origin(3.0, 8.6);
    const auto at = [origin](double x, double w) { return origin + QPointF(4.0 * x, -2.9 * w); };
    d.arrow({1.0, origin.y()}, {24.0, origin.y()}, Stroke::Quiet);
    d.label({24.0, origin.y()}, text("x"), Side::Below);
    d.arrow({origin.x(), 10.0}, {origin.x(), 0.4}, Stroke::Quiet);
    d.label({origin.x(), 0.7}, text("w"), Side::Left);
    d.line({1.0, at(0, 1).y()}, {24.0, at(0, 1).y()}, Stroke::Dashed);
    d.label({1.6, at(0, 1).y()}, text("w = 1"), Side::Above);
    d.line(at(-0.4, -0.4), at(2.75, 2.75), Stroke::Accent);
    for (const double w : {1.0, 2.0})
        d.dot(at(w, w), Stroke::Accent);
    d.label(at(1, 1) + QPointF(1.2, 0.1), text("(x, 1)"), Side::Below);
    d.label(at(2, 2) - QPointF(0.1, 0.45), text("(2 x, 2)"), Side::Left);
    d.dot(at(3.0, 1));
    d.arrow(at(1.05, 1), at(2.95, 1), Stroke::Second);
    d.label(at(2.0, 1), text("a"), Side::Above, Stroke::Second);
    d.label(at(3.0, 1) + QPointF(0.0, 0.1), text("(x + a, 1)"), Side::Below);
    d.arrow(at(0, 0), at(1.6, 0));
    d.label(at(0.95, 0), text("(x, 0)"), Side::Below);
    d.label({22.6, at(0, 1).y()}, Words::tr("points"), Side::Above, Stroke::Quiet);
    d.label({21.4, origin.y()}, Words::tr("vectors"), Side::Above, Stroke::Quiet);
}

/// The eye and its axes, with the other names for them in parentheses.
void drawLookAt(Drawing &d)
{
    const QPointF eye(8.0, 6.4), center(22.0, 4.6);
    d.line(eye, center, Stroke::Dashed);
    d.arrow(eye, between(eye, center, 0.4), Stroke::Accent);
    d.label(between(eye, center, 0.36) + QPointF(0.0, 0.2), text("<b>f</b>"), Side::Below, Stroke::Accent);
    d.arrow(eye, between(eye, center, -0.35), Stroke::Quiet);
    d.label(between(eye, center, -0.35), text("(<b>n</b>)"), Side::Left, Stroke::Quiet);
    const QPointF upwards = eye + QPointF(-0.4, -4.4), side = eye + QPointF(3.3, 3.2);
    d.arrow(eye, upwards, Stroke::Accent);
    d.label(upwards, text("<b>u</b> (<b>v</b>)"), Side::Above, Stroke::Accent);
    d.arrow(eye, side, Stroke::Accent);
    d.label(side, text("<b>s</b> (<b>u</b>)"), Side::Right, Stroke::Accent);
    d.rightAngle(eye, upwards, center);
    const QPointF up = eye + QPointF(2.6, -4.9);
    d.arrow(eye, up, Stroke::SecondDashed);
    d.label(up, text("up"), Side::Right, Stroke::Second);
    d.dot(eye);
    d.label(eye + QPointF(-0.7, 0.1), text("eye"), Side::Below);
    d.dot(center);
    d.label(center, text("center"), Side::Right);
    // The plane that up and f span: u lies in it.
    d.area({eye, upwards, upwards + QPointF(3.4, -0.44), between(eye, center, 0.24)}, Stroke::Second);
}

/// The steps of the view, from above, x to the right and z towards the reader: the world with its
/// axes is moved, then turned, until the eye's axes are x and -z.
void drawViewSteps(Drawing &d)
{
    const QPointF eye(3.4, 2.0), center(-0.8, -1.6);
    const QPointF ahead = center - eye;
    const QPointF forward = ahead / std::hypot(ahead.x(), ahead.y()), side(-forward.y(), forward.x());
    const auto dot = [](const QPointF &a, const QPointF &b) { return QPointF::dotProduct(a, b); };
    const auto draw = [&](const QPointF &origin, bool isMoved, bool isTurned) {
        const auto at = [&](const QPointF &world) {
            const QPointF moved = isMoved ? world - eye : world;
            return origin + (isTurned ? QPointF(dot(side, moved), -dot(forward, moved)) : moved);
        };
        if (isMoved) {
            d.arrow(origin, origin + QPointF(2.6, 0.0), Stroke::Quiet);
            d.label(origin + QPointF(2.5, 0.0), text("x"), Side::Below);
            d.arrow(origin, origin + QPointF(0.0, 2.4), Stroke::Quiet);
            d.label(origin + QPointF(0.0, 2.2), text("z"), Side::Left);
        }
        constexpr double kAxis = 1.8;
        d.arrow(at({}), at({kAxis, 0.0}), Stroke::Second);
        d.arrow(at({}), at({0.0, kAxis}), Stroke::Second);
        if (!isMoved) {
            d.label(at({kAxis - 0.2, 0.0}), text("x"), Side::Above, Stroke::Second);
            d.label(at({0.0, kAxis}), text("z"), Side::Left, Stroke::Second);
        }
        const std::vector<QPointF> object{at(center + QPointF(-0.9, 0.5)), at(center + QPointF(0.8, 0.6)),
                                          at(center + QPointF(0.1, -0.7))};
        d.area(object, Stroke::Second);
        d.outline(object);
        const QPointF tip = at(eye + 2.0 * forward), right = at(eye + 1.7 * side);
        d.arrow(at(eye), tip, Stroke::Accent);
        d.arrow(at(eye), right, Stroke::Accent);
        d.label(between(at(eye), tip, 0.7) + QPointF(0.2, 0.1), text("<b>f</b>"), isTurned ? Side::Right : Side::Above,
                Stroke::Accent);
        d.label(right, text("<b>s</b>"), Side::Above, Stroke::Accent);
        d.dot(at(eye));
        d.label(at(eye) + QPointF(-0.2, 0.2), text("eye"), isMoved ? Side::Left : Side::Below);
    };
    const auto step = [&d](double at, const char *letter) {
        d.arrow({at - 0.9, 2.0}, {at + 0.9, 2.0}, Stroke::Accent);
        d.label({at, 1.9}, text(letter), Side::Above, Stroke::Accent);
    };
    constexpr double kEye = 7.0;
    draw({2.2, kEye - eye.y()}, false, false);
    step(9.4, "T");
    draw({16.6, kEye}, true, false);
    step(21.0, "R");
    draw({26.4, kEye}, true, true);
}

/// glScale(2, 1, 1): the points' matrix tilts the normal.
void drawNormals(Drawing &d)
{
    constexpr double kUnit = 3.6;
    const auto draw = [&d](const QPointF &origin, double stretch, bool isScaled) {
        const auto at = [origin](double x, double y) { return origin + QPointF(kUnit * x, -kUnit * y); };
        d.arrow(at(-0.1, 0), at(stretch + 0.7, 0), Stroke::Quiet);
        d.label(at(stretch + 0.7, 0), text("x"), Side::Below);
        d.arrow(at(0, -0.1), at(0, 1.6), Stroke::Quiet);
        d.label(at(0, 1.55), text("y"), Side::Left);
        d.line(at(0, 1), at(stretch, 0));
        const QPointF middle = at(stretch / 2.0, 0.5);
        const QPointF tangent = at(stretch * 0.8, 0.2);
        // Perpendicular to (stretch, -1): (1, stretch) / stretch, by the normal matrix.
        const QPointF normal = middle + QPointF(kUnit * 0.62 / stretch, -kUnit * 0.62);
        d.arrow(middle, normal, Stroke::Accent);
        // The name of the other one is beside it if scaled.
        d.label(normal - QPointF(isScaled ? 0.7 : 0.0, 0.0), isScaled ? text("(½, 1, 0)") : text("n = (1, 1, 0)"),
                Side::Above, Stroke::Accent);
        d.rightAngle(middle, normal, tangent);
        if (isScaled) {
            const QPointF wrong = middle + QPointF(kUnit * 1.24, -kUnit * 0.62);
            d.arrow(middle, wrong, Stroke::SecondDashed);
            d.label(wrong + QPointF(0.7, 0.0), text("(2, 1, 0)"), Side::Above, Stroke::Second);
        }
    };
    draw({2.0, 7.0}, 1.0, false);
    d.arrow({10.2, 4.6}, {16.4, 4.6}, Stroke::Quiet);
    d.label({13.2, 4.5}, text("glScale(2, 1, 1)"), Side::Above);
    draw({19.0, 7.0}, 2.0, true);
}

/// (16): the eye's axes, scaled and added.
void drawEyeToWorld(Drawing &d)
{
    const QPointF origin(2.6, 9.4);
    for (const QPointF &axis : {QPointF(2.6, 0.0), QPointF(0.0, -2.6), QPointF(-1.4, 1.2)})
        d.arrow(origin, origin + axis, Stroke::Quiet);
    d.label(origin + QPointF(2.5, 0.0), text("x"), Side::Below);
    d.label(origin + QPointF(0.0, -2.5), text("y"), Side::Left);
    d.label(origin + QPointF(-1.3, 1.1), text("z"), Side::Left);
    const QPointF eye(8.4, 5.2), along = eye + QPointF(11.0, -1.3), right = along + QPointF(1.9, 1.9),
                                 point = right + QPointF(-0.3, -3.9);
    d.arrow(origin, eye);
    d.label(between(origin, eye, 0.55) + QPointF(-0.2, -0.3), text("eye"), Side::Left);
    d.arrow(eye, along, Stroke::Accent);
    d.label(between(eye, along, 0.5), text("z <b>f</b>"), Side::Above, Stroke::Accent);
    d.arrow(along, right, Stroke::Accent);
    d.label(between(along, right, 0.8) + QPointF(-0.5, 0.4), text("x <b>s</b>"), Side::Left, Stroke::Accent);
    d.arrow(right, point, Stroke::Accent);
    d.label(between(right, point, 0.5), text("y <b>u</b>"), Side::Right, Stroke::Accent);
    d.line(origin, point, Stroke::SecondDashed);
    d.dot(eye);
    d.dot(point, Stroke::Second);
    d.label(point + QPointF(0.1, 0.0), text("p"), Side::Right, Stroke::Second);
}

} // namespace unprojector::gui::figures
