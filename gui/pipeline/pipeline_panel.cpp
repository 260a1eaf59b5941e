#include "gui/pipeline/pipeline_panel.h"

#include "core/scene/given_matrices.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/derivation_line.h"
#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/factor_shares.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/followed_point_row.h"
#include "gui/pipeline/matrix_findings_view.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/pipeline/pipeline_switches.h"
#include "gui/pipeline/stage_text.h"
#include "gui/widgets/help_link.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;

using Space = PointModel::Space;

PipelinePanel::PipelinePanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(new PipelineModel(document, this)),
      m_switches(new PipelineSwitches(document, *m_model)), m_followed(new FollowedPointRow(document, *m_model)),
      m_chain(new PipelineChain(*m_model)), m_derivation(new DerivationLine(document, *m_model))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    layout->addWidget(m_switches);
    layout->addWidget(m_followed);
    layout->addWidget(m_chain);
    createStages();
    layout->addWidget(m_scrollArea, 1);

    connect(m_chain, &PipelineChain::partChosen, this, &PipelinePanel::open);
    connect(m_chain, &PipelineChain::numberChosen, this, &PipelinePanel::explain);
    connect(m_chain, &PipelineChain::numberReached, this, [this](Space space, int coordinate) {
        if (isOpen(space)) // else the Tab key could not leave the chain for the open matrix
            explain(space, coordinate);
    });
    connect(m_chain, &PipelineChain::allOpenChanged, this, &PipelinePanel::showOpened);
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (kVisibleChanges | Change::Names | Change::Pick | Change::GivenPoint | Change::Conventions))
            refresh();
    });
    connect(m_model, &PipelineModel::followedChanged, this, &PipelinePanel::refresh);
    connect(m_switches, &PipelineSwitches::directionChanged, this, &PipelinePanel::followDirection);
    connect(m_switches, &PipelineSwitches::viewChanged, this, &PipelinePanel::showTitles);
    connect(m_switches, &PipelineSwitches::objectChanged, this, &PipelinePanel::showStatus);
    connect(m_switches, &PipelineSwitches::pasteWanted, this, [this] {
        emit aboutToPaste();
        PasteCameraDialog::open(m_document, window());
    });
    arrange();
    createActions();
}

PipelinePanel::~PipelinePanel()
{
    // Deleting a row during editing would commit its text.
    for (int i = 0; i < PointModel::kSpaces; ++i)
        m_model->point(static_cast<Space>(i))->disconnect(m_model);
}

void PipelinePanel::createStages()
{
    auto *content = new QWidget;
    m_rows = new QVBoxLayout(content);
    m_rows->setContentsMargins(0, 0, 4, 0);
    m_rows->setSpacing(4);

    for (const PipelineStage stage : kPipelineStages) {
        auto *section = new MatrixSection(m_model->matrix(stage));
        m_sections[static_cast<std::size_t>(stage)] = section;
        connect(section, &MatrixSection::rowChosen, this, [this, stage](int mathRow) {
            if (const auto space = spaceMadeBy(stage, m_model->direction()))
                explain(*space, mathRow);
        });
    }
    const auto takeApart = [this](PipelineStage stage) {
        MatrixSection *section = m_sections[static_cast<std::size_t>(stage)];
        connect(section, &MatrixSection::factorsOpened, this, &PipelinePanel::showFactors);
        return section->addFactors();
    };
    m_viewFactors = takeApart(PipelineStage::ViewMatrix);
    m_projectionFactors = takeApart(PipelineStage::ProjectionMatrix);
    m_given = new MatrixSection(m_model->given());
    m_givenView = new MatrixSection(m_model->givenView());
    m_givenFindings = new MatrixFindingsView;
    m_givenViewFindings = new MatrixFindingsView;
    connect(m_givenFindings, &MatrixFindingsView::repairWanted, m_model,
            [this](const MatrixFinding &finding) { m_model->repair(MatrixRole::Projection, finding); });
    connect(m_givenViewFindings, &MatrixFindingsView::repairWanted, m_model,
            [this](const MatrixFinding &finding) { m_model->repair(MatrixRole::View, finding); });
    showGiven();
    m_apiNote = new QLabel;
    m_apiNote->setWordWrap(true);
    m_apiNote->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_apiNote->setAccessibleName(tr("Differences from OpenGL"));
    m_division = new QLabel;
    m_flip = new QLabel;
    const auto addHelp = [](QLabel *step, const char *anchor) {
        step->setIndent(6);
        auto *line = new QHBoxLayout(new QWidget);
        line->setContentsMargins(0, 0, 0, 0);
        line->addWidget(step, 1);
        line->addWidget(new HelpLink(QString::fromLatin1(anchor)));
    };
    addHelp(m_division, "viewport");
    addHelp(m_flip, "half-pixel");

    m_scrollArea = new QScrollArea;
    m_scrollArea->setWidgetResizable(true);
    m_scrollArea->setFrameShape(QFrame::NoFrame);
    m_scrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scrollArea->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    m_scrollArea->setWidget(content);
    m_scrollArea->setSizePolicy(QSizePolicy::Expanding,
                                QSizePolicy::Ignored); // it takes the remaining room, and asks for none
}

