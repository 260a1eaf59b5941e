#include "gui/text/formula_text.h"

#include "core/geometry/numbers.h"
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
/// The digits of numbers that users compare with their own: pixels, the viewport.
constexpr int kPixelDigits = 10;

struct Formulas {
    Q_DECLARE_TR_FUNCTIONS(Formulas)
};

/// The number with the typographic minus, as in the paper.
QString number(double value, int digits = kDigits)
{
    return writtenText(value, digits).replace(u'-', u'−');
}

/// A coordinate; far from zero with more digits than other numbers: down to thousandths, if those
/// are certain.
QString coordinate(double value, double uncertainty)
{
    constexpr int kDecimals = 3;
    const int before = std::abs(value) < 1.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return number(value, std::max(kDigits, before + std::clamp(-certainPlace(uncertainty), 0, kDecimals)));
}

FormulaTerm scalar(const char *symbol, const QString &name, double value, int digits = kDigits)
{
    return {QString::fromUtf8(symbol), name, {number(value, digits)}, {value}};
}

/// @param uncertainty  of each coordinate
FormulaTerm vector(const char *symbol, const QString &name, const Components<3> &v,
                   const Components<3> &uncertainty = {})
{
    return {QString::fromUtf8(symbol),
            name,
            {coordinate(v.x, uncertainty.x), coordinate(v.y, uncertainty.y), coordinate(v.z, uncertainty.z)},
            {v.x, v.y, v.z}};
}

/// All terms in the formulas of a surface pick.
FormulaTerms termsOf(const Pick &pick, const EyePoint &eye, const WorldPoint &world, double depth,
                     const EyeFrame &frame)
{
    const DevicePoint device = pixelCenter(pick.devicePixel);
    const Viewport &v = pick.setup.viewport;
    const ProjectionWindow w = projectionWindow(pick.setup.projection());
    const double z = -eye.z;
    const auto *oblique = std::get_if<Oblique>(&pick.setup.projection());
    FormulaTerms terms{
        {"px", scalar("px", Formulas::tr("The pixel's centre from the window's left edge, device pixels"), device.x,
                      kPixelDigits)},
        {"py", scalar("py", Formulas::tr("The pixel's centre from the window's upper edge, device pixels"), device.y,
                      kPixelDigits)},
        {"H", scalar("rect.bottom", Formulas::tr("Height of the window, device pixels"),
                     pick.setup.surface.heightPixels, kPixelDigits)},
        {"vx", scalar("v<sub>x</sub>", Formulas::tr("Left edge of the viewport, device pixels"), v.x, kPixelDigits)},
        {"vy", scalar("v<sub>y</sub>", Formulas::tr("Lower edge of the viewport, device pixels"), v.y, kPixelDigits)},
        {"width", scalar("width", Formulas::tr("Width of the viewport, device pixels"), v.width)},
        {"height", scalar("height", Formulas::tr("Height of the viewport, device pixels"), v.height)},
        {"l", scalar("l", Formulas::tr("Left edge of the projection window, eye units"), w.left)},
        {"r", scalar("r", Formulas::tr("Right edge of the projection window, eye units"), w.right)},
        {"b", scalar("b", Formulas::tr("Lower edge of the projection window, eye units"), w.bottom)},
        {"t", scalar("t", Formulas::tr("Upper edge of the projection window, eye units"), w.top)},
        {"n", scalar("n", Formulas::tr("Distance of the near plane, eye units"), w.nearDistance)},
        {"f", scalar("f", Formulas::tr("Distance of the far plane, eye units"), w.farDistance)},
        {"d", FormulaTerm{QStringLiteral("d"),
                          Formulas::tr("Depth from the depth buffer, 0 at the near and 1 at the far plane"),
                          {depthText(depth).replace(u'-', u'−')},
                          {depth}}},
        {"z", scalar("z", Formulas::tr("Distance of the point in front of the eye, eye units"), z)},
        {"x", scalar("x", Formulas::tr("Distance of the point to the right of the eye, eye units"), eye.x)},
        {"y", scalar("y", Formulas::tr("Distance of the point above the eye, eye units"), eye.y)},
        {"eye", vector("eye", Formulas::tr("Position of the eye, world units"), frame.eye, pick.uncertainty.world)},
        {"s", vector("<b>s</b>", Formulas::tr("The eye's axis to the right, world space"), frame.side)},
        {"u", vector("<b>u</b>", Formulas::tr("The eye's axis upwards, world space"), frame.upward)},
        {"forward", vector("<b>f</b>", Formulas::tr("The eye's axis forwards, world space"), frame.forward)},
        {"world", vector("world", Formulas::tr("The point, world units"), world, pick.uncertainty.world)},
    };
    if (w.skew != 0.0) {
        terms[QStringLiteral("x0")] =
            scalar("x<sub>0</sub>", Formulas::tr("The point's x before the skew is undone, eye units"),
                   eye.x + w.skew * eye.y);
        terms[QStringLiteral("skew")] = scalar("skew", Formulas::tr("Shift of x per unit of y by the skew"), w.skew);
    }
    if (oblique) {
        const auto shear = [&terms, z](const char *of, const char *symbol, const char *before, const char *cot,
                                       const Angle &angle, double sheared) {
            const QString degrees = number(angle.degrees());
            terms[QLatin1String(of) + QStringLiteral("0")] =
                scalar(before, Formulas::tr("The point in the box, before the shear, eye units"),
                       sheared - cotangent(angle) * z);
            terms[QLatin1String(cot)] = {QString::fromUtf8(symbol),
                                         Formulas::tr("Shift by the shear per unit of z"),
                                         {QStringLiteral("cot %1°").arg(degrees)},
                                         {cotangent(angle)}};
        };
        shear("x", "cot θ", "x<sub>0</sub>", "cotTheta", oblique->theta, eye.x);
        shear("y", "cot φ", "y<sub>0</sub>", "cotPhi", oblique->phi, eye.y);
    }
    return terms;
}

