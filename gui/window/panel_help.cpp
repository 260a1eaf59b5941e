#include "gui/window/panel_help.h"

#include "gui/widgets/help_link.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QTabBar>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
namespace {

const QString kButtonName = QStringLiteral("manualOfPanel");

QToolButton *buttonIn(const QWidget &parent)
{
    return parent.findChild<QToolButton *>(kButtonName, Qt::FindDirectChildrenOnly);
}

QToolButton *makeButton(QWidget &parent)
{
    auto *button = new QToolButton(&parent);
    button->setObjectName(kButtonName);
    button->setText(QStringLiteral("?"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace

PanelHelp::PanelHelp(QMainWindow &window) : QObject(&window), m_window(window) {}

void PanelHelp::add(QDockWidget &dock, const QString &place)
{
    m_places[&dock] = place;
    QToolButton *button = makeButton(dock);
    button->setAccessibleName(tr("Manual: %1").arg(dock.windowTitle()));
    button->setToolTip(tr("%1 (%2)").arg(button->accessibleName(),
                                         QKeySequence(Qt::SHIFT | Qt::Key_F1).toString(QKeySequence::NativeText)));
    connect(button, &QToolButton::clicked, this, [place] { openManual(place); });
    dock.installEventFilter(this);
}

void PanelHelp::settle()
{
    for (QDockWidget *dock : m_window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly))
        placeInTitle(*dock);
    for (QTabBar *tabs : m_window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!buttonIn(*tabs)) {
            QToolButton *button = makeButton(*tabs);
            connect(button, &QToolButton::clicked, this, [this, tabs] { openManual(m_places.value(frontOf(*tabs))); });
            connect(tabs, &QTabBar::currentChanged, this, [this, tabs] { placeInTabs(*tabs); });
            tabs->installEventFilter(this);
        }
        placeInTabs(*tabs);
    }
}

const QDockWidget *PanelHelp::frontOf(const QTabBar &tabs) const
{
    for (const QDockWidget *dock : m_places.keys()) {
        if (tabs.count() > 0 && dock->windowTitle() == tabs.tabText(tabs.currentIndex()))
            return dock;
    }
    return nullptr;
}

void PanelHelp::placeInTitle(QDockWidget &dock)
{
    QToolButton *button = buttonIn(dock);
    if (!button)
        return;
    // This object name belongs to Qt's own float button.
    const auto *next = dock.findChild<QWidget *>(QStringLiteral("qt_dockwidget_floatbutton"));
    button->setVisible(!dock.titleBarWidget() && next && next->isVisibleTo(&dock));
    if (button->isHidden())
        return;
    const int width = std::max(next->width(), button->fontMetrics().horizontalAdvance(u'?') + 6);
    button->setGeometry(next->x() - width, next->y(), width, next->height());
    button->raise();
}

void PanelHelp::placeInTabs(QTabBar &tabs)
{
    QToolButton *button = buttonIn(tabs);
    const QDockWidget *dock = frontOf(tabs);
    const int side = button->fontMetrics().height() + 4;
    // The tabs take precedence in a narrow row; Shift+F1 still opens the manual.
    const bool isRoom = dock && tabs.tabRect(tabs.count() - 1).right() + side < tabs.width();
    button->setVisible(isRoom);
    if (button->isHidden())
        return;
    const QToolButton *own = buttonIn(*dock);
    button->setAccessibleName(own->accessibleName());
    button->setToolTip(own->toolTip());
    button->setGeometry(tabs.width() - side, (tabs.height() - side) / 2, side, side);
    button->raise();
}

bool PanelHelp::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) {
        if (auto *dock = qobject_cast<QDockWidget *>(watched))
            placeInTitle(*dock);
        else if (auto *tabs = qobject_cast<QTabBar *>(watched))
            placeInTabs(*tabs);
    }
    return QObject::eventFilter(watched, event);
}

} // namespace unprojector::gui
