#include "gui/click/comparison_panel.h"

#include "gui/click/answer_view.h"
#include "gui/click/api_clicks_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/coordinates_table.h"
#include "gui/click/earlier_picks_view.h"
#include "gui/click/other_programs_view.h"
#include "gui/click/ray_model.h"
#include "gui/click/then_and_now_view.h"
#include "gui/click/verdict_view.h"
#include "gui/document/object_names.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/since_click_text.h"
#include "gui/text/formula_text.h"
#include "gui/text/number_text.h"
#include "gui/text/ray_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/figure_view.h"
#include "gui/widgets/fold.h"
#include "gui/widgets/formula_view.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/segmented_switch.h"
#include "gui/widgets/steady_label.h"
#include "gui/widgets/whole_table.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

SteadyLabel *steadyLabel(const QString &accessibleName, const QString &toolTip)
{
    auto *label = new SteadyLabel;
    label->setAccessibleName(accessibleName);
    label->setToolTip(toolTip);
    return label;
}

/// A column of widgets without a margin of its own.
QVBoxLayout *columnOf(QWidget &widget)
{
    auto *layout = new QVBoxLayout(&widget);
    layout->setContentsMargins(0, 0, 0, 0);
    return layout;
}

QString positionText(double x, double y)
{
    return QStringLiteral("(%1, %2)").arg(pixelText(x), pixelText(y));
}

QString clickedDepthText(const QString &text, bool isRead)
{
    return isRead ? ComparisonPanel::tr("%1, as read").arg(text)
                  : ComparisonPanel::tr("%1, the far plane: no surface").arg(text);
}

enum ChainLink { Widget, DevicePixelOf, Window, Depth };

} // namespace

ComparisonPanel::ComparisonPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(new ComparisonModel(this)), m_rayModel(new RayModel(this)),
      m_before(new QWidget)
{
    m_after = answerPart();
    auto *sentence = new QLabel(tr("Click the model. Its world coordinate appears here, computed in two ways: by the "
                                   "formulas and by the inverted matrix."));
    sentence->setWordWrap(true);
    auto *before = columnOf(*m_before);
    before->addWidget(sentence);
    before->addWidget(new FigureView(QStringLiteral("ray")));

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(m_before);
    layout->addWidget(m_after);
    layout->addWidget(earlierPart());
    layout->addStretch(1);
    // The panel has this width with and without a pick. It is counted in digits, because the
    // average character of a font for Chinese is as wide as an ideograph.
    constexpr int kLeastDigits = 46;
    const QMargins margins = layout->contentsMargins();
    setMinimumWidth(std::max(kLeastDigits * fontMetrics().horizontalAdvance(u'0'),
                             m_after->minimumSizeHint().width() + margins.left() + margins.right()));

    connect(m_again, &QPushButton::clicked, this, [this] {
        if (m_document.picks().pick())
            emit pickRequested(m_document.picks().pick()->widget);
    });
    connect(m_formula, &FormulaView::termPointed, this, &ComparisonPanel::termPointed);
    connect(m_answer, &AnswerView::copyAllRequested, this, [this] { copyToClipboard(text()); });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Conventions)
            m_apis->setScenes(m_document.scene().conventions);
        if (changes & (Change::Pick | Change::Names | Change::Ray)) {
            showPick();
            return;
        }
        if (changes & (Change::Setup | Change::Placement | Change::Visibility | Change::ClipPlanes))
            showSinceClick();
    });
    showPick();
}

