#include "gui/pipeline/pipeline_panel.h"

#include "gui/document/scene_document.h"
#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/matrix_findings_view.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/pipeline/paste_matrices_dialog.h"
#include "gui/text/api_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/segmented_switch.h"
#include "gui/widgets/steady_label.h"

#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

// What it shows is in pipeline_panel_shown.cpp, what is done in it in pipeline_panel_actions.cpp.

namespace unprojector::gui {
namespace {

using Space = PointModel::Space;

/// Of the switch of digits, whose first one is the double as it fits.
constexpr int kWholeChoice = 1;
constexpr int kFloatChoice = 2;

} // namespace

PipelinePanel::PipelinePanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(new PipelineModel(document, this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(createSwitches());

    m_status = new SteadyLabel(PipelineModel::longestStatusTexts());
    m_status->setAccessibleName(tr("What the points are"));
    layout->addLayout(createFollowed());

    createStages();
    layout->addWidget(m_scrollArea, 1);
    auto *edge = new QFrame;
    edge->setFrameShape(QFrame::HLine);
    edge->setFrameShadow(QFrame::Sunken);
    layout->addWidget(edge);
    m_derivation = new SteadyLabel(longestDerivations(false));
    m_derivation->setObjectName(QStringLiteral("derivation"));
    m_derivation->setAccessibleName(tr("How the chosen number comes about"));
    m_derivationHelp = new HelpLink({});
    auto *derivation = new QHBoxLayout;
    derivation->setSpacing(2);
    derivation->addWidget(m_derivation, 1, Qt::AlignTop);
    derivation->addWidget(m_derivationHelp, 0, Qt::AlignTop);
    layout->addLayout(derivation);

    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Conventions)
            followConventions();
        if (changes & (kSeen | Change::Names | Change::Pick | Change::GivenPoint | Change::Conventions))
            refresh();
    });
    showFollowed();
    connect(m_model, &PipelineModel::followedChanged, this, &PipelinePanel::refresh);
    connect(m_model, &PipelineModel::refused, this, [this](const QString &reason) {
        m_status->setText(reason);
        m_status->setToolTip(reason);
    });
    arrange();
    createActions();
    followConventions();
}

PipelinePanel::~PipelinePanel()
{
    // A row that goes while somebody types into it would commit that.
    for (int i = 0; i < PointModel::kSpaces; ++i)
        m_model->point(static_cast<Space>(i))->disconnect(m_model);
}

QLayout *PipelinePanel::createFollowed()
{
    m_follow = new QToolButton;
    m_follow->setAutoRaise(true);
    m_remove = new QToolButton;
    m_remove->setAutoRaise(true);
    m_remove->setText(QStringLiteral("✕"));
    m_remove->setToolTip(tr("Remove your point"));
    m_remove->setAccessibleName(m_remove->toolTip());
    m_follow->setAccessibleName(tr("Which point to follow"));
    connect(m_follow, &QToolButton::clicked, this, [this] { m_model->followGiven(!m_model->followsGiven()); });
    connect(m_remove, &QToolButton::clicked, m_model, &PipelineModel::removeGiven);
    // The rows below stay where they are when these come.
    for (QToolButton *button : {m_follow, m_remove}) {
        QSizePolicy policy = button->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        button->setSizePolicy(policy);
    }
    auto *line = new QHBoxLayout;
    line->setSpacing(2);
    line->addWidget(m_status, 1);
    line->addWidget(m_follow, 0, Qt::AlignTop);
    line->addWidget(m_remove, 0, Qt::AlignTop);
    return line;
}

