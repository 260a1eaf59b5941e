#include "gui/pipeline/pipeline_switches.h"

#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/text/api_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/segmented_switch.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace matrices;
using namespace scene;

namespace {

// Of the switch of digits, whose first choice is the double as it fits.
constexpr int kWholeChoice = 1;
constexpr int kFloatChoice = 2;

// Before the document's objects in the combo box.
constexpr int kAutomaticItem = 0;
constexpr int kNoneItem = 1;
constexpr int kFirstObjectItem = 2;

} // namespace

PipelineSwitches::PipelineSwitches(SceneDocument &document, PipelineModel &model, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(model)
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

    auto *lines = new QVBoxLayout(this);
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
    connect(copy, &QPushButton::clicked, this, [this] { copyToClipboard(m_model.text()); });
    auto *third = new QHBoxLayout;
    auto *paste = new QPushButton(tr("P&aste…"));
    paste->setToolTip(tr("Take the camera from matrices that another program prints (Ctrl+V here)"));
    paste->setAccessibleName(tr("Paste matrices"));
    connect(paste, &QPushButton::clicked, this, &PipelineSwitches::pasteWanted);
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
        m_model.setDirection(index == 0 ? PipelineDirection::Forward : PipelineDirection::Backward);
        emit directionChanged();
    });
    const auto showView = [this] {
        m_model.setView({m_layoutSwitch->choice() == 0 ? MatrixLayout::Column : MatrixLayout::Row,
                         m_memorySwitch->choice() == 1,
                         m_digitsSwitch->choice() == kFloatChoice ? Digits::Float : Digits::Double,
                         m_digitsSwitch->choice() == kWholeChoice});
        emit viewChanged();
    };
    for (SegmentedSwitch *one : {m_layoutSwitch, m_memorySwitch, m_digitsSwitch})
        connect(one, &SegmentedSwitch::chosen, this, showView);
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
    createActions();
    followConventions();
}

void PipelineSwitches::createActions()
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
    for (const Api api : kApis)
        add(QStringLiteral("conventions_") + QLatin1String(conventionsOf(api).key),
            [this, api] { takeConventions(api); });
}

void PipelineSwitches::setDirection(PipelineDirection direction)
{
    m_directionSwitch->setChoice(direction == PipelineDirection::Forward ? 0 : 1);
}

void PipelineSwitches::setMatrixView(const MatrixView &view)
{
    m_layoutSwitch->setChoice(view.layout == MatrixLayout::Column ? 0 : 1);
    m_memorySwitch->setChoice(view.isMemoryOrder ? 1 : 0);
    m_digitsSwitch->setChoice(view.digits == Digits::Float ? kFloatChoice : view.isWhole ? kWholeChoice : 0);
}

void PipelineSwitches::refresh()
{
    showObjects();
    m_conventions->setToolTip(
        tr("Whose axes, depths and pixels are shown, kept in the scene. %1").arg(apiText(m_model.api())));
    m_apiNote->setText(m_model.apiNote());
    m_apiNote->setVisible(!m_model.apiNote().isEmpty());
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

void PipelineSwitches::takeConventions(Api api)
{
    m_model.setApi(api);
    takeTheirLayout();
}

void PipelineSwitches::followConventions()
{
    const int item = static_cast<int>(m_document.scene().conventions);
    if (m_conventions->currentIndex() == item)
        return;
    m_conventions->setCurrentIndex(item);
    takeTheirLayout();
}

void PipelineSwitches::takeTheirLayout()
{
    m_layoutSwitch->setChoice(conventionsOf(m_document.scene().conventions).areVectorsRows ? 1 : 0);
}

} // namespace unprojector::gui
