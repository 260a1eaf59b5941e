#include "gui/text/added_text.h"

#include "gui/text/bundled_names.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

struct AddedText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::AddedText)
};

/// The size ratio from which one of two objects is a speck beside the other.
constexpr double kMuchLarger = 100.0;

QString trianglesText(std::size_t count)
{
    return count == 1 ? AddedText::tr("1 triangle")
                      : AddedText::tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(count)));
}

/// The object whose size differs most from the rest.
struct Misfit {
    const SceneObject *object;
    double ratio; ///< its size : size of the rest
};

std::optional<Misfit> misfitAmong(const std::vector<SceneObject> &objects, std::size_t added)
{
    std::optional<Misfit> misfit;
    for (std::size_t i = objects.size() - added; i < objects.size(); ++i) {
        Box rest;
        for (std::size_t k = 0; k < objects.size(); ++k) {
            if (k != i && !objects[k].isHidden)
                rest.add(boundsOf(objects[k]));
        }
        const double ratio = boundsOf(objects[i]).diagonal() / rest.diagonal();
        if (!std::isfinite(ratio) || !(ratio > 0.0) || std::max(ratio, 1.0 / ratio) <= kMuchLarger)
            continue;
        if (!misfit || std::abs(std::log(ratio)) > std::abs(std::log(misfit->ratio)))
            misfit = Misfit{&objects[i], ratio};
    }
    return misfit;
}

/// Returns whether each visible object is a speck in the view of all.
bool areFarApart(const std::vector<SceneObject> &objects)
{
    Box all;
    double largest = 0.0;
    for (const SceneObject &object : objects) {
        if (object.isHidden)
            continue;
        all.add(boundsOf(object));
        largest = std::max(largest, boundsOf(object).diagonal());
    }
    return largest > 0.0 && all.diagonal() > kMuchLarger * largest;
}

} // namespace

QString sizesText(const std::vector<SceneObject> &objects, std::size_t added)
{
    if (areFarApart(objects))
        return AddedText::tr(
            "The objects are so far apart that each looks like a dot. To see one, choose Fit in the Objects panel.");
    const std::optional<Misfit> misfit = misfitAmong(objects, added);
    if (!misfit)
        return {};
    const QString name = readName(misfit->object->name, objects);
    const double times = std::max(misfit->ratio, 1.0 / misfit->ratio);
    const QString ratio = QLocale().toString(std::round(times), 'f', 0);
    return misfit->ratio > 1.0
               ? AddedText::tr(
                     "%1 is %2 times as large as the rest. To see one object, choose Fit in the Objects panel.")
                     .arg(name, ratio)
               : AddedText::tr(
                     "The rest is %2 times as large as %1. To see one object, choose Fit in the Objects panel.")
                     .arg(name, ratio);
}

QString addedText(const std::vector<SceneObject> &objects, std::size_t added)
{
    std::size_t triangles = 0;
    for (std::size_t i = objects.size() - added; i < objects.size(); ++i)
        triangles += objects[i].model->triangleCount();
    const QString text =
        added == 1 ? AddedText::tr("%1 added: %2").arg(readName(objects.back().name, objects), trianglesText(triangles))
                   : AddedText::tr("%1 models added: %2").arg(added).arg(trianglesText(triangles));
    const QString sizes = sizesText(objects, added);
    //: two sentences, the second with its full stop
    return sizes.isEmpty() ? text : AddedText::tr("%1. %2").arg(text, sizes);
}

} // namespace unprojector::gui
