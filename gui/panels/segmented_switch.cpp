#include "gui/panels/segmented_switch.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

namespace unprojector::gui {

SegmentedSwitch::SegmentedSwitch(const QString &accessibleName, const QList<Choice> &choices, QWidget *parent)
    : QWidget(parent), m_group(new QButtonGroup(this))
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const Choice &choice : choices) {
        auto *button = new QToolButton;
        button->setText(choice.text);
        button->setToolTip(choice.toolTip);
        button->setAccessibleName(QStringLiteral("%1: %2").arg(accessibleName, choice.text));
        button->setAccessibleDescription(choice.toolTip);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        m_group->addButton(button, static_cast<int>(m_group->buttons().size()));
        layout->addWidget(button);
    }
    m_group->button(0)->setChecked(true);
    connect(m_group, &QButtonGroup::idToggled, this, [this](int index, bool isOn) {
        if (isOn)
            emit chosen(index);
    });
}

int SegmentedSwitch::choice() const
{
    return m_group->checkedId();
}

void SegmentedSwitch::setChoice(int index)
{
    if (QAbstractButton *button = m_group->button(index))
        button->setChecked(true);
}

} // namespace unprojector::gui
