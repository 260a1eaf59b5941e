#pragma once

#include "core/text/expression.h"

#include <QLineEdit>

namespace unprojector::gui {

/// A line edit for one double. What is typed, a number or an expression such as 1/3 or 2*pi, counts when it is finished:
/// on Enter, when the focus goes elsewhere, or before a shortcut such as Save. Until then it is only a text, and Esc or
/// Undo takes it back. A text that is refused stays in red with its reason until it is corrected, until Esc, or until
/// the document's value becomes another one.
///
/// With the focus it shows all digits, else as many as fit; its head is always in sight.
///
/// Up and Down and the wheel step the digit right of the caret, or left of it where none is right of it: with the caret
/// in "12.3|4" by 0.01. With the whole text selected, or an expression in the field, they step by a tenth of the leading
/// digit's place or by `setFixedStep`. Page Up, Page Down and Shift step ten times as far. The wheel steps in a field
/// with the focus, or with Ctrl in any.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    /// @param name  for people who do not see it: "Eye x"
    /// @param help  what it is, with its unit
    NumberField(const QString &name, const QString &help, QWidget *parent = nullptr);

    /// How far one step goes that is of no digit; else it is relative to the value, and never reaches 0.
    void setFixedStep(double step) { m_fixedStep = step; }

    /// The document's value.
    double value() const { return m_value; }
    /// The document's value may be another one. If it is it is shown, whatever was being typed.
    void setValue(double value);
    /// What was typed is taken: shows the document's value, good.
    void accept(double value);

    /// Whether there is a text that is not the document's value, refused or not finished.
    bool isTyping() const { return text() != m_shown; }
    /// What is typed, or the document's value to its last bit where nothing is.
    geometry::Result<double, text::ExpressionError> typed() const;
    /// Finishes the typing, if there is any.
    void commit();
    /// Whether there is a text that was not committed as it is: neither taken nor refused.
    bool isUntried() const { return isTyping() && text() != m_tried; }
    /// Finishes the typing, unless it was refused already.
    void commitUntried();

    bool isBad() const { return !m_reason.isEmpty(); }
    const QString &reason() const { return m_reason; }
    /// Marks the field red with a reason; an empty one makes it good again.
    void setReason(const QString &reason);
    /// Back to the document's value, good again.
    void restore();
    /// Selects all, with the head in sight.
    void selectNumber();

    /// Steps that follow each other have the same number: they are undone as one. A typed number has one of its own.
    quint64 session() const { return m_session; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// `typed()` is to be taken or refused.
    void committed();
    /// The text of a bad field was changed.
    void retyped();
    void reasonChanged();

protected:
    bool event(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// The digit that is stepped, while the caret is where the last step put it.
    struct SteppedDigit {
        QString text;
        int caret = -1;
        int place = 0; ///< power of ten, before the exponent
    };

    void stepBy(double steps);
    bool stepDigit(double steps);
    void stepNumber(double from, double steps);
    void commitLeft(Qt::FocusReason reason);
    void commitBeforeShortcut(const QKeyEvent &key);
    void showText(const QString &text);
    /// The value with as many digits as are wanted now.
    QString shownText() const;
    int widthFor(const QString &number) const;
    int roomForText() const;

    QString m_help;
    QString m_reason;
    QString m_shown; ///< the value, as the field wrote it
    QString m_tried; ///< what was refused: leaving the field does not ask again
    double m_value = 0.0;
    double m_fixedStep = 0.0; ///< 0: relative
    SteppedDigit m_stepped;
    bool m_isStepping = false;
    bool m_opensMenu = false;
    int m_wheelAngle = 0;
    quint64 m_session = 0;
};

} // namespace unprojector::gui
