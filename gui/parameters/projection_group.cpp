#include "gui/parameters/projection_group.h"
#include "core/geometry/numbers.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/parameters/group_heading.h"
#include "gui/text/help_anchors.h"
#include "gui/widgets/wheel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace unprojector::gui {
using namespace scene;
using namespace geometry;

ProjectionGroup::ProjectionGroup(SceneDocument &document, QWidget *parent)
    : ParameterGroup(document, Change::Setup,
                     {tr("Projection"), tr("glFrustum, gluPerspective, glOrtho, oblique"),
                      tr("A perspective of 45°, the viewport's aspect, near and far around the objects")},
                     parent)
{
    m_kind = new QComboBox;
    m_kind->setObjectName(QStringLiteral("projectionKind"));
    m_kind->setAccessibleName(tr("Kind of projection"));
    m_kind->setToolTip(tr("Switching the kind keeps the view as similar as possible: objects at the center's distance "
                          "keep their position and size"));
    m_kind->addItem(tr("Frustum (glFrustum)"), static_cast<int>(ProjectionKind::Frustum));
    m_kind->addItem(tr("Perspective (gluPerspective)"), static_cast<int>(ProjectionKind::Perspective));
    m_kind->addItem(tr("Orthographic (glOrtho)"), static_cast<int>(ProjectionKind::Ortho));
    m_kind->addItem(tr("Oblique (glOrtho, sheared)"), static_cast<int>(ProjectionKind::Oblique));
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    ignoreWheelWithoutFocus(m_kind);
    content()->addWidget(m_kind);

    addNumber(Number::Fovy, tr("Field of view"), QStringLiteral("fovy"),
              tr("Vertical angle of view in degrees, between 0 and 180 (gluPerspective: fovy)"));
    addNumber(Number::Aspect, tr("Aspect"), QStringLiteral("aspect"),
              tr("Width divided by height of the view (gluPerspective: aspect)"));
    addNumber(Number::Left, tr("Left"), QStringLiteral("left"),
              tr("Left edge of the view volume, eye units; of a frustum on its near plane"));
    addNumber(Number::Right, tr("Right"), QStringLiteral("right"),
              tr("Right edge of the view volume, eye units; of a frustum on its near plane"));
    addNumber(Number::Bottom, tr("Bottom"), QStringLiteral("bottom"),
              tr("Lower edge of the view volume, eye units; of a frustum on its near plane"));
    addNumber(Number::Top, tr("Top"), QStringLiteral("top"),
              tr("Upper edge of the view volume, eye units; of a frustum on its near plane"));
    addNumber(Number::Skew, tr("Skew"), QStringLiteral("skew"),
              tr("Shift of x per unit of y in eye space before glFrustum, as by the skew of a camera matrix"));
    addNumber(Number::Near, tr("Near"), QStringLiteral("nearDistance"),
              tr("Distance of the near plane in front of the eye, eye units; smaller than far, and above 0 in a "
                 "perspective"));
    addNumber(Number::Far, tr("Far"), QStringLiteral("farDistance"),
              tr("Distance of the far plane in front of the eye, eye units; greater than near"));
    addNumber(
        Number::Theta, tr("θ"), QStringLiteral("theta"),
        tr("Angle of the shear in x, degrees, more than 0 and less than 180: x grows by cot θ · z. 45 moves a point as "
           "far to the side as it lies deep, 90 is no shear"));
    addNumber(
        Number::Phi, tr("φ"), QStringLiteral("phi"),
        tr("Angle of the shear in y, degrees, more than 0 and less than 180: y grows by cot φ · z. 45 moves a point as "
           "far down as it lies deep, 90 is no shear"));

    m_followsViewport = new QCheckBox;
    m_followsViewport->setObjectName(QStringLiteral("followsViewport"));
    m_followsViewport->setToolTip(tr("Compute the width from the height and the viewport's aspect, so that a circle "
                                     "stays a circle. Typing left, right or the aspect switches this off"));
    m_fitsObjects = new QCheckBox(tr("Fit near and far to the objects"));
    m_fitsObjects->setObjectName(QStringLiteral("fitsObjects"));
    m_fitsObjects->setToolTip(tr("Set near and far tightly around the objects, for the most accurate depth. Typing one "
                                 "of them switches this off"));
    content()->addWidget(m_followsViewport);
    content()->addWidget(m_fitsObjects);

    connect(m_kind, &QComboBox::activated, this,
            [this](int index) { choose(static_cast<ProjectionKind>(m_kind->itemData(index).toInt())); });
    connect(m_followsViewport, &QCheckBox::clicked, this, [this](bool follows) {
        change(m_followsViewport->text(), [&](Scene &scene) { scene.projectionFollowsViewport = follows; });
    });
    connect(m_fitsObjects, &QCheckBox::clicked, this, [this](bool fits) {
        change(m_fitsObjects->text(), [&](Scene &scene) { scene.clipDistancesFitObjects = fits; });
    });
}

