#include "gui/pipeline/pipeline_chain.h"

#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/stage_text.h"
#include "gui/widgets/number_grid.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
using namespace pipeline;

using Space = PointModel::Space;

namespace {

constexpr std::array kProducts{PipelineStage::ModelviewMatrix, PipelineStage::WholeMatrix};
constexpr int kCoordinates = 4;

/// A button as low as a line of numbers: seven of them are always visible.
class LowButton : public QToolButton {
public:
    QSize sizeHint() const override
    {
        const QFontMetrics metrics(font());
        const int height = metrics.height();
        return {metrics.horizontalAdvance(text()) + 2 * height, height + 3};
    }
};

} // namespace

PipelineChain::PipelineChain(PipelineModel &model, QWidget *parent)
    : QWidget(parent), m_model(model), m_layout(new QGridLayout(this)), m_scrollBar(new QScrollBar(Qt::Horizontal)),
      m_openAll(new QToolButton)
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setHorizontalSpacing(0);
    m_layout->setVerticalSpacing(1);
    for (int coordinate = 0; coordinate < kCoordinates; ++coordinate) {
        auto *axis = new QLabel(QString(QStringLiteral("xyzw")[coordinate]));
        axis->setAlignment(Qt::AlignCenter);
        m_layout->addWidget(axis, 0, 1 + coordinate);
        m_layout->setColumnStretch(1 + coordinate, 1);
        m_axes[static_cast<std::size_t>(coordinate)] = axis;
    }
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        PointModel *point = m_model.point(static_cast<Space>(i));
        auto *grid = new NumberGrid(point);
        grid->hideScrollBar();
        if (point->columnCount() < kCoordinates) // its numbers are below the same letters as the others
            grid->setMinimumWidth(1);
        connect(grid, &NumberGrid::entered, this,
                [this, point](const QModelIndex &index) { emit numberChosen(point->space(), index.column()); });
        connect(grid, &NumberGrid::reached, this,
                [this, point](const QModelIndex &index) { emit numberReached(point->space(), index.column()); });
        m_lines[static_cast<std::size_t>(i)] = {createOpener(point->space()), grid};
    }
    createScrollBar(1 + PointModel::kSpaces);
    createProducts(2 + PointModel::kSpaces);
    arrange();
    showView();
}

QToolButton *PipelineChain::createOpener(const ChainPart &part)
{
    auto *button = new LowButton;
    button->setAutoRaise(true);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    // The checked button is the open part, which the panel decides.
    connect(button, &QToolButton::clicked, this, [this, part] { emit partChosen(part); });
    return button;
}

void PipelineChain::createScrollBar(int line)
{
    m_scrollBar->setAccessibleName(tr("Scroll the points sideways"));
    m_layout->addWidget(m_scrollBar, line, 1, 1, kCoordinates);
    connect(m_scrollBar, &QScrollBar::valueChanged, this, &PipelineChain::scrollAll);
    for (const Line &point : m_lines) {
        // Scrolls to a number reached by the arrow keys; the other points scroll along.
        const QScrollBar *own = point.grid->horizontalScrollBar();
        connect(own, &QScrollBar::valueChanged, this, &PipelineChain::scrollAll);
        connect(own, &QScrollBar::rangeChanged, this, [this, own] {
            if (own->maximum() < m_scrollBar->maximum() && own->pageStep() < m_scrollBar->pageStep())
                return; // the widget position has only half the numbers
            m_scrollBar->setRange(0, own->maximum());
            m_scrollBar->setPageStep(own->pageStep());
        });
    }
}

void PipelineChain::scrollAll(int value)
{
    if (m_isScrolling) // a shorter line that reaches its end doesn't stop the others
        return;
    const QScopedValueRollback scrolling(m_isScrolling, true);
    m_scrollBar->setValue(value);
    for (const Line &point : m_lines)
        point.grid->horizontalScrollBar()->setValue(value);
}

void PipelineChain::showView()
{
    const bool isWhole = m_model.view().isWhole;
    for (QLabel *axis : m_axes)
        axis->setVisible(!isWhole);
    for (const Line &point : m_lines)
        point.grid->setLabelsShown(isWhole);
    m_scrollBar->setVisible(isWhole);
}

