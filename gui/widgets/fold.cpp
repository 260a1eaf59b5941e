#include "gui/widgets/fold.h"

#include "gui/widgets/help_link.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace unprojector::gui {

Fold::Fold(const QString &title, const QString &toolTip, QWidget *content, const QString &helpAnchor, QWidget *parent)
    : QWidget(parent), m_head(new QToolButton)
{
    m_head->setText(title);
    m_head->setToolTip(toolTip);
    m_head->setCheckable(true);
    m_head->setAutoRaise(true);
    m_head->setArrowType(Qt::RightArrow);
    m_head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    if (content->accessibleName().isEmpty())
        content->setAccessibleName(title);
    content->hide();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto *line = new QHBoxLayout;
    line->addWidget(m_head);
    line->addStretch();
    if (!helpAnchor.isEmpty())
        line->addWidget(new HelpLink(helpAnchor));
    layout->addLayout(line);
    layout->addWidget(content);
    connect(m_head, &QToolButton::toggled, this, [this, content](bool isOpen) {
        m_head->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        content->setVisible(isOpen);
        emit toggled(isOpen);
    });
}

bool Fold::isOpen() const
{
    return m_head->isChecked();
}

void Fold::setOpen(bool isOpen)
{
    m_head->setChecked(isOpen);
}

} // namespace unprojector::gui
