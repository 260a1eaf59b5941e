#include "gui/parameters/number_field.h"

#include "gui/parameters/digit_step.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/refused_field.h"

#include <QApplication>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr int kFewestDigits = 3;
constexpr int kMostDigits = 17;
constexpr double kFirstStep = 0.1;     // from 0, where no step can be relative
constexpr int kWheelAngleOfStep = 120; // eighths of a degree
constexpr double kStepsOfPage = 10.0;
constexpr int kMarginOfText = 4; // QLineEdit's own, left and right

quint64 nextSession()
{
    static quint64 last = 0;
    return ++last;
}

} // namespace

NumberField::NumberField(const QString &name, const QString &help, QWidget *parent)
    : QLineEdit(parent), m_help(help), m_session(nextSession())
{
    setAccessibleName(name);
    setAccessibleDescription(help);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    showText(shownText());
    connect(this, &QLineEdit::textEdited, this, [this] {
        m_tried.clear();
        if (!isTyping())
            setReason({});
        else if (isBad())
            emit retyped();
    });
}

base::Expected<double, base::ExpressionError> NumberField::typed() const
{
    if (!isTyping())
        return m_value;
    return base::evaluate(text().toStdString());
}

void NumberField::setValue(double value)
{
    const bool isSame = value == m_value || (std::isnan(value) && std::isnan(m_value));
    if (!isSame)
        accept(value);
}

void NumberField::accept(double value)
{
    const auto isSaid = [&] {
        const base::Expected<double, base::ExpressionError> said = base::evaluate(text().toStdString());
        return said && *said == value;
    };
    m_value = value;
    setReason({});
    // The zeros at the end of "12.40" stay while the hundredths are stepped.
    if (m_isStepping && hasFocus() && isSaid())
        m_shown = text();
    else
        showText(shownText());
}

void NumberField::commit()
{
    if (!isTyping())
        return;
    m_isStepping = false;
    m_session = nextSession();
    m_tried = text();
    emit committed();
}

void NumberField::commitUntried()
{
    if (isUntried())
        commit();
}

void NumberField::setReason(const QString &reason)
{
    if (reason == m_reason)
        return;
    const bool wasBad = isBad();
    m_reason = reason;
    setAccessibleDescription(isBad() ? reason : m_help);
    if (wasBad != isBad())
        setRefused(*this, isBad());
    emit reasonChanged();
}

void NumberField::restore()
{
    m_isStepping = false;
    m_tried.clear();
    setReason({});
    showText(shownText());
    if (hasFocus())
        selectNumber();
}

void NumberField::selectNumber()
{
    const int length = static_cast<int>(text().size());
    setSelection(length, -length);
}

void NumberField::showText(const QString &text)
{
    if (text != this->text())
        setText(text);
    m_shown = text;
    // A number that is too long is cut at its end, not at its sign.
    setCursorPosition(0);
}

int NumberField::roomForText() const
{
    QStyleOptionFrame option;
    initStyleOption(&option);
    return style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - kMarginOfText;
}

QString NumberField::shownText() const
{
    QString shown = writtenText(m_value);
    if (hasFocus())
        return shown;
    const int room = roomForText();
    // Fractional widths: over a dozen digits, rounding exceeds a pixel.
    const QFontMetricsF metrics(font());
    // Character by character: a number has no ligatures, and this runs while the camera moves.
    const auto fits = [&] {
        double width = 0.0;
        for (const QChar character : shown)
            width += metrics.horizontalAdvance(character);
        return width <= room;
    };
    const int mostThatFit = static_cast<int>(room / std::max(1.0, metrics.horizontalAdvance(u'0'))) + 1;
    for (int digits = std::clamp(mostThatFit, kFewestDigits, kMostDigits); !fits() && digits >= kFewestDigits; --digits)
        shown = writtenText(m_value, digits);
    return shown;
}

void NumberField::stepBy(double steps)
{
    const base::Expected<double, base::ExpressionError> from = typed();
    if (!from) {
        commit(); // shows the error
        return;
    }
    if (!std::exchange(m_isStepping, true))
        m_session = nextSession();
    if (!hasFocus() || selectedText() == text() || !stepDigit(steps))
        stepNumber(*from, steps);
    m_tried = text();
    if (isTyping())
        emit committed();
}

bool NumberField::stepDigit(double steps)
{
    const CaretText before{text(), cursorPosition()};
    const bool goesOn = m_stepped.text == before.text && m_stepped.caret == before.caret;
    const std::optional<int> place = goesOn ? m_stepped.place : digitAt(before);
    if (!place)
        return false;
    const CaretText after = withDigitStepped(before, *place, steps);
    setText(after.text);
    setCursorPosition(after.caret);
    m_stepped = {after.text, after.caret, *place};
    return true;
}

void NumberField::stepNumber(double from, double steps)
{
    const double magnitude = std::abs(from);
    double step = m_fixedStep > 0.0 ? m_fixedStep : kFirstStep;
    if (m_fixedStep == 0.0 && magnitude > 0.0) {
        const double place = std::pow(10.0, std::floor(std::log10(magnitude)));
        // Steps towards 0 from 1 are as from 0.9: 0 is never reached or passed.
        const bool isTowardsZero = steps * from < 0.0;
        const bool leavesPlace = isTowardsZero && magnitude - std::abs(steps) * place / 10.0 < place * (1.0 - 1e-9);
        step = leavesPlace ? place / 100.0 : place / 10.0;
    }
    // Fifteen digits: 0.1 + 0.2 is 0.3.
    const double stepped = QString::number(from + steps * step, 'g', 15).toDouble();
    setText(writtenText(std::abs(stepped) < step * 1e-9 ? 0.0 : stepped));
    if (hasFocus())
        selectNumber();
}

