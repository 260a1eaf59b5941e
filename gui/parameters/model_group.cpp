#include "gui/parameters/model_group.h"

#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/parameters/group_heading.h"
#include "gui/text/bundled_names.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/wheel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

constexpr int kCallDigits = 5;

/// The numbers of a step in the order of its call.
double *numberIn(TransformStep &step, int i)
{
    if (auto *translate = std::get_if<Translate>(&step))
        return &translate->offset[i];
    if (auto *scale = std::get_if<Scale>(&step))
        return &scale->factors[i];
    auto &rotate = std::get<Rotate>(step);
    return i == 0 ? &rotate.degrees : &rotate.axis[i - 1];
}

int numbersOf(const TransformStep &step)
{
    return std::holds_alternative<Rotate>(step) ? 4 : 3;
}

QToolButton *smallButton(const QString &text, const QString &name, const QString &tip)
{
    auto *button = new QToolButton;
    button->setText(text);
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(tip);
    return button;
}

/// The OpenGL call of a step: "glRotated(30, 0, 1, 0)", its numbers with at most five digits.
QString callText(const TransformStep &step)
{
    TransformStep copy = step;
    QStringList numbers;
    for (int i = 0; i < numbersOf(step); ++i)
        numbers << writtenText(*numberIn(copy, i), kCallDigits);
    const QString name = std::holds_alternative<Translate>(step) ? QStringLiteral("glTranslated")
                         : std::holds_alternative<Rotate>(step)  ? QStringLiteral("glRotated")
                                                                 : QStringLiteral("glScaled");
    return QStringLiteral("%1(%2)").arg(name, numbers.join(QStringLiteral(", ")));
}

} // namespace

ModelGroup::ModelGroup(SceneDocument &document, QWidget *parent)
    : ParameterGroup(document, Change::Objects | Change::Names | Change::Placement,
                     {tr("Model"), tr("Position of each object (glTranslate, glRotate, glScale)"),
                      tr("No steps: the shown object has the coordinates of its file")},
                     parent),
      m_shown(new FollowedObject(document, this))
{
    heading().setHelp(QStringLiteral("model"));
    m_object = new QComboBox;
    m_object->setObjectName(QStringLiteral("object"));
    m_object->setAccessibleName(tr("Object"));
    m_object->setToolTip(tr("Object that these steps move"));
    m_object->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_object->setMinimumContentsLength(12);
    ignoreWheelWithoutFocus(m_object);
    m_removeObject = smallButton(QStringLiteral("✕"), tr("Remove object"), tr("Remove this object from the scene"));
    m_removeObject->setObjectName(QStringLiteral("removeObject"));
    onClick(m_removeObject, [this](bool) { removeObject(); });
    auto *top = new QHBoxLayout;
    top->setSpacing(0);
    top->addWidget(m_object, 1);
    top->addWidget(m_removeObject);
    content()->addLayout(top);

    auto *adds = new QHBoxLayout;
    adds->setSpacing(content()->spacing());
    const auto add = [&](const QString &label, const QString &text, const QString &tip, const QString &objectName,
                         const TransformStep &step) {
        auto *button = new QPushButton(label);
        button->setObjectName(objectName);
        button->setAccessibleName(text);
        button->setToolTip(tip);
        onClick(button, [this, step, text](bool byKeyboard) { addStep(step, text, byKeyboard); });
        adds->addWidget(button, 1);
        m_adds.push_back(button);
    };
    add(tr("+ Translate"), tr("Add translate"), tr("Add a glTranslate after the last step"),
        QStringLiteral("addTranslate"), Translate{});
    add(tr("+ Rotate"), tr("Add rotate"), tr("Add a glRotate after the last step"), QStringLiteral("addRotate"),
        Rotate{0.0, {0.0, 1.0, 0.0}});
    add(tr("+ Scale"), tr("Add scale"), tr("Add a glScale after the last step"), QStringLiteral("addScale"), Scale{});
    content()->addLayout(adds);

    m_hint = wrappedLabel();
    content()->addWidget(m_hint);

    m_list = new QVBoxLayout;
    m_list->setSpacing(2 * content()->spacing());
    content()->addLayout(m_list);

    connect(m_object, &QComboBox::activated, this, [this](int index) {
        restoreFields();
        m_shown->choose(static_cast<std::size_t>(index));
        refresh();
    });
}

