#pragma once

#include <QPlainTextEdit>
#include <QUrl>

#include <limits>

namespace unprojector::gui {

/// The most characters of a text that the window parses while it waits: about a second.
inline constexpr qsizetype kMostPastedCharacters = 1'000'000;

/// A box for plain text of several lines; the only one in the program. Qt's own box reads the first
/// format of what is pasted or dropped, even if there is none: Qt 6.4 then ends the program. This
/// one takes plain text alone, and refuses a text that would make it longer than it may be.
class PlainTextBox : public QPlainTextEdit {
    Q_OBJECT
public:
    using QPlainTextEdit::QPlainTextEdit;

    /// @param most  characters
    void setMost(qsizetype most) { m_most = most; }
    /// Emits filesPasted instead of taking the names of copied files.
    void setTakesFiles(bool takes) { m_takesFiles = takes; }
    /// Replaces the text unless it is too long.
    void setText(const QString &text);

signals:
    /// Emitted instead of taking a text.
    /// @param characters  that the box would have
    void refused(qsizetype characters);
    /// @param files  as a file manager copies them
    void filesPasted(const QList<QUrl> &files);

protected:
    bool canInsertFromMimeData(const QMimeData *source) const override;
    void insertFromMimeData(const QMimeData *source) override;

private:
    bool hasRoomFor(qsizetype characters);

    bool m_takesFiles = false;
    qsizetype m_most = std::numeric_limits<int>::max();
};

} // namespace unprojector::gui
