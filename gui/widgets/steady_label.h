#pragma once

#include "gui/widgets/copy_menu.h"

#include <QLabel>

#include <utility>

namespace unprojector::gui {

/// A multi-line text that keeps the room it once needed: the label grows with its texts and never
/// shrinks, so that its surroundings don't move with every value. Texts can be selected.
class SteadyLabel : public QLabel {
    Q_OBJECT
public:
    explicit SteadyLabel(QWidget *parent = nullptr);

    /// Shows a plain text.
    void setText(const QString &text);
    /// Shows a text with subscripts. Copying gives the plain text.
    void setMarkup(const QString &markup, const QString &plain);
    /// Forgets earlier texts and keeps room for the present one only.
    void startOver();

    /// The text that the label keeps room for.
    struct Room {
        QString tallest; ///< the largest text so far
        Qt::TextFormat format = Qt::PlainText;
    };
    const Room &room() const { return m_room; }
    /// Keeps room for that text and the present one, and forgets all others.
    void setRoom(const Room &room);

    /// Sets the value that the context menu copies in addition to the text.
    void setValue(Copyable value) { m_value = std::move(value); }

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;
    /// The height is fixed. A wrapping label would lay out each new text several times to compute
    /// it.
    bool hasHeightForWidth() const override { return false; }
    int heightForWidth(int) const override { return -1; }

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void keepRoom();
    int heightOf(const QString &text, Qt::TextFormat format) const;

    Room m_room;
    QString m_plain; ///< plain text of the markup
    Copyable m_value;
};

} // namespace unprojector::gui
