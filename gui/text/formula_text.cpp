#include "gui/text/formula_text.h"

#include "core/geometry/angle.h"
#include "core/unproject/closed_form.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;
namespace {

constexpr int kDigits = 6;

struct Formulas {
    Q_DECLARE_TR_FUNCTIONS(Formulas)
};

/// With the typographic minus, as the paper has it.
QString number(double value, int digits = kDigits)
{
    return significantText(value, digits).replace(u'-', u'−');
}

/// In parentheses where a sign would run into an operator.
QString term(double value, int digits = kDigits)
{
    const QString text = number(value, digits);
    return value < 0.0 ? u'(' + text + u')' : text;
}

/// The values that the formulas name, of any projection.
struct Values {
    ProjectionWindow w;
    Viewport v;
    double px, py, rectBottom;
    double depth, z;
    EyePoint eye;
    bool perspective;
};

QString depthLine(const Values &a)
{
    const QString n = number(a.w.nearDistance), f = number(a.w.farDistance);
    const QString d = number(a.depth, 9);
    if (a.perspective) {
        return QStringLiteral("z = n f / (f (1 − d) + n d)\n  = %1 × %2 / (%2 × (1 − %3) + %1 × %3) = %4")
            .arg(n, f, d, number(a.z));
    }
    return QStringLiteral("z = n (1 − d) + f d\n  = %1 × (1 − %2) + %3 × %2 = %4")
        .arg(term(a.w.nearDistance), d, term(a.w.farDistance), number(a.z));
}

/// (9) and (10), or (11) and (12), for one axis.
/// @param position  "412.5 − 0" for x, "600 − 300.5 − 0" for y: what stands in the first parentheses
QString axisLine(const QString &head, const QString &position, double low, double high, double size, const Values &a,
                 double result)
{
    const QString window = QStringLiteral("(%1) × (%2 − %3)").arg(position, number(high), term(low));
    if (a.perspective) {
        return QStringLiteral("%1 = %2 × %3 / (%4 × %5) + %6 × %3 / %5 = %7")
            .arg(head, window, number(a.z), number(size), number(a.w.nearDistance), term(low), number(result));
    }
    return QStringLiteral("%1 = %2 / %3 + %4 = %5").arg(head, window, number(size), term(low), number(result));
}

QString vectorText(const Components<3> &v)
{
    return QStringLiteral("(%1, %2, %3)").arg(number(v.x), number(v.y), number(v.z));
}

QString agreementText()
{
    return Formulas::tr(
        "The two agree to the last places: the matrix rounds at every step, the formula once at the end.");
}

QString boxCauseText(const QString &byCancelling)
{
    return Formulas::tr(
               "Cause: rounding in the inverted matrix, magnified %1 times where the eye's coordinates cancel. The "
               "formula inverts nothing.")
        .arg(byCancelling);
}

QString perspectiveCauseText(const QString &byPerspective, const QString &byCancelling)
{
    return Formulas::
        tr("Cause: rounding in the inverted matrix, magnified %1 times by the perspective (z (f − n) / (f n)) and %2 "
           "times where the eye's coordinates cancel. The formula inverts nothing.")
            .arg(byPerspective, byCancelling);
}

QString leftOpenText(const QString &along, const QString &across, const QString &up)
{
    return Formulas::tr("The buffers leave ± %1 along the view (half a depth step) and ± %2 × %3 across it "
                        "(half a pixel).")
        .arg(along, across, up);
}

} // namespace

