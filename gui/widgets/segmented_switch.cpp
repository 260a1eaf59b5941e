#include "gui/widgets/segmented_switch.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

namespace unprojector::gui {
namespace {

/// A selected choice has the selection's colour: styles show a pressed button too faintly, on a
/// dark desktop not at all.
class Segment : public QToolButton {
public:
    QSize sizeHint() const override
    {
        const QFontMetrics metrics(font());
        return {metrics.horizontalAdvance(text()) + metrics.height(), metrics.height() * 3 / 2};
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        const QPalette::ColorGroup group = isEnabled() ? QPalette::Active : QPalette::Disabled;
        const QPalette::ColorRole fill = isChecked()    ? QPalette::Highlight
                                         : underMouse() ? QPalette::Midlight
                                                        : QPalette::Button;
        painter.setPen(palette().color(group, hasFocus() ? QPalette::Highlight : QPalette::Mid));
        painter.setBrush(palette().color(group, fill));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
        painter.setPen(palette().color(group, isChecked() ? QPalette::HighlightedText : QPalette::ButtonText));
        QFont taken = font();
        taken.setUnderline(hasFocus() && isChecked());
        painter.setFont(taken);
        painter.drawText(rect(), Qt::AlignCenter, text());
    }
};

} // namespace

SegmentedSwitch::SegmentedSwitch(const QString &accessibleName, const QList<Choice> &choices, QWidget *parent)
    : QWidget(parent), m_group(new QButtonGroup(this))
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const Choice &choice : choices) {
        auto *button = new Segment;
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

void SegmentedSwitch::setChoiceEnabled(int index, bool isEnabled)
{
    m_group->button(index)->setEnabled(isEnabled);
}

} // namespace unprojector::gui
