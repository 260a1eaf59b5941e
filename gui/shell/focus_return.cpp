#include "gui/shell/focus_return.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

template <class... Kinds>
bool isAny(const QWidget *widget)
{
    return (... || (qobject_cast<const Kinds *>(widget) != nullptr));
}

/// The list that a widget is in, or null. Its editors and its viewport are in it.
QAbstractItemView *listOf(QWidget *widget)
{
    for (QWidget *one = widget; one && !one->isWindow(); one = one->parentWidget()) {
        if (auto *list = qobject_cast<QAbstractItemView *>(one))
            return list;
    }
    return nullptr;
}

bool endsTyping(const QKeyEvent &key)
{
    return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Escape;
}

} // namespace

FocusReturn::FocusReturn(QWidget &view, std::vector<QWidget *> areas)
    : QObject(&view), m_view(view), m_areas(std::move(areas))
{
    qApp->installEventFilter(this);
}

bool FocusReturn::isControl(const QWidget &widget) const
{
    return &widget != &m_view && widget.window() == m_view.window()
           && std::any_of(m_areas.begin(), m_areas.end(),
                          [&widget](const QWidget *area) { return area->isAncestorOf(&widget); });
}

bool FocusReturn::eventFilter(QObject *watched, QEvent *event)
{
    const QEvent::Type type = event->type();
    if ((type != QEvent::FocusIn && type != QEvent::MouseButtonRelease && type != QEvent::MouseButtonDblClick
         && type != QEvent::KeyPress)
        || !watched->isWidgetType())
        return false;
    auto &widget = *static_cast<QWidget *>(watched);
    if (!isControl(widget))
        return false;
    if (type == QEvent::FocusIn) {
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        if (reason == Qt::MouseFocusReason)
            m_clicked = &widget;
        else if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason)
            m_clicked = nullptr;
        else if (m_clicked == &widget && isAny<QAbstractButton, QComboBox>(&widget)) // its menu has closed
            giveBackAfter(widget);
    } else if (type == QEvent::MouseButtonRelease) {
        if (isAny<QAbstractButton, QAbstractSpinBox>(&widget))
            giveBackAfter(widget);
    } else if (type == QEvent::MouseButtonDblClick) {
        if (QAbstractItemView *list = listOf(&widget); list && list->viewport() == &widget)
            giveBackAfter(*list);
    } else if (const auto &key = *static_cast<QKeyEvent *>(event); endsTyping(key)) {
        const bool isField = isAny<QLineEdit, QAbstractSpinBox>(&widget) && !listOf(&widget);
        if (isField || (key.key() == Qt::Key_Escape && isAny<QAbstractItemView>(&widget)))
            giveBackAfter(widget);
    }
    return false;
}

void FocusReturn::giveBackAfter(QWidget &control)
{
    // A control that its own click has disabled or hidden has lost the focus to any other.
    QTimer::singleShot(0, this, [this, used = QPointer<QWidget>(&control)] {
        QWidget *focus = m_view.window()->focusWidget();
        if (QApplication::activeModalWidget())
            return;
        const bool isGone = !used || !used->isEnabled() || !used->isVisible();
        // The tool bar's buttons take no focus by mouse: it may still be in a field.
        const bool isInField =
            focus && isControl(*focus) && isAny<QLineEdit, QAbstractSpinBox>(focus) && !listOf(focus);
        if (focus == used || isGone || isInField)
            m_view.setFocus(Qt::OtherFocusReason);
    });
}

} // namespace unprojector::gui
