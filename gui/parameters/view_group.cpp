#include "gui/parameters/view_group.h"

#include "gui/document/scene_document.h"
#include "gui/parameters/group_heading.h"

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

ViewGroup::ViewGroup(SceneDocument &document, QWidget *parent)
    : ParameterGroup(
        document, Change::Setup,
        {tr("View"), tr("Position and direction of the camera (gluLookAt)"), tr("Return to the scene's initial view")},
        parent)
{
    heading().setHelp(QStringLiteral("view"));
    addPoint(tr("Eye"), tr("Eye %1"), QStringLiteral("eye"), worldUnits(),
             tr("Position of the camera, world units (gluLookAt: eye%1)"),
             [](LookAt &view, int i) { return &view.eye[i]; });
    addPoint(tr("Center"), tr("Center %1"), QStringLiteral("center"), worldUnits(),
             tr("The point the camera looks at, world units (gluLookAt: center%1)"),
             [](LookAt &view, int i) { return &view.center[i]; });
    m_lengths = findChildren<NumberField *>();
    addPoint(tr("Up"), tr("Up %1"), QStringLiteral("up"), ofAnyLength(),
             tr("Direction that points up in the view; its length does not matter (gluLookAt: up%1)"),
             [](LookAt &view, int i) { return &view.up[i]; });
}

void ViewGroup::addPoint(const QString &title, const QString &name, const QString &objectName, const QString &unit,
                         const QString &help, const std::function<double *(LookAt &, int)> &number)
{
    ParameterRow *row = addRow(content(), title);
    for (int i = 0; i < 3; ++i) {
        const QString axis = QString(QChar(u'x' + i));
        NumberField *field = addField(row, axis, unit,
                                      {name.arg(axis), help.arg(axis.toUpper()),
                                       [number, i](const Scene &scene) -> std::optional<double> {
                                           LookAt view = scene.camera;
                                           return *number(view, i);
                                       },
                                       [number, i](Scene &scene, double value) {
                                           LookAt view = scene.camera;
                                           *number(view, i) = value;
                                           scene.camera = view;
                                       }});
        field->setObjectName(objectName + axis.toUpper());
    }
}

void ViewGroup::setDefaults(Scene &scene) const
{
    scene.camera = scene.home;
}

void ViewGroup::showScene()
{
    // A step moves the eye by about a hundredth of its distance.
    const LookAt &view = document().scene().camera;
    const double step = std::pow(10.0, std::floor(std::log10(distance(view.center, view.eye) / 50.0)));
    if (step == m_step || !std::isfinite(step))
        return;
    m_step = step;
    for (NumberField *field : m_lengths)
        field->setFixedStep(step);
}

} // namespace unprojector::gui