PickFormulas surfaceFormulas(const Pick &pick)
{
    const Result<EyePoint> &eye = pick.point.eye[Method::Formula];
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    const Result<double> depth = unitDepth(pick.setup.depthRange, pick.window.z);
    const Result<EyeFrame> frame = eyeFrame(pick.setup.camera());
    if (!eye || !world || !depth || !frame)
        return {};
    PickFormulas result{{}, termsOf(pick, *eye, *world, *depth, *frame)};
    const auto add = [&result](const char *number, const char *left, const char *expression) {
        result.formulas.emplace_back(QString::fromUtf8(number), QString::fromUtf8(left), QString::fromUtf8(expression),
                                     result.terms);
    };
    const bool isOblique = std::holds_alternative<Oblique>(pick.setup.projection());
    const bool hasSkew = projectionWindow(pick.setup.projection()).skew != 0.0;
    if (isPerspective(pick.setup.projection())) {
        add("(13)", "z", "{[n]*[f] | [f]*(1 − [d]) + [n]*[d]}");
        add("(9)", hasSkew ? "x0" : "x", "{([px] − [vx])*([r] − [l])*[z] | [width] · [n]} + {[l]*[z] | [n]}");
        add("(10)", "y", "{([H] − [py] − [vy])*([t] − [b])*[z] | [height] · [n]} + {[b]*[z] | [n]}");
        if (hasSkew)
            add("(9)", "x", "[x0] − [skew]*[y]");
    } else {
        add("(14)", "z", "[n]*(1 − [d]) + [f]*[d]");
        add("(11)", isOblique ? "x0" : "x", "{([px] − [vx])*([r] − [l]) | [width]} + [l]");
        add("(12)", isOblique ? "y0" : "y", "{([H] − [py] − [vy])*([t] − [b]) | [height]} + [b]");
    }
    if (isOblique) {
        add("(15)", "x", "[x0] + [cotTheta]*[z]");
        add("(15)", "y", "[y0] + [cotPhi]*[z]");
    }
    add("(16)", "world", "[eye] + [x]*[s] + [y]*[u] + [z]*[forward]");
    return result;
}

PickFormulas rayFormulas(const Pick &pick)
{
    const Result<WorldPoint> &enter = pick.rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick.rayFar.world[Method::Formula];
    if (!enter || !leave)
        return {};
    PickFormulas result;
    result.terms = {
        {"p", {QStringLiteral("p(t)"), Formulas::tr("A point of the ray, world units"), {}, {}}},
        {"t", {QStringLiteral("t"), Formulas::tr("Fraction of the distance from the near to the far plane"), {}, {}}},
        {"near", vector("near", Formulas::tr("Point where the ray enters the view volume, world units"), *enter)},
        {"way",
         vector("(far − near)", Formulas::tr("Vector to the point where the ray leaves the view volume, world units"),
                *leave - *enter)}};
    result.formulas.emplace_back(QString(), QStringLiteral("p"), QStringLiteral("[near] + [t]*[way]"), result.terms,
                                 QStringLiteral(", 0 ≤ t ≤ 1"));
    return result;
}

} // namespace

PickFormulas formulasOf(const Pick &pick)
{
    return pick.hit() ? surfaceFormulas(pick) : rayFormulas(pick);
}

QString PickFormulas::text() const
{
    QStringList lines;
    for (const FormulaWithNumbers &formula : formulas)
        lines << formula.text();
    return lines.join(QStringLiteral("\n\n"));
}

QString certaintyText(const Pick &pick)
{
    if (pick.hit()) {
        const Certainty &c = pick.certainty;
        if (pick.sample.dotPixels > 1.0)
            return Formulas::tr("Accuracy ± %1 along the view and ± %2 × %3 across it (half of the %4 pixels that a "
                                "point is drawn wide).")
                .arg(boundText(c.distance), boundText(c.footprintWidth / 2.0), boundText(c.footprintHeight / 2.0),
                     significantText(pick.sample.dotPixels, 3));
        return Formulas::tr("Accuracy ± %1 along the view (depth buffer alone ± %2). A pixel covers %3 × %4 here.")
            .arg(boundText(c.distance), readableText(c.halfDepthStep), readableText(c.footprintWidth),
                 readableText(c.footprintHeight));
    }
    const Result<WorldPoint> &enter = pick.rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick.rayFar.world[Method::Formula];
    if (!enter || !leave)
        return {};
    const auto written = [](const WorldPoint &p) {
        return QStringLiteral("(%1, %2, %3)").arg(coordinate(p.x, 0.0), coordinate(p.y, 0.0), coordinate(p.z, 0.0));
    };
    return Formulas::tr("The ray enters the view volume at %1 and leaves it at %2.")
        .arg(written(*enter), written(*leave));
}

} // namespace unprojector::gui