void PipelinePanel::arrange()
{
    const auto section = [this](PipelineStage stage) -> QWidget * {
        return m_sections[static_cast<std::size_t>(stage)];
    };
    const bool isForward = m_model->direction() == PipelineDirection::Forward;
    QList<QWidget *> rows{section(PipelineStage::ModelMatrix)};
    if (isForward)
        rows << m_givenView << m_givenViewFindings << section(PipelineStage::ViewMatrix);
    else
        rows << section(PipelineStage::ViewMatrix) << m_givenViewFindings << m_givenView;
    // The division comes after the projection forward, and after its inverse backward.
    if (isForward)
        rows << m_given << m_givenFindings << section(PipelineStage::ProjectionMatrix) << m_division->parentWidget();
    else
        rows << m_division->parentWidget() << section(PipelineStage::ProjectionMatrix) << m_givenFindings << m_given;
    rows << section(PipelineStage::ViewportMatrix) << m_flip->parentWidget();
    if (!isForward)
        std::reverse(rows.begin(), rows.end());
    rows << section(PipelineStage::ModelviewMatrix) << section(PipelineStage::WholeMatrix) << m_apiNote;

    while (QLayoutItem *item = m_rows->takeAt(0))
        delete item;
    for (QWidget *row : std::as_const(rows))
        m_rows->addWidget(row);
    m_rows->addStretch();
    m_chain->arrange();
    // The Tab order is the visual order.
    QWidget *last = nullptr;
    for (QWidget *row : std::as_const(rows)) {
        for (QWidget *child : row->findChildren<QWidget *>()) {
            if (child->focusPolicy() == Qt::NoFocus)
                continue;
            if (last)
                setTabOrder(last, child);
            last = child;
        }
    }
    m_division->setText(isForward ? tr("↓  divide by w") : tr("↓  divide by its own w′, as gluUnProject does"));
    m_flip->setText(flipText(*m_model, m_model->setup().surface));
    showTitles();
    showOpened();
}

void PipelinePanel::followDirection()
{
    const PipelineDirection direction = m_model->direction();
    const PipelineDirection before =
        direction == PipelineDirection::Forward ? PipelineDirection::Backward : PipelineDirection::Forward;
    if (const auto *space = std::get_if<Space>(&m_opened); space && !m_derivation->chosenSpace()) {
        // The same matrix now leads to the other one of its two spaces.
        if (const std::optional<PipelineStage> stage = stageOf(*space, before))
            m_opened = spaceMadeBy(*stage, direction).value_or(*space);
    }
    arrange();
    showStatus();
}

void PipelinePanel::open(const ChainPart &part)
{
    if (part != m_opened)
        m_derivation->clear();
    showPart(part);
}

void PipelinePanel::showPart(const ChainPart &part)
{
    const bool isOther = part != m_opened;
    m_opened = part;
    showOpened();
    if (!isOther && !areAllOpen())
        return;
    const auto *space = std::get_if<Space>(&part);
    const QWidget *step = space ? stepTo(*space) : m_sections[static_cast<std::size_t>(std::get<PipelineStage>(part))];
    scrollTo(step ? *step : *m_derivation, space ? m_derivation : nullptr);
}

QWidget *PipelinePanel::stepTo(Space space) const
{
    const PipelineDirection direction = m_model->direction();
    if (const std::optional<PipelineStage> stage = stageOf(space, direction))
        return m_sections[static_cast<std::size_t>(*stage)];
    if (space == startOf(direction))
        return nullptr;
    return (space == Space::Window || space == Space::Widget ? m_flip : m_division)->parentWidget();
}

void PipelinePanel::explain(Space space, int coordinate)
{
    const bool isSeen = m_derivation->chosenSpace() == space;
    m_derivation->choose(space, coordinate);
    if (isSeen) // walking through its numbers must not scroll
        m_opened = space;
    else
        showPart(space);
}

