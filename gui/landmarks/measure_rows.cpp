#include "gui/landmarks/measure_rows.h"

#include "core/geometry/numbers.h"
#include "core/landmarks/measure.h"
#include "core/landmarks/symmetry.h"
#include "gui/text/landmark_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <functional>
#include <numeric>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Landmark;
using landmarks::LandmarkSet;
using landmarks::Measured;

struct Measures {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::Measures)
};

const QString kBetweenNames = QStringLiteral(" – ");
const QString kBetweenSides = QStringLiteral(" ↔ ");

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
    return names.join(kBetweenNames);
}

/// Why a measure of these landmarks does not exist.
QString reasonOf(const landmarks::MeasureError &error, const LandmarkSet &set, const std::vector<std::size_t> &indices)
{
    if (error.code != landmarks::MeasureError::Code::Missing)
        return measureErrorText(error);
    const std::size_t index = indices[error.point];
    return absenceText(set.landmarks[index], nameOf(set, index));
}

/// @param indices  of the landmarks, as they were measured
MeasureRow lengthRow(const QString &kind, const QString &points, const Measured &measured, const LandmarkSet &set,
                     const std::vector<std::size_t> &indices)
{
    if (!measured)
        return {kind, points, reasonOf(measured.error(), set, indices)};
    MeasureRow row{kind, points, {}, measured->value, measured->error};
    row.valueTexts = lengthTexts(*measured, QString::fromStdString(set.unit));
    row.value = row.valueTexts.front();
    return row;
}

MeasureRow angleRow(const QString &points, const Measured &measured, const LandmarkSet &set,
                    const std::vector<std::size_t> &indices)
{
    const QString kind = Measures::tr("Angle");
    if (!measured)
        return {kind, points, reasonOf(measured.error(), set, indices)};
    MeasureRow row{kind,
                   points,
                   {},
                   degreesFromRadians(measured->value),
                   measured->error ? std::optional(degreesFromRadians(*measured->error)) : std::nullopt};
    row.valueTexts = angleTexts(*measured);
    row.value = row.valueTexts.front();
    return row;
}

} // namespace

QString namesFitted(const QString &names, const QFontMetrics &metrics, int width)
{
    const QString &between = names.contains(kBetweenSides) ? kBetweenSides : kBetweenNames;
    QStringList parts = names.split(between);
    const auto lengthOf = [&metrics](const QString &text) { return metrics.horizontalAdvance(text); };
    if (parts.size() < 2 || lengthOf(names) <= width)
        return names;
    // Each name may take the same width; a shorter one leaves room to those that need more.
    QStringList byLength = parts;
    std::sort(byLength.begin(), byLength.end(),
              [&](const QString &a, const QString &b) { return lengthOf(a) < lengthOf(b); });
    int room = width - static_cast<int>(parts.size() - 1) * lengthOf(between), share = 0;
    for (qsizetype i = 0; i < byLength.size(); ++i) {
        share = room / static_cast<int>(byLength.size() - i);
        room -= std::min(lengthOf(byLength[i]), share);
    }
    for (QString &part : parts)
        part = metrics.elidedText(part, Qt::ElideMiddle, share);
    return parts.join(between);
}

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
                                   landmarks::distanceOf(*points[i], *points[k]), set, {indices[i], indices[k]}),
                         {Shape::Polyline, {indices[i], indices[k]}, {}});
        }
    }
    for (std::size_t i = 0; count == 3 && i < count; ++i) {
        const std::size_t a = (i + 2) % 3, c = (i + 1) % 3;
        addShown(angleRow(Measures::tr("at %1").arg(nameOf(set, indices[i])),
                          landmarks::angleAt(*points[i], *points[a], *points[c]), set,
                          {indices[i], indices[a], indices[c]}),
                 {Shape::Angle, {indices[i], indices[a], indices[c]}, {}});
    }
    if (count == 4)
        addShown(lengthRow(Measures::tr("Height"),
                           Measures::tr("%1 over the plane %2")
                               .arg(nameOf(set, indices[3]), namesOf(set, {indices[0], indices[1], indices[2]})),
                           landmarks::heightOver(*points[0], *points[1], *points[2], *points[3]), set, indices),
                 {Shape::Height, indices, {}});
    if (count >= 3)
        addShown(lengthRow(Measures::tr("Length along"), namesOf(set, indices), landmarks::lengthAlong(points), set,
                           indices),
                 {Shape::Polyline, indices, {}});
    return rows;
}