/// Calls a function with the member of a projection for a number, if it has one: a double, an
/// angle or an aspect. A pinhole has only near and far.
template <class AnyProjection, class Use>
void ProjectionGroup::withNumber(AnyProjection &projection, Number number, const Use &use)
{
    const auto inBox = [&](auto &box) {
        switch (number) {
        case Number::Left: return use(box.left);
        case Number::Right: return use(box.right);
        case Number::Bottom: return use(box.bottom);
        case Number::Top: return use(box.top);
        case Number::Near: return use(box.nearDistance);
        case Number::Far: return use(box.farDistance);
        case Number::Skew:
            if constexpr (requires { box.skew; }) {
                if (box.skew != 0.0)
                    use(box.skew);
            }
            return;
        case Number::Fovy:
        case Number::Aspect:
        case Number::Theta:
        case Number::Phi: break;
        }
    };
    if (auto *pinhole = std::get_if<Pinhole>(&projection)) {
        if (number == Number::Near)
            use(pinhole->nearDistance);
        else if (number == Number::Far)
            use(pinhole->farDistance);
        return;
    }
    if (auto *frustum = std::get_if<Frustum>(&projection))
        return inBox(*frustum);
    if (auto *box = std::get_if<Ortho>(&projection))
        return inBox(*box);
    if (auto *oblique = std::get_if<Oblique>(&projection)) {
        switch (number) {
        case Number::Theta: return use(oblique->theta);
        case Number::Phi: return use(oblique->phi);
        default: return inBox(oblique->box);
        }
    }
    auto &perspective = std::get<Perspective>(projection);
    switch (number) {
    case Number::Fovy: return use(perspective.verticalFov);
    case Number::Aspect: return use(perspective.aspect);
    case Number::Near: return use(perspective.nearDistance);
    case Number::Far: return use(perspective.farDistance);
    default: return;
    }
}

std::optional<double> ProjectionGroup::numberIn(const Projection &projection, Number number)
{
    if (const auto *pinhole = std::get_if<Pinhole>(&projection))
        return numberIn(frustumFromPinhole(*pinhole), number);
    struct Shown {
        double operator()(double value) const { return value; }
        double operator()(const DoubleDouble &value) const { return value.value; }
        double operator()(const Angle &angle) const { return angle.degrees(); }
    };
    std::optional<double> shown;
    withNumber(projection, number, [&shown](const auto &member) { shown = Shown()(member); });
    return shown;
}

void ProjectionGroup::setNumber(Projection &projection, Number number, double value)
{
    const auto set = [value](auto &member) {
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(member)>, Angle>)
            member = Angle::fromDegrees(value);
        else
            member = value;
    };
    const auto *pinhole = std::get_if<Pinhole>(&projection);
    if (pinhole && number != Number::Near && number != Number::Far)
        projection = frustumFromPinhole(*pinhole);
    withNumber(projection, number, set);
}

bool ProjectionGroup::isAngle(Number number)
{
    return number == Number::Fovy || number == Number::Theta || number == Number::Phi;
}

void ProjectionGroup::addNumber(Number number, const QString &name, const QString &objectName, const QString &help)
{
    ParameterRow *row = addRow(content(), name);
    const QString unit = number == Number::Skew     ? QString()
                         : number == Number::Aspect ? ratio()
                         : isAngle(number)          ? degrees()
                                                    : eyeUnits();
    NumberField *field =
        addField(row, {}, unit,
                 {name, help, [number](const Scene &scene) { return numberIn(scene.projection, number); },
                  [number](Scene &scene, double value) {
                      Projection projection = scene.projection;
                      setNumber(projection, number, value);
                      scene.projection = projection;
                      // A number that follows something else would be reset at once.
                      if (number == Number::Left || number == Number::Right || number == Number::Aspect)
                          scene.projectionFollowsViewport = false;
                      if (number == Number::Near || number == Number::Far)
                          scene.clipDistancesFitObjects = false;
                  }});
    field->setObjectName(objectName);
    if (isAngle(number))
        field->setFixedStep(1.0);
    m_rows.push_back({number, row, sliderFor(number, row, field)});
}