QWidget *ComparisonPanel::answerPart()
{
    m_answer = new AnswerView;
    m_edge = new QLabel;
    m_edge->setAccessibleName(tr("Edge in the pixel"));
    m_edge->setToolTip(tr("Rays of this pixel hit surfaces at different distances. Zoom in to choose one of them."));
    m_edge->setWordWrap(true);
    m_edge->setTextFormat(Qt::PlainText);
    m_edge->setContentsMargins(4, 2, 4, 2);
    m_edge->setAutoFillBackground(true);
    m_edge->setBackgroundRole(QPalette::ToolTipBase);
    m_edge->setForegroundRole(QPalette::ToolTipText);
    m_verdict = new VerdictView;

    m_changed = new QWidget;
    m_sinceClick = new QLabel;
    m_sinceClick->setAccessibleName(tr("Since the click"));
    m_sinceClick->setWordWrap(true);
    m_again = new QPushButton(tr("Pick a&gain"));
    m_again->setToolTip(tr("Click the same pixel again in the current view"));
    auto *changed = new QHBoxLayout(m_changed);
    changed->setContentsMargins(4, 2, 4, 2);
    changed->addWidget(m_sinceClick, 1);
    changed->addWidget(m_again);
    m_changed->setAutoFillBackground(true);
    m_changed->setBackgroundRole(QPalette::ToolTipBase);
    m_sinceClick->setForegroundRole(QPalette::ToolTipText);
    m_now = new ThenAndNowView(m_document);
    m_nowFold =
        new Fold(tr("Values at the click and now"),
                 tr("The picked point in the view as it was at the click and as it is now, and what differs"), m_now);
    m_folds.emplace_back(QStringLiteral("now"), m_nowFold);

    m_space =
        new SegmentedSwitch(tr("Space"), {{tr("World"), tr("The coordinate in world space")},
                                          {tr("Eye", "space"), tr("The coordinate in eye space: the eye is the origin, "
                                                                  "and it looks along −z")},
                                          {tr("Object"), tr("The coordinate in the space of the clicked object")}});
    m_showsFloat = new QCheckBox(tr("Floa&t"));
    m_showsFloat->setToolTip(tr("Add the matrix inverse in single precision, as most programs compute it"));
    m_showsRay = new QCheckBox(tr("E&xact hit"));
    m_showsRay->setToolTip(tr("Add the point where the ray through the pixel's centre meets the mesh itself"));
    auto *switches = new QHBoxLayout;
    switches->addWidget(m_space);
    switches->addStretch();
    switches->addWidget(m_showsFloat);
    switches->addWidget(m_showsRay);
    m_table = new CoordinatesTable(m_model);
    m_table->setAccessibleName(tr("Coordinates by both methods"));
    for (int column = ComparisonModel::MatrixInFloat; column < ComparisonModel::ColumnCount; ++column)
        m_table->setColumnShown(column, false);

    m_formula = new FormulaView;
    m_formula->setAccessibleName(tr("Formula with its numbers"));
    auto *formulaLine = new QHBoxLayout;
    formulaLine->addWidget(new QLabel(tr("The formula with its numbers:")), 1);
    for (const auto &[method, anchor] : {std::pair(tr("Formula"), "weng"), std::pair(tr("Matrix"), "matrix")}) {
        auto *link = new HelpLink(QLatin1String(anchor));
        link->setText(QStringLiteral("%1 ?").arg(method));
        link->setAccessibleName(QStringLiteral("%1: %2").arg(method, link->toolTip()));
        formulaLine->addWidget(link);
    }

    m_others = new OtherProgramsView;
    m_apis = new ApiClicksView;
    m_apis->setScenes(m_document.scene().conventions);

    auto *part = new QWidget;
    auto *layout = columnOf(*part);
    layout->addWidget(m_answer);
    layout->addWidget(m_edge);
    layout->addWidget(m_verdict);
    layout->addWidget(m_changed);
    layout->addWidget(m_nowFold);
    layout->addLayout(switches);
    layout->addWidget(m_table);
    layout->addLayout(formulaLine);
    layout->addWidget(m_formula);
    const auto addFold = [&](const QString &name, const QString &title, const QString &toolTip, QWidget *content,
                             const QString &helpAnchor) {
        auto *fold = new Fold(title, toolTip, content, helpAnchor);
        m_folds.emplace_back(name, fold);
        layout->addWidget(fold);
    };
    addFold(QStringLiteral("pixel"), tr("From the pixel to the window point"),
            tr("Steps from the mouse position to window coordinates"), pixelPart(), QStringLiteral("half-pixel"));
    addFold(QStringLiteral("ray"), tr("Exact hit on the mesh"),
            tr("What the ray through the pixel's centre meets on the mesh itself, without the depth buffer"), rayPart(),
            QStringLiteral("certainty"));
    addFold(QStringLiteral("programs"), tr("Answers of other programs"),
            tr("Distance of their points from the formula's for the same click, with the reason"), m_others,
            QStringLiteral("half-pixel"));
    addFold(QStringLiteral("apis"), tr("In other APIs"),
            tr("The same click in the conventions of Vulkan, Direct3D, Unity, OpenCV and others"), m_apis,
            QStringLiteral("conventions"));

    connect(m_space, &SegmentedSwitch::chosen, this,
            [this](int index) { m_model->setSpace(static_cast<ComparisonModel::Space>(index)); });
    connect(m_showsFloat, &QCheckBox::toggled, this, [this](bool shows) {
        m_table->setColumnShown(ComparisonModel::MatrixInFloat, shows);
        m_table->setColumnShown(ComparisonModel::FloatDifference, shows);
    });
    connect(m_showsRay, &QCheckBox::toggled, this, [this](bool shows) {
        m_table->setColumnShown(ComparisonModel::Ray, shows);
        m_table->setColumnShown(ComparisonModel::RayDifference, shows);
    });
    return part;
}

Fold *ComparisonPanel::earlierPart()
{
    auto *picks = new EarlierPicksView(m_document);
    auto *fold =
        new Fold(tr("Earlier picks"), tr("The last picks of this scene. Show one again, or compare two"), picks);
    fold->setVisible(picks->table().rowCount() > 0);
    connect(picks, &EarlierPicksView::filled, fold, &QWidget::setVisible);
    m_folds.emplace_back(QStringLiteral("picks"), fold);
    return fold;
}

