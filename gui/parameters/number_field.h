#pragma once

#include "core/base/expression.h"

#include <QLineEdit>

namespace unprojector::gui {

/// A line edit for one double. The text is a number or an expression such as 1/3 or 2*pi. It is
/// committed on Enter, on loss of focus, or before a shortcut such as Save. Until then it is only a
/// text, and Esc or Undo reverts it. A rejected text stays red with its reason until it is
/// corrected, until Esc, or until the document's value changes.
///
/// With the focus it shows all digits, else as many as fit; the first digits are always visible.
///
/// Up, Down and the wheel step the digit right of the caret, or left of it if none is right of it:
/// with the caret in "12.3|4" by 0.01. If the whole text is selected, or the field has an
/// expression, the step is a tenth of the leading digit's place or `setFixedStep`. Page Up, Page
/// Down and Shift step ten times as far. The wheel steps in a field with the focus, or with Ctrl in
/// any.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    /// @param name  for screen readers: "Eye x"
    /// @param help  its meaning, with its unit
    NumberField(const QString &name, const QString &help, QWidget *parent = nullptr);

    /// Sets the step without a digit; else it is relative to the value, and never reaches 0.
    void setFixedStep(double step) { m_fixedStep = step; }

    /// The document's value.
    double value() const { return m_value; }
    /// Updates the document's value. If it changed, it replaces any pending text.
    void setValue(double value);
    /// Accepts the typed text: shows the document's value without an error.
    void accept(double value);

    /// Returns whether there is a text other than the document's value, rejected or unfinished.
    bool isTyping() const { return text() != m_shown; }
    /// The parsed text, or the document's exact value if no text is pending.
    base::Expected<double, base::ExpressionError> typed() const;
    /// Commits pending text.
    void commit();
    /// Returns whether there is a text that is neither accepted nor rejected yet.
    bool isUntried() const { return isTyping() && text() != m_tried; }
    /// Commits pending text, unless it was rejected already.
    void commitUntried();

    bool isBad() const { return !m_reason.isEmpty(); }
    const QString &reason() const { return m_reason; }
    /// Marks the field red with a reason; an empty one clears the error.
    void setReason(const QString &reason);
    /// Restores the document's value and clears the error.
    void restore();
    /// Selects all and shows the first digits.
    void selectNumber();

    /// The number of an edit session: consecutive steps share one and are one step of undo. A typed
    /// number has its own.
    quint64 session() const { return m_session; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when `typed()` must be accepted or rejected.
    void committed();
    /// Emitted when the text of a rejected field was edited.
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
    /// The stepped digit, while the caret is where the last step left it.
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
    /// The value with the currently wanted digits.
    QString shownText() const;
    int widthFor(const QString &number) const;
    int roomForText() const;

    QString m_help;
    QString m_reason;
    QString m_shown; ///< the value, as the field wrote it
    QString m_tried; ///< the rejected text: leaving the field does not commit it again
    double m_value = 0.0;
    double m_fixedStep = 0.0; ///< 0: relative
    SteppedDigit m_stepped;
    bool m_isStepping = false;
    bool m_opensMenu = false;
    int m_wheelAngle = 0;
    quint64 m_session = 0;
};

} // namespace unprojector::gui
