#include "gui/pipeline/pipeline_switches.h"

#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/text/api_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/segmented_switch.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;
using namespace scene;

namespace {

// The index among the digits' choices; the first is a double that fits.
constexpr int kWholeChoice = 1;
constexpr int kFloatChoice = 2;

// The item before the document's objects in the combo box.
constexpr int kAutomaticItem = 0;
constexpr int kNoneItem = 1;
constexpr int kFirstObjectItem = 2;

enum When { AtClick, Now };

} // namespace

PipelineSwitches::PipelineSwitches(SceneDocument &document, PipelineModel &model, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(model)
{
    m_directionSwitch = new SegmentedSwitch(
        tr("Direction"), {{tr("Forward"), tr("From the object to the widget")},
                          {tr("Backward"), tr("From the window to the object, by the inverse of each matrix")}});
    m_when = new SegmentedSwitch(tr("Values"), {{tr("At click"), tr("Points and matrices as they were at the click")},
                                                {tr("Now"), tr("The clicked point in the view as it is now")}});
    m_when->setObjectName(QStringLiteral("values"));
    QSizePolicy policy = m_when->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // nothing moves when it comes
    m_when->setSizePolicy(policy);
    createFormatMenu();

    m_object = new QComboBox;
    m_object->setAccessibleName(tr("Object"));
    m_object->setToolTip(tr("The object whose space comes first in the chain"));
    m_object->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_object->setMinimumContentsLength(8);
    auto *objectLabel = new QLabel(tr("&Object:"));
    objectLabel->setBuddy(m_object);
    auto *copy = new QPushButton(tr("&Copy all"));
    copy->setToolTip(tr("Copy all points and matrices with all digits"));
    connect(copy, &QPushButton::clicked, this, [this] { copyToClipboard(m_model.text()); });
    auto *paste = new QPushButton(tr("P&aste…"));
    paste->setToolTip(tr("Set the camera from another program's (Ctrl+V)"));
    paste->setAccessibleName(tr("Paste camera"));
    connect(paste, &QPushButton::clicked, this, &PipelineSwitches::pasteWanted);

    auto *lines = new QVBoxLayout(this);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(4);
    auto *first = new QHBoxLayout;
    first->addWidget(m_directionSwitch);
    first->addStretch();
    first->addWidget(m_when);
    first->addWidget(m_format);
    first->addWidget(new HelpLink(QStringLiteral("conventions")));
    auto *second = new QHBoxLayout;
    second->addWidget(objectLabel);
    second->addWidget(m_object, 1);
    second->addWidget(paste);
    second->addWidget(copy);
    lines->addLayout(first);
    lines->addLayout(second);

    connect(m_directionSwitch, &SegmentedSwitch::chosen, this, [this](int index) {
        m_model.setDirection(index == 0 ? PipelineDirection::Forward : PipelineDirection::Backward);
        emit directionChanged();
    });
    connect(m_when, &SegmentedSwitch::chosen, this, [this](int index) { m_model.setShowsClick(index == AtClick); });
    connect(m_object, &QComboBox::activated, this, [this](int item) {
        m_model.setObject(item == kAutomaticItem ? PipelineModel::kAutomaticObject
                          : item == kNoneItem    ? PipelineModel::kNoObject
                                                 : item - kFirstObjectItem);
        emit objectChanged();
        showObjects();
    });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Conventions)
            followConventions();
    });
    createDirectionActions();
    followConventions();
    showFormat();
    showWhen();
}

void PipelineSwitches::createFormatMenu()
{
    m_format = new QToolButton;
    m_format->setObjectName(QStringLiteral("format"));
    m_format->setPopupMode(QToolButton::InstantPopup);
    m_format->setFocusPolicy(Qt::StrongFocus);
    auto *menu = new QMenu(m_format);
    menu->setToolTipsVisible(true);
    m_format->setMenu(menu);
    m_layouts =
        addGroup(*menu, tr("Vectors"),
                 {{QStringLiteral("columns"), tr("Columns"), tr("Column vectors, M · v, as OpenGL writes them")},
                  {QStringLiteral("rows"), tr("Rows"),
                   tr("Row vectors, v · M: every matrix transposed, products in reversed order")}});
    m_arrangements = addGroup(
        *menu, tr("Arrangement"),
        {{QStringLiteral("square"), tr("4 × 4"), tr("Rows and columns, as matrices are printed")},
         {QStringLiteral("memory_order"), QStringLiteral("m[0..15]"),
          tr("The memory order that glGetFloatv gives and a debugger shows, the same for column and row vectors")}});
    m_digits = addGroup(
        *menu, tr("Digits"),
        {{QStringLiteral("double_digits"), QStringLiteral("double"),
          tr("Nine digits of the double; all of them in the tooltip and when copied")},
         {QStringLiteral("all_digits"), tr("All digits"), tr("All digits of the double, up to 17; needs more space")},
         {QStringLiteral("float_digits"), QStringLiteral("float"),
          tr("Rounded to single precision, with all its digits")}});
    menu->addSeparator();
    m_conventionsMenu = menu->addMenu(tr("Conventions"));
    m_conventionsMenu->setToolTipsVisible(true);
    QList<Choice> apis;
    for (const Api api : kApis)
        apis.push_back({QStringLiteral("conventions_") + QLatin1String(conventionsOf(api).key),
                        QString::fromUtf8(conventionsOf(api).name), apiText(api)});
    m_conventions = addGroup(*m_conventionsMenu, {}, apis);
    for (QActionGroup *group : {m_layouts, m_arrangements, m_digits})
        connect(group, &QActionGroup::triggered, this, &PipelineSwitches::takeView);
    for (const Api api : kApis)
        connect(m_conventions->actions()[static_cast<qsizetype>(api)], &QAction::triggered, this,
                [this, api] { takeConventions(api); });
}

