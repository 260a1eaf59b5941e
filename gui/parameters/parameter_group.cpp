#include "gui/parameters/parameter_group.h"

#include "gui/parameters/group_heading.h"
#include "gui/text/error_text.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

/// More rejected fields at once are rare; all their subsets are tried one by one.
constexpr std::size_t kMostTriedTogether = 4;

} // namespace

ParameterGroup::ParameterGroup(SceneDocument &document, Changes shown, const Title &title, QWidget *parent)
    : QWidget(parent), m_document(document), m_heading(new GroupHeading(title.text, title.help, title.resetHelp)),
      m_body(new QWidget), m_reason(wrappedLabel())
{
    const int em = fontMetrics().height();
    m_content = new QVBoxLayout(m_body);
    m_content->setContentsMargins(em / 2, em / 4, em / 2, em / 2);
    m_content->setSpacing(em / 4);
    m_reason->setAccessibleName(tr("Reason why the change was rejected"));
    m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_reason->hide();
    m_content->addWidget(m_reason);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_heading);
    layout->addWidget(m_body);

    connect(m_heading, &GroupHeading::openChanged, this, &ParameterGroup::setOpen);
    connect(m_heading, &GroupHeading::resetRequested, this, [this, title] {
        restoreFields();
        change(tr("Reset %1").arg(title.text), [this](Scene &scene) { setDefaults(scene); });
    });
    connect(&m_document, &SceneDocument::changed, this, [this, shown](Changes changes) {
        if (!(changes & shown))
            return;
        if (isVisible() && isOpen())
            refresh();
        else
            m_isStale = true;
    });
}

ParameterGroup::~ParameterGroup() = default;

bool ParameterGroup::isOpen() const
{
    return m_heading->isOpen();
}

void ParameterGroup::setOpen(bool isOpen)
{
    if (m_heading->isOpen() != isOpen) {
        m_heading->setOpen(isOpen); // and back here
        return;
    }
    m_body->setVisible(isOpen);
    if (isOpen && isVisible() && m_isStale)
        refresh();
}

int ParameterGroup::leastWidth() const
{
    return std::max(m_heading->minimumSizeHint().width(), m_body->minimumSizeHint().width());
}

QLabel *ParameterGroup::wrappedLabel(const QString &text)
{
    auto *label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    label->setSizePolicy(policy);
    return label;
}

ParameterRow *ParameterGroup::addRow(QBoxLayout *layout, const QString &title)
{
    auto *row = new ParameterRow(title);
    layout->addWidget(row);
    return row;
}

NumberField *ParameterGroup::addField(ParameterRow *row, const QString &letter, const QString &unit,
                                      NumberBinding binding)
{
    auto *widget = new NumberField(binding.name, binding.help);
    row->addField(widget, letter, unit);
    const FieldPointer field = std::make_shared<Field>(Field{widget, std::move(binding)});
    m_fields.push_back(field);
    connect(widget, &NumberField::committed, this, [this, field] { apply(field); });
    connect(widget, &NumberField::retyped, this, [this, field] { field->widget->setReason(refusalOf(*field)); });
    return widget;
}

NumberSlider *ParameterGroup::addSlider(ParameterRow *row, const NumberField *of, NumberSlider::Scale scale,
                                        std::function<double(const Scene &, double)> within)
{
    const auto found =
        std::find_if(m_fields.begin(), m_fields.end(), [of](const FieldPointer &field) { return field->widget == of; });
    Q_ASSERT(found != m_fields.end());
    const NumberBinding &binding = (*found)->binding;
    auto *slider = new NumberSlider(binding.name, binding.help, scale);
    (*found)->slider = slider;
    row->setSlider(of, slider);
    connect(slider, &NumberSlider::moved, this,
            [this, slider, within = std::move(within), field = *found](double number) {
                const QString mergeKey = QStringLiteral("%1 ~%2").arg(field->binding.name).arg(slider->session());
                const Check done = m_document.edit({field->binding.name, mergeKey}, [&](Scene &scene) {
                    field->binding.write(scene, within(scene, number));
                });
                if (!done)
                    refresh();
            });
    return slider;
}

void ParameterGroup::onClick(QAbstractButton *button, std::function<void(bool byKeyboard)> act)
{
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QAbstractButton::clicked, this, [button, act = std::move(act)] {
        if (auto *typing = qobject_cast<NumberField *>(QApplication::focusWidget()))
            typing->commitUntried();
        act(button->hasFocus());
    });
}

void ParameterGroup::removeFieldsIn(QWidget *container)
{
    std::erase_if(m_fields, [&](const FieldPointer &field) {
        if (!container->isAncestorOf(field->widget))
            return false;
        // It may be the sender of the present signal.
        field->widget->disconnect(this);
        return true;
    });
    container->hide();
    container->deleteLater();
}

void ParameterGroup::restoreFields()
{
    setReason({});
    for (const FieldPointer &field : m_fields) {
        if (field->widget->isBad() || field->widget->isTyping())
            field->widget->restore();
    }
}

void ParameterGroup::applyTyped()
{
    const auto isUntried = [](const FieldPointer &field) { return field->widget->isUntried(); };
    if (std::none_of(m_fields.begin(), m_fields.end(), isUntried))
        return;
    // A folded or hidden group may have fields of removed objects and planes.
    if (m_isStale)
        refresh();
    const std::vector<FieldPointer> fields = m_fields; // a copy: a change may add or remove fields
    for (const FieldPointer &field : fields) {
        if (isThere(field))
            field->widget->commitUntried();
    }
}

