#include "gui/parameters/view_group.h"

#include "gui/document/scene_document.h"
#include "gui/parameters/group_heading.h"

#include <algorithm>
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
             tr("Position of the camera, world units (gluLookAt: eye%1)"), Sliders::Yes,
             [](LookAt &view, int i) { return &view.eye[i]; });
    addPoint(tr("Center"), tr("Center %1"), QStringLiteral("center"), worldUnits(),
             tr("The point the camera looks at, world units (gluLookAt: center%1)"), Sliders::Yes,
             [](LookAt &view, int i) { return &view.center[i]; });
    m_lengths = findChildren<NumberField *>();
    addPoint(tr("Up"), tr("Up %1"), QStringLiteral("up"), ofAnyLength(),
             tr("Direction that points up in the view; its length does not matter (gluLookAt: up%1)"), Sliders::No,
             [](LookAt &view, int i) { return &view.up[i]; });
}

void ViewGroup::addPoint(const QString &title, const QString &name, const QString &objectName, const QString &unit,
                         const QString &help, Sliders sliders, const std::function<double *(LookAt &, int)> &number)
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
        if (sliders == Sliders::Yes) {
            NumberSlider *slider = addSlider(row, field, NumberSlider::Scale::Linear,
                                             [](const Scene &, double coordinate) { return coordinate; });
            slider->setFocusPolicy(Qt::ClickFocus); // the field is the way of the keyboard
            m_slides.push_back({slider, i});
        }
    }
}

void ViewGroup::setDefaults(Scene &scene) const
{
    scene.camera = scene.home;
}

void ViewGroup::rangeSliders()
{
    const auto isHeld = [](const Slide &slide) { return slide.slider->isSliderDown(); };
    if (std::any_of(m_slides.begin(), m_slides.end(), isHeld))
        return;
    // The range is centred on the objects, or on the view's centre if there are none. It reaches a
    // bit further than the objects' size and the distances of eye and centre.
    const Box &bounds = document().bounds();
    const double size = bounds.diagonal();
    const bool areObjects = size > 0.0 && std::isfinite(size);
    const LookAt &view = document().scene().camera;
    const WorldPoint middle = areObjects ? WorldPoint(bounds.center()) : view.center;
    constexpr double kFurther = 1.25;
    const double wanted =
        kFurther * std::max({areObjects ? size : 0.0, distance(middle, view.eye), distance(middle, view.center)});
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double reach = power * (wanted <= 2.0 * power ? 2.0 : wanted <= 5.0 * power ? 5.0 : 10.0);
    if (!(reach > 0.0) || !std::isfinite(reach) || (reach == m_slidesReach && middle == m_slidesMiddle))
        return;
    m_slidesReach = reach;
    m_slidesMiddle = middle;
    constexpr double kSteps = 200.0;
    const double step = reach / kSteps;
    for (const Slide &slide : m_slides) {
        const double start = std::round(middle[slide.axis] / step) * step;
        slide.slider->setNumbers(start - reach, start + reach, step);
    }
}

void ViewGroup::showScene()
{
    rangeSliders();
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