QWidget *PipelinePanel::createSwitches()
{
    m_directionSwitch = new SegmentedSwitch(
        tr("Direction"), {{tr("Forward"), tr("From the object to the widget")},
                          {tr("Backward"), tr("From the window to the object, by the inverse of each matrix")}});
    m_layoutSwitch = new SegmentedSwitch(
        tr("Vectors"), {{tr("Columns"), tr("Column vectors, M · v, as OpenGL writes them")},
                        {tr("Rows"), tr("Row vectors, v · M: every matrix transposed, products in reversed order")}});
    m_memorySwitch = new SegmentedSwitch(
        tr("Arrangement"),
        {{tr("4 × 4"), tr("Rows and columns, as matrices are printed")},
         {QStringLiteral("m[0..15]"),
          tr("The memory order that glGetFloatv gives and a debugger shows, the same for column and row vectors")}});
    m_digitsSwitch = new SegmentedSwitch(
        tr("Digits"),
        {{QStringLiteral("double"), tr("Nine digits of the double; all of them in the tooltip and when copied")},
         {tr("All digits"), tr("The double with all its digits, up to 17; they need room")},
         {QStringLiteral("float"), tr("Rounded to single precision, with all the digits that it has")}});

    m_object = new QComboBox;
    m_object->setAccessibleName(tr("Object"));
    m_object->setToolTip(tr("Whose object space: by itself that of the object that was drawn at the picked pixel"));
    m_object->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_object->setMinimumContentsLength(8);
    auto *objectLabel = new QLabel(tr("&Object:"));
    objectLabel->setBuddy(m_object);

    m_conventions = new QComboBox;
    m_conventions->setObjectName(QStringLiteral("conventions"));
    m_conventions->setAccessibleName(tr("Conventions"));
    for (const Api api : kApis) {
        m_conventions->addItem(QString::fromUtf8(conventionsOf(api).name));
        m_conventions->setItemData(static_cast<int>(api), apiText(api), Qt::ToolTipRole);
    }
    auto *conventionsLabel = new QLabel(tr("Conve&ntions:"));
    conventionsLabel->setBuddy(m_conventions);
    m_apiNote = new QLabel;
    m_apiNote->setWordWrap(true);
    m_apiNote->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_apiNote->setAccessibleName(tr("What is otherwise than in OpenGL"));
    m_apiNote->hide();
    connect(m_conventions, &QComboBox::activated, this,
            [this](int item) { takeConventions(kApis[static_cast<std::size_t>(item)]); });

    auto *switches = new QWidget;
    auto *lines = new QVBoxLayout(switches);
    lines->setContentsMargins(0, 0, 0, 0);
    auto *first = new QHBoxLayout;
    first->addWidget(m_directionSwitch);
    first->addSpacing(6);
    first->addWidget(objectLabel);
    first->addWidget(m_object, 1);
    auto *second = new QHBoxLayout;
    second->addWidget(m_layoutSwitch);
    second->addWidget(m_memorySwitch);
    second->addStretch();
    auto *copy = new QPushButton(tr("&Copy all"));
    copy->setToolTip(tr("Copy all points and matrices with all digits"));
    connect(copy, &QPushButton::clicked, this, [this] { copyToClipboard(m_model->text()); });
    auto *third = new QHBoxLayout;
    auto *paste = new QPushButton(tr("P&aste…"));
    paste->setToolTip(tr("Take the camera from matrices that another program prints (Ctrl+V here)"));
    paste->setAccessibleName(tr("Paste matrices"));
    connect(paste, &QPushButton::clicked, this, [this] {
        emit aboutToPaste();
        PasteMatricesDialog::open(m_document, window());
    });
    third->addWidget(m_digitsSwitch);
    third->addStretch();
    third->addWidget(paste);
    third->addWidget(copy);
    auto *fourth = new QHBoxLayout;
    fourth->addWidget(conventionsLabel);
    fourth->addWidget(m_conventions);
    fourth->addStretch();
    fourth->addWidget(new HelpLink(QStringLiteral("conventions")));
    for (QHBoxLayout *line : {fourth, first, second, third})
        lines->addLayout(line);
    lines->addWidget(m_apiNote);

    connect(m_directionSwitch, &SegmentedSwitch::chosen, this, [this](int index) {
        m_model->setDirection(index == 0 ? PipelineDirection::Forward : PipelineDirection::Backward);
        arrange();
        showStatus();
    });
    const auto showView = [this] {
        m_model->setView({m_layoutSwitch->choice() == 0 ? MatrixLayout::Column : MatrixLayout::Row,
                          m_memorySwitch->choice() == 1,
                          m_digitsSwitch->choice() == kFloatChoice ? Digits::Float : Digits::Double,
                          m_digitsSwitch->choice() == kWholeChoice});
        showTitles();
    };
    for (SegmentedSwitch *one : {m_layoutSwitch, m_memorySwitch, m_digitsSwitch})
        connect(one, &SegmentedSwitch::chosen, this, showView);
    connect(m_object, &QComboBox::activated, this, [this](int item) {
        m_model->setObject(item == kAutomaticItem ? PipelineModel::kAutomaticObject
                           : item == kNoneItem    ? PipelineModel::kNoObject
                                                  : item - kFirstObjectItem);
        showStatus();
        showObjects();
    });
    return switches;
}

