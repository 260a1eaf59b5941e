#include "gui/click/comparison_panel.h"

#include "gui/click/api_clicks_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_table.h"
#include "gui/click/other_programs_view.h"
#include "gui/click/ray_model.h"
#include "gui/click/ray_table.h"
#include "gui/document/object_names.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/since_click_text.h"
#include "gui/text/formula_text.h"
#include "gui/text/number_text.h"
#include "gui/text/ray_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/elided_label.h"
#include "gui/widgets/formula_view.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/steady_label.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

SteadyLabel *steadyLabel(const QString &accessibleName, const QString &toolTip = {})
{
    auto *label = new SteadyLabel;
    label->setAccessibleName(accessibleName);
    label->setToolTip(toolTip);
    return label;
}

/// "(412.5, 299.5)": a position in pixels to a hundredth at the most.
QString positionText(double x, double y)
{
    return QStringLiteral("(%1, %2)")
        .arg(writtenText(std::round(x * 100.0) / 100.0, 9), writtenText(std::round(y * 100.0) / 100.0, 9));
}

// What the chain of a click says.

QString widgetText(const WidgetPoint &position)
{
    return ComparisonPanel::tr("%1 logical pixels").arg(positionText(position.x, position.y));
}

QString devicePixelText(const DevicePixel &pixel, const Surface &surface)
{
    return ComparisonPanel::tr("(%1, %2) of %3 × %4, ratio %5")
        .arg(pixel.i)
        .arg(pixel.j)
        .arg(surface.widthPixels)
        .arg(surface.heightPixels)
        .arg(writtenText(surface.devicePixelRatio, 4));
}

QString windowText(const WindowPoint &window)
{
    return ComparisonPanel::tr("%1, the pixel's centre").arg(positionText(window.x, window.y));
}

QString clickedDepthText(const QString &text, bool isRead)
{
    return isRead ? ComparisonPanel::tr("%1, as read").arg(text)
                  : ComparisonPanel::tr("%1, the far plane's: nothing to read").arg(text);
}

} // namespace