bool PipelinePanel::isOpen(PipelineStage stage) const
{
    if (areAllOpen())
        return true;
    if (const auto *product = std::get_if<PipelineStage>(&m_opened))
        return *product == stage;
    return stageOf(std::get<Space>(m_opened), m_model->direction()) == stage;
}

bool PipelinePanel::isOpen(Space space) const
{
    return areAllOpen() || m_opened == ChainPart(space);
}

void PipelinePanel::showOpened()
{
    for (const PipelineStage stage : kPipelineStages)
        m_sections[static_cast<std::size_t>(stage)]->setVisible(isOpen(stage));
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        QWidget *step = stepTo(static_cast<Space>(i));
        if (step && !stageOf(static_cast<Space>(i), m_model->direction()))
            step->setVisible(isOpen(static_cast<Space>(i)));
    }

    // The derivation, or a hint before any number is chosen.
    std::optional<Space> of = m_derivation->chosenSpace();
    if (const auto *space = std::get_if<Space>(&m_opened); space && !of)
        of = *space;
    if (of) {
        m_rows->removeWidget(m_derivation);
        QWidget *step = stepTo(*of);
        if (auto *section = qobject_cast<MatrixSection *>(step))
            section->putBelowNumbers(m_derivation);
        else
            // the start of a path is at the top
            m_rows->insertWidget(step ? m_rows->indexOf(step) + 1 : 0, m_derivation);
    }
    m_derivation->setVisible(of && isOpen(*of));
    m_chain->setOpened(m_opened);
    showGiven();
    showFactors();
}

void PipelinePanel::setDirection(PipelineDirection direction)
{
    m_switches->setDirection(direction);
}

void PipelinePanel::setMatrixView(const MatrixView &view)
{
    m_switches->setMatrixView(view);
}

QSize PipelinePanel::sizeHint() const
{
    return {51 * fontMetrics().horizontalAdvance(u'0'), 36 * fontMetrics().lineSpacing()};
}

void PipelinePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void PipelinePanel::refresh()
{
    if (!isVisible())
        return;
    m_model->update();
    showStatus();
    m_switches->refresh();
}

void PipelinePanel::showHelp()
{
    for (const PipelineStage stage : kPipelineStages)
        m_sections[static_cast<std::size_t>(stage)]->setHelp(
            stageHelp(stage, m_model->direction(), kindOf(m_model->setup().projection())));
}

void PipelinePanel::showTitles()
{
    for (const PipelineStage stage : kPipelineStages)
        m_sections[static_cast<std::size_t>(stage)]->setTitle(
            stageTitle(stage, m_model->direction()), stageName(stage, m_model->direction()),
            productText(stage, m_model->direction(), m_model->view().layout));
    m_chain->showView();
    showHelp();
    showFactors();
    m_derivation->startOver();
}

void PipelinePanel::showFactors()
{
    const Projection projection = m_model->setup().projection();
    const auto show = [this](PipelineStage stage, FactorsView *view, bool isGiven, const Projection *of) {
        if (!m_sections[static_cast<std::size_t>(stage)]->showsFactors())
            return;
        if (const auto factors = m_model->factors(stage))
            view->setFactors(*factors, m_model->matrix(stage)->matrix(), m_model->view(), isGiven, of);
        else if (m_model->direction() == PipelineDirection::Backward) // else they stay, as the matrices do
            view->setNone(tr("Forward shows the factors; this matrix is the inverse of their product."));
    };
    show(PipelineStage::ViewMatrix, m_viewFactors, m_model->isViewGiven(), nullptr);
    show(PipelineStage::ProjectionMatrix, m_projectionFactors, m_model->isProjectionGiven(), &projection);
}

void PipelinePanel::showStatus()
{
    showGiven();
    m_followed->refresh();
    showHelp();
    showFactors();
    m_derivation->refresh();
    m_flip->setText(flipText(*m_model, m_model->setup().surface));
    m_apiNote->setText(m_model->apiNote());
    m_apiNote->setVisible(!m_model->apiNote().isEmpty());
}

void PipelinePanel::showGiven()
{
    const auto setTitle = [](MatrixSection *section, PipelineStage stage, const QString &note) {
        const QString title = tr("%1 as given").arg(stageTitle(stage, PipelineDirection::Forward));
        section->setTitle(title, title, note);
    };
    setTitle(m_given, PipelineStage::ProjectionMatrix, m_model->givenNote());
    m_given->setVisible(!m_model->givenNote().isEmpty() && isOpen(PipelineStage::ProjectionMatrix));
    setTitle(m_givenView, PipelineStage::ViewMatrix, {});
    m_givenView->setVisible(m_model->isViewGiven() && isOpen(PipelineStage::ViewMatrix));
    // The scene stores matrices by columns.
    m_givenFindings->setFindings(m_model->givenFindings(MatrixRole::Projection), MatrixRole::Projection,
                                 NumberOrder::ByColumns);
    m_givenViewFindings->setFindings(m_model->givenFindings(MatrixRole::View), MatrixRole::View,
                                     NumberOrder::ByColumns);
}

