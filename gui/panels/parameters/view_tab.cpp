#include "gui/panels/parameters/view_tab.h"

#include "gui/document/scene_document.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>

namespace unprojector::gui {
namespace {

double *component(WorldPoint &point, int i)
{
    return i == 0 ? &point.x : i == 1 ? &point.y : &point.z;
}

} // namespace

ViewTab::ViewTab(SceneDocument &document, QWidget *parent) : ParameterTab(document, Change::Picture, parent)
{
    addPoint(tr("Eye"), tr("Eye %1"), QStringLiteral("eye"),
             tr("Where the camera stands, world units (gluLookAt: eye%1)"),
             [](LookAt &view, int i) { return component(view.eye, i); });
    const std::size_t ofEye = m_lengths.size();
    addPoint(tr("Center"), tr("Center %1"), QStringLiteral("center"),
             tr("The point the camera looks at, world units (gluLookAt: center%1)"),
             [](LookAt &view, int i) { return component(view.center, i); });
    Q_ASSERT(m_lengths.size() == 2 * ofEye);
    addPoint(tr("Up"), tr("Up %1"), QStringLiteral("up"),
             tr("The direction that is upwards in the picture; its length does not matter (gluLookAt: up%1)"),
             [](LookAt &view, int i) { return &view.up[i]; });
    m_lengths.resize(2 * ofEye);
    content()->addStretch();
}

void ViewTab::addPoint(const QString &title, const QString &name, const QString &objectName, const QString &help,
                       std::function<double *(LookAt &, int)> number)
{
    content()->addWidget(heading(title));
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    for (int i = 0; i < 3; ++i) {
        const QString axis = QString(QChar(u'x' + i));
        NumberField *field = addField({name.arg(axis), help.arg(axis.toUpper()),
                                       [number, i](const Scene &scene) -> std::optional<double> {
                                           LookAt view = scene.camera;
                                           return *number(view, i);
                                       },
                                       [number, i](Scene &scene, double value) { *number(scene.camera, i) = value; }});
        field->setObjectName(objectName + axis.toUpper());
        auto *label = new QLabel(axis);
        label->setBuddy(field);
        row->addWidget(label);
        row->addWidget(field, 1);
        m_lengths.push_back(field);
    }
    content()->addLayout(row);
    content()->addSpacing(6);
}

Check ViewTab::edit(const Scene &next, const Deed &deed)
{
    return document().editCamera(next.camera, deed);
}

void ViewTab::showScene()
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
