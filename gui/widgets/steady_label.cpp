#include "gui/widgets/steady_label.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QResizeEvent>
#include <QTextDocument>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {

SteadyLabel::SteadyLabel(QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    // The height follows from the width, which the layout decides.
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    keepRoom();
}

int SteadyLabel::heightOf(const QString &text, Qt::TextFormat format) const
{
    const int room = std::max(width(), 1);
    if (format == Qt::RichText) {
        QTextDocument set;
        set.setDocumentMargin(0.0);
        set.setDefaultFont(font());
        set.setHtml(text);
        set.setTextWidth(room);
        return static_cast<int>(std::ceil(set.size().height()));
    }
    return fontMetrics().boundingRect(QRect(0, 0, room, 1 << 16), Qt::AlignLeft | Qt::TextWordWrap, text).height();
}

void SteadyLabel::setText(const QString &text)
{
    setTextFormat(Qt::PlainText);
    QLabel::setText(text);
    keepRoom();
}

void SteadyLabel::setMarkup(const QString &markup, const QString &plain)
{
    m_plain = plain;
    setTextFormat(Qt::RichText);
    QLabel::setText(markup);
    keepRoom();
}

void SteadyLabel::startOver()
{
    m_room.tallest.clear();
    keepRoom();
}

void SteadyLabel::setRoom(const Room &room)
{
    m_room = room;
    keepRoom();
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
    const int now = heightOf(text(), textFormat()), most = heightOf(m_room.tallest, m_room.format);
    if (now > most) {
        m_room.tallest = text();
        m_room.format = textFormat();
    }
    setFixedHeight(std::max({now, most, fontMetrics().lineSpacing()}) + 2);
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

void SteadyLabel::contextMenuEvent(QContextMenuEvent *event)
{
    if (text().isEmpty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QString copied = hasSelectedText() ? selectedText() : textFormat() == Qt::RichText ? m_plain : text();
    copied.replace(QChar::Nbsp, u' '); // they only keep lines from breaking
    menu->addAction(hasSelectedText() ? tr("Copy the &selection") : tr("Copy the &text"), menu,
                    [copied] { copyToClipboard(copied); });
    if (!m_value.numbers.empty())
        menu->addSeparator();
    addCopyActions(*menu, {}, m_value);
    menu->popup(event->globalPos());
}

} // namespace unprojector::gui