ComparisonPanel::ComparisonPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(new ComparisonModel(this)), m_rayModel(new RayModel(this))
{
    m_heading = new ElidedLabel;
    QFont headingFont = m_heading->font();
    headingFont.setBold(true);
    m_heading->setFont(headingFont);
    m_heading->setAccessibleName(tr("What was clicked"));
    m_sinceClick = new SteadyLabel;
    m_sinceClick->setAccessibleName(tr("Since the click"));
    m_again = new QPushButton(tr("Pick this pixel a&gain"));
    m_again->setToolTip(tr("Pick what is now under the pixel of this click"));
    auto *headingLine = new QHBoxLayout;
    headingLine->addWidget(m_heading, 1);
    headingLine->addWidget(m_again);

    m_widget = steadyLabel(tr("Widget position"), tr("Logical pixels from the view's top-left corner, y down"));
    m_devicePixel = steadyLabel(tr("Device pixel"),
                                tr("Column and row from the top-left corner of the framebuffer, in device pixels"));
    m_window =
        steadyLabel(tr("Window position"), tr("The pixel's centre in device pixels from the bottom-left corner, y up"));
    m_depth = steadyLabel(
        tr("Depth"), tr("From the depth buffer, in the depth range: by default 0 is the near plane, 1 the far plane"));
    auto *chain = new QGridLayout; // names and values begin on one line, however many the value takes
    chain->setVerticalSpacing(2);
    chain->setColumnStretch(1, 1);
    const auto addLink = [chain](const QString &name, SteadyLabel *value) {
        const int row = chain->rowCount();
        chain->addWidget(new QLabel(name), row, 0, Qt::AlignLeft | Qt::AlignTop);
        chain->addWidget(value, row, 1, Qt::AlignTop);
    };
    addLink(tr("Widget position:"), m_widget);
    addLink(tr("Device pixel:"), m_devicePixel);
    addLink(tr("Window position:"), m_window);
    addLink(tr("Depth:"), m_depth);

    m_table = new ComparisonTable(m_model);
    m_table->setAccessibleName(tr("Coordinates by both methods"));

    m_showsFloat = new QCheckBox(tr("Show what float woul&d give"));
    m_showsFloat->setToolTip(
        tr("The matrix inverse done in single precision, as most programs do it, in the place of the "
           "difference between the two methods in double"));
    m_copy = new QPushButton(tr("&Copy all"));
    m_copy->setToolTip(tr("Copy the chain, the table with all digits and the formula"));
    auto *tools = new QHBoxLayout;
    tools->addWidget(m_showsFloat);
    tools->addStretch();
    tools->addWidget(m_copy);

    m_certainty = steadyLabel(tr("Certainty"));
    m_cause = steadyLabel(tr("Cause of the difference"));

    m_rayTable = new RayTable(m_rayModel);
    m_rayTable->setAccessibleName(tr("What the ray meets on the mesh"));
    m_ray = steadyLabel(tr("Ray on mesh"),
                        tr("What the ray through the pixel's centre meets on the mesh itself, in double"));
    m_rayDetail = steadyLabel(tr("Triangle, vertex and edge"),
                              tr("By their numbers in the model: triangles and vertices are counted from 0"));

    m_others = new OtherProgramsView;
    m_apis = new ApiClicksView;
    m_apis->setScenes(m_document.scene().conventions);

    m_formula = new FormulaView;
    m_formula->setAccessibleName(tr("Formula with its numbers"));
    m_formula->setPlaceholderText(tr("The formulas appear here with the numbers of the click."));

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addLayout(headingLine);
    layout->addWidget(m_sinceClick);
    layout->addLayout(chain);
    layout->addWidget(m_table);
    layout->addWidget(m_rayTable);
    layout->addWidget(m_ray);
    layout->addWidget(m_rayDetail);
    layout->addLayout(tools);
    const auto addWithHelp = [layout](QWidget *label, const QString &anchor) {
        auto *line = new QHBoxLayout;
        line->setSpacing(2);
        auto *link = new HelpLink(anchor);
        QSizePolicy policy = link->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        link->setSizePolicy(policy);
        line->addWidget(label, 1, Qt::AlignTop);
        line->addWidget(link, 0, Qt::AlignTop);
        layout->addLayout(line);
        return link;
    };
    m_certaintyHelp = addWithHelp(m_certainty, QStringLiteral("certainty"));
    m_causeHelp = addWithHelp(m_cause, QStringLiteral("matrix"));
    layout->addWidget(m_others);
    layout->addWidget(m_apis);
    auto *formulaLine = new QHBoxLayout;
    formulaLine->addWidget(new QLabel(tr("The formula with its numbers:")), 1);
    const auto addMethod = [formulaLine](const QString &method, const QString &anchor) {
        auto *link = new HelpLink(anchor);
        link->setText(QStringLiteral("%1 ?").arg(method));
        link->setAccessibleName(QStringLiteral("%1: %2").arg(method, link->toolTip()));
        formulaLine->addWidget(link);
    };
    addMethod(tr("Formula"), QStringLiteral("weng"));
    addMethod(tr("Matrix"), QStringLiteral("matrix"));
    layout->addLayout(formulaLine);
    layout->addWidget(m_formula, 1);

    // The chain of a click needs this width to stay within two lines. It is fixed here, so that it does not change from click to
    // click. It is counted in digits, because the average character of a font for Chinese is as wide as an ideograph.
    constexpr int kLeastDigits = 48;
    setMinimumWidth(std::max(kLeastDigits * fontMetrics().horizontalAdvance(u'0'), layout->minimumSize().width()));

    connect(m_showsFloat, &QCheckBox::toggled, this, [this](bool shows) {
        m_table->setShowsFloat(shows);
        emit showsFloatChanged(shows);
    });
    connect(m_copy, &QPushButton::clicked, this, [this] { copyToClipboard(text()); });
    connect(m_again, &QPushButton::clicked, this, [this] {
        if (m_document.picks().pick())
            emit pickRequested(m_document.picks().pick()->widget);
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Conventions)
            m_apis->setScenes(m_document.scene().conventions);
        if (changes & (Change::Pick | Change::Names | Change::Ray)) {
            showPick();
            return;
        }
        if (changes & (Change::Picture | Change::Placement | Change::Visibility | Change::ClipPlanes))
            showSinceClick();
    });
    showPick();
}

