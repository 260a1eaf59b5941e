#include "gui/widgets/wheel.h"

#include <QEvent>
#include <QWidget>

namespace unprojector::gui {
namespace {

class WheelFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() != QEvent::Wheel || static_cast<QWidget *>(watched)->hasFocus())
            return false;
        event->ignore();
        return true;
    }
};

} // namespace

void ignoreWheelWithoutFocus(QWidget *widget)
{
    widget->setFocusPolicy(Qt::StrongFocus); // the wheel itself gives no focus
    widget->installEventFilter(new WheelFilter(widget));
}

} // namespace unprojector::gui
