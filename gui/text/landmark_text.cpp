#include "gui/text/landmark_text.h"

#include "core/geometry/numbers.h"
#include "core/ray/placed_landmark.h"
#include "gui/text/fitted_text.h"

#include <QCoreApplication>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace unprojector::gui {
using namespace geometry;

namespace {

struct Points {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::Points)
};

template <class... Fs>
struct Cases : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Cases(Fs...) -> Cases<Fs...>;

/// Rounds a value to the last digit of its error: the error of a length is hardly ever all of its
/// last certain digit.
QString toLastDigitOf(const QString &error, double value, double exactError)
{
    if (error.contains(u'×')) { // a power of ten
        constexpr double kLeastWrittenOut = 1e-4, kTooLarge = 1e10;
        const double size = std::abs(value);
        const int place = certainPlace(exactError);
        if (place < 0 && size >= kLeastWrittenOut && size < kTooLarge)
            return fixedText(value, -place);
        return certainText(value, exactError);
    }
    const qsizetype point = error.indexOf(u'.');
    return fixedText(value, point < 0 ? 0 : static_cast<int>(error.size() - point - 1));
}

/// The unit behind a number.
QString behindNumber(const QString &unit)
{
    return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QChar(QChar::Nbsp) + unit;
}

/// A value with its error.
QString measureText(double value, const std::optional<double> &error, const QString &unit)
{
    constexpr int kDigits = 7; // for a value with unknown uncertainty
    const QString behind = behindNumber(unit);
    const QString inner = unit == QStringLiteral("°") ? unit : QString();
    if (!error)
        return writtenText(value, kDigits) + inner + QStringLiteral(" ± ?") + (inner.isEmpty() ? behind : QString());
    if (!(*error > 0.0))
        return writtenText(value) + behind;
    const QString bound = boundText(*error);
    return QStringLiteral("%1 ± %2").arg(toLastDigitOf(bound, value, *error) + inner, bound + behind);
}

/// The same in ever less room: without its error, then with ever fewer digits.
QStringList measureTexts(double value, const std::optional<double> &error, const QString &unit)
{
    QStringList texts{measureText(value, error, unit)};
    const bool isUncertain = error && *error > 0.0;
    const QString certain = isUncertain ? toLastDigitOf(boundText(*error), value, *error) : writtenText(value);
    texts << certain + behindNumber(unit);
    for (const QString &shorter : shorterTexts(value)) {
        if (shorter.size() < certain.size())
            texts << shorter + behindNumber(unit);
    }
    return texts;
}

/// The state of a landmark without a position, in one or two words.
QString stateText(landmarks::Absence absence)
{
    switch (absence) {
    case landmarks::Absence::NotPlaced: return Points::tr("not placed", "state of a landmark");
    case landmarks::Absence::Skipped: return Points::tr("skipped", "state of a landmark");
    case landmarks::Absence::Missing: return Points::tr("missing", "state of a landmark");
    }
    return {};
}

} // namespace

QString heldByText(const landmarks::Landmark &landmark)
{
    if (!landmark.isPlaced())
        return stateText(landmark.absence);
    return std::visit(
        Cases{[](const landmarks::Free &) { return Points::tr("free"); },
              [](const landmarks::OnTriangle &held) { return Points::tr("triangle %1").arg(held.triangle); },
              [](const landmarks::AtVertex &held) { return Points::tr("vertex %1").arg(held.vertex); },
              [](const landmarks::OnEdge &held) {
                  return Points::tr("edge %1–%2").arg(held.vertices[0]).arg(held.vertices[1]);
              }},
        landmark.anchor);
}

QString heldByExplanation(const landmarks::Landmark &landmark)
{
    if (landmark.isMissing())
        return Points::tr("Missing on this specimen. To place it all the same, click this row, then the surface.");
    if (!landmark.isPlaced())
        return landmark.absence == landmarks::Absence::Skipped ? Points::tr("Skipped: it comes again after the others.")
                                                               : Points::tr("Not placed yet.");
    return std::visit(
        Cases{[](const landmarks::Free &) { return Points::tr("Free: only its coordinates define the position."); },
              [](const landmarks::OnTriangle &held) {
                  return Points::tr("On triangle %1 of the mesh, by barycentric coordinates %2, %3, %4.")
                      .arg(QString::number(held.triangle), writtenText(held.barycentric.x, 6),
                           writtenText(held.barycentric.y, 6), writtenText(held.barycentric.z, 6));
              },
              [](const landmarks::AtVertex &held) {
                  return Points::tr("At vertex %1 of the mesh, with its exact coordinate.").arg(held.vertex);
              },
              [](const landmarks::OnEdge &held) {
                  return Points::tr("On the edge from vertex %1 to vertex %2 of the mesh, %3 of the way.")
                      .arg(QString::number(held.vertices[0]), QString::number(held.vertices[1]),
                           writtenText(held.share, 6));
              }},
        landmark.anchor);
}

