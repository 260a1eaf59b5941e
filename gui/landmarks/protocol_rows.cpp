#include "gui/landmarks/protocol_rows.h"

#include "core/geometry/numbers.h"
#include "core/landmarks/name_key.h"
#include "core/landmarks/protocol.h"
#include "gui/text/landmark_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace unprojector::gui {
namespace {

using landmarks::KeptMeasure;
using landmarks::LandmarkSet;
using landmarks::MeasureKind;
using Shape = ShownMeasure::Shape;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::Protocol)
};

QString kindText(MeasureKind kind)
{
    switch (kind) {
    case MeasureKind::Distance: return Texts::tr("distance");
    case MeasureKind::Angle: return Texts::tr("angle");
    case MeasureKind::Height: return Texts::tr("height");
    case MeasureKind::Length: return Texts::tr("length");
    case MeasureKind::Surface: break;
    }
    return Texts::tr("along the surface");
}

/// The measure for the view. @param indices  of its landmarks
ShownMeasure shownOf(MeasureKind kind, std::vector<std::size_t> indices)
{
    switch (kind) {
    case MeasureKind::Angle: return {Shape::Angle, {indices[1], indices[0], indices[2]}, {}};
    case MeasureKind::Height: return {Shape::Height, std::move(indices), {}};
    case MeasureKind::Surface: return {Shape::Surface, std::move(indices), {}};
    case MeasureKind::Distance:
    case MeasureKind::Length: break;
    }
    return {Shape::Polyline, std::move(indices), {}};
}

/// Nothing for a mirror plane: it depends on all landmarks.
std::optional<MeasureKind> kindOf(const ShownMeasure &shown)
{
    switch (shown.shape) {
    case Shape::Angle: return MeasureKind::Angle;
    case Shape::Height: return MeasureKind::Height;
    case Shape::Surface: return MeasureKind::Surface;
    case Shape::Mirror: return std::nullopt;
    case Shape::Polyline: break;
    }
    return shown.points.size() == 2 ? MeasureKind::Distance : MeasureKind::Length;
}

MeasureRow rowOf(const KeptMeasure &measure, const LandmarkSet &set, const std::vector<std::size_t> &selection,
                 const SceneCurves::Line *along)
{
    QStringList names;
    for (const std::string &name : measure.landmarks)
        names << QString::fromStdString(name).simplified();
    MeasureRow row{QString::fromStdString(measure.name),
                   Texts::tr("%1: %2", "kind of a measure, its landmarks")
                       .arg(kindText(measure.kind), names.join(QStringLiteral(" – "))),
                   {}};
    const std::vector<std::size_t> indices = indicesOf(measure, set);
    const QString unit = QString::fromStdString(set.unit);
    if (measure.kind == MeasureKind::Surface && !indices.empty() && indices == selection && along) {
        row.value = curveLengthText(*along, unit);
        row.valueTexts = curveLengthTexts(*along, unit);
        if (!along->isComputing && along->line) {
            row.number = along->line->length.value;
            row.error = along->line->length.error;
            row.shown = shownOf(measure.kind, indices);
        }
        return row;
    }
    // The selection has no landmark twice.
    const QString later = std::set(indices.begin(), indices.end()).size() == indices.size()
                              ? Texts::tr("click to compute")
                              : Texts::tr("computed at export");
    const auto ofSelection =
        [&later](std::span<const landmarks::Landmark *const>) -> geometry::Result<landmarks::Measure, std::string> {
        return later.toStdString();
    };
    const landmarks::ProtocolValue value = landmarks::valueOf(measure, set, ofSelection);
    if (!value.measure) {
        row.value = QString::fromStdString(value.reason);
        return row;
    }
    row.number = value.measure->value;
    row.error = value.measure->error;
    if (measure.kind == MeasureKind::Angle) {
        landmarks::Measure radians{geometry::radiansFromDegrees(value.measure->value), std::nullopt};
        if (value.measure->error)
            radians.error = geometry::radiansFromDegrees(*value.measure->error);
        row.valueTexts = angleTexts(radians);
    } else {
        row.valueTexts = lengthTexts(*value.measure, unit);
    }
    row.value = row.valueTexts.front();
    if (!indices.empty())
        row.shown = shownOf(measure.kind, indices);
    return row;
}

} // namespace

std::vector<std::size_t> indicesOf(const KeptMeasure &measure, const LandmarkSet &set)
{
    std::vector<std::size_t> indices;
    for (const std::string &name : measure.landmarks) {
        const std::optional<std::size_t> index = landmarks::indexOfName(set.landmarks, name);
        if (!index)
            return {};
        indices.push_back(*index);
    }
    return indices;
}

std::vector<MeasureRow> protocolRows(const LandmarkSet &set, const std::vector<std::size_t> &selection,
                                     const SceneCurves::Line *along)
{
    std::vector<MeasureRow> rows;
    for (const KeptMeasure &measure : set.measures)
        rows.push_back(rowOf(measure, set, selection, along));
    return rows;
}

QString protocolText(const KeptMeasure &measure, const LandmarkSet &set)
{
    const MeasureRow row = rowOf(measure, set, {}, nullptr);
    return row.number ? row.value : QStringLiteral("–");
}

QString protocolTip(const KeptMeasure &measure, const LandmarkSet &set)
{
    const MeasureRow row = rowOf(measure, set, {}, nullptr);
    return measure.kind == MeasureKind::Surface && !row.number
               ? Texts::tr("%1. The tables of Export have its value.", "a measure along the surface").arg(row.points)
               : Texts::tr("%1. %2", "a measure, its value").arg(row.points, row.value);
}

std::optional<KeptMeasure> keptMeasureOf(const ShownMeasure &shown, const LandmarkSet &set)
{
    const std::optional<MeasureKind> kind = kindOf(shown);
    if (!kind)
        return std::nullopt;
    KeptMeasure measure;
    measure.kind = *kind;
    std::vector<std::size_t> points = shown.points;
    if (measure.kind == MeasureKind::Angle)
        std::swap(points[0], points[1]); // the vertex is the second one
    std::string names;
    for (const std::size_t point : points) {
        const std::string &name = set.landmarks[point].name;
        if (name.empty() || landmarks::indexOfName(set.landmarks, name) != point)
            return std::nullopt;
        measure.landmarks.push_back(name);
        names += (names.empty() ? "" : "-") + name;
    }
    const std::string stem = measure.kind == MeasureKind::Distance
                                 ? names
                                 : landmarks::kMeasureKinds[static_cast<std::size_t>(measure.kind)] + (' ' + names);
    measure.name = stem;
    const auto isTaken = [&set](const std::string &name) {
        return std::any_of(set.measures.begin(), set.measures.end(),
                           [&name](const KeptMeasure &other) { return other.name == name; });
    };
    for (int number = 2; isTaken(measure.name); ++number)
        measure.name = stem + ' ' + std::to_string(number);
    return measure;
}

} // namespace unprojector::gui
