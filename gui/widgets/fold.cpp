#include "gui/widgets/fold.h"

#include "gui/widgets/help_link.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QTimer>
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
    // Only what the user opens: a layout that is restored leaves the panel where it is.
    connect(m_head, &QToolButton::clicked, this, [this](bool isOpen) {
        if (isOpen) // its place is known only after the layout
            QTimer::singleShot(0, this, &Fold::bringIntoSight);
    });
}

void Fold::bringIntoSight()
{
    for (QWidget *above = parentWidget(); above; above = above->parentWidget()) {
        if (auto *area = qobject_cast<QScrollArea *>(above)) {
            area->ensureWidgetVisible(this, 0, 0);
            area->ensureWidgetVisible(m_head, 0, 0); // where the part is higher than the area
            return;
        }
    }
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
