#include "gui/landmarks/measure_rows.h"

#include "core/geometry/angle.h"
#include "core/landmarks/measure.h"
#include "core/landmarks/symmetry.h"
#include "gui/text/landmark_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Landmark;
using landmarks::LandmarkSet;
using landmarks::Measured;

struct Measures {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::Measures)
};

QString nameOf(const LandmarkSet &set, std::size_t index)
{
    const QString name = QString::fromStdString(set.landmarks[index].name).simplified();
    return name.isEmpty() ? QString::number(index + 1) : name;
}

QString namesOf(const LandmarkSet &set, const std::vector<std::size_t> &indices)
{
    constexpr std::size_t kMost = 4;
    QStringList names;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices.size() > kMost && i >= 2 && i + 1 < indices.size()) {
            if (i == 2)
                names << QStringLiteral("…");
            continue;
        }
        names << nameOf(set, indices[i]);
    }
    return names.join(QStringLiteral(" – "));
}

MeasureRow lengthRow(const QString &kind, const QString &points, const Measured &measured, const LandmarkSet &set)
{
    if (!measured)
        return {kind, points, measureErrorText(measured.error())};
    return {kind, points, lengthText(*measured, QString::fromStdString(set.unit)), measured->value, measured->error};
}

MeasureRow angleRow(const QString &points, const Measured &measured)
{
    const QString kind = Measures::tr("Angle");
    if (!measured)
        return {kind, points, measureErrorText(measured.error())};
    return {kind, points, angleText(*measured), degreesFromRadians(measured->value),
            measured->error ? std::optional(degreesFromRadians(*measured->error)) : std::nullopt};
}

} // namespace

std::vector<MeasureRow> measuresOf(const LandmarkSet &set, const std::vector<std::size_t> &indices)
{
    std::vector<const Landmark *> points;
    points.reserve(indices.size());
    for (const std::size_t index : indices)
        points.push_back(&set.landmarks[index]);
    std::vector<MeasureRow> rows;
    using Shape = ShownMeasure::Shape;
    const auto addShown = [&rows](MeasureRow row, const ShownMeasure &shown) {
        if (row.number)
            row.shown = shown;
        rows.push_back(std::move(row));
    };
    const std::size_t count = indices.size();
    if (count == 2 || count == 3) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = i + 1; k < count; ++k)
                addShown(lengthRow(Measures::tr("Distance"), namesOf(set, {indices[i], indices[k]}),
                                   landmarks::distanceOf(*points[i], *points[k]), set),
                         {Shape::Polyline, {indices[i], indices[k]}, {}});
        }
    }
    for (std::size_t i = 0; count == 3 && i < count; ++i) {
        const std::size_t a = (i + 2) % 3, c = (i + 1) % 3;
        addShown(angleRow(Measures::tr("at %1").arg(nameOf(set, indices[i])),
                          landmarks::angleAt(*points[i], *points[a], *points[c])),
                 {Shape::Angle, {indices[i], indices[a], indices[c]}, {}});
    }
    if (count == 4)
        addShown(lengthRow(Measures::tr("Height"),
                           Measures::tr("%1 over the plane %2")
                               .arg(nameOf(set, indices[3]), namesOf(set, {indices[0], indices[1], indices[2]})),
                           landmarks::heightOver(*points[0], *points[1], *points[2], *points[3]), set),
                 {Shape::Height, indices, {}});
    if (count >= 3)
        addShown(lengthRow(Measures::tr("Length along"), namesOf(set, indices), landmarks::lengthAlong(points), set),
                 {Shape::Polyline, indices, {}});
    return rows;
}

QString curveLengthText(const SceneCurves::Line &line, const QString &unit)
{
    if (line.isComputing)
        return Measures::tr("computing…");
    return line.line ? lengthText(line.line->length, unit) : line.reason;
}

MeasureRow surfaceLengthOf(const LandmarkSet &set, const std::vector<std::size_t> &indices,
                           const SceneCurves::Line &line)
{
    MeasureRow row{Measures::tr("Along the surface"), namesOf(set, indices),
                   curveLengthText(line, QString::fromStdString(set.unit))};
    row.isComputing = line.isComputing;
    if (line.isComputing || !line.line)
        return row;
    row.number = line.line->length.value;
    row.error = line.line->length.error;
    row.shown = ShownMeasure{ShownMeasure::Shape::Surface, indices, {}};
    return row;
}

