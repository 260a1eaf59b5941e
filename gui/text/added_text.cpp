#include "gui/text/added_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::gui {
namespace {

struct AddedText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::AddedText)
};

/// From here on one of two things is a speck beside the other.
constexpr double kMuchLarger = 100.0;

QString trianglesText(std::size_t count)
{
    return count == 1 ? AddedText::tr("1 triangle")
                      : AddedText::tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(count)));
}

/// Of those that are much larger or smaller than the rest the one that is so most.
struct Misfit {
    const SceneObject *object;
    double ratio; ///< of its size to that of the rest
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

} // namespace

QString addedText(const std::vector<SceneObject> &objects, std::size_t added)
{
    std::size_t triangles = 0;
    for (std::size_t i = objects.size() - added; i < objects.size(); ++i)
        triangles += objects[i].model->triangleCount();
    QString text =
        added == 1
            ? AddedText::tr("%1 added: %2").arg(QString::fromStdString(objects.back().name), trianglesText(triangles))
            : AddedText::tr("%1 models added: %2").arg(added).arg(trianglesText(triangles));
    if (const std::optional<Misfit> misfit = misfitAmong(objects, added)) {
        const QString name = QString::fromStdString(misfit->object->name);
        const double times = std::max(misfit->ratio, 1.0 / misfit->ratio);
        const QString ratio = QLocale().toString(std::round(times), 'f', 0);
        const QString how =
            misfit->ratio > 1.0
                ? AddedText::tr("%1 is %2 times as large as the rest: Fit, in Objects, shows each.").arg(name, ratio)
                : AddedText::tr("The rest is %2 times as large as %1: Fit, in Objects, shows each.").arg(name, ratio);
        //: two sentences, the second with its full stop
        text = AddedText::tr("%1. %2").arg(text, how);
    }
    return text;
}

} // namespace unprojector::gui