void PipelineChain::createProducts(int line)
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(0, 2, 0, 0);
    row->setSpacing(2);
    for (std::size_t i = 0; i < kProducts.size(); ++i) {
        m_products[i] = createOpener(kProducts[i]);
        row->addWidget(m_products[i]);
    }
    row->addStretch();
    m_openAll->setText(tr("Open all"));
    m_openAll->setObjectName(QStringLiteral("openAll"));
    m_openAll->setAccessibleName(m_openAll->text());
    m_openAll->setToolTip(tr("Show all matrices one below the other"));
    m_openAll->setCheckable(true);
    m_openAll->setFocusPolicy(Qt::StrongFocus);
    connect(m_openAll, &QToolButton::toggled, this, &PipelineChain::allOpenChanged);
    row->addWidget(m_openAll);
    m_layout->addLayout(row, line, 0, 1, 1 + kCoordinates);
}

void PipelineChain::arrange()
{
    const PipelineDirection direction = m_model.direction();
    const bool isForward = direction == PipelineDirection::Forward;
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        const Line &line = m_lines[static_cast<std::size_t>(isForward ? i : PointModel::kSpaces - 1 - i)];
        const auto *point = static_cast<const PointModel *>(line.grid->model());
        m_layout->addWidget(line.name, 1 + i, 0);
        m_layout->addWidget(line.grid, 1 + i, 1, 1, point->columnCount());
        if (i > 0)
            setTabOrder(m_lines[static_cast<std::size_t>(isForward ? i - 1 : PointModel::kSpaces - i)].grid, line.name);
        setTabOrder(line.name, line.grid);

        const QString name = point->name();
        const std::optional<PipelineStage> stage = stageOf(point->space(), direction);
        line.name->setText(name);
        line.name->setAccessibleName(tr("Step to %1").arg(name));
        line.name->setToolTip(point->space() == startOf(direction) ? tr("The path starts here")
                              : stage ? tr("Show the matrix: %1").arg(stageTitle(*stage, direction))
                                      : tr("Show how %1 follows from the point above").arg(name));
        line.grid->setAccessibleName(tr("Point in %1 coordinates").arg(name));
    }
    for (std::size_t i = 0; i < kProducts.size(); ++i) {
        const bool isWhole = kProducts[i] == PipelineStage::WholeMatrix; // its name alone is not a product
        m_products[i]->setText(isWhole ? stageTitle(kProducts[i], direction) : stageName(kProducts[i], direction));
        m_products[i]->setAccessibleName(tr("Product %1").arg(m_products[i]->text()));
        m_products[i]->setToolTip(tr("Show the matrix: %1").arg(stageTitle(kProducts[i], direction)));
    }
    setTabOrder(m_lines[static_cast<std::size_t>(isForward ? PointModel::kSpaces - 1 : 0)].grid, m_products.front());
    setTabOrder(m_products.front(), m_products.back());
    setTabOrder(m_products.back(), m_openAll);
}

void PipelineChain::setOpened(const ChainPart &part)
{
    const auto show = [](QToolButton *button, bool isOpen) {
        button->setChecked(isOpen);
        button->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        button->setAccessibleDescription(isOpen ? tr("Shown below") : tr("Not shown"));
    };
    for (int i = 0; i < PointModel::kSpaces; ++i)
        show(m_lines[static_cast<std::size_t>(i)].name, areAllOpen() || part == ChainPart(static_cast<Space>(i)));
    for (std::size_t i = 0; i < kProducts.size(); ++i)
        show(m_products[i], areAllOpen() || part == ChainPart(kProducts[i]));
}

bool PipelineChain::areAllOpen() const
{
    return m_openAll->isChecked();
}

void PipelineChain::setAllOpen(bool areOpen)
{
    m_openAll->setChecked(areOpen);
}

void PipelineChain::applyTyped()
{
    for (const Line &line : m_lines)
        line.grid->applyTyped();
}

} // namespace unprojector::gui