QActionGroup *PipelineSwitches::addGroup(QMenu &menu, const QString &title, const QList<Choice> &choices)
{
    auto *group = new QActionGroup(this);
    if (!title.isEmpty()) {
        // Not addSection: some styles draw no text for it.
        if (!menu.isEmpty())
            menu.addSeparator();
        menu.addAction(title)->setEnabled(false);
    }
    for (const Choice &choice : choices) {
        QAction *action = menu.addAction(choice.text);
        action->setObjectName(choice.action);
        action->setToolTip(choice.toolTip);
        action->setCheckable(true);
        action->setActionGroup(group);
    }
    group->actions().constFirst()->setChecked(true);
    return group;
}

void PipelineSwitches::createDirectionActions()
{
    for (const auto &[name, index] : {std::pair("forward", 0), std::pair("backward", 1)}) {
        auto *action = new QAction(this);
        action->setObjectName(QLatin1String(name));
        const int choice = index;
        connect(action, &QAction::triggered, this, [this, choice] { m_directionSwitch->setChoice(choice); });
    }
}

void PipelineSwitches::takeView()
{
    const auto chosen = [](const QActionGroup *group) { return group->actions().indexOf(group->checkedAction()); };
    const qsizetype digits = chosen(m_digits);
    m_model.setView({chosen(m_layouts) == 0 ? MatrixLayout::Column : MatrixLayout::Row, chosen(m_arrangements) == 1,
                     digits == kFloatChoice ? Digits::Float : Digits::Double, digits == kWholeChoice});
    showFormat();
    emit viewChanged();
}

void PipelineSwitches::setDirection(PipelineDirection direction)
{
    m_directionSwitch->setChoice(direction == PipelineDirection::Forward ? 0 : 1);
}

void PipelineSwitches::setMatrixView(const MatrixView &view)
{
    m_layouts->actions()[view.layout == MatrixLayout::Column ? 0 : 1]->setChecked(true);
    m_arrangements->actions()[view.isMemoryOrder ? 1 : 0]->setChecked(true);
    m_digits->actions()[view.digits == Digits::Float ? kFloatChoice
                        : view.isWhole               ? kWholeChoice
                                                     : 0]
        ->setChecked(true);
    takeView();
}

void PipelineSwitches::refresh()
{
    showObjects();
    showFormat();
    showWhen();
}

void PipelineSwitches::showWhen()
{
    const QSignalBlocker blocker(m_when);
    m_when->setChoice(m_model.showsClick() ? AtClick : Now);
    m_when->setVisible(m_model.canShowClick());
}

void PipelineSwitches::showFormat()
{
    const Api api = m_document.scene().conventions;
    const QString name = QString::fromUtf8(conventionsOf(api).name);
    m_format->setText(api == Api::OpenGl ? tr("Format") : tr("Format (%1)").arg(name));
    QStringList chosen;
    for (const QActionGroup *group : {m_layouts, m_arrangements, m_digits})
        chosen << group->checkedAction()->text();
    chosen << name;
    m_format->setToolTip(
        tr("Format of vectors, matrices and digits, and the conventions. Now: %1").arg(chosen.join(tr(", "))));
    m_format->setAccessibleName(m_format->text());
    m_format->setAccessibleDescription(m_format->toolTip());
}

void PipelineSwitches::showObjects()
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
    const std::optional<std::size_t> shown = m_model.shownObject();
    const bool isAutomatic = m_model.object() == PipelineModel::kAutomaticObject;
    const QString automatic = isAutomatic && shown
                                  ? tr("Clicked object (%1)").arg(shownObjectName(objects[*shown].name, objects))
                              : isAutomatic ? tr("None (identity)")
                                            : tr("Clicked object");
    if (m_object->itemText(kAutomaticItem) != automatic)
        m_object->setItemText(kAutomaticItem, automatic);
    const int item = isAutomatic || !shown ? (isAutomatic ? kAutomaticItem : kNoneItem)
                                           : kFirstObjectItem + static_cast<int>(*shown);
    if (m_object->currentIndex() != item)
        m_object->setCurrentIndex(item);
}

void PipelineSwitches::takeConventions(Api api)
{
    m_model.setApi(api);
    takeTheirLayout();
}

void PipelineSwitches::followConventions()
{
    QAction *action = m_conventions->actions()[static_cast<qsizetype>(m_document.scene().conventions)];
    if (action->isChecked())
        return;
    action->setChecked(true);
    takeTheirLayout();
}

void PipelineSwitches::takeTheirLayout()
{
    MatrixView view = m_model.view();
    view.layout =
        conventionsOf(m_document.scene().conventions).areVectorsRows ? MatrixLayout::Row : MatrixLayout::Column;
    setMatrixView(view);
}

} // namespace unprojector::gui