NumberSlider *ProjectionGroup::sliderFor(Number number, ParameterRow *row, const NumberField *field)
{
    using Scale = NumberSlider::Scale;
    constexpr double kApart = 0.01; // the share of one of them that a slider keeps between near and far
    if (number == Number::Fovy) {
        NumberSlider *slider = addSlider(row, field, Scale::Linear, [](const Scene &, double fovy) { return fovy; });
        slider->setNumbers(1.0, 179.0);
        return slider;
    }
    if (number == Number::Near)
        return addSlider(row, field, Scale::Logarithmic, [](const Scene &scene, double distance) {
            const double farDistance = projectionWindow(scene.projection).farDistance;
            return std::min(distance, farDistance - kApart * std::abs(farDistance));
        });
    if (number == Number::Far)
        return addSlider(row, field, Scale::Logarithmic, [](const Scene &scene, double distance) {
            const double nearDistance = projectionWindow(scene.projection).nearDistance;
            return std::max(distance, nearDistance + kApart * std::abs(nearDistance));
        });
    return nullptr;
}

void ProjectionGroup::rangeSliders()
{
    // Relative to the scene's size: the range stays while the camera moves.
    const Box &bounds = document().bounds();
    const double size = bounds.diagonal();
    const double unit = size > 0.0 && std::isfinite(size) ? std::pow(10.0, std::round(std::log10(size))) : 1.0;
    const bool isBox = !isPerspective(document().scene().projection);
    const bool isSameUnit = std::exchange(m_sliderUnit, unit) == unit;
    if (std::exchange(m_areBoxSliders, isBox) == isBox && isSameUnit)
        return;
    for (const Row &row : m_rows) {
        if (row.number != Number::Near && row.number != Number::Far)
            continue;
        const bool isNear = row.number == Number::Near;
        row.slider->setScale(isBox ? NumberSlider::Scale::Linear : NumberSlider::Scale::Logarithmic);
        if (isBox) // near and far may be behind the eye
            row.slider->setNumbers(-10.0 * unit, (isNear ? 10.0 : 30.0) * unit, 0.05 * unit);
        else
            row.slider->setNumbers((isNear ? 1e-3 : 0.1) * unit, (isNear ? 10.0 : 1000.0) * unit);
    }
}

void ProjectionGroup::choose(ProjectionKind kind)
{
    if (kindOf(document().scene().projection) == kind)
        return;
    restoreFields(); // a rejected number of one kind is meaningless for another
    change(m_kind->currentText(),
           [&](Scene &scene) { scene.projection = converted(scene.projection, kind, centerDistance(scene.camera)); });
}

void ProjectionGroup::setDefaults(Scene &scene) const
{
    scene.projection = openingProjection();
    scene.projectionFollowsViewport = scene.clipDistancesFitObjects = true;
}

void ProjectionGroup::showScene()
{
    rangeSliders();
    const Scene &scene = document().scene();
    m_followsViewport->setChecked(scene.projectionFollowsViewport);
    m_fitsObjects->setChecked(scene.clipDistancesFitObjects);
    const ProjectionKind kind = kindOf(scene.projection);
    const int index = m_kind->findData(static_cast<int>(kind));
    if (index != m_kind->currentIndex())
        m_kind->setCurrentIndex(index);
    const bool hasSkew = projectionWindow(scene.projection).skew != 0.0;
    if (kind == m_shownKind && hasSkew == m_hasSkew)
        return;
    m_shownKind = kind;
    m_hasSkew = hasSkew;
    heading().setHelp(helpAnchorOf(kind));
    restoreFields();
    for (const Row &row : m_rows)
        row.row->setVisible(numberIn(scene.projection, row.number).has_value());
    m_followsViewport->setText(kind == ProjectionKind::Perspective ? tr("Aspect follows the viewport")
                                                                   : tr("Keep proportions"));
}

} // namespace unprojector::gui