QWidget *ComparisonPanel::pixelPart()
{
    auto *part = new QWidget;
    auto *chain = new QFormLayout(part);
    chain->setContentsMargins(0, 0, 0, 0);
    chain->setVerticalSpacing(2);
    const auto add = [&](const QString &name, const QString &toolTip) {
        auto *label = steadyLabel(name, toolTip);
        m_chain.push_back(label);
        chain->addRow(tr("%1:").arg(name), label);
    };
    add(tr("Widget position"), tr("Logical pixels from the view's top-left corner, y down"));
    add(tr("Device pixel"), tr("Column and row from the top-left corner of the framebuffer, in device pixels"));
    add(tr("Window position"), tr("The pixel's centre in device pixels from the bottom-left corner, y up"));
    add(tr("Depth"), tr("From the depth buffer, in the depth range: by default 0 is the near plane, 1 the far plane"));
    return part;
}

QWidget *ComparisonPanel::rayPart()
{
    auto *table = new CoordinatesTable(m_rayModel);
    table->setAccessibleName(tr("The hit, its normal and the nearest vertex"));
    m_ray =
        steadyLabel(tr("Exact hit"), tr("What the ray through the pixel's centre meets on the mesh itself, in double"));
    m_rayDetail = steadyLabel(tr("Triangle, vertex and edge"),
                              tr("Indices in the model; triangles and vertices are counted from 0"));
    auto *part = new QWidget;
    auto *layout = columnOf(*part);
    layout->addWidget(table);
    layout->addWidget(m_ray);
    layout->addWidget(m_rayDetail);
    return part;
}

void ComparisonPanel::showSinceClick()
{
    const bool isStale = m_document.picks().sinceClick().isAnything();
    m_changed->setVisible(isStale);
    m_nowFold->setVisible(isStale);
    if (!isStale)
        return;
    m_now->refresh();
    m_sinceClick->setText(sinceClickText(m_document));
    const std::optional<Pick> &pick = m_document.picks().pick();
    m_again->setEnabled(devicePixelFromWidget(m_document.setup().surface, pick->widget).hasValue());
    m_again->setToolTip(m_again->isEnabled() ? tr("Click the same pixel again in the current view")
                                             : tr("The pixel of this click is outside the view now."));
}