QString formulaText(const Pick &pick)
{
    const Result<EyePoint> &eye = pick.point.eye[Method::Formula];
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    const Result<double> depth = unitDepth(pick.geometry.depthRange, pick.window.z);
    const Result<EyeFrame> frame = eyeFrame(pick.geometry.camera());
    if (!eye || !world || !depth || !frame)
        return {};
    const DevicePoint device = pixelCenter(pick.devicePixel);
    const Values a{projectionWindow(pick.geometry.projection()),
                   pick.geometry.viewport,
                   device.x,
                   device.y,
                   double(pick.geometry.surface.heightPixels),
                   *depth,
                   -eye->z,
                   *eye,
                   isPerspective(pick.geometry.projection())};
    const auto *oblique = std::get_if<Oblique>(&pick.geometry.projection());
    const double boxX = oblique ? eye->x - cotangent(oblique->thetaRadians) * a.z : eye->x;
    const double boxY = oblique ? eye->y - cotangent(oblique->phiRadians) * a.z : eye->y;

    // px, py and the viewport are written in full: they are short, and they are what people compare with their own.
    const QString xPosition = QStringLiteral("%1 − %2").arg(number(a.px, 10), term(a.v.x, 10));
    const QString yPosition =
        QStringLiteral("%1 − %2 − %3").arg(number(a.rectBottom, 10), number(a.py, 10), term(a.v.y, 10));
    const QString xName = a.perspective ? QStringLiteral("(9) x") : QStringLiteral("(11) x");
    const QString yName = a.perspective ? QStringLiteral("(10) y") : QStringLiteral("(12) y");
    QStringList lines{
        depthLine(a),
        axisLine(xName, xPosition, a.w.left, a.w.right, a.v.width, a, boxX),
        axisLine(yName, yPosition, a.w.bottom, a.w.top, a.v.height, a, boxY),
    };
    if (oblique) {
        const auto shear = [&a](const QString &name, double from, double angle, double to) {
            return QStringLiteral("%1 += cot %2° × %3: %4 → %5")
                .arg(name, number(degreesFromRadians(angle)), number(a.z), number(from), number(to));
        };
        lines << shear(QStringLiteral("x"), boxX, oblique->thetaRadians, eye->x)
              << shear(QStringLiteral("y"), boxY, oblique->phiRadians, eye->y);
    }
    lines << Formulas::tr("world = eye + x s + y u + z f\n  = %1 + %2 × %3 + %4 × %5 + %6 × %7\n  = %8")
                 .arg(vectorText(frame->eye), term(eye->x), vectorText(frame->side), term(eye->y),
                      vectorText(frame->upward), term(a.z), vectorText(frame->forward), vectorText(*world));
    return lines.join(QStringLiteral("\n\n"));
}

QString rayText(const Pick &pick)
{
    const Result<WorldPoint> &enter = pick.rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick.rayFar.world[Method::Formula];
    if (!enter || !leave)
        return {};
    return Formulas::tr("p(t) = near + t (far − near), 0 ≤ t ≤ 1\nnear = %1\nfar = %2")
        .arg(vectorText(*enter), vectorText(*leave));
}

QString differenceCauseText(const Pick &pick)
{
    const Answers<WorldSpace> &world = pick.hit() ? pick.point.world : pick.rayFar.world;
    if (!world[Method::Formula] || !world[Method::Matrix])
        return {};
    const WorldVector d = world.difference();
    const double ulps = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) / ulpOfLargest(*world[Method::Formula]);
    if (ulps <= 4.0)
        return agreementText();
    const Result<EyePoint> &eye = pick.hit() ? pick.point.eye[Method::Formula] : pick.rayFar.eye[Method::Formula];
    if (!eye)
        return {};
    // Near the world's origin the eye and the way from it cancel, and what rounding did to either stands out.
    const WorldPoint point = *world[Method::Formula], origin = pick.geometry.camera().eye;
    const auto largest = [](const Components<3> &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    const double cancelled = std::max(largest(origin), largest(*eye)) / largest(point);
    const QString byCancelling = significantText(std::max(1.0, cancelled), 2);
    if (!isPerspective(pick.geometry.projection()))
        return boxCauseText(byCancelling);
    // z_ndc changes by n f / (f - n) / z^2 a unit of z: what rounding does to the one shows in the other that much larger.
    const ProjectionWindow w = projectionWindow(pick.geometry.projection());
    const double n = w.nearDistance, f = w.farDistance, z = -eye->z;
    return perspectiveCauseText(significantText(std::max(1.0, z * (f - n) / (f * n)), 2), byCancelling);
}

QStringList longestDifferenceCauseTexts()
{
    const QString widest = significantText(8.8e88, 2);
    return {agreementText(), boxCauseText(widest), perspectiveCauseText(widest, widest)};
}

QString certaintyText(const Pick &pick)
{
    const Certainty &c = pick.certainty;
    return leftOpenText(readableText(c.halfDepthStep), readableText(c.footprintWidth / 2.0),
                        readableText(c.footprintHeight / 2.0));
}

QStringList longestCertaintyTexts()
{
    const QString widest = readableText(-8e-88);
    return {leftOpenText(widest, widest, widest)};
}

} // namespace unprojector::gui
