#include "gui/panels/parameters/number_field.h"

#include "gui/text/number_text.h"

#include <QApplication>
#include <QKeyEvent>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kMostDigits = 7;
constexpr int kFewestDigits = 3;
constexpr int kWheelAngleOfStep = 120; // eighths of a degree

quint64 nextSession()
{
    static quint64 last = 0;
    return ++last;
}

QPalette refusedPalette()
{
    // Mixed from the theme's own colours, so that it is readable on a dark one as well.
    QPalette palette = QApplication::palette();
    const QColor base = palette.color(QPalette::Base);
    const auto mixed = [](int from, int to) { return (from * 65 + to * 35) / 100; };
    palette.setColor(QPalette::Base, QColor(mixed(base.red(), 255), mixed(base.green(), 60), mixed(base.blue(), 60)));
    return palette;
}

} // namespace

std::optional<double> numberFromText(const QString &text)
{
    QString number = text.trimmed();
    number.replace(QChar(0x2212), u'-');
    if (number.count(u',') == 1 && !number.contains(u'.'))
        number.replace(u',', u'.');
    bool isNumber = false;
    const double value = number.toDouble(&isNumber);
    if (!isNumber)
        return std::nullopt;
    return value;
}

NumberField::NumberField(const QString &name, const QString &help, QWidget *parent)
    : QLineEdit(parent), m_help(help), m_session(nextSession())
{
    setAccessibleName(name);
    setAccessibleDescription(help);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    showText(shownText());
    connect(this, &QLineEdit::textEdited, this, &NumberField::edited);
    connect(this, &QLineEdit::returnPressed, this, &NumberField::entered);
}

void NumberField::setFixedStep(double step)
{
    m_step = Step::Fixed;
    m_fixedStep = step;
}

void NumberField::setValue(double value)
{
    const bool isSame = value == m_value || (std::isnan(value) && std::isnan(m_value));
    if (isBad() && isSame)
        return;
    m_value = value;
    setReason({});
    if (hasFocus() && typed() == value)
        return;
    const QString shown = shownText();
    if (shown != text())
        showText(shown);
}

void NumberField::setReason(const QString &reason)
{
    if (reason == m_reason)
        return;
    const bool wasBad = isBad();
    m_reason = reason;
    setAccessibleDescription(isBad() ? reason : m_help);
    if (wasBad != isBad())
        setPalette(isBad() ? refusedPalette() : QPalette());
    emit reasonChanged();
}

void NumberField::restore()
{
    setReason({});
    showText(shownText());
    if (hasFocus())
        selectAll();
}

void NumberField::showText(const QString &text)
{
    setText(text);
    // A number that is too long is cut at its end, not at its sign.
    setCursorPosition(0);
}

QString NumberField::shownText() const
{
    if (hasFocus())
        return shortestText(m_value == 0.0 ? 0.0 : m_value);
    QStyleOptionFrame option;
    initStyleOption(&option);
    const int room =
        style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - 4; // QLineEdit's own margins
    QString shown;
    for (int digits = kMostDigits; digits >= kFewestDigits; --digits) {
        shown = significantText(m_value, digits);
        if (!isVisible() || fontMetrics().horizontalAdvance(shown) <= room)
            break;
    }
    return shown;
}

void NumberField::stepBy(double steps)
{
    const double magnitude = std::abs(m_value);
    double step = m_fixedStep;
    if (m_step == Step::Relative && magnitude > 0.0 && std::isfinite(magnitude)) {
        const double place = std::pow(10.0, std::floor(std::log10(magnitude)));
        // Towards 0 the steps from 1 are those of 0.9: 0 is never reached, nor passed.
        const bool isTowardsZero = steps * m_value < 0.0;
        const bool leavesPlace = isTowardsZero && magnitude - std::abs(steps) * place / 10.0 < place * (1.0 - 1e-9);
        step = leavesPlace ? place / 100.0 : place / 10.0;
    }
    // Fifteen digits: 0.1 + 0.2 is 0.3.
    const double stepped = QString::number(m_value + steps * step, 'g', 15).toDouble();
    setText(shortestText(std::abs(stepped) < step * 1e-9 ? 0.0 : stepped));
    selectAll();
    emit edited();
}

bool NumberField::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::ToolTip:
        // Made when it is asked for: keeping it up to date would cost more than the text.
        setToolTip((isBad() ? m_reason : shortestText(m_value)) + u'\n' + m_help);
        break;
    case QEvent::ShortcutOverride:
        // Undo is the document's, not that of the characters typed; a refused text is not in the document.
        if (const auto *key = static_cast<QKeyEvent *>(event);
            key->matches(QKeySequence::Redo) || (key->matches(QKeySequence::Undo) && !isBad())) {
            event->ignore();
            return false;
        }
        break;
    default: break;
    }
    return QLineEdit::event(event);
}

void NumberField::focusInEvent(QFocusEvent *event)
{
    m_session = nextSession();
    if (!isBad()) {
        const QString all = shownText();
        if (all != text())
            setText(all);
    }
    QLineEdit::focusInEvent(event);
}

void NumberField::focusOutEvent(QFocusEvent *event)
{
    QLineEdit::focusOutEvent(event);
    if (!isBad() && !hasFocus())
        showText(shownText());
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    const double steps = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
    if (event->key() == Qt::Key_Up)
        stepBy(steps);
    else if (event->key() == Qt::Key_Down)
        stepBy(-steps);
    else if (isBad() && (event->key() == Qt::Key_Escape || event->matches(QKeySequence::Undo)))
        restore();
    else if (event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo))
        event->ignore();
    else
        QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    if (!hasFocus()) {
        event->ignore(); // the tab scrolls
        return;
    }
    const QPoint angle = event->angleDelta();
    m_wheelAngle += angle.y() != 0 ? angle.y() : angle.x(); // Shift turns the wheel sideways on some systems
    const int steps = m_wheelAngle / kWheelAngleOfStep;
    m_wheelAngle -= steps * kWheelAngleOfStep;
    if (steps != 0)
        stepBy(steps * (event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0));
    event->accept();
}

void NumberField::resizeEvent(QResizeEvent *event)
{
    QLineEdit::resizeEvent(event);
    if (!hasFocus() && !isBad())
        showText(shownText());
}

int NumberField::widthFor(int characters) const
{
    QStyleOptionFrame option;
    initStyleOption(&option);
    const QSize content(characters * fontMetrics().horizontalAdvance(u'0') + 4, fontMetrics().height());
    return style()->sizeFromContents(QStyle::CT_LineEdit, &option, content, this).width();
}

QSize NumberField::sizeHint() const
{
    return {widthFor(10), QLineEdit::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const
{
    return {widthFor(4), QLineEdit::minimumSizeHint().height()};
}

} // namespace unprojector::gui
