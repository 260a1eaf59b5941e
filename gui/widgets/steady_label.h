#pragma once

#include "gui/widgets/copy_menu.h"

#include <QLabel>

#include <utility>

namespace unprojector::gui {

/// A text over several lines that keeps the room it once needed: the label grows with its texts and never shrinks, so that
/// what stands around it does not move with every value. Texts can be selected.
class SteadyLabel : public QLabel {
    Q_OBJECT
public:
    explicit SteadyLabel(QWidget *parent = nullptr);

    /// Shows a text as it is.
    void setText(const QString &text);
    /// Shows a text with its indexes set as such. What is copied is the plain text.
    void setMarkup(const QString &markup, const QString &plain);
    /// Forgets the texts so far and keeps room for the one that is shown.
    void startOver();

    /// The text that the label keeps room for.
    struct Room {
        QString tallest; ///< of the texts so far, the one that needs the most room
        Qt::TextFormat format = Qt::PlainText;
    };
    const Room &room() const { return m_room; }
    /// Keeps room for that text and the one that is shown, as if no other had been shown.
    void setRoom(const Room &room);

    /// What its menu copies besides the text.
    void setValue(Copyable value) { m_value = std::move(value); }

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;
    /// The height is fixed. A label that wraps would lay out each new text several times to tell one.
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
    QString m_plain; ///< of the markup
    Copyable m_value;
};

} // namespace unprojector::gui
