#include "gui/panels/steady_label.h"

#include <QEvent>
#include <QResizeEvent>

#include <algorithm>

namespace unprojector::gui {

SteadyLabel::SteadyLabel(const QStringList &longest, QWidget *parent) : QLabel(parent), m_longest(longest)
{
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    // The height follows from the width, which is the layout's to say.
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

int SteadyLabel::heightAt(int width) const
{
    int height = fontMetrics().lineSpacing();
    for (const QString &text : m_longest) {
        const QRect needed = fontMetrics().boundingRect(QRect(0, 0, std::max(width, 1), 1 << 16),
                                                        Qt::AlignLeft | Qt::TextWordWrap, text);
        height = std::max(height, needed.height());
    }
    return height + 2;
}

QSize SteadyLabel::minimumSizeHint() const
{
    return {8 * fontMetrics().horizontalAdvance(u'0'), minimumHeight()};
}

QSize SteadyLabel::sizeHint() const
{
    return minimumSizeHint();
}

void SteadyLabel::keepRoom()
{
    setFixedHeight(heightAt(width()));
}

void SteadyLabel::resizeEvent(QResizeEvent *event)
{
    QLabel::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        keepRoom();
}

void SteadyLabel::changeEvent(QEvent *event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange)
        keepRoom();
}

} // namespace unprojector::gui