namespace {

QString listOf(const LandmarkSet &set, const std::vector<std::size_t> &indices)
{
    QStringList names;
    for (const std::size_t index : indices)
        names << nameOf(set, index);
    return names.join(Measures::tr(", ", "between names"));
}

/// Rows for the landmarks of a mirror plane, and those without an uncertainty.
std::vector<MeasureRow> madeFrom(const LandmarkSet &set, const std::vector<landmarks::Pair> &pairs,
                                 const std::vector<std::size_t> &counted)
{
    std::vector<bool> isPaired(set.landmarks.size(), false);
    for (const landmarks::Pair &pair : pairs)
        isPaired[pair.left] = isPaired[pair.right] = true;
    std::vector<std::size_t> middle, open;
    std::size_t paired = 0;
    for (const std::size_t index : counted) {
        if (isPaired[index])
            ++paired;
        else
            middle.push_back(index);
        if (!set.landmarks[index].uncertainty)
            open.push_back(index);
    }
    const QString from =
        middle.empty()
            ? Measures::tr("pairs: %1").arg(paired / 2)
            : Measures::tr("pairs: %1; in the middle: %2").arg(QString::number(paired / 2), listOf(set, middle));
    std::vector<MeasureRow> rows{{Measures::tr("Made from"), from, {}}};
    if (!open.empty())
        rows.push_back({Measures::tr("Without ±"), listOf(set, open), Measures::tr("leave the errors open")});
    return rows;
}

} // namespace

std::vector<MeasureRow> sidesOf(const LandmarkSet &whole)
{
    LandmarkSet set = whole;
    for (Landmark &landmark : set.landmarks) { // hidden landmarks are not measured
        if (landmark.isHidden)
            landmark.world.reset();
    }
    const std::vector<landmarks::Pair> pairs = landmarks::pairsByName(set.landmarks);
    if (pairs.empty())
        return {};
    const auto whyNot = [&](std::size_t index) {
        return !whole.landmarks[index].isPlaced() ? Measures::tr("%1 is not placed").arg(nameOf(set, index))
                                                  : Measures::tr("%1 is hidden").arg(nameOf(set, index));
    };
    const std::optional<landmarks::Symmetry> symmetry = landmarks::symmetryOf(set.landmarks, pairs);
    std::vector<MeasureRow> rows;
    const QString unit = QString::fromStdString(set.unit);
    if (symmetry) {
        const landmarks::MirrorPlane *plane = &symmetry->plane;
        constexpr int kDigits = 5;
        rows.push_back({Measures::tr("Mirror plane"),
                        Measures::tr("normal (%1, %2, %3)")
                            .arg(writtenText(plane->normal.x, kDigits), writtenText(plane->normal.y, kDigits),
                                 writtenText(plane->normal.z, kDigits)),
                        Measures::tr("offset %1").arg(lengthText({plane->offset, symmetry->offsetError}, unit)),
                        plane->offset, symmetry->offsetError});
        for (MeasureRow &row : madeFrom(set, pairs, symmetry->counted))
            rows.push_back(std::move(row));
    } else {
        rows.push_back(
            {Measures::tr("Mirror plane"), {}, Measures::tr("too few pairs; place more left and right landmarks")});
    }
    const auto add = [&](const QString &kind, const QString &points, std::size_t index, std::size_t partner) {
        MeasureRow row{kind, points, {}};
        if (!set.landmarks[index].isPlaced() || !set.landmarks[partner].isPlaced()) {
            row.value = whyNot(!set.landmarks[index].isPlaced() ? index : partner);
        } else if (symmetry && symmetry->asymmetries[index]) {
            row.number = symmetry->asymmetries[index]->value;
            row.error = symmetry->asymmetries[index]->error;
            row.value = lengthText(*symmetry->asymmetries[index], unit);
        } else {
            return;
        }
        rows.push_back(std::move(row));
    };
    std::vector<bool> isPaired(set.landmarks.size(), false);
    for (const landmarks::Pair &pair : pairs) {
        isPaired[pair.left] = isPaired[pair.right] = true;
        add(Measures::tr("Asymmetry"), QStringLiteral("%1 ↔ %2").arg(nameOf(set, pair.left), nameOf(set, pair.right)),
            pair.left, pair.right);
    }
    for (std::size_t i = 0; i < isPaired.size(); ++i) {
        if (isPaired[i] || !whole.landmarks[i].isPlaced()) // names to place are listed above
            continue;
        if (landmarks::isSided(set.landmarks[i].name))
            rows.push_back({Measures::tr("Left out"), nameOf(set, i), Measures::tr("no partner on the other side")});
        else
            add(Measures::tr("Distance from the mirror plane"), nameOf(set, i), i,
                i); // between the landmark and its image
    }
    return rows;
}

QString csvOf(const std::vector<MeasureRow> &rows, const QString &unit)
{
    const auto cell = [](QString text) {
        if (text.contains(u',') || text.contains(u'"') || text.contains(u'\n'))
            text = u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
        return text;
    };
    QString csv = QStringLiteral("kind,points,value,error,unit\n");
    for (const MeasureRow &row : rows) {
        const bool isAngle = row.value.contains(QChar(0x00B0));
        csv += cell(row.kind) + u',' + cell(row.points) + u',' + (row.number ? shortestText(*row.number) : QString())
               + u',' + (row.error ? shortestText(*row.error) : QString()) + u','
               + cell(isAngle ? QStringLiteral("deg") : unit) + u'\n';
    }
    return csv;
}

} // namespace unprojector::gui
