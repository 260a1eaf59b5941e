#pragma once

#include <QLineEdit>

#include <optional>

namespace unprojector::gui {

/// A number as it is typed: as C writes it, with a decimal comma or point and an ASCII or typographic minus; blanks
/// around it do not matter. "nan" and "inf" are numbers here, for the document to refuse. Nothing for any other text.
std::optional<double> numberFromText(const QString &text);

/// A line edit for one double. Every keystroke that leaves a number is passed on at once; a text that is none, or that
/// is refused, stays in red with its reason until it is corrected, until Esc restores the last good value, or until the
/// document's value becomes another one. With the focus it shows all digits, else at most seven, as they fit.
/// Up and Down and the wheel (with the focus) step; Shift steps ten times as far.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    /// How far one step goes.
    enum class Step {
        Relative, ///< a tenth of the leading digit's place: 0.1 from 1 on, 1 from 10 on; never through 0
        Fixed     ///< `setFixedStep`
    };

    /// @param name  for people who do not see it: "Eye x"
    /// @param help  what it is, with its unit
    NumberField(const QString &name, const QString &help, QWidget *parent = nullptr);

    void setFixedStep(double step);

    /// The document's value.
    double value() const { return m_value; }
    /// Shows the document's value. What is being typed stays, with its cursor, where it is that very number or was
    /// refused while the document's value stays as it is.
    void setValue(double value);

    /// The number in the field, good or not; nothing where the text is not a number.
    std::optional<double> typed() const { return numberFromText(text()); }

    bool isBad() const { return !m_reason.isEmpty(); }
    const QString &reason() const { return m_reason; }
    /// Marks the field red with a reason; an empty one makes it good again.
    void setReason(const QString &reason);
    /// Back to the document's value, good again.
    void restore();

    /// A number of its own for each time the field has the focus: edits of one session are undone as one.
    quint64 session() const { return m_session; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user typed, pasted or stepped: `typed()` is to be taken or refused.
    void edited();
    /// Enter: what was refused is to be tried again.
    void entered();
    void reasonChanged();

protected:
    bool event(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void stepBy(double steps);
    void showText(const QString &text);
    /// The value with as many digits as are wanted now.
    QString shownText() const;
    int widthFor(int characters) const;

    QString m_help;
    QString m_reason;
    double m_value = 0.0;
    Step m_step = Step::Relative;
    double m_fixedStep = 0.1; ///< also from 0, where nothing is relative
    int m_wheelAngle = 0;
    quint64 m_session = 0;
};

} // namespace unprojector::gui
