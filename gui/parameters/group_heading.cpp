#include "gui/parameters/group_heading.h"

#include "gui/widgets/help_link.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>

namespace unprojector::gui {

GroupHeading::GroupHeading(const QString &title, const QString &help, const QString &resetHelp, QWidget *parent)
    : QWidget(parent), m_fold(new QToolButton), m_reset(new QToolButton), m_help(new HelpLink({}))
{
    m_fold->setText(title);
    m_fold->setAccessibleName(title);
    m_fold->setToolTip(help);
    m_fold->setAutoRaise(true);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_fold->setFocusPolicy(Qt::StrongFocus);
    m_fold->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = m_fold->font();
    bold.setBold(true);
    m_fold->setFont(bold);
    m_fold->installEventFilter(this);
    m_reset->setText(tr("Reset"));
    m_reset->setAccessibleName(tr("Reset %1").arg(title));
    m_reset->setToolTip(resetHelp);
    m_reset->setAutoRaise(true);
    m_reset->setFocusPolicy(Qt::TabFocus);
    m_reset->setObjectName(QStringLiteral("reset"));

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_fold, 1);
    layout->addWidget(m_reset);
    layout->addWidget(m_help);
    m_help->hide();
    connect(m_fold, &QToolButton::clicked, this, [this] { setOpen(!m_isOpen); });
    connect(m_reset, &QToolButton::clicked, this, &GroupHeading::resetRequested);
    setOpen(true);
}

void GroupHeading::setHelp(const QString &anchor)
{
    m_help->setAnchor(anchor);
    m_help->show();
}

void GroupHeading::setOpen(bool isOpen)
{
    m_isOpen = isOpen;
    m_fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
    m_fold->setAccessibleDescription(isOpen ? tr("Open") : tr("Folded"));
    emit openChanged(isOpen);
}

bool GroupHeading::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    switch (static_cast<QKeyEvent *>(event)->key()) {
    case Qt::Key_Enter:
    case Qt::Key_Return: setOpen(!m_isOpen); return true;
    case Qt::Key_Left: setOpen(false); return true;
    case Qt::Key_Right: setOpen(true); return true;
    case Qt::Key_Up: emit neighbourRequested(-1); return true;
    case Qt::Key_Down: emit neighbourRequested(1); return true;
    default: return QWidget::eventFilter(watched, event); // Space clicks the button
    }
}

} // namespace unprojector::gui
