#pragma once

#include <QPlainTextEdit>

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
    /// Replaces the text unless it is too long.
    void setText(const QString &text);

signals:
    /// Emitted instead of taking a text.
    /// @param characters  that the box would have
    void refused(qsizetype characters);

protected:
    bool canInsertFromMimeData(const QMimeData *source) const override;
    void insertFromMimeData(const QMimeData *source) override;

private:
    bool hasRoomFor(qsizetype characters);

    qsizetype m_most = std::numeric_limits<int>::max();
};

} // namespace unprojector::gui
