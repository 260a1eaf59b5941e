#include "gui/widgets/refused_field.h"

#include "gui/widgets/contrast.h"

#include <QApplication>
#include <QEvent>
#include <QLineEdit>

namespace unprojector::gui {
namespace {

const char *const kGroundName = "refusedGround";

/// The background of a rejected field. It exists while the text is rejected.
class RefusedGround : public QObject {
public:
    explicit RefusedGround(QLineEdit &field) : QObject(&field), m_field(field)
    {
        setObjectName(QLatin1String(kGroundName));
        field.installEventFilter(this);
        colour();
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::PaletteChange)
            colour();
        return QObject::eventFilter(watched, event);
    }

private:
    void colour()
    {
        constexpr double kShare = 0.35;
        const QColor ground = mixed(QApplication::palette().color(QPalette::Base), QColor(255, 60, 60), kShare);
        if (m_field.palette().color(QPalette::Base) == ground) // our own change comes back as an event
            return;
        QPalette own; // all other colours stay the application's
        own.setColor(QPalette::Base, ground);
        m_field.setPalette(own);
    }

    QLineEdit &m_field;
};

} // namespace

void setRefused(QLineEdit &field, bool isRefused)
{
    const auto *ground = field.findChild<QObject *>(QLatin1String(kGroundName), Qt::FindDirectChildrenOnly);
    if (isRefused == (ground != nullptr))
        return;
    if (isRefused) {
        new RefusedGround(field);
    } else {
        delete ground;
        field.setPalette(QPalette());
    }
}

} // namespace unprojector::gui
