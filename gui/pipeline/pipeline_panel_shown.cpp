// What the pipeline panel shows.

#include "gui/pipeline/pipeline_panel.h"

#include "core/scene/given_matrices.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/matrix_findings_view.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/text/api_text.h"
#include "gui/text/help_anchors.h"
#include "gui/text/number_text.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/steady_label.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
namespace {

using Space = PointModel::Space;

QString stageName(PipelineStage stage, PipelineDirection direction)
{
    QString name;
    switch (stage) {
    case PipelineStage::ModelMatrix: name = PipelinePanel::tr("Model"); break;
    case PipelineStage::ViewMatrix: name = PipelinePanel::tr("View"); break;
    case PipelineStage::ProjectionMatrix: name = PipelinePanel::tr("Projection"); break;
    case PipelineStage::ViewportMatrix: name = PipelinePanel::tr("Viewport"); break;
    case PipelineStage::ModelviewMatrix: name = PipelinePanel::tr("Modelview"); break;
    case PipelineStage::WholeMatrix: name = QStringLiteral("MVPW"); break;
    }
    return direction == PipelineDirection::Forward ? name : name + QStringLiteral("⁻¹");
}

/// The factors of a combined matrix in the order they are written in; empty for a single one.
QString productText(PipelineStage stage, PipelineDirection direction, MatrixLayout layout)
{
    std::vector<PipelineStage> stages;
    if (stage == PipelineStage::ModelviewMatrix)
        stages = {PipelineStage::ViewMatrix, PipelineStage::ModelMatrix};
    else if (stage == PipelineStage::WholeMatrix)
        stages = {PipelineStage::ViewportMatrix, PipelineStage::ProjectionMatrix, PipelineStage::ViewMatrix,
                  PipelineStage::ModelMatrix};
    else
        return {};
    // Both the inverse and the row vectors turn the order round.
    if ((direction == PipelineDirection::Backward) != (layout == MatrixLayout::Row))
        std::reverse(stages.begin(), stages.end());
    QStringList names;
    for (const PipelineStage factor : stages)
        names << stageName(factor, direction);
    return QStringLiteral("= ") + names.join(QStringLiteral(" · "));
}

} // namespace

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
    showObjects();
    showConventions();
}

void PipelinePanel::showFollowed()
{
    const bool isGiven = m_model->followsGiven();
    m_follow->setText(isGiven ? tr("The click") : tr("Your point"));
    m_follow->setToolTip(isGiven ? tr("Follow the clicked point again; yours stays")
                                 : tr("Follow the point that you have given in numbers"));
    m_follow->setVisible(m_document.scene().givenPoint && (!isGiven || m_document.pick()));
    m_remove->setVisible(m_document.scene().givenPoint.has_value());
}

QString PipelinePanel::helpOf(PipelineStage stage) const
{
    if (m_model->direction() == PipelineDirection::Backward)
        return QStringLiteral("matrix");
    switch (stage) {
    case PipelineStage::ModelMatrix: return QStringLiteral("model");
    case PipelineStage::ViewMatrix: return QStringLiteral("view");
    case PipelineStage::ProjectionMatrix: return helpAnchorOf(kindOf(m_document.geometry().projection()));
    case PipelineStage::ViewportMatrix: return QStringLiteral("viewport");
    case PipelineStage::ModelviewMatrix:
    case PipelineStage::WholeMatrix: return QStringLiteral("mvpw");
    }
    Q_UNREACHABLE();
}

QString PipelinePanel::helpOf(const EntryDerivation &derivation) const
{
    if (derivation.stage)
        return helpOf(*derivation.stage);
    if (!m_chosen || !derivation.source)
        return QStringLiteral("spaces");
    // The flip, and the division.
    return m_chosen->space == Space::Window || m_chosen->space == Space::Widget ? QStringLiteral("half-pixel")
                                                                                : QStringLiteral("viewport");
}

void PipelinePanel::showHelp()
{
    for (const PipelineStage stage : kPipelineStages)
        m_sections[static_cast<std::size_t>(stage)]->setHelp(helpOf(stage));
}

void PipelinePanel::showTitles()
{
    for (const PipelineStage stage : kPipelineStages)
        m_sections[static_cast<std::size_t>(stage)]->setTitle(
            stageName(stage, m_model->direction()), m_model->matrix(stage)->variableName(),
            productText(stage, m_model->direction(), m_model->view().layout));
    showHelp();
    m_derivation->setLongest(longestDerivations(m_model->view().isWhole));
    showFactors();
    showDerivation();
}

void PipelinePanel::showFactors()
{
    const Projection projection = m_document.geometry().projection();
    const auto show = [this](PipelineStage stage, FactorsView *view, bool isGiven, const Projection *of) {
        if (!m_sections[static_cast<std::size_t>(stage)]->showsFactors())
            return;
        if (const auto factors = m_model->factors(stage))
            view->setFactors(*factors, m_model->matrix(stage)->matrix(), m_model->view(), isGiven, of);
        else if (m_model->direction() == PipelineDirection::Backward) // else they stay, as the matrices do
            view->setNone(tr("Forward shows the factors; this matrix is the inverse of their product."));
    };
    show(PipelineStage::ViewMatrix, m_viewFactors, givenView(m_document.scene()) != nullptr, nullptr);
    show(PipelineStage::ProjectionMatrix, m_projectionFactors, givenProjection(m_document.scene()) != nullptr,
         &projection);
}