/// Marked while the numbers are not those of the view as it is.
void ComparisonPanel::showSinceClick()
{
    const bool isStale = m_document.picks().sinceClick().isAnything();
    m_sinceClick->setText(sinceClickText(m_document));
    m_sinceClick->setToolTip(m_sinceClick->text());
    m_sinceClick->setBackgroundRole(isStale ? QPalette::ToolTipBase : QPalette::Window);
    m_sinceClick->setForegroundRole(isStale ? QPalette::ToolTipText : QPalette::WindowText);
    m_sinceClick->setAutoFillBackground(isStale);
    const std::optional<Pick> &pick = m_document.picks().pick();
    m_again->setEnabled(isStale && devicePixelFromWidget(m_document.picture().surface, pick->widget).hasValue());
}

QSize ComparisonPanel::sizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const int tables = std::max(m_table->sizeHint().width(), m_rayTable->sizeHint().width());
    return {std::max(tables + margins.left() + margins.right(), minimumWidth()), QWidget::sizeHint().height()};
}

QString ComparisonPanel::nameOf(const std::optional<std::size_t> &object, const std::string &formerName) const
{
    const std::vector<SceneObject> &objects = m_document.objects();
    const std::string &name = object && *object < objects.size() ? objects[*object].name : formerName;
    return name.empty() ? tr("the surface") : shownObjectName(name, objects);
}

void ComparisonPanel::showRay()
{
    const std::optional<Pick> &pick = m_document.picks().pick();
    const PickedRay *ray = m_document.picks().pickedRay();
    m_rayModel->setRay(pick ? &*pick : nullptr, ray);
    m_ray->clear();
    m_ray->setValue({});
    m_rayDetail->clear();
    const Result<WorldPoint> *formula = pick ? &pick->point.world[Method::Formula] : nullptr;
    m_others->setAnswers(ray ? ray->others : std::nullopt,
                         formula && *formula ? std::optional(**formula) : std::nullopt,
                         pick ? WorldVector(pick->uncertainty.world) : WorldVector());
    if (!ray)
        return;
    switch (ray->state) {
    case PickedRay::State::Preparing: m_ray->setText(rayPreparingText()); return;
    case PickedRay::State::Impossible:
        m_ray->setText(rayImpossibleText(ray->failure ? failureText(*ray->failure) : QString()));
        return;
    case PickedRay::State::Answered: break;
    }
    const auto hitOf = [](const std::optional<MetPlace> &place) {
        return place ? std::optional(place->hit) : std::nullopt;
    };
    const QString met = ray->met ? nameOf(ray->met->object, ray->met->objectName) : QString();
    m_ray->setText(rayComparisonText(ray->comparison, nameOf(pick->object, {}), met));
    m_rayDetail->setText(rayDetailText(ray->snap, hitOf(ray->taken)));
    if (ray->met) {
        const WorldVector &uncertainty = ray->met->hit.uncertainty;
        m_ray->setValue({QStringLiteral("rayUncertainty"), {uncertainty.x, uncertainty.y, uncertainty.z}});
    }
}

/// What the click has taken instead of the surface under the pixel; null where it has not.
const MetPlace *ComparisonPanel::takenPlace() const
{
    const PickedRay *ray = m_document.picks().pickedRay();
    return ray && ray->snap != ray::Snap::Surface && ray->taken ? &*ray->taken : nullptr;
}

