#include "gui/text/mistake_text.h"

#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

namespace unprojector::gui {
namespace {

struct MistakeText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MistakeText)
};

struct Wording {
    std::string_view id;
    const char *name;
    const char *sentence;
};

/// By the ids that core/doctor has. The sentences are its own.
constexpr Wording kMistakes[] = {
    {"y-not-flipped", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "y not flipped"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "y is not turned over: rows of a window count from the top, OpenGL's from the bottom.")},
    {"row-above", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "row above"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The row is one too high: H - y is taken for H - 1 - y.")},
    {"row-below", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "row below"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The row is one too low: H - 1 - y is taken for H - y, though y has its half already.")},
    {"pixel-corner", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "pixel corner"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The pixel's corner is unprojected instead of its centre: half a pixel is missing.")},
    {"ratio-logical-in-device",
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "logical pixels in a device viewport"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The pixel is in logical pixels, the viewport and the height of the flip are in device pixels.")},
    {"ratio-logical-both", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "pixel and flip in logical pixels"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The pixel and the height of the flip are in logical pixels, the viewport is in device pixels.")},
    {"ratio-device-in-logical",
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "device pixels in a logical viewport"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The viewport is in logical pixels, the pixel in device pixels; or the pixel ratio is applied twice.")},
    {"viewport-origin-ignored", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "viewport's origin ignored"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The viewport's origin is ignored, as if it lay in the window's corner.")},
    {"viewport-y-from-top", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "viewport's y from the top"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The viewport's y is counted from the top of the window; OpenGL counts it from the bottom.")},
    {"flipped-with-viewport-height",
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "flipped with the viewport's height"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "y is turned over with the viewport's height instead of the framebuffer's.")},
    {"viewport-is-window", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "window taken for viewport"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The whole window is taken for the viewport.")},
    {"xy-swapped", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "x and y swapped"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "x and y are swapped.")},
    {"aspect-integer", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "aspect integer"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The aspect is divided in whole numbers: 800 / 600 is 1.")},
    {"aspect-inverted", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "aspect inverted"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The aspect is turned round: height by width.")},
    {"aspect-of-window", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "aspect of the window"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The aspect is the window's, not the viewport's.")},
    {"aspect-left-out", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "aspect left out"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The aspect is left out, as in a square viewport.")},
    {"aspect-stale", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "aspect of another size"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The aspect is another one than the viewport's: of the window's size before, or a fixed one.")},
    {"viewport-stale", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "viewport of another size"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The viewport or the height of the flip is that of another size.")},
    {"fov-degrees-as-radians", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "degrees taken for radians"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The field of view is in degrees where radians are meant.")},
    {"fov-radians-as-degrees", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "radians taken for degrees"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The field of view is in radians where degrees are meant.")},
    {"fov-half", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "half the field of view"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "Half the field of view is taken for the whole.")},
    {"fov-double", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "twice the field of view"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The field of view is twice as large: half the angle is the one that has the tangent.")},
    {"fov-horizontal", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "horizontal field of view"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The field of view of one axis is taken for the other's: these functions want the vertical angle.")},
    {"frustum-centred", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "frustum taken for centred"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The frustum is taken for a centred one, though the view axis is not in its middle.")},
    {"depth-not-remapped", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth not remapped"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "z in NDC is taken to be the depth itself: depths go from 0 to 1, OpenGL's NDC from -1 to 1.")},
    {"depth-remapped-twice", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth remapped twice"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The depth is mapped to -1 to 1 once too often: the function does it itself, or the matrix goes by 0 to 1.")},
    {"depth-linear", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth taken for linear"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "A depth is not linear in the distance: a share of the way from near to far is confused with it.")},
    {"depth-zero", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth 0"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The depth is 0: it was not read, or not where the picture is.")},
    {"depth-one", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth 1"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The depth is 1: that of the background, or of a buffer that was cleared.")},
    {"depth-is-eye-distance", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "distance taken for depth"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "A distance from the eye is confused with the depth.")},
    {"depth-reversed", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth reversed"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The depth is turned round: reversed depths are taken for ordinary ones, or ordinary for reversed ones.")},
    {"depth-rounded", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth rounded"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The depth is rounded to few bits.")},
    {"depth-range-ignored", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth range ignored"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The depth range is ignored, as if it went from 0 to 1.")},
    {"depth-of-another-row", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "depth of another row"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The depth is that of a neighbouring row.")},
    {"near-differs", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "another near plane"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The near plane is not that of the picture.")},
    {"far-differs", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "another far plane"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The far plane is not that of the picture.")},
    {"ray-length-as-z", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "length of the ray taken for z"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The length of the ray is taken for z: z is measured along the view axis.")},
    {"z-as-ray-length", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "z taken for length of the ray"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "z is taken for the length of the ray: z is measured along the view axis.")},
    {"linear-angle", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "angle interpolated"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The ray's angle is interpolated; it is its tangent that is linear in the pixel.")},
    {"ortho-formula", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "orthographic formula"),
     QT_TRANSLATE_NOOP(
         "unprojector::gui::MistakeText",
         "The formula of an orthographic view is used in a perspective one: x and y are not scaled by z / near.")},
    {"divided-by-far", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "divided by far"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The near plane's window is scaled by z / far instead of z / near.")},
    {"perspective-formula", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "perspective formula"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The formula of a perspective is used in an orthographic view, as if rays came from the eye.")},
    {"no-w-divide", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "not divided by w"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The result is not divided by w.")},
    {"w-divided-twice", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "divided by w twice"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The result is divided by w twice.")},
    {"projection-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "projection transposed"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The projection matrix is transposed: its rows are taken for columns.")},
    {"view-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "view transposed"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The view matrix is transposed: its rows are taken for columns.")},
    {"both-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "both transposed"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "Projection and view matrix are transposed: rows are taken for columns.")},
    {"product-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "product transposed"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The product of projection and view is transposed: its rows are taken for columns.")},
    {"inverse-order", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "inverses in the wrong order"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The inverses stand in the wrong order: the inverse of P V is inverse(V) inverse(P).")},
    {"not-inverted", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "not inverted"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The matrices are not inverted.")},
    {"view-inverse-as-view", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "view's inverse taken for view"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The camera's own matrix, which is the view's inverse, is passed for the view.")},
    {"view-left-out", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "view left out"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The view matrix is left out: what comes is the point in eye space.")},
    {"projection-left-out", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "projection left out"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The projection matrix is left out.")},
    {"overwritten-in-place", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "overwritten in place"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The vector is overwritten while it is still needed: y is computed with the new x.")},
    {"model-left-in", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "model left in"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The model matrix is left in: these are the object's own coordinates, not the world's.")},
    {"model-left-out", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "model left out"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The model matrix is applied once too often, or left out of the inverse.")},
    {"eye-added", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "eye added"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "The eye's position is added to a point that has it already.")},
    {"eye-subtracted", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "eye subtracted"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "The eye's position is missing: the point is counted from the eye, along the world's axes.")},
    {"eye-z-positive", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "z of the eye point positive"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "z of the eye point has the wrong sign: an eye looks down -z.")},
    {"eye-xy-mirrored", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "eye point mirrored"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText",
                       "x and y of the eye point are mirrored: the formulas want z as a distance, above 0.")},
    {"axes-swapped", QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "axes swapped"),
     QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "Axes are exchanged, as between y up and z up.")},
};

/// Ways to make a mistake that have no number in them.
constexpr const char *kVariants[] = {
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "its x only"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "its y only"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "with its flip"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the flip only"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "about the middle of the viewport"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "lower left corner"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "upper left corner"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "x only"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "y only, lower edge"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "y only, upper edge"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "lower left corner of the whole pixel"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "upper left corner of the whole pixel"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "before the flip"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the vertical angle spans the width"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the horizontal angle spans the height"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the depth too"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the depth only"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the horizontal angle is the vertical one times the aspect"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "of the projection"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the size given"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "z up given for y up"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "y up given for z up"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "y and z exchanged"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "a share of the way is passed for the depth"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the depth is taken for a share of the way"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the depth is taken for a share of far"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the distance is passed for the depth"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the length of the ray is passed for the depth"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the depth is taken for the distance"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "nor mapped by the depth range"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "in the depth range"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "before the depth range"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the row above"),
    QT_TRANSLATE_NOOP("unprojector::gui::MistakeText", "the row below"),
};

const Wording *wordingOf(std::string_view id)
{
    const auto *found =
        std::find_if(std::begin(kMistakes), std::end(kMistakes), [&](const Wording &w) { return w.id == id; });
    return found == std::end(kMistakes) ? nullptr : found;
}

/// Of each mistake of an id, put together.
template <class Of>
QStringList ofEach(const std::string &id, Of of)
{
    QStringList texts;
    for (const QString &part : QString::fromStdString(id).split(u'+')) {
        const Wording *wording = wordingOf(part.toStdString());
        texts << (wording ? of(*wording) : part);
    }
    return texts;
}

/// What of a text stands between a start and an end; nothing where it has others.
std::optional<QString> between(const QString &text, QLatin1String start, QLatin1String end = {})
{
    if (!text.startsWith(start) || !text.endsWith(end) || text.size() < start.size() + end.size())
        return std::nullopt;
    return text.mid(start.size(), text.size() - start.size() - end.size());
}

QString wayText(const QString &way)
{
    const auto *known = std::find(std::begin(kVariants), std::end(kVariants), way.toStdString());
    if (known != std::end(kVariants))
        return MistakeText::tr(*known);
    if (const auto ratio = between(way, QLatin1String("ratio "), QLatin1String(", flipped in logical pixels")))
        return MistakeText::tr("ratio %1, flipped in logical pixels").arg(*ratio);
    if (const auto ratio = between(way, QLatin1String("ratio ")))
        return MistakeText::tr("ratio %1").arg(*ratio);
    if (const auto factor =
            between(way, QLatin1String("near times "), QLatin1String(", the window of glFrustum as it was")))
        return MistakeText::tr("near times %1, the window of glFrustum as it was").arg(*factor);
    if (const auto factor = between(way, QLatin1String("near times ")))
        return MistakeText::tr("near times %1").arg(*factor);
    if (const auto factor = between(way, QLatin1String("far times ")))
        return MistakeText::tr("far times %1").arg(*factor);
    if (const auto bits = between(way, QLatin1String("to "), QLatin1String(" bits")))
        return MistakeText::tr("to %1 bits").arg(*bits);
    if (const auto model = between(way, QLatin1String("of ")))
        return MistakeText::tr("of %1").arg(*model);
    return way; // the sides of a size
}

} // namespace

QString mistakeName(const std::string &id)
{
    return ofEach(id, [](const Wording &wording) { return MistakeText::tr(wording.name); }).join(QStringLiteral(" + "));
}

QString mistakeSentence(const std::string &id)
{
    return inARow(ofEach(id, [](const Wording &wording) { return MistakeText::tr(wording.sentence); }));
}

QString variantText(const std::string &variant)
{
    QStringList ways;
    for (const QString &way : QString::fromStdString(variant).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        ways << wayText(way);
    return ways.join(QStringLiteral("; "));
}

} // namespace unprojector::gui
