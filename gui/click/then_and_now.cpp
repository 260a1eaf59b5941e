#include "gui/click/then_and_now.h"

#include "core/geometry/numbers.h"
#include "core/geometry/setup.h"
#include "gui/click/comparison_model.h"
#include "gui/click/pick_rows.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/since_click_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::ThenAndNow)
};

/// A point with the uncertainty of each coordinate.
template <class OfPoint>
struct Measured {
    OfPoint at;
    Components<3> uncertainty;
};

/// The picked point in one setup.
struct PointIn {
    Measured<WorldPoint> world;
    Measured<EyePoint> eye;
    ClipPoint clip;
    std::optional<Measured<WindowPoint>> window; ///< nothing in the plane of the eye and behind it
};

/// The window point of an eye point; nothing unless w > 0. The uncertainties are multiplied by the
/// derivatives of the division and the viewport transform.
std::optional<Measured<WindowPoint>> windowOf(const Setup &setup, const glm::dmat4 &clipFromEye,
                                              const Measured<EyePoint> &eye, const ClipPoint &clip)
{
    if (!(clip.w > 0.0))
        return std::nullopt;
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    const auto &[atNear, atFar] = setup.depthRange;
    const std::array half{setup.viewport.width / 2.0, setup.viewport.height / 2.0, std::abs(atFar - atNear) / 2.0};
    Measured<WindowPoint> window{windowFromNdc(setup.viewport, setup.depthRange, ndc, ndcDepthOf(setup)), {}};
    for (int axis = 0; axis < 3; ++axis) {
        for (int of = 0; of < 3; ++of)
            window.uncertainty[axis] += half[static_cast<std::size_t>(axis)] / clip.w
                                        * std::abs(clipFromEye[of][axis] - ndc[axis] * clipFromEye[of][3])
                                        * eye.uncertainty[of];
    }
    return window;
}

/// @param ofEye  the eye point's uncertainty; if it is known directly; nothing: computed from the
/// world point's, which is less accurate
std::optional<PointIn> pointIn(const Setup &setup, const Measured<WorldPoint> &world,
                               const std::optional<Components<3>> &ofEye)
{
    const Result<glm::dmat4> view = eyeFromWorld(setup), projection = clipFromEye(setup);
    if (!view || !projection)
        return std::nullopt;
    const Measured<EyePoint> eye{EyePoint(glm::dvec3(*view * glm::dvec4(world.at.coordinates(), 1.0))),
                                 ofEye ? *ofEye : mapped(glm::dmat3(*view), world.uncertainty)};
    const ClipPoint clip(*projection * glm::dvec4(eye.at.coordinates(), 1.0));
    return PointIn{world, eye, clip, windowOf(setup, *projection, eye, clip)};
}

std::optional<PointIn> pointThen(const KeptPick &kept)
{
    const std::optional<WorldPoint> point = pickedPoint(kept);
    if (!point)
        return std::nullopt;
    const Pick &pick = *kept.pick;
    const Result<WorldPoint> &formula = pick.point.world[Method::Formula];
    const bool isSnapped = !formula || point->coordinates() != formula->coordinates();
    std::optional<PointIn> then =
        pointIn(pick.setup, {*point, pickedUncertainty(kept)},
                isSnapped ? std::nullopt : std::optional(Components<3>(pick.uncertainty.eye)));
    if (then && then->window && !isSnapped)
        then->window->at = pick.window; // the exact pixel centre, without rounding on the way forward
    return then;
}

std::optional<PointIn> pointNow(const SceneDocument &document)
{
    const KeptPick &kept = document.picks().keptPick();
    const std::optional<WorldPoint> point = pickedPoint(kept);
    if (!point)
        return std::nullopt;
    Measured<WorldPoint> world{*point, pickedUncertainty(kept)};
    if (const PreciseMatrix placement = placementOf(*kept.pick, document.objects()); placement != kept.placement) {
        const glm::dmat4 moved = placement.rounded() * glm::inverse(kept.placement.rounded());
        world = {WorldPoint(glm::dvec3(moved * glm::dvec4(point->coordinates(), 1.0))),
                 mapped(glm::dmat3(moved), world.uncertainty)};
    }
    return pointIn(document.setup(), world, std::nullopt);
}