void PipelinePanel::showDerivation()
{
    const EntryDerivation derivation =
        m_chosen ? entryDerivation(*m_model, m_document.geometry(), m_chosen->space, m_chosen->coordinate)
                 : EntryDerivation{entryHint(), {}, 0, {}, {}};
    m_derivation->setText(unbrokenTerms(derivation.text));
    m_derivationHelp->setAnchor(helpOf(derivation));
    m_derivation->setToolTip(derivation.text);
    for (const PipelineStage stage : kPipelineStages) {
        MatrixModel *matrix = m_model->matrix(stage);
        QModelIndexList marked;
        for (int column = 0; column < 4 && derivation.stage == stage; ++column)
            marked << matrix->indexOf(derivation.matrixRow, column);
        matrix->setMarked(marked);
    }
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        PointModel *point = m_model->point(static_cast<Space>(i));
        QModelIndexList marked;
        if (m_chosen && m_chosen->space == point->space())
            marked << point->indexOf(m_chosen->coordinate);
        if (derivation.source == point->space()) {
            for (const int coordinate : derivation.coordinates)
                marked << point->indexOf(coordinate);
        }
        point->setMarked(marked);
    }
}

void PipelinePanel::showStatus()
{
    showGiven();
    showFollowed();
    showHelp();
    showFactors();
    showDerivation();
    if (m_status->text() != m_model->status()) {
        m_status->setText(m_model->status());
        m_status->setToolTip(m_model->status());
    }
    const Surface &surface = m_document.geometry().surface;
    if (surface == m_surface && m_model->isDepthRead() == m_isDepthRead && m_model->api() == m_api)
        return;
    m_surface = surface;
    m_api = m_model->api();
    m_isDepthRead = m_model->isDepthRead();
    showFlip();
}

void PipelinePanel::showGiven()
{
    m_given->setTitle(tr("Projection"), m_model->given()->variableName(), m_model->givenNote());
    m_given->setVisible(!m_model->givenNote().isEmpty());
    m_givenView->setTitle(tr("View"), m_model->givenView()->variableName(), tr("As it was given."));
    m_givenView->setVisible(givenView(m_document.scene()) != nullptr);
    // Of what the scene keeps, the order is that of columns.
    m_givenFindings->setFindings(m_model->givenFindings(MatrixRole::Projection), MatrixRole::Projection,
                                 NumberOrder::ByColumns);
    m_givenViewFindings->setFindings(m_model->givenFindings(MatrixRole::View), MatrixRole::View,
                                     NumberOrder::ByColumns);
}

void PipelinePanel::showFlip()
{
    const ApiConventions &api = conventionsOf(m_api);
    const double pixelRatio = api.areLogicalPixels ? 1.0 : m_surface.devicePixelRatio;
    const bool isForward = m_model->direction() == PipelineDirection::Forward;
    const QString ratio = pixelRatio == 1.0 ? QString() : significantText(pixelRatio, 6);
    const QString half = api.pixelCentre != 0.0 ? QString()
                         : isForward            ? QStringLiteral(" + ½")
                                                : QStringLiteral(" − ½");
    const auto axis = [&](QChar name, bool isFlipped) {
        const QString scaled =
            isForward || ratio.isEmpty() ? QString(name) : QStringLiteral("%1 · %2").arg(name).arg(ratio);
        return (isFlipped ? QStringLiteral("%1 − ").arg(m_surface.heightPixels) : QString()) + scaled + half;
    };
    QString text = QStringLiteral("↓  (%1, %2)").arg(axis(u'x', false), axis(u'y', !api.isOriginTop));
    if (isForward && !ratio.isEmpty())
        text += QStringLiteral(" / ") + ratio;
    if (isForward)
        m_flip->setText(text);
    else
        m_flip->setText(m_isDepthRead ? tr("%1, depth as read").arg(text) : tr("%1, depth computed").arg(text));
}

void PipelinePanel::showObjects()
{
    const std::vector<SceneObject> &objects = m_document.objects();
    const auto hasName = [](const SceneObject &object, const std::string &name) { return object.name == name; };
    const bool isSame =
        m_object->count() > 0
        && std::equal(objects.begin(), objects.end(), m_objectNames.begin(), m_objectNames.end(), hasName);
    if (!isSame) {
        m_objectNames.clear();
        const QSignalBlocker blocker(m_object);
        m_object->clear();
        m_object->addItem({});
        m_object->addItem(tr("None (identity)"));
        for (const SceneObject &object : objects) {
            m_objectNames.push_back(object.name);
            m_object->addItem(shownObjectName(object.name, objects));
        }
    }
    const std::optional<std::size_t> shown = m_model->shownObject();
    const bool isAutomatic = m_model->object() == PipelineModel::kAutomaticObject;
    const QString automatic = isAutomatic && shown
                                  ? tr("Automatic: %1").arg(shownObjectName(objects[*shown].name, objects))
                              : isAutomatic ? tr("None (identity)")
                                            : tr("Automatic");
    if (m_object->itemText(kAutomaticItem) != automatic)
        m_object->setItemText(kAutomaticItem, automatic);
    const int item = isAutomatic || !shown ? (isAutomatic ? kAutomaticItem : kNoneItem)
                                           : kFirstObjectItem + static_cast<int>(*shown);
    if (m_object->currentIndex() != item)
        m_object->setCurrentIndex(item);
}

void PipelinePanel::showConventions()
{
    m_conventions->setToolTip(
        tr("Whose axes, depths and pixels are shown, kept in the scene. %1").arg(apiText(m_model->api())));
    m_apiNote->setText(m_model->apiNote());
    m_apiNote->setVisible(!m_model->apiNote().isEmpty());
}

} // namespace unprojector::gui
