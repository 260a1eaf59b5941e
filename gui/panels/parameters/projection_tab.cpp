#include "gui/panels/parameters/projection_tab.h"
#include "core/geometry/angle.h"

#include "gui/document/scene_document.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include <utility>

namespace unprojector::gui {
using namespace geometry;

ProjectionTab::ProjectionTab(SceneDocument &document, QWidget *parent) : ParameterTab(document, Change::Picture, parent)
{
    m_kind = new QComboBox;
    m_kind->setObjectName(QStringLiteral("projectionKind"));
    m_kind->setAccessibleName(tr("Kind of projection"));
    m_kind->setToolTip(
        tr("Another kind shows the same picture as nearly as it can: what lies at the picked point's distance, "
           "else at the center's, keeps its place"));
    m_kind->addItem(tr("Frustum (glFrustum)"), static_cast<int>(ProjectionKind::Frustum));
    m_kind->addItem(tr("Perspective (gluPerspective)"), static_cast<int>(ProjectionKind::Perspective));
    m_kind->addItem(tr("Orthographic (glOrtho)"), static_cast<int>(ProjectionKind::Ortho));
    m_kind->addItem(tr("Oblique (glOrtho, sheared)"), static_cast<int>(ProjectionKind::Oblique));
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_kind->setMinimumContentsLength(12);
    ignoreWheelWithoutFocus(m_kind);
    content()->addWidget(m_kind);

    m_form = new QFormLayout;
    m_form->setVerticalSpacing(4);
    m_form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    content()->addLayout(m_form);
    addRow(Number::Fovy, tr("Field of view"), QStringLiteral("fovy"),
           tr("Vertical angle of view in degrees, between 0 and 180 (gluPerspective: fovy)"));
    addRow(Number::Aspect, tr("Aspect"), QStringLiteral("aspect"),
           tr("Width divided by height of the picture (gluPerspective: aspect)"));
    addRow(Number::Left, tr("Left"), QStringLiteral("left"),
           tr("Left edge of the view volume, eye units; of a frustum on its near plane"));
    addRow(Number::Right, tr("Right"), QStringLiteral("right"),
           tr("Right edge of the view volume, eye units; of a frustum on its near plane"));
    addRow(Number::Bottom, tr("Bottom"), QStringLiteral("bottom"),
           tr("Lower edge of the view volume, eye units; of a frustum on its near plane"));
    addRow(Number::Top, tr("Top"), QStringLiteral("top"),
           tr("Upper edge of the view volume, eye units; of a frustum on its near plane"));
    addRow(Number::Near, tr("Near"), QStringLiteral("nearDistance"),
           tr("Distance of the near plane in front of the eye, eye units; smaller than far, and above 0 in a "
              "perspective"));
    addRow(Number::Far, tr("Far"), QStringLiteral("farDistance"),
           tr("Distance of the far plane in front of the eye, eye units; greater than near"));
    addRow(Number::Theta, tr("θ"), QStringLiteral("theta"),
           tr("Angle of the shear in x, degrees between 0 and 180: x grows by cot θ · z. 90 is no shear"));
    addRow(Number::Phi, tr("φ"), QStringLiteral("phi"),
           tr("Angle of the shear in y, degrees between 0 and 180: y grows by cot φ · z. 90 is no shear"));

    m_followsViewport = new QCheckBox;
    m_followsViewport->setObjectName(QStringLiteral("followsViewport"));
    m_followsViewport->setToolTip(
        tr("The width is always that of the viewport for this height, so that a circle stays a circle. "
           "Typing left, right or the aspect switches this off"));
    m_fitsObjects = new QCheckBox(tr("Fit near and far to the objects"));
    m_fitsObjects->setObjectName(QStringLiteral("fitsObjects"));
    m_fitsObjects->setToolTip(
        tr("The near and far planes hold the objects tightly, which makes the depth as exact as it can be. "
           "Typing one of them switches this off"));
    content()->addSpacing(4);
    content()->addWidget(m_followsViewport);
    content()->addWidget(m_fitsObjects);
    content()->addStretch();

    connect(m_kind, &QComboBox::activated, this,
            [this](int index) { choose(static_cast<ProjectionKind>(m_kind->itemData(index).toInt())); });
    connect(m_followsViewport, &QCheckBox::clicked, this, [this](bool follows) {
        Scene next = this->document().scene();
        next.projectionFollowsViewport = follows;
        change(next, m_followsViewport->text());
    });
    connect(m_fitsObjects, &QCheckBox::clicked, this, [this](bool fits) {
        Scene next = this->document().scene();
        next.clipDistancesFitObjects = fits;
        change(next, m_fitsObjects->text());
    });
}

double *ProjectionTab::numberIn(Projection &projection, Number number)
{
    const auto inBox = [number](auto &box) -> double * {
        switch (number) {
        case Number::Left: return &box.left;
        case Number::Right: return &box.right;
        case Number::Bottom: return &box.bottom;
        case Number::Top: return &box.top;
        case Number::Near: return &box.nearDistance;
        case Number::Far: return &box.farDistance;
        case Number::Fovy:
        case Number::Aspect:
        case Number::Theta:
        case Number::Phi: break;
        }
        return nullptr;
    };
    if (auto *frustum = std::get_if<Frustum>(&projection))
        return inBox(*frustum);
    if (auto *box = std::get_if<Ortho>(&projection))
        return inBox(*box);
    if (auto *oblique = std::get_if<Oblique>(&projection)) {
        if (isAngle(number) && number != Number::Fovy)
            return number == Number::Theta ? &oblique->thetaRadians : &oblique->phiRadians;
        return inBox(oblique->box);
    }
    if (auto *perspective = std::get_if<Perspective>(&projection)) {
        switch (number) {
        case Number::Fovy: return &perspective->verticalFovRadians;
        case Number::Aspect: return &perspective->aspect;
        case Number::Near: return &perspective->nearDistance;
        case Number::Far: return &perspective->farDistance;
        case Number::Left:
        case Number::Right:
        case Number::Bottom:
        case Number::Top:
        case Number::Theta:
        case Number::Phi: break;
        }
    }
    return nullptr;
}

bool ProjectionTab::isAngle(Number number)
{
    return number == Number::Fovy || number == Number::Theta || number == Number::Phi;
}

void ProjectionTab::addRow(Number number, const QString &name, const QString &objectName, const QString &help)
{
    NumberField *field =
        addField({name, help,
                  [number](const Scene &scene) -> std::optional<double> {
                      Projection projection = scene.projection;
                      const double *value = numberIn(projection, number);
                      if (!value)
                          return std::nullopt;
                      return isAngle(number) ? degreesFromRadians(*value) : *value;
                  },
                  [number](Scene &scene, double value) {
                      double *place = numberIn(scene.projection, number);
                      if (!place)
                          return;
                      *place = isAngle(number) ? radiansFromDegrees(value) : value;
                      // What follows something else would take the number back at once.
                      if (number == Number::Left || number == Number::Right || number == Number::Aspect)
                          scene.projectionFollowsViewport = false;
                      if (number == Number::Near || number == Number::Far)
                          scene.clipDistancesFitObjects = false;
                  }});
    field->setObjectName(objectName);
    if (isAngle(number))
        field->setFixedStep(1.0);
    m_form->addRow(isAngle(number) ? tr("%1 (°):").arg(name) : tr("%1:").arg(name), field);
    m_rows.emplace_back(number, field);
}

void ProjectionTab::choose(ProjectionKind kind)
{
    Scene next = document().scene();
    if (kindOf(next.projection) == kind)
        return;
    restoreFields(); // a refused number of one kind means nothing to another
    next.projection = converted(next.projection, kind, document().pivotDistance());
    change(next, m_kind->currentText());
}

Check ProjectionTab::edit(const Scene &next, const Deed &deed)
{
    return document().editProjection({next.projection, next.projectionFollowsViewport, next.clipDistancesFitObjects},
                                     deed);
}

void ProjectionTab::showScene()
{
    const Scene &scene = document().scene();
    m_followsViewport->setChecked(scene.projectionFollowsViewport);
    m_fitsObjects->setChecked(scene.clipDistancesFitObjects);
    const ProjectionKind kind = kindOf(scene.projection);
    const int index = m_kind->findData(static_cast<int>(kind));
    if (index != m_kind->currentIndex())
        m_kind->setCurrentIndex(index);
    if (kind == m_shownKind)
        return;
    m_shownKind = kind;
    restoreFields();
    Projection projection = scene.projection;
    for (const auto &[number, field] : m_rows)
        m_form->setRowVisible(field, numberIn(projection, number) != nullptr);
    m_followsViewport->setText(kind == ProjectionKind::Perspective ? tr("Aspect follows the viewport")
                                                                   : tr("Keep proportions"));
}

} // namespace unprojector::gui
