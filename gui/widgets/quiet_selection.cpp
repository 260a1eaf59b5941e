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
        if (event->type() == QEvent::ApplicationPaletteChange)
            tint();
        return QObject::eventFilter(watched, event);
    }

private:
    void tint()
    {
        QPalette palette = QApplication::palette(&m_view);
        for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
            palette.setColor(
                group, QPalette::Highlight,
                mixed(palette.color(group, QPalette::Base), palette.color(group, QPalette::Highlight), kTint));
            palette.setColor(group, QPalette::HighlightedText, palette.color(group, QPalette::Text));
        }
        m_view.setPalette(palette);
    }

    QAbstractItemView &m_view;
};

} // namespace

void useQuietSelection(QAbstractItemView &view)
{
    new QuietSelection(view);
}

} // namespace unprojector::gui