/// The row of a coordinate. Both texts are the same if only rounding or uncertain digits changed.
/// @param scale  the largest coordinate of the point, whose rounding reaches all of them
ThenAndNow row(const QString &name, double then, const std::optional<double> &now, double ofThen, double ofNow,
               double scale)
{
    constexpr double kRounding = 1e-11, kShare = 1e-3; // of the scale, of the uncertainty
    const QString text = certainText(then, ofThen);
    if (!now)
        return {name, text, QStringLiteral("–"), true, then};
    const bool isClose = std::abs(*now - then) <= std::max(kRounding * scale, kShare * std::min(ofThen, ofNow));
    const QString nowText = isClose ? text : certainText(*now, ofNow);
    return {name, text, nowText, nowText != text, then, now};
}

double scaleOf(const Components<3> &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Adds "name: a → b" if two values differ, with enough digits to distinguish them.
/// @param textOf  formats a value with a number of significant digits
template <class Value, class TextOf>
void addChange(QStringList &changes, const QString &name, const Value &a, const Value &b, const TextOf &textOf)
{
    constexpr int kDigits = 6, kMostDigits = 12; // further digits are rounding
    QString from = textOf(a, kDigits), to = textOf(b, kDigits);
    if (from == to) {
        from = textOf(a, kMostDigits);
        to = textOf(b, kMostDigits);
    }
    if (from != to)
        changes << QStringLiteral("%1: %2 → %3").arg(name, from, to);
}

QString number(double value, int digits)
{
    return writtenText(value, digits);
}

QString triple(const Components<3> &v, int digits)
{
    return QStringLiteral("(%1, %2, %3)").arg(number(v.x, digits), number(v.y, digits), number(v.z, digits));
}

QString kindText(ProjectionKind kind)
{
    switch (kind) {
    case ProjectionKind::Frustum: return Texts::tr("frustum");
    case ProjectionKind::Perspective: return Texts::tr("perspective");
    case ProjectionKind::Ortho: return Texts::tr("orthographic");
    case ProjectionKind::Oblique: return Texts::tr("oblique");
    }
    Q_UNREACHABLE();
}

constexpr double kRoundedToZero = 1e-12; // a smaller part of a unit vector or of a window is rounding

void addCameraChanges(QStringList &changes, const Setup &then, const Setup &now)
{
    const Result<EyeFrame> from = eyeFrame(then.camera()), to = eyeFrame(now.camera());
    if (!from || !to)
        return;
    const auto direction = [](const WorldVector &v, int digits) {
        const auto exact = [](double value) { return std::abs(value) > kRoundedToZero ? value : 0.0; };
        return triple({exact(v.x), exact(v.y), exact(v.z)}, digits);
    };
    addChange(changes, Texts::tr("Eye position"), from->eye, to->eye, triple);
    const qsizetype before = changes.size();
    addChange(changes, Texts::tr("View direction"), from->forward, to->forward, direction);
    if (changes.size() == before) // else it turns with the direction
        addChange(changes, Texts::tr("Up direction"), from->upward, to->upward, direction);
}

void addProjectionChanges(QStringList &changes, const Projection &then, const Projection &now)
{
    const ProjectionWindow from = projectionWindow(then), to = projectionWindow(now);
    addChange(changes, Texts::tr("Projection"), kindOf(then), kindOf(now),
              [](ProjectionKind kind, int) { return kindText(kind); });
    if (isPerspective(then) && isPerspective(now)) {
        addChange(changes, Texts::tr("Vertical field of view"), from, to, [](const ProjectionWindow &w, int digits) {
            const double angle = std::atan(w.top / w.nearDistance) - std::atan(w.bottom / w.nearDistance);
            return number(degreesFromRadians(angle), digits) + u'°';
        });
        addChange(changes, Texts::tr("Aspect"), from, to, [](const ProjectionWindow &w, int digits) {
            return number((w.right - w.left) / (w.top - w.bottom), digits);
        });
        addChange(changes, Texts::tr("Centre of the projection window at near 1"), from, to,
                  [](const ProjectionWindow &w, int digits) {
                      const auto centre = [&](double a, double b) {
                          const double sum = (a + b) / (2.0 * w.nearDistance);
                          return std::abs(sum) > kRoundedToZero ? sum : 0.0;
                      };
                      return QStringLiteral("(%1, %2)")
                          .arg(number(centre(w.left, w.right), digits), number(centre(w.bottom, w.top), digits));
                  });
    } else {
        addChange(changes, Texts::tr("Projection window"), from, to, [](const ProjectionWindow &w, int digits) {
            return QStringLiteral("x %1 … %2, y %3 … %4")
                .arg(number(w.left, digits), number(w.right, digits), number(w.bottom, digits), number(w.top, digits));
        });
    }
    const auto *obliqueThen = std::get_if<Oblique>(&then), *obliqueNow = std::get_if<Oblique>(&now);
    if (obliqueThen && obliqueNow) {
        addChange(changes, Texts::tr("Shear angles"), *obliqueThen, *obliqueNow, [](const Oblique &o, int digits) {
            return QStringLiteral("θ %1°, φ %2°")
                .arg(number(o.theta.degrees(), digits), number(o.phi.degrees(), digits));
        });
    }
    addChange(changes, Texts::tr("Skew"), from.skew, to.skew, number);
    addChange(changes, Texts::tr("Near"), from.nearDistance, to.nearDistance, number);
    addChange(changes, Texts::tr("Far"), from.farDistance, to.farDistance, number);
}

} // namespace

