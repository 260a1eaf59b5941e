#include "gui/click/pick_rows.h"

#include "gui/document/object_names.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <glm/geometric.hpp>

#include <cstddef>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

struct PickRows {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::PickRows)
};

/// The object's own name; empty for the background.
QString objectName(const Pick &pick, const std::vector<SceneObject> &objects)
{
    return pick.object && *pick.object < objects.size() ? shownObjectName(objects[*pick.object].name, objects)
                                                        : QString();
}

QString pixelOf(const Pick &pick)
{
    return QStringLiteral("(%1, %2)").arg(pick.devicePixel.i).arg(pick.devicePixel.j);
}

QString csvCell(QString text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n'))
        return text;
    return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

/// "a → b", or the common value.
QString fromTo(const QString &from, const QString &to)
{
    return from == to ? from : QStringLiteral("%1 → %2").arg(from, to);
}

QString setupDifference(const Setup &from, const Setup &to)
{
    QStringList other;
    if (from.pose != to.pose)
        other << PickRows::tr("camera");
    if (from.lens != to.lens)
        other << PickRows::tr("projection");
    if (from.viewport != to.viewport)
        other << PickRows::tr("viewport");
    if (from.depthRange != to.depthRange)
        other << PickRows::tr("depth range");
    if (from.surface != to.surface)
        other << PickRows::tr("window size");
    return other.isEmpty() ? PickRows::tr("Setup: the same")
                           : PickRows::tr("Setup: other %1").arg(other.join(QStringLiteral(", ")));
}

} // namespace

PickRow pickRow(const EarlierPick &earlier, const std::vector<SceneObject> &objects)
{
    const Pick &pick = *earlier.kept.pick;
    const std::optional<WorldPoint> point = pickedPoint(earlier.kept);
    return {pick.hit() ? objectName(pick, objects) : PickRows::tr("Background"),
            point ? pointText(*point, pickedUncertainty(earlier.kept)) : QString(), pixelOf(pick)};
}

QString pickDifferenceText(const EarlierPick &from, const EarlierPick &to, const std::vector<SceneObject> &objects)
{
    const Pick &first = *from.kept.pick, &second = *to.kept.pick;
    QStringList lines{PickRows::tr("From pick %1 to pick %2").arg(from.number).arg(to.number)};
    const std::optional<WorldPoint> a = pickedPoint(from.kept), b = pickedPoint(to.kept);
    if (a && b) {
        const Components<3> ofFirst = pickedUncertainty(from.kept), ofSecond = pickedUncertainty(to.kept);
        const Components<3> uncertainty{ofFirst.x + ofSecond.x, ofFirst.y + ofSecond.y, ofFirst.z + ofSecond.z};
        // The triangle inequality: the length's error is at most the vector's.
        const double bound = glm::length(glm::dvec3(uncertainty.x, uncertainty.y, uncertainty.z));
        lines << PickRows::tr("Distance: %1 ± %2").arg(certainText(distance(*a, *b), bound), boundText(bound));
        lines << PickRows::tr("Δ (x, y, z): %1").arg(pointText(*b - *a, uncertainty));
    } else {
        lines << PickRows::tr("Distance: none, the background has no point");
    }
    lines << PickRows::tr("Depth: %1 (Δ %2)")
                 .arg(fromTo(depthText(first.window.z), depthText(second.window.z)),
                      significantText(second.window.z - first.window.z, 3));
    lines << PickRows::tr("Pixel: %1 (Δ %2, %3)")
                 .arg(fromTo(pixelOf(first), pixelOf(second)))
                 .arg(second.devicePixel.i - first.devicePixel.i)
                 .arg(second.devicePixel.j - first.devicePixel.j);
    lines << PickRows::tr("Object: %1").arg(fromTo(pickRow(from, objects).object, pickRow(to, objects).object));
    if (first.hit() && first.object == second.object && from.kept.placement != to.kept.placement)
        lines << PickRows::tr("The object was moved between the two clicks.");
    lines << setupDifference(first.setup, second.setup);
    return lines.join(u'\n');
}

QString pickRowsText(const std::vector<EarlierPick> &picks, const std::vector<SceneObject> &objects)
{
    QString text = QStringList{PickRows::tr("Pick"), PickRows::tr("Object"), PickRows::tr("World coordinate"),
                               PickRows::tr("Pixel")}
                       .join(u'\t')
                   + u'\n';
    for (const EarlierPick &earlier : picks) {
        const PickRow row = pickRow(earlier, objects);
        text += QStringLiteral("%1\t%2\t%3\t%4\n").arg(earlier.number).arg(row.object, row.coordinate, row.pixel);
    }
    return text;
}

QString pickRowsCsv(const std::vector<EarlierPick> &picks, const std::vector<SceneObject> &objects)
{
    QString text =
        QStringLiteral("pick,object,x,y,z,uncertainty_x,uncertainty_y,uncertainty_z,pixel_i,pixel_j,depth\n");
    for (const EarlierPick &earlier : picks) {
        const Pick &pick = *earlier.kept.pick;
        QStringList cells{QString::number(earlier.number), csvCell(objectName(pick, objects))};
        const std::optional<WorldPoint> point = pickedPoint(earlier.kept);
        const Components<3> uncertainty = pickedUncertainty(earlier.kept);
        for (int axis = 0; axis < 3; ++axis)
            cells << (point ? shortestText((*point)[axis]) : QString());
        for (int axis = 0; axis < 3; ++axis)
            cells << (point ? shortestText(uncertainty[axis]) : QString());
        cells << QString::number(pick.devicePixel.i) << QString::number(pick.devicePixel.j)
              << shortestText(pick.window.z);
        text += cells.join(u',') + u'\n';
    }
    return text;
}

} // namespace unprojector::gui
