#include "gui/widgets/quiet_selection.h"

#include "gui/widgets/contrast.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QEvent>

namespace unprojector::gui {
namespace {

constexpr double kTint = 0.25;

class QuietSelection : public QObject {
public:
    explicit QuietSelection(QAbstractItemView &view) : QObject(&view), m_view(view)
    {
        view.installEventFilter(this);
        tint();
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::PaletteChange)
            tint();
        return QObject::eventFilter(watched, event);
    }

private:
    void tint()
    {
        const QPalette colours = QApplication::palette(&m_view);
        QPalette own; // all its other colours stay the application's
        bool isTinted = true;
        for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
            const QColor ground =
                mixed(colours.color(group, QPalette::Base), colours.color(group, QPalette::Highlight), kTint);
            own.setColor(group, QPalette::Highlight, ground);
            own.setColor(group, QPalette::HighlightedText, colours.color(group, QPalette::Text));
            isTinted =
                isTinted && m_view.palette().color(group, QPalette::Highlight) == ground
                && m_view.palette().color(group, QPalette::HighlightedText) == colours.color(group, QPalette::Text);
        }
        if (!isTinted) // what is set comes back as a change
            m_view.setPalette(own);
    }

    QAbstractItemView &m_view;
};

} // namespace

void useQuietSelection(QAbstractItemView &view)
{
    new QuietSelection(view);
}

} // namespace unprojector::gui