std::vector<ThenAndNow> thenAndNow(const SceneDocument &document)
{
    const std::optional<PointIn> then = pointThen(document.picks().keptPick()), now = pointNow(document);
    if (!then || !now || !then->window)
        return {};
    std::vector<ThenAndNow> rows;
    const std::array windowNames{Texts::tr("Window x"), Texts::tr("Window y"), Texts::tr("Window depth")};
    constexpr double kPixelDigit = 0.01; // as pixels are written everywhere
    for (int axis = 0; axis < 3; ++axis) {
        const bool isPixel = axis < 2;
        ThenAndNow one = row(windowNames[static_cast<std::size_t>(axis)], then->window->at[axis],
                             now->window ? std::optional(now->window->at[axis]) : std::nullopt,
                             isPixel ? kPixelDigit : then->window->uncertainty[axis],
                             now->window ? std::max(now->window->uncertainty[axis], isPixel ? kPixelDigit : 0.0) : 0.0,
                             isPixel ? scaleOf(then->window->at) : 1.0);
        if (isPixel) {
            one.then = pixelText(then->window->at[axis]);
            if (!one.differs && now->window)
                one.now = one.then;
        }
        rows.push_back(std::move(one));
    }
    const auto add = [&rows](const std::array<QString, 3> &names, const auto &a, const auto &b) {
        for (int axis = 0; axis < 3; ++axis)
            rows.push_back(row(names[static_cast<std::size_t>(axis)], a.at[axis], b.at[axis], a.uncertainty[axis],
                               b.uncertainty[axis], std::max(scaleOf(a.at), scaleOf(b.at))));
    };
    add({Texts::tr("Eye x"), Texts::tr("Eye y"), Texts::tr("Eye z")}, then->eye, now->eye);
    add({Texts::tr("World x"), Texts::tr("World y"), Texts::tr("World z")}, then->world, now->world);
    return rows;
}

QString placeNowText(const SceneDocument &document)
{
    const std::optional<PointIn> now = pointNow(document);
    const QString outside = now ? clipTestText(now->clip) : QString();
    return outside.isEmpty() ? outside : Texts::tr("Now the point is outside the view volume: %1.").arg(outside);
}

QStringList setupChanges(const SceneDocument &document)
{
    const std::optional<Pick> &pick = document.picks().pick();
    if (!pick)
        return {};
    const Setup &then = pick->setup, &now = document.setup();
    QStringList changes;
    addCameraChanges(changes, then, now);
    addProjectionChanges(changes, then.projection(), now.projection());
    addChange(changes, Texts::tr("Viewport"), then.viewport, now.viewport, [](const Viewport &v, int digits) {
        return QStringLiteral("(%1, %2) %3 × %4")
            .arg(number(v.x, digits), number(v.y, digits), number(v.width, digits), number(v.height, digits));
    });
    addChange(changes, Texts::tr("Depth range"), then.depthRange, now.depthRange, [](const DepthRange &r, int digits) {
        return QStringLiteral("[%1, %2]").arg(number(r.atNear, digits), number(r.atFar, digits));
    });
    addChange(changes, Texts::tr("Window size"), then.surface, now.surface,
              [](const Surface &s, int) { return QStringLiteral("%1 × %2").arg(s.widthPixels).arg(s.heightPixels); });
    addChange(changes, Texts::tr("Pixel ratio"), then.surface.devicePixelRatio, now.surface.devicePixelRatio, number);
    return changes;
}

} // namespace unprojector::gui