bool NumberField::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::ToolTip:
        // Created on demand: keeping it up to date would cost more than the text.
        setToolTip(
            plainToolTip((isBad() ? m_reason : writtenText(m_value)) + u'\n' + m_help)); // it repeats the typed text
        break;
    case QEvent::ShortcutOverride: {
        const auto &key = *static_cast<QKeyEvent *>(event);
        // Undo reverts pending text; otherwise it is the document's.
        const bool isHistory = key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
        if ((isHistory && !isTyping()) || (key.key() == Qt::Key_Escape && (isTyping() || isBad()))) {
            event->setAccepted(!isHistory);
            return event->isAccepted();
        }
        const bool isTaken = QLineEdit::event(event);
        if (!event->isAccepted())
            commitBeforeShortcut(key);
        return isTaken;
    }
    default: break;
    }
    return QLineEdit::event(event);
}

void NumberField::commitBeforeShortcut(const QKeyEvent &key)
{
    // Save includes pending text. AltGr, which is Ctrl and Alt, types characters.
    const Qt::KeyboardModifiers held = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    const bool isModifierItself = key.key() >= Qt::Key_Escape;
    if (held != Qt::NoModifier && held != (Qt::ControlModifier | Qt::AltModifier) && !isModifierItself)
        commitUntried();
}

void NumberField::focusInEvent(QFocusEvent *event)
{
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason)
        return;
    m_isStepping = false;
    if (!isTyping())
        showText(shownText());
    // A mouse press sets the caret itself.
    if (event->reason() != Qt::MouseFocusReason)
        selectNumber();
}

void NumberField::focusOutEvent(QFocusEvent *event)
{
    QLineEdit::focusOutEvent(event);
    const Qt::FocusReason reason = event->reason();
    if (reason == Qt::PopupFocusReason && m_opensMenu)
        return; // Copy, Paste: the user is still typing
    if (reason == Qt::ActiveWindowFocusReason) {
        // Another program leaves pending text; another window of this one commits it.
        QTimer::singleShot(0, this, [this, reason] {
            if (!hasFocus() && QApplication::activeWindow())
                commitLeft(reason);
        });
        return;
    }
    commitLeft(reason);
}

void NumberField::commitLeft(Qt::FocusReason reason)
{
    commitUntried();
    // A menu over the window keeps all digits visible.
    if (reason == Qt::PopupFocusReason)
        return;
    m_isStepping = false;
    if (isTyping())
        setCursorPosition(0);
    else
        showText(shownText());
}

void NumberField::contextMenuEvent(QContextMenuEvent *event)
{
    const QScopedValueRollback<bool> opens(m_opensMenu, true);
    QLineEdit::contextMenuEvent(event);
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    const double steps = event->modifiers() & Qt::ShiftModifier ? kStepsOfPage : 1.0;
    switch (event->key()) {
    case Qt::Key_Up: stepBy(steps); return;
    case Qt::Key_Down: stepBy(-steps); return;
    case Qt::Key_PageUp: stepBy(kStepsOfPage); return;
    case Qt::Key_PageDown: stepBy(-kStepsOfPage); return;
    case Qt::Key_Enter:
    case Qt::Key_Return:
        commit();
        if (!isBad())
            selectNumber();
        return;
    case Qt::Key_Escape:
        if (isTyping() || isBad())
            restore();
        else
            event->ignore();
        return;
    default: break;
    }
    if (!isTyping() && (event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo)))
        event->ignore();
    else
        QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    if (!hasFocus() && !(event->modifiers() & Qt::ControlModifier)) {
        event->ignore(); // the panel scrolls
        return;
    }
    const QPoint angle = event->angleDelta();
    m_wheelAngle += angle.y() != 0 ? angle.y() : angle.x(); // Shift turns the wheel sideways on some systems
    const int steps = m_wheelAngle / kWheelAngleOfStep;
    m_wheelAngle -= steps * kWheelAngleOfStep;
    if (steps != 0)
        stepBy(steps * (event->modifiers() & Qt::ShiftModifier ? kStepsOfPage : 1.0));
    event->accept();
}

void NumberField::resizeEvent(QResizeEvent *event)
{
    QLineEdit::resizeEvent(event);
    if (!hasFocus() && !isTyping())
        showText(shownText());
}

int NumberField::widthFor(const QString &number) const
{
    QStyleOptionFrame option;
    initStyleOption(&option);
    const int width = static_cast<int>(std::ceil(QFontMetricsF(font()).horizontalAdvance(number)));
    const QSize content(width + kMarginOfText, fontMetrics().height());
    return style()->sizeFromContents(QStyle::CT_LineEdit, &option, content, this).width();
}

QSize NumberField::sizeHint() const
{
    return {widthFor(QStringLiteral("888888888888")), QLineEdit::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const
{
    return {widthFor(QStringLiteral("-888888888")), QLineEdit::minimumSizeHint().height()};
}

} // namespace unprojector::gui