void ComparisonPanel::showCertainty(const Pick &pick)
{
    if (const MetPlace *taken = takenPlace()) {
        const WorldVector &uncertainty = taken->hit.uncertainty;
        m_certainty->setText(takenCertaintyText(m_document.picks().pickedRay()->snap, taken->hit));
        m_certainty->setValue({QStringLiteral("takenUncertainty"), {uncertainty.x, uncertainty.y, uncertainty.z}});
        return;
    }
    const Components<3> &uncertainty = pick.uncertainty.world;
    m_certainty->setText(certaintyText(pick));
    m_certainty->setValue(
        pick.hit() ? Copyable{QStringLiteral("worldUncertainty"), {uncertainty.x, uncertainty.y, uncertainty.z}}
                   : Copyable{});
}

void ComparisonPanel::showPick()
{
    const std::optional<Pick> &pick = m_document.picks().pick();
    m_model->setPick(pick);
    m_apis->setPick(pick);
    showSinceClick();
    showRay();
    m_certaintyHelp->setVisible(pick.has_value());
    m_causeHelp->setVisible(pick.has_value());
    if (!pick) {
        m_heading->setFullText(tr("No point yet"));
        m_sinceClick->setText(tr("Press the left button on the model"));
        for (SteadyLabel *label : {m_widget, m_devicePixel, m_window, m_depth}) {
            label->setText(QStringLiteral("–"));
            label->setValue({});
        }
        m_certainty->clear();
        m_certainty->setValue({});
        m_cause->clear();
        m_formula->setFormulas({});
        m_copy->setEnabled(false);
        return;
    }
    m_copy->setEnabled(true);
    if (const MetPlace *taken = takenPlace())
        m_heading->setFullText(
            takenText(m_document.picks().pickedRay()->snap, taken->hit, nameOf(taken->object, taken->objectName)));
    else
        m_heading->setFullText(pick->hit() ? tr("A point on %1").arg(nameOf(pick->object, {}))
                                           : tr("Background: no surface here"));
    m_widget->setText(widgetText(pick->widget));
    m_devicePixel->setText(devicePixelText(pick->devicePixel, pick->picture.surface));
    m_window->setText(windowText(pick->window));
    m_depth->setText(clickedDepthText(depthText(pick->window.z), pick->hit()));
    m_widget->setValue({QStringLiteral("widget"), {pick->widget.x, pick->widget.y}});
    m_devicePixel->setValue(
        {QStringLiteral("devicePixel"), {double(pick->devicePixel.i), double(pick->devicePixel.j)}});
    m_window->setValue({QStringLiteral("window"), {pick->window.x, pick->window.y, pick->window.z}});
    m_depth->setValue({QStringLiteral("depth"), {pick->window.z}});
    m_cause->setText(differenceCauseText(*pick));
    showCertainty(*pick);
    m_formula->setFormulas(formulasOf(*pick));
}

bool ComparisonPanel::showsFloat() const
{
    return m_showsFloat->isChecked();
}

void ComparisonPanel::setShowsFloat(bool shows)
{
    m_showsFloat->setChecked(shows);
}

QString ComparisonPanel::text() const
{
    QString text = m_heading->fullText() + u'\n' + m_sinceClick->text() + u'\n';
    const std::optional<Pick> &pick = m_document.picks().pick();
    for (const SteadyLabel *link : {m_widget, m_devicePixel, m_window, m_depth}) {
        const bool isDepth = link == m_depth && pick;
        text += link->accessibleName() + u'\t'
                + (isDepth ? clickedDepthText(shortestText(pick->window.z), pick->hit()) : link->text()) + u'\n';
    }
    text += m_model->text() + m_certainty->text() + u'\n' + m_cause->text() + u'\n';
    text += m_rayModel->text() + m_ray->text() + u'\n' + m_rayDetail->text() + u'\n';
    text += m_others->text() + m_apis->text();
    return text + m_formula->formulas().text() + u'\n';
}

} // namespace unprojector::gui
