// What is done in the pipeline panel: what lessons link to, the conventions that are chosen, what is typed and pasted.

#include "gui/pipeline/pipeline_panel.h"

#include "gui/document/scene_document.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/pipeline/paste_matrices_dialog.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/segmented_switch.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>

#include <algorithm>

namespace unprojector::gui {

void PipelinePanel::createActions()
{
    const auto add = [this](const QString &name, const auto &does) {
        auto *action = new QAction(this);
        action->setObjectName(name);
        connect(action, &QAction::triggered, this, does);
    };
    const auto choices = [&add](SegmentedSwitch *among, const QStringList &names) {
        for (int i = 0; i < names.size(); ++i)
            add(names[i], [among, i] { among->setChoice(i); });
    };
    choices(m_directionSwitch, {QStringLiteral("forward"), QStringLiteral("backward")});
    choices(m_layoutSwitch, {QStringLiteral("columns"), QStringLiteral("rows")});
    choices(m_memorySwitch, {QStringLiteral("square"), QStringLiteral("memory_order")});
    choices(m_digitsSwitch,
            {QStringLiteral("double_digits"), QStringLiteral("all_digits"), QStringLiteral("float_digits")});
    constexpr std::array kStages{"model", "view", "projection", "viewport", "modelview", "whole"}; // of PipelineStage
    for (std::size_t i = 0; i < kStages.size(); ++i)
        add(QStringLiteral("open_") + QLatin1String(kStages[i]), [this, i] { openMatrix(kPipelineStages[i]); });
    for (const int percent : {0, 100}) {
        add(QStringLiteral("factors_%1").arg(percent), [this, percent] {
            takeApart(PipelineStage::ProjectionMatrix);
            m_projectionFactors->setShares(percent);
        });
    }
    for (const Api api : kApis)
        add(QStringLiteral("conventions_") + QLatin1String(conventionsOf(api).key),
            [this, api] { takeConventions(api); });
}

void PipelinePanel::openMatrix(PipelineStage stage)
{
    MatrixSection &section = *m_sections[static_cast<std::size_t>(stage)];
    section.setOpen(true);
    scrollTo(section, nullptr);
}

void PipelinePanel::takeApart(PipelineStage stage)
{
    setDirection(PipelineDirection::Forward);
    MatrixSection &section = *m_sections[static_cast<std::size_t>(stage)];
    section.takeApart();
    scrollTo(section, stage == PipelineStage::ProjectionMatrix ? &m_projectionFactors->shares() : nullptr);
}

void PipelinePanel::scrollTo(const QWidget &row, const QWidget *tried)
{
    // Once all stands where it will.
    QTimer::singleShot(0, this, [this, &row, tried] {
        const auto topOf = [this](const QWidget &one) { return one.mapTo(m_scrollArea->widget(), QPoint()).y(); };
        int top = topOf(row);
        // From the heading on, unless what there is to try would be out of sight.
        if (tried && tried->isVisible()) {
            if (const int below = topOf(*tried); below >= top)
                top = std::clamp(below + tried->height() - m_scrollArea->viewport()->height(), top, below);
        }
        m_scrollArea->verticalScrollBar()->setValue(top);
    });
}

void PipelinePanel::scrollToTop()
{
    QTimer::singleShot(0, this, [this] { m_scrollArea->verticalScrollBar()->setValue(0); });
}

void PipelinePanel::takeConventions(Api api)
{
    m_model->setApi(api);
    takeTheirLayout();
}

void PipelinePanel::followConventions()
{
    const int item = static_cast<int>(m_document.scene().conventions);
    if (m_conventions->currentIndex() == item)
        return;
    m_conventions->setCurrentIndex(item);
    takeTheirLayout();
}

void PipelinePanel::takeTheirLayout()
{
    m_layoutSwitch->setChoice(conventionsOf(m_document.scene().conventions).areVectorsRows ? 1 : 0);
}

void PipelinePanel::applyTyped()
{
    for (NumberGrid *grid : m_pointGrids)
        grid->applyTyped();
}

void PipelinePanel::keyPressEvent(QKeyEvent *event)
{
    if (!event->matches(QKeySequence::Paste)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const auto hasFocus = [this](const QWidget *section) { return section->isAncestorOf(window()->focusWidget()); };
    MatrixRole role = MatrixRole::Projection;
    if (hasFocus(m_givenView) || hasFocus(m_sections[std::size_t(PipelineStage::ViewMatrix)])
        || hasFocus(m_sections[std::size_t(PipelineStage::ModelviewMatrix)]))
        role = MatrixRole::View;
    else if (hasFocus(m_sections[std::size_t(PipelineStage::WholeMatrix)]))
        role = MatrixRole::Product;
    emit aboutToPaste();
    PasteMatricesDialog::open(m_document, window(), role, QGuiApplication::clipboard()->text());
}

} // namespace unprojector::gui