void PipelinePanel::createStages()
{
    auto *content = new QWidget;
    m_rows = new QVBoxLayout(content);
    m_rows->setContentsMargins(0, 0, 4, 0);
    m_rows->setSpacing(4);

    QFont bold = font();
    bold.setBold(true);
    int nameWidth = 0;
    for (const PipelineDirection direction : {PipelineDirection::Backward, PipelineDirection::Forward}) {
        m_model->setDirection(direction);
        for (int i = 0; i < PointModel::kSpaces; ++i)
            nameWidth = std::max(nameWidth,
                                 QFontMetrics(bold).horizontalAdvance(m_model->point(static_cast<Space>(i))->name()));
    }
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        PointModel *point = m_model->point(static_cast<Space>(i));
        auto *row = new QWidget;
        auto *name = new QLabel(point->name());
        name->setFont(bold);
        name->setFixedWidth(nameWidth + 8);
        auto *grid = new NumberGrid(point);
        grid->setAccessibleName(tr("Point in %1 coordinates").arg(point->name()));
        name->setBuddy(grid);
        auto *line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(0);
        line->addWidget(name);
        line->addWidget(grid, 1);
        line->addStretch();
        connect(grid, &NumberGrid::entered, this, [this, point](const QModelIndex &index) {
            m_chosen = {point->space(), std::max(index.row(), index.column())};
            showDerivation();
        });
        m_pointGrids[static_cast<std::size_t>(i)] = grid;
        m_pointNames[static_cast<std::size_t>(i)] = name;
        m_pointRows[static_cast<std::size_t>(i)] = row;
    }
    for (const PipelineStage stage : kPipelineStages) {
        auto *section = new MatrixSection(m_model->matrix(stage));
        m_sections[static_cast<std::size_t>(stage)] = section;
        section->setOpen(stage != PipelineStage::ModelviewMatrix && stage != PipelineStage::WholeMatrix);
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
    m_division = new QLabel;
    m_flip = new QLabel;
    const auto stepRow = [](QLabel *step, const char *anchor) {
        step->setIndent(6);
        auto *row = new QWidget;
        auto *line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        line->addWidget(step, 1);
        line->addWidget(new HelpLink(QString::fromLatin1(anchor)));
        return row;
    };
    m_divisionRow = stepRow(m_division, "viewport");
    m_flipRow = stepRow(m_flip, "half-pixel");

    m_scrollArea = new QScrollArea;
    m_scrollArea->setWidgetResizable(true);
    m_scrollArea->setFrameShape(QFrame::NoFrame);
    m_scrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scrollArea->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    m_scrollArea->setWidget(content);
    m_scrollArea->setSizePolicy(QSizePolicy::Expanding,
                                QSizePolicy::Ignored); // it takes what is left, and asks for nothing
}

void PipelinePanel::arrange()
{
    const auto point = [this](Space space) { return m_pointRows[static_cast<std::size_t>(space)]; };
    const auto section = [this](PipelineStage stage) -> QWidget * {
        return m_sections[static_cast<std::size_t>(stage)];
    };
    const bool isForward = m_model->direction() == PipelineDirection::Forward;
    QList<QWidget *> rows{point(Space::Object), section(PipelineStage::ModelMatrix), point(Space::World)};
    if (isForward)
        rows << m_givenView << m_givenViewFindings << section(PipelineStage::ViewMatrix);
    else
        rows << section(PipelineStage::ViewMatrix) << m_givenViewFindings << m_givenView;
    rows << point(Space::Eye);
    // The division comes after the projection on the way there, and after its inverse on the way back.
    if (isForward)
        rows << m_given << m_givenFindings << section(PipelineStage::ProjectionMatrix) << point(Space::Clip)
             << m_divisionRow;
    else
        rows << m_divisionRow << point(Space::Clip) << section(PipelineStage::ProjectionMatrix) << m_givenFindings
             << m_given;
    rows << point(Space::Ndc) << section(PipelineStage::ViewportMatrix) << point(Space::Window) << m_flipRow
         << point(Space::Widget);
    if (!isForward)
        std::reverse(rows.begin(), rows.end());
    rows << section(PipelineStage::ModelviewMatrix) << section(PipelineStage::WholeMatrix);

    while (QLayoutItem *item = m_rows->takeAt(0))
        delete item;
    for (QWidget *row : std::as_const(rows))
        m_rows->addWidget(row);
    m_rows->addStretch();
    // The Tab key follows the eye.
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
    for (int i = 0; i < PointModel::kSpaces; ++i)
        m_pointNames[static_cast<std::size_t>(i)]->setText(m_model->point(static_cast<Space>(i))->name());
    showFlip();
    showTitles();
}

void PipelinePanel::setDirection(PipelineDirection direction)
{
    m_directionSwitch->setChoice(direction == PipelineDirection::Forward ? 0 : 1);
}

void PipelinePanel::setMatrixView(const MatrixView &view)
{
    m_layoutSwitch->setChoice(view.layout == MatrixLayout::Column ? 0 : 1);
    m_memorySwitch->setChoice(view.isMemoryOrder ? 1 : 0);
    m_digitsSwitch->setChoice(view.digits == Digits::Float ? kFloatChoice : view.isWhole ? kWholeChoice : 0);
}

QSize PipelinePanel::sizeHint() const
{
    return {51 * fontMetrics().horizontalAdvance(u'0'), 36 * fontMetrics().lineSpacing()};
}

} // namespace unprojector::gui