void ParameterGroup::bringUp(NumberField *field, bool byKeyboard)
{
    if (byKeyboard)
        field->setFocus(Qt::TabFocusReason);
    // Its position is known only after the layout.
    QTimer::singleShot(0, field, [this, field] { emit bringUpRequested(field); });
}

void ParameterGroup::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale && isOpen())
        refresh();
}

void ParameterGroup::refresh()
{
    m_isStale = false;
    setReason({});
    showScene();
    const Scene &scene = m_document.scene();
    for (const FieldPointer &field : m_fields) {
        if (const std::optional<double> value = field->binding.read(scene)) {
            field->widget->setValue(*value);
            if (field->slider)
                field->slider->setNumber(*value);
        } else if (field->widget->isBad()) {
            field->widget->restore();
        }
    }
    updateReasons();
}

bool ParameterGroup::change(const QString &text, const std::function<void(Scene &)> &edit)
{
    const Check changed = m_document.edit({text}, edit);
    if (!changed)
        refresh(); // the combo box or check box goes back
    setReason(changed ? QString() : errorText(changed.error()));
    return changed.hasValue();
}

bool ParameterGroup::isThere(const FieldPointer &field) const
{
    return field->widget && std::find(m_fields.begin(), m_fields.end(), field) != m_fields.end();
}

Check ParameterGroup::changeTogether(const std::vector<FieldPointer> &fields, const EditLabel &label)
{
    const Check changed = m_document.edit(label, [&](Scene &scene) {
        for (const FieldPointer &field : fields)
            field->binding.write(scene, *field->widget->typed());
    });
    if (changed) {
        for (const FieldPointer &field : fields) {
            if (!isThere(field))
                continue;
            if (const std::optional<double> value = field->binding.read(m_document.scene()))
                field->widget->accept(*value);
        }
    }
    return changed;
}

std::vector<ParameterGroup::FieldPointer> ParameterGroup::refusedBut(const FieldPointer &other) const
{
    std::vector<FieldPointer> refused;
    for (const FieldPointer &field : m_fields) {
        NumberField *widget = field->widget;
        if (field == other || !widget->isBad() || !widget->typed() || refused.size() == kMostTriedTogether
            || !field->binding.read(m_document.scene()))
            continue;
        if (!field->binding.refusal || field->binding.refusal(*widget->typed()).isEmpty())
            refused.push_back(field);
    }
    return refused;
}

void ParameterGroup::apply(const FieldPointer &field)
{
    setReason({});
    const base::Expected<double, base::ExpressionError> typed = field->widget->typed();
    const std::vector<FieldPointer> refused = refusedBut(field);
    const std::optional<double> current = field->binding.read(m_document.scene());
    if (!current) {
        field->widget->restore(); // its number no longer exists
        return;
    }
    if (!typed || (field->binding.refusal && !field->binding.refusal(*typed).isEmpty())) {
        refuse(field);
        return;
    }
    const QString mergeKey = QStringLiteral("%1 #%2").arg(field->binding.name).arg(field->widget->session());

    // All of them, else the sets with one less, and so on down to this field alone.
    std::vector<unsigned> sets(1u << refused.size());
    std::iota(sets.begin(), sets.end(), 0u);
    std::stable_sort(sets.begin(), sets.end(),
                     [](unsigned a, unsigned b) { return std::popcount(a) > std::popcount(b); });
    for (const unsigned set : sets) {
        std::vector<FieldPointer> together{field};
        for (std::size_t i = 0; i < refused.size(); ++i) {
            if (set & (1u << i))
                together.push_back(refused[i]);
        }
        if (together.size() == 1 && *current == *typed) {
            field->widget->accept(*current);
            return;
        }
        if (changeTogether(together, {field->binding.name, mergeKey})) {
            updateReasons();
            return;
        }
    }
    refuse(field);
}

void ParameterGroup::refuse(const FieldPointer &field)
{
    field->widget->setReason(refusalOf(*field));
    if (field->widget->hasFocus()) {
        QPointer<QWidget> row = field->widget->parentWidget();
        // The position of the reason is known only after the layout.
        QTimer::singleShot(0, this, [this, row] {
            if (row)
                emit bringUpRequested(row);
        });
    }
}

QString ParameterGroup::refusalOf(const Field &field) const
{
    if (!field.binding.read(m_document.scene()))
        return {}; // its number no longer exists
    const base::Expected<double, base::ExpressionError> typed = field.widget->typed();
    if (!typed)
        return typed.error().code == base::ExpressionErrorCode::Empty
                   ? tr("%1 is empty; type a number.").arg(field.binding.name)
                   : errorText(typed.error(), field.widget->text());
    if (field.binding.refusal) {
        if (QString reason = field.binding.refusal(*typed); !reason.isEmpty())
            return reason;
    }
    Scene next = m_document.scene();
    field.binding.write(next, *typed);
    const Result<Setup> setup = setupOf(next, m_document.setup().surface, m_document.ground().box);
    return setup ? QString() : errorText(setup.error());
}

void ParameterGroup::updateReasons()
{
    for (const FieldPointer &field : m_fields) {
        if (!field->widget->isBad())
            continue;
        const QString reason = refusalOf(*field);
        field->widget->setReason(reason.isEmpty() ? tr("%1 is valid now; press Enter.").arg(field->binding.name)
                                                  : reason);
    }
}

void ParameterGroup::setReason(const QString &reason)
{
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
}

} // namespace unprojector::gui
