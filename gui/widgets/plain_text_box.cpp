#include "gui/widgets/plain_text_box.h"

#include <QMimeData>
#include <QTextCursor>

namespace unprojector::gui {

bool PlainTextBox::hasRoomFor(qsizetype characters)
{
    if (characters <= m_most)
        return true;
    emit refused(characters);
    return false;
}

void PlainTextBox::setText(const QString &text)
{
    if (hasRoomFor(text.size()))
        setPlainText(text);
}

bool PlainTextBox::canInsertFromMimeData(const QMimeData *source) const
{
    return source->hasText();
}

void PlainTextBox::insertFromMimeData(const QMimeData *source)
{
    if (!(textInteractionFlags() & Qt::TextEditable) || !source->hasText())
        return;
    if (const QList<QUrl> urls = source->urls(); m_takesFiles && !urls.isEmpty() && urls.front().isLocalFile()) {
        emit filesPasted(urls);
        return;
    }
    const QString text = source->text();
    const qsizetype selected = textCursor().selectionEnd() - textCursor().selectionStart();
    constexpr qsizetype kEnd = 1; // the document counts its end
    if (!hasRoomFor(document()->characterCount() - kEnd - selected + text.size()))
        return;
    insertPlainText(text);
    ensureCursorVisible();
}

} // namespace unprojector::gui