const std::vector<TransformStep> &ModelGroup::steps() const
{
    static const std::vector<TransformStep> none;
    const std::vector<SceneObject> &objects = document().objects();
    const std::optional<std::size_t> shown = m_shown->index();
    return shown ? objects[*shown].transform : none;
}

bool ModelGroup::changeSteps(const QString &text, const std::function<void(std::vector<TransformStep> &)> &edit)
{
    return change(text, [&](Scene &scene) { edit(scene.objects[m_shown->index().value()].transform); });
}

void ModelGroup::addStep(const TransformStep &step, const QString &text, bool byKeyboard)
{
    if (m_shown->index() && changeSteps(text, [&](auto &list) { list.push_back(step); }) && !m_rows.empty())
        bringUp(m_rows.back().first, byKeyboard);
}

void ModelGroup::moveStep(std::size_t from, std::size_t to, bool byKeyboard)
{
    restoreFields();
    const bool isUp = to < from;
    if (changeSteps(tr("Reorder steps"), [&](auto &list) { std::swap(list[from], list[to]); }) && byKeyboard
        && to < m_rows.size()) {
        // The focus follows the step, at the end of the list to the other button.
        QToolButton *same = isUp ? m_rows[to].up : m_rows[to].down;
        (same->isEnabled() ? same : isUp ? m_rows[to].down : m_rows[to].up)->setFocus();
    }
}

void ModelGroup::removeStep(std::size_t step, bool byKeyboard)
{
    restoreFields();
    const auto erase = [&](auto &list) { list.erase(list.begin() + static_cast<std::ptrdiff_t>(step)); };
    if (!changeSteps(tr("Remove step"), erase) || !byKeyboard)
        return;
    if (m_rows.empty())
        m_adds.front()->setFocus();
    else
        m_rows[std::min(step, m_rows.size() - 1)].remove->setFocus();
}

void ModelGroup::removeObject()
{
    const std::optional<std::size_t> shown = m_shown->index();
    if (!shown)
        return;
    restoreFields();
    static_cast<void>(gui::removeObject(document(), *shown)); // fewer objects always give a valid setup
}

void ModelGroup::showObjects()
{
    const std::vector<SceneObject> &objects = document().objects();
    if (!m_shown->index()) {
        // Pending text for the removed step must not apply to the one that replaces it.
        m_rowsOf.reset();
        if (!objects.empty())
            m_shown->choose(std::min(m_shown->lastIndex(), objects.size() - 1));
    }
    const int shown = objects.empty() ? -1 : static_cast<int>(*m_shown->index());
    QStringList names;
    for (const SceneObject &object : objects)
        names << readName(object.name, objects);
    if (names != m_names) {
        m_names = names;
        m_object->clear();
        for (const QString &name : names) {
            m_object->addItem(name);
            m_object->setItemData(m_object->count() - 1, plainToolTip(name), Qt::ToolTipRole); // it may be cut off
        }
    }
    m_object->setCurrentIndex(shown);
    m_object->setEnabled(shown >= 0);
    m_removeObject->setEnabled(shown >= 0);
    for (QPushButton *button : m_adds)
        button->setEnabled(shown >= 0);
}

void ModelGroup::setDefaults(Scene &scene) const
{
    if (const std::optional<std::size_t> shown = m_shown->index())
        scene.objects[*shown].transform.clear();
}

