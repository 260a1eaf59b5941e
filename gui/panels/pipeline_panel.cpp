#include "gui/panels/pipeline_panel.h"

#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/panels/copy_menu.h"
#include "gui/panels/entry_derivation.h"
#include "gui/panels/factors_view.h"
#include "gui/panels/help_link.h"
#include "gui/panels/matrix_findings_view.h"
#include "gui/panels/matrix_section.h"
#include "gui/panels/number_grid.h"
#include "gui/panels/paste_matrices_dialog.h"
#include "gui/panels/segmented_switch.h"
#include "gui/panels/steady_label.h"
#include "gui/text/api_text.h"
#include "gui/text/help_anchors.h"
#include "gui/text/number_text.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFrame>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

using Space = PointModel::Space;

/// Of the switch of digits, whose first one is the double as it fits.
constexpr int kWholeChoice = 1;
constexpr int kFloatChoice = 2;

/// Before the document's objects in the combo box.
constexpr int kAutomaticItem = 0;
constexpr int kNoneItem = 1;
constexpr int kFirstObjectItem = 2;

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

void PipelinePanel::takeOver(const PipelinePanel &other)
{
    setDirection(other.direction());
    setMatrixView(other.matrixView());
    m_model->takeOver(*other.m_model);
    m_chosen = other.m_chosen;
    showStatus();
}

void PipelinePanel::applyTyped()
{
    for (NumberGrid *grid : m_pointGrids)
        grid->applyTyped();
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

void PipelinePanel::showFollowed()
{
    const bool isGiven = m_model->followsGiven();
    m_follow->setText(isGiven ? tr("The click") : tr("Your point"));
    m_follow->setToolTip(isGiven ? tr("Follow the clicked point again; yours stays")
                                 : tr("Follow the point that you have given in numbers"));
    m_follow->setVisible(m_document.givenPoint() && (!isGiven || m_document.pick()));
    m_remove->setVisible(m_document.givenPoint().has_value());
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
    show(PipelineStage::ViewMatrix, m_viewFactors, m_document.givenView() != nullptr, nullptr);
    show(PipelineStage::ProjectionMatrix, m_projectionFactors, m_document.givenProjection() != nullptr, &projection);
}

void PipelinePanel::takeApart(PipelineStage stage)
{
    setDirection(PipelineDirection::Forward);
    MatrixSection &section = *m_sections[static_cast<std::size_t>(stage)];
    section.takeApart();
    scrollTo(section, stage == PipelineStage::ProjectionMatrix ? &m_projectionFactors->shares() : nullptr);
}

void PipelinePanel::openMatrix(PipelineStage stage)
{
    MatrixSection &section = *m_sections[static_cast<std::size_t>(stage)];
    section.setOpen(true);
    scrollTo(section, nullptr);
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

void PipelinePanel::takeConventions(Api api)
{
    m_model->setApi(api);
    takeTheirLayout();
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

void PipelinePanel::refresh()
{
    if (!isVisible())
        return;
    m_model->update();
    showStatus();
    showObjects();
    showConventions();
}

void PipelinePanel::takeTheirLayout()
{
    m_layoutSwitch->setChoice(conventionsOf(m_document.scene().conventions).areVectorsRows ? 1 : 0);
}

void PipelinePanel::followConventions()
{
    const int item = static_cast<int>(m_document.scene().conventions);
    if (m_conventions->currentIndex() == item)
        return;
    m_conventions->setCurrentIndex(item);
    takeTheirLayout();
}

void PipelinePanel::showConventions()
{
    m_conventions->setToolTip(
        tr("Whose axes, depths and pixels are shown, kept in the scene. %1").arg(apiText(m_model->api())));
    m_apiNote->setText(m_model->apiNote());
    m_apiNote->setVisible(!m_model->apiNote().isEmpty());
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
    m_givenView->setVisible(m_document.givenView() != nullptr);
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

void PipelinePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

} // namespace unprojector::gui