void PipelinePanel::createActions()
{
    const auto add = [this](const QString &name, const auto &does) {
        auto *action = new QAction(this);
        action->setObjectName(name);
        connect(action, &QAction::triggered, this, does);
    };
    // in the order of PipelineStage
    constexpr std::array kStages{"model", "view", "projection", "viewport", "modelview", "whole"};
    for (std::size_t i = 0; i < kStages.size(); ++i)
        add(QStringLiteral("open_") + QLatin1String(kStages[i]), [this, i] { openMatrix(kPipelineStages[i]); });
    for (const int percent : {0, 100}) {
        add(QStringLiteral("factors_%1").arg(percent), [this, percent] {
            takeApart(PipelineStage::ProjectionMatrix);
            m_projectionFactors->shares().setAll(percent);
        });
    }
}

void PipelinePanel::openMatrix(PipelineStage stage)
{
    openStep(stage);
    scrollTo(*m_sections[static_cast<std::size_t>(stage)], nullptr);
}

void PipelinePanel::openStep(PipelineStage stage)
{
    const std::optional<Space> space = spaceMadeBy(stage, m_model->direction());
    open(space ? ChainPart(*space) : ChainPart(stage));
}

void PipelinePanel::takeApart(PipelineStage stage)
{
    m_switches->setDirection(PipelineDirection::Forward);
    openStep(stage);
    MatrixSection &section = *m_sections[static_cast<std::size_t>(stage)];
    section.setApart(true);
    scrollTo(section, stage == PipelineStage::ProjectionMatrix ? &m_projectionFactors->shares() : nullptr);
}

void PipelinePanel::scrollTo(const QWidget &row, const QWidget *tried)
{
    // After the layout.
    QTimer::singleShot(0, this, [this, &row, tried] {
        const auto topOf = [this](const QWidget &one) { return one.mapTo(m_scrollArea->widget(), QPoint()).y(); };
        int top = topOf(row);
        // Starts at the heading, unless the widget to try would be out of sight.
        if (tried && tried->isVisible()) {
            if (const int below = topOf(*tried); below >= top)
                top = std::clamp(below + tried->height() - m_scrollArea->viewport()->height(), top, below);
        }
        m_scrollArea->verticalScrollBar()->setValue(top);
    });
}

void PipelinePanel::startOver()
{
    m_derivation->clear();
    for (const PipelineStage stage : {PipelineStage::ViewMatrix, PipelineStage::ProjectionMatrix})
        m_sections[static_cast<std::size_t>(stage)]->setApart(false);
    showOpened();
    QTimer::singleShot(0, this, [this] { m_scrollArea->verticalScrollBar()->setValue(0); });
}

PipelinePanel::Kept PipelinePanel::kept() const
{
    const auto isApart = [this](PipelineStage stage) { return m_sections[static_cast<std::size_t>(stage)]->isApart(); };
    return {m_opened,
            areAllOpen(),
            isApart(PipelineStage::ViewMatrix),
            isApart(PipelineStage::ProjectionMatrix),
            m_projectionFactors->shares().percents(),
            m_derivation->chosen(),
            m_scrollArea->verticalScrollBar()->value()};
}

void PipelinePanel::restore(const Kept &kept)
{
    setAllOpen(kept.areAllOpen);
    m_opened = kept.opened;
    showOpened();
    m_sections[static_cast<std::size_t>(PipelineStage::ViewMatrix)]->setApart(kept.isViewApart);
    m_sections[static_cast<std::size_t>(PipelineStage::ProjectionMatrix)]->setApart(kept.isProjectionApart);
    m_projectionFactors->shares().setPercents(kept.percents);
    if (kept.chosen)
        m_derivation->choose(kept.chosen->space, kept.chosen->coordinate);
    else
        m_derivation->clear();
    showOpened();
    // After the layout.
    QTimer::singleShot(0, this, [this, top = kept.top] { m_scrollArea->verticalScrollBar()->setValue(top); });
}

void PipelinePanel::applyTyped()
{
    m_chain->applyTyped();
}

} // namespace unprojector::gui
