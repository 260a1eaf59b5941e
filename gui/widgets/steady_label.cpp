#include "gui/widgets/steady_label.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QResizeEvent>
#include <QTextDocument>

#include <algorithm>
#include <cmath>

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
        if (Qt::mightBeRichText(text)) {
            QTextDocument set;
            set.setDocumentMargin(0.0);
            set.setDefaultFont(font());
            set.setHtml(text);
            set.setTextWidth(std::max(width, 1));
            height = std::max(height, static_cast<int>(std::ceil(set.size().height())));
            continue;
        }
        const QRect needed = fontMetrics().boundingRect(QRect(0, 0, std::max(width, 1), 1 << 16),
                                                        Qt::AlignLeft | Qt::TextWordWrap, text);
        height = std::max(height, needed.height());
    }
    return height + 2;
}

void SteadyLabel::setLongest(const QStringList &longest)
{
    if (longest == m_longest)
        return;
    m_longest = longest;
    keepRoom();
}

void SteadyLabel::setMarkup(const QString &markup, const QString &plain)
{
    m_plain = plain;
    setTextFormat(Qt::RichText);
    setText(markup);
}

void SteadyLabel::setPlain(const QString &text)
{
    setTextFormat(Qt::PlainText);
    setText(text);
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

void SteadyLabel::contextMenuEvent(QContextMenuEvent *event)
{
    if (text().isEmpty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QString copied = hasSelectedText() ? selectedText() : textFormat() == Qt::RichText ? m_plain : text();
    copied.replace(QChar::Nbsp, u' '); // there to keep lines from breaking
    menu->addAction(hasSelectedText() ? tr("Copy the &selection") : tr("Copy the &words"), menu,
                    [copied] { copyToClipboard(copied); });
    if (!m_value.numbers.empty())
        menu->addSeparator();
    addCopyActions(*menu, {}, m_value);
    menu->popup(event->globalPos());
}

} // namespace unprojector::gui