void ModelGroup::showScene()
{
    showObjects();
    std::vector<std::size_t> kinds;
    for (const TransformStep &step : steps())
        kinds.push_back(step.index());
    if (kinds != m_shownKinds || m_rowsOf != m_shown->index()) {
        m_shownKinds = std::move(kinds);
        m_rowsOf = m_shown->index();
        rebuildRows();
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        // allows a line break there
        m_rows[i].call->setText(callText(steps()[i]).replace(u'(', QStringLiteral("(\u200b")));
}

void ModelGroup::rebuildRows()
{
    for (const Row &row : m_rows) {
        m_list->removeWidget(row.widget);
        removeFieldsIn(row.widget);
    }
    m_rows.clear();
    for (std::size_t i = 0; i < steps().size(); ++i) {
        m_rows.push_back(makeRow(i));
        m_list->addWidget(m_rows.back().widget);
        m_rows.back().widget->show();
    }
    m_hint->setText(document().objects().empty() ? tr("The scene has no objects.")
                    : m_rows.empty()             ? tr("No steps: the object has the coordinates of its file.")
                                     : tr("In the order of the calls: the last step is applied to the object first."));
    emit rowsChanged();
}

ModelGroup::Row ModelGroup::makeRow(std::size_t step)
{
    const TransformStep &shown = steps()[step];
    const int number = static_cast<int>(step) + 1;
    Row row{};
    row.widget = new QWidget;
    row.widget->setObjectName(QStringLiteral("step%1").arg(number));
    row.call = wrappedLabel();
    row.call->setAccessibleName(tr("Call of step %1").arg(number));
    row.up = smallButton(QStringLiteral("↑"), tr("Move step %1 up").arg(number), tr("Call this step earlier"));
    row.down = smallButton(QStringLiteral("↓"), tr("Move step %1 down").arg(number), tr("Call this step later"));
    row.remove = smallButton(QStringLiteral("✕"), tr("Remove step %1").arg(number), tr("Remove this step"));
    row.up->setObjectName(QStringLiteral("up"));
    row.down->setObjectName(QStringLiteral("down"));
    row.remove->setObjectName(QStringLiteral("remove"));
    row.up->setEnabled(step > 0);
    row.down->setEnabled(step + 1 < steps().size());
    onClick(row.up, [this, step](bool byKeyboard) { moveStep(step, step - 1, byKeyboard); });
    onClick(row.down, [this, step](bool byKeyboard) { moveStep(step, step + 1, byKeyboard); });
    onClick(row.remove, [this, step](bool byKeyboard) { removeStep(step, byKeyboard); });

    auto *top = new QHBoxLayout;
    top->setSpacing(0);
    top->addWidget(row.call, 1);
    top->addWidget(row.up);
    top->addWidget(row.down);
    top->addWidget(row.remove);

    auto *layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(content()->spacing());
    layout->addLayout(top);
    const bool isRotation = std::holds_alternative<Rotate>(shown);
    const QString kind = isRotation                             ? tr("Rotation")
                         : std::holds_alternative<Scale>(shown) ? tr("Scale")
                                                                : tr("Translation");
    const bool isScale = std::holds_alternative<Scale>(shown);
    ParameterRow *angle = isRotation ? addRow(layout, tr("Angle")) : nullptr;
    ParameterRow *vector = addRow(layout, isRotation ? tr("Axis") : isScale ? tr("Factor") : tr("Offset"));
    for (int i = 0; i < numbersOf(shown); ++i) {
        const QString axis = QString(QChar(u'x' + (isRotation ? i - 1 : i)));
        const bool isAngle = isRotation && i == 0;
        const QString name = isAngle      ? tr("Rotation angle")
                             : isRotation ? tr("Rotation axis %1").arg(axis)
                                          : QStringLiteral("%1 %2").arg(kind, axis);
        const QString help = isAngle ? tr("Angle in degrees, counter-clockwise seen against the axis (glRotate: angle)")
                             : isRotation
                                 ? tr("Axis of the rotation, %1; its length does not matter (glRotate: %1)").arg(axis)
                             : isScale ? tr("Factor along %1, not 0 (glScale: %1)").arg(axis)
                                       : tr("Offset along %1, world units (glTranslate: %1)").arg(axis);
        const std::size_t object = m_shown->index().value();
        const QString unit = isAngle ? degrees() : isRotation ? ofAnyLength() : isScale ? QString() : worldUnits();
        NumberField *field =
            addField(isAngle ? angle : vector, isAngle ? QString() : axis, unit,
                     {name, help,
                      [object, step, i](const Scene &scene) -> std::optional<double> {
                          if (object >= scene.objects.size() || step >= scene.objects[object].transform.size())
                              return std::nullopt;
                          TransformStep copy = scene.objects[object].transform[step];
                          return i < numbersOf(copy) ? std::optional<double>(*numberIn(copy, i)) : std::nullopt;
                      },
                      [object, step, i](Scene &scene, double value) {
                          *numberIn(scene.objects[object].transform[step], i) = value;
                      }});
        field->setObjectName(QStringLiteral("number%1").arg(i));
        field->setAccessibleName(tr("Step %1: %2").arg(number).arg(name));
        if (isAngle)
            field->setFixedStep(1.0);
        else if (!isScale)
            field->setFixedStep(0.1);
        if (i == 0)
            row.first = field;
    }

    return row;
}

} // namespace unprojector::gui