QSize ComparisonPanel::sizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    return {std::max(m_table->sizeHint().width() + margins.left() + margins.right(), minimumWidth()),
            QWidget::sizeHint().height()};
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
    const bool hasEdge = ray && ray->state == PickedRay::State::Answered && ray->edge && !isVertexTaken();
    m_edge->setText(hasEdge ? pixelEdgeText(*ray->edge, nameOf(std::nullopt, ray->edgeObject), ray->met.has_value())
                            : QString());
    m_edge->setVisible(hasEdge);
    m_rayDetail->clear();
    const Result<WorldPoint> *formula = pick ? &pick->point.world[Method::Formula] : nullptr;
    QString notAnswered;
    if (ray && ray->state == PickedRay::State::Preparing)
        notAnswered = rayPreparingText();
    else if (ray && ray->state == PickedRay::State::Impossible)
        notAnswered = rayImpossibleText(ray->failure ? failureText(*ray->failure) : QString());
    m_others->setAnswers(ray ? ray->others : std::nullopt,
                         formula && *formula ? std::optional(**formula) : std::nullopt,
                         pick ? WorldVector(pick->uncertainty.world) : WorldVector(), notAnswered);
    if (!ray || ray->state != PickedRay::State::Answered) {
        m_ray->setText(notAnswered);
        return;
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

bool ComparisonPanel::isVertexTaken() const
{
    const MetPlace *taken = takenPlace();
    return taken && m_document.picks().pickedRay()->snap == ray::Snap::Vertex;
}

const MetPlace *ComparisonPanel::takenPlace() const
{
    const PickedRay *ray = m_document.picks().pickedRay();
    return ray && ray->snap != ray::Snap::Surface && ray->taken ? &*ray->taken : nullptr;
}

void ComparisonPanel::showAnswer(const Pick &pick)
{
    const auto numbers = [](const Components<3> &v) { return std::vector{v.x, v.y, v.z}; };
    const std::optional<WorldPoint> point = m_document.picks().pickedPoint();
    if (const MetPlace *taken = takenPlace()) {
        const ray::Snap snap = m_document.picks().pickedRay()->snap;
        const WorldVector &uncertainty = taken->hit.uncertainty;
        m_answer->setAnswer(takenText(snap, taken->hit, nameOf(taken->object, taken->objectName)), point, uncertainty);
        m_verdict->setPick(pick, takenCertaintyText(snap, taken->hit), QStringLiteral("takenUncertainty"),
                           numbers(uncertainty));
        return;
    }
    m_answer->setAnswer(pick.hit() ? nameOf(pick.object, {}) : tr("Background: no surface here"), point,
                        pick.uncertainty.world);
    m_verdict->setPick(pick, certaintyText(pick), QStringLiteral("worldUncertainty"),
                       pick.hit() ? numbers(pick.uncertainty.world) : std::vector<double>());
}

void ComparisonPanel::showPick()
{
    const std::optional<Pick> &pick = m_document.picks().pick();
    m_before->setVisible(!pick);
    m_after->setVisible(pick.has_value());
    m_model->setPick(m_document.picks().keptPick());
    m_apis->setPick(pick);
    showRay();
    showSinceClick();
    if (!pick) {
        m_answer->setAnswer({}, std::nullopt, {});
        m_formula->setFormulas({});
        return;
    }
    showAnswer(*pick);
    // The background has no object.
    constexpr int kWorld = static_cast<int>(ComparisonModel::Space::World);
    constexpr int kObject = static_cast<int>(ComparisonModel::Space::Object);
    m_space->setChoiceEnabled(kObject, pick->hit());
    if (!pick->hit() && m_space->choice() == kObject)
        m_space->setChoice(kWorld);
    const auto show = [this](ChainLink link, const QString &text, Copyable value) {
        m_chain[link]->setText(text);
        m_chain[link]->setValue(std::move(value));
    };
    const Surface &surface = pick->setup.surface;
    show(Widget, tr("%1 logical pixels").arg(positionText(pick->widget.x, pick->widget.y)),
         {QStringLiteral("widget"), {pick->widget.x, pick->widget.y}});
    show(DevicePixelOf,
         tr("(%1, %2) of %3 × %4, ratio %5")
             .arg(pick->devicePixel.i)
             .arg(pick->devicePixel.j)
             .arg(surface.widthPixels)
             .arg(surface.heightPixels)
             .arg(writtenText(surface.devicePixelRatio, 4)),
         {QStringLiteral("devicePixel"), {double(pick->devicePixel.i), double(pick->devicePixel.j)}});
    show(Window, tr("%1, the pixel's centre").arg(positionText(pick->window.x, pick->window.y)),
         {QStringLiteral("window"), {pick->window.x, pick->window.y, pick->window.z}});
    show(Depth, clickedDepthText(depthText(pick->window.z), pick->hit()), {QStringLiteral("depth"), {pick->window.z}});
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

bool ComparisonPanel::showsRay() const
{
    return m_showsRay->isChecked();
}

void ComparisonPanel::setShowsRay(bool shows)
{
    m_showsRay->setChecked(shows);
}

QStringList ComparisonPanel::openFolds() const
{
    QStringList names;
    for (const auto &[name, fold] : m_folds) {
        if (fold->isOpen())
            names << name;
    }
    return names;
}

void ComparisonPanel::setOpenFolds(const QStringList &names)
{
    for (const auto &[name, fold] : m_folds)
        fold->setOpen(names.contains(name));
}

void ComparisonPanel::copyAnswer()
{
    m_answer->copy();
}

void ComparisonPanel::markTerm(const QString &term)
{
    m_formula->setMarkedTerm(term);
}

QString ComparisonPanel::text() const
{
    const std::optional<Pick> &pick = m_document.picks().pick();
    if (!pick)
        return {};
    QString text = m_answer->heading() + u'\n' + m_answer->text() + u'\n';
    if (!m_edge->text().isEmpty())
        text += m_edge->text() + u'\n';
    text += m_verdict->text();
    if (m_document.picks().sinceClick().isAnything())
        text += m_sinceClick->text() + u'\n' + m_now->text();
    for (const SteadyLabel *link : m_chain) {
        const bool isDepth = link == m_chain[Depth];
        text += link->accessibleName() + u'\t'
                + (isDepth ? clickedDepthText(shortestText(pick->window.z), pick->hit()) : link->text()) + u'\n';
    }
    using Space = ComparisonModel::Space;
    for (const auto &[space, name] : {std::pair(Space::World, tr("World")), std::pair(Space::Eye, tr("Eye")),
                                      std::pair(Space::Object, tr("Object"))}) {
        if (space == Space::Object && !pick->hit())
            continue;
        ComparisonModel model;
        model.setSpace(space);
        model.setPick(m_document.picks().keptPick());
        text += name + u'\n' + model.text();
    }
    text += m_rayModel->text() + m_ray->text() + u'\n' + m_rayDetail->text() + u'\n';
    text += m_others->text() + m_apis->text();
    return text + m_formula->formulas().text() + u'\n';
}

} // namespace unprojector::gui