QString absenceText(const landmarks::Landmark &landmark, const QString &name)
{
    return landmark.isMissing() ? Points::tr("%1 is missing on this specimen").arg(name)
                                : Points::tr("%1 is not placed yet").arg(name);
}

QString plusMinusText(const landmarks::Landmark &landmark)
{
    if (!landmark.world)
        return {};
    if (!landmark.uncertainty)
        return QStringLiteral("?");
    const double off = length(*landmark.uncertainty);
    const QString bound = off > 0.0 ? boundText(off) : QStringLiteral("0");
    return ray::edgeOf(landmark) ? QStringLiteral("▲ ") + bound : bound;
}

QString landmarkEdgeText(const landmarks::Landmark &landmark)
{
    const std::optional<ray::LandmarkEdge> edge = ray::edgeOf(landmark);
    if (!edge)
        return {};
    if (edge->object.empty())
        return Points::tr("Its pixel held an edge of the surface: beside it was the background.");
    const QString away = significantText(std::abs(edge->behind), 2),
                  object = QString::fromStdString(edge->object).simplified();
    return (edge->behind >= 0.0
                ? Points::tr("Its pixel held an edge of the surface: %1 behind it lay %2. The ± reaches there.")
                : Points::tr("Its pixel held an edge of the surface: %1 before it lay %2. The ± reaches there."))
        .arg(away, object);
}

Notation landmarkNotation(const landmarks::Landmark &landmark, int axis, int characters, int most)
{
    constexpr int kDigits = 15, kBeyondCertain = 2;
    if (!landmark.world)
        return {};
    Notation notation = notationOf(*landmark.world, (*landmark.world)[axis], kDigits, characters);
    if (landmark.uncertainty && !notation.isScientific) {
        const int certain = certainPlace((*landmark.uncertainty)[axis]);
        notation.decimals = std::min(notation.decimals, std::max(0, kBeyondCertain - certain));
        if ((*landmark.uncertainty)[axis] > 0.0) {
            const Notation wide = notationOf(*landmark.world, (*landmark.world)[axis], kDigits, most);
            notation.decimals = std::max(notation.decimals, std::min(wide.decimals, -certain));
        }
    } else if (!notation.isScientific) {
        // Thousandths, or five digits of a small coordinate.
        constexpr int kThousandths = 3, kFewestDigits = 5;
        const glm::dvec3 size = glm::abs(landmark.world->coordinates());
        const double largest = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
        const int wanted =
            std::max(kThousandths, kFewestDigits - 1 - static_cast<int>(std::floor(std::log10(largest))));
        const Notation wide = notationOf(*landmark.world, (*landmark.world)[axis], kDigits, most);
        notation.decimals = std::max(notation.decimals, std::min(wide.decimals, wanted));
    }
    return notation;
}

QStringList lengthTexts(const landmarks::Measure &measure, const QString &unit)
{
    return measureTexts(measure.value, measure.error, unit);
}

QStringList angleTexts(const landmarks::Measure &measure)
{
    return measureTexts(degreesFromRadians(measure.value),
                        measure.error ? std::optional(degreesFromRadians(*measure.error)) : std::nullopt,
                        QStringLiteral("°"));
}

QString lengthText(const landmarks::Measure &measure, const QString &unit)
{
    return lengthTexts(measure, unit).front();
}

QString angleText(const landmarks::Measure &measure)
{
    return angleTexts(measure).front();
}

QString measureErrorText(const landmarks::MeasureError &error)
{
    using Code = landmarks::MeasureError::Code;
    switch (error.code) {
    case Code::Missing: return Points::tr("a landmark has no position");
    case Code::TooFew: return Points::tr("there are fewer than two landmarks");
    case Code::SamePoint: return Points::tr("two landmarks coincide, so there is no direction");
    case Code::NoPlane:
        return Points::tr("within their uncertainty the three landmarks lie on one line, so there is no plane");
    }
    return {};
}

} // namespace unprojector::gui