QString curveLengthText(const SceneCurves::Line &line, const QString &unit)
{
    if (line.isComputing)
        return Measures::tr("computing…");
    return line.line ? lengthText(line.line->length, unit) : line.reason;
}

QStringList curveLengthTexts(const SceneCurves::Line &line, const QString &unit)
{
    return !line.isComputing && line.line ? lengthTexts(line.line->length, unit) : QStringList();
}

MeasureRow surfaceLengthOf(const LandmarkSet &set, const std::vector<std::size_t> &indices,
                           const SceneCurves::Line &line)
{
    MeasureRow row{Measures::tr("Along the surface"), namesOf(set, indices),
                   curveLengthText(line, QString::fromStdString(set.unit))};
    row.valueTexts = curveLengthTexts(line, QString::fromStdString(set.unit));
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

QString normalText(const geometry::WorldVector &normal, const std::function<QString(double)> &text)
{
    return Measures::tr("normal (%1, %2, %3)").arg(text(normal.x), text(normal.y), text(normal.z));
}

/// The row of the mirror plane. The view shows the plane and all mirror images.
MeasureRow planeRow(const LandmarkSet &set, const std::vector<landmarks::Pair> &pairs,
                    const landmarks::Symmetry &symmetry, const ShownMeasure::Mirror &mirror)
{
    constexpr int kDigits = 5;
    const landmarks::MirrorPlane &plane = symmetry.plane;
    const landmarks::Measure offset{plane.offset, symmetry.offsetError};
    MeasureRow row{Measures::tr("Mirror plane"),
                   normalText(plane.normal, [](double value) { return writtenText(value, kDigits); }),
                   Measures::tr("offset %1").arg(lengthText(offset, QString::fromStdString(set.unit))), plane.offset,
                   symmetry.offsetError};
    row.copied = normalText(plane.normal, [](double value) { return shortestText(value); });
    for (int digits = kDigits; digits > 0; --digits)
        row.pointsTexts << normalText(plane.normal, [digits](double value) { return writtenText(value, digits); });
    for (const QString &text : lengthTexts(offset, QString::fromStdString(set.unit)))
        row.valueTexts << Measures::tr("offset %1").arg(text);
    std::vector<std::size_t> partners(set.landmarks.size());
    std::iota(partners.begin(), partners.end(), std::size_t{0});
    for (const landmarks::Pair &pair : pairs) {
        partners[pair.left] = pair.right;
        partners[pair.right] = pair.left;
    }
    ShownMeasure shown{ShownMeasure::Shape::Mirror, {}, Measures::tr("Mirror plane"), mirror};
    for (const std::size_t index : symmetry.counted) {
        if (partners[index] >= index) // a pair once
            shown.points.insert(shown.points.end(), {index, partners[index]});
    }
    row.shown = std::move(shown);
    return row;
}

/// Rows for the pairs of which a landmark has no position, with their number.
std::vector<MeasureRow> leftOut(const LandmarkSet &set, const std::vector<landmarks::Pair> &pairs)
{
    std::vector<std::size_t> toPlace, missing;
    int pairsToPlace = 0, pairsMissing = 0;
    for (const landmarks::Pair &pair : pairs) {
        const Landmark &left = set.landmarks[pair.left], &right = set.landmarks[pair.right];
        if (left.isPlaced() && right.isPlaced())
            continue;
        const bool isMissing = left.isMissing() || right.isMissing();
        ++(isMissing ? pairsMissing : pairsToPlace);
        for (const std::size_t index : {pair.left, pair.right}) {
            if (isMissing ? set.landmarks[index].isMissing() : set.landmarks[index].isToPlace())
                (isMissing ? missing : toPlace).push_back(index);
        }
    }
    std::vector<MeasureRow> rows;
    if (pairsToPlace > 0)
        rows.push_back({Measures::tr("Left out"), Measures::tr("not placed yet: %1").arg(listOf(set, toPlace)),
                        Measures::tr("pairs: %1").arg(pairsToPlace)});
    if (pairsMissing > 0)
        rows.push_back({Measures::tr("Left out"),
                        Measures::tr("missing on this specimen: %1").arg(listOf(set, missing)),
                        Measures::tr("pairs: %1").arg(pairsMissing)});
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
    const std::optional<landmarks::Symmetry> symmetry = landmarks::symmetryOf(set.landmarks, pairs);
    std::vector<MeasureRow> rows;
    std::optional<ShownMeasure::Mirror> mirror;
    if (symmetry) {
        mirror = ShownMeasure::Mirror{symmetry->plane,
                                      landmarks::rectangleOf(symmetry->plane, set.landmarks, symmetry->counted)};
        rows.push_back(planeRow(set, pairs, *symmetry, *mirror));
        for (MeasureRow &row : madeFrom(set, pairs, symmetry->counted))
            rows.push_back(std::move(row));
    } else {
        rows.push_back(
            {Measures::tr("Mirror plane"), {}, Measures::tr("too few pairs; place more left and right landmarks")});
    }
    const auto add = [&](const QString &kind, const QString &points, std::size_t index, std::size_t partner,
                         const std::optional<landmarks::Measure> &measure) {
        MeasureRow row{kind, points, {}};
        if (whole.landmarks[index].isHidden || whole.landmarks[partner].isHidden) {
            row.value =
                Measures::tr("%1 is hidden").arg(nameOf(set, whole.landmarks[index].isHidden ? index : partner));
        } else if (measure) {
            row.number = measure->value;
            row.error = measure->error;
            row.valueTexts = lengthTexts(*measure, QString::fromStdString(set.unit));
            row.value = row.valueTexts.front();
            row.shown = ShownMeasure{ShownMeasure::Shape::Mirror, {index, partner}, {}, mirror};
        } else {
            return;
        }
        rows.push_back(std::move(row));
    };
    using Values = std::vector<std::optional<landmarks::Measure>>;
    const Values none(set.landmarks.size());
    const Values &asymmetries = symmetry ? symmetry->asymmetries : none;
    const Values &distances = symmetry ? symmetry->distances : none;
    std::vector<bool> isPaired(set.landmarks.size(), false);
    for (const landmarks::Pair &pair : pairs) {
        isPaired[pair.left] = isPaired[pair.right] = true;
        if (whole.landmarks[pair.left].isPlaced() && whole.landmarks[pair.right].isPlaced())
            add(Measures::tr("Asymmetry"), nameOf(set, pair.left) + kBetweenSides + nameOf(set, pair.right), pair.left,
                pair.right, asymmetries[pair.left]);
    }
    for (std::size_t i = 0; i < isPaired.size(); ++i) {
        if (isPaired[i] || !whole.landmarks[i].isPlaced()) // the table lists names to place
            continue;
        if (landmarks::isSided(set.landmarks[i].name))
            rows.push_back({Measures::tr("Left out"), nameOf(set, i), Measures::tr("no partner on the other side")});
        else
            add(Measures::tr("Plane distance"), nameOf(set, i), i, i, distances[i]);
    }
    for (MeasureRow &row : leftOut(whole, pairs))
        rows.push_back(std::move(row));
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
        csv += cell(row.kind) + u',' + cell(row.copied.isEmpty() ? row.points : row.copied) + u','
               + (row.number ? shortestText(*row.number) : QString()) + u','
               + (row.error ? shortestText(*row.error) : QString()) + u','
               + cell(isAngle ? QStringLiteral("deg") : unit) + u'\n';
    }
    return csv;
}

} // namespace unprojector::gui
