#include "tests/gui/cut_texts.h"

#include "gui/widgets/elided_label.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStyleOptionFrame>
#include <QTextDocument>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
namespace {

QString nameOf(const QWidget &widget)
{
    for (const QString &name : {widget.accessibleName(), widget.objectName()}) {
        if (!name.isEmpty())
            return name;
    }
    return QString::fromLatin1(widget.metaObject()->className());
}

/// The size that a widget's text needs, and the room that it has.
struct Text {
    QString text;
    QSize needed;
    QSize room;
};

Text textOf(const QLabel &label)
{
    const QSize room = label.contentsRect().size();
    if (label.textFormat() == Qt::RichText
        || (label.textFormat() == Qt::AutoText && Qt::mightBeRichText(label.text()))) {
        QTextDocument set;
        set.setDocumentMargin(0.0);
        set.setDefaultFont(label.font());
        set.setHtml(label.text());
        set.setTextWidth(room.width());
        return {set.toPlainText(), set.size().toSize(), room};
    }
    const int flags = Qt::TextShowMnemonic | (label.wordWrap() ? Qt::TextWordWrap : 0);
    return {label.text(), label.fontMetrics().boundingRect(QRect(QPoint(), room), flags, label.text()).size(), room};
}

Text textOf(const QLineEdit &field)
{
    QStyleOptionFrame option;
    option.initFrom(&field);
    option.lineWidth = field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field);
    const QRect inside = field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field);
    return {field.text(), {field.fontMetrics().horizontalAdvance(field.text()), 0}, inside.size()};
}

Text textOf(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.currentText = box.currentText();
    const QRect inside = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return {box.currentText(), {box.fontMetrics().horizontalAdvance(box.currentText()), 0}, inside.size()};
}

/// A style asks for more than a short text needs.
Text textOf(const QAbstractButton &button)
{
    QSize needed = button.sizeHint();
    const int margin = button.style()->pixelMetric(QStyle::PM_ButtonMargin, nullptr, &button);
    const auto *tool = qobject_cast<const QToolButton *>(&button);
    const bool isText =
        qobject_cast<const QPushButton *>(&button) || (tool && tool->arrowType() == Qt::NoArrow && !tool->menu());
    if (isText && button.icon().isNull())
        needed.setWidth(button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width() + margin);
    return {button.text(), needed, button.size()};
}

Text textOf(const QWidget &widget)
{
    if (qobject_cast<const ElidedLabel *>(&widget))
        return {};
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return textOf(*label);
    if (const auto *field = qobject_cast<const QLineEdit *>(&widget); field && !field->hasFocus())
        return textOf(*field);
    if (const auto *box = qobject_cast<const QComboBox *>(&widget))
        return textOf(*box);
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        return textOf(*button);
    return {};
}

} // namespace

QStringList cutTexts(const QWidget &widget)
{
    QStringList found;
    for (const QWidget *child : widget.findChildren<QWidget *>()) {
        if (!child->isVisible() || qobject_cast<const QScrollBar *>(child))
            continue;
        const Text text = textOf(*child);
        constexpr int kAboveLetters = 1; // a line is higher than its letters by that much at least
        if (!text.text.isEmpty()
            && (text.needed.width() > text.room.width() || text.needed.height() > text.room.height() + kAboveLetters))
            found << QStringLiteral("“%1” (%2) needs %3 x %4 of %5 x %6")
                         .arg(text.text, nameOf(*child))
                         .arg(text.needed.width())
                         .arg(text.needed.height())
                         .arg(text.room.width())
                         .arg(text.room.height());
        const QWidget *parent = child->parentWidget();
        if (child->isWindow() || qobject_cast<const QAbstractScrollArea *>(parent))
            continue;
        const bool isScrolled = qobject_cast<const QAbstractScrollArea *>(parent->parentWidget()) != nullptr;
        const QRect place = child->geometry(), room = parent->rect();
        if (place.left() < room.left() || place.right() > room.right()
            || (!isScrolled && (place.top() < room.top() || place.bottom() > room.bottom())))
            found << QStringLiteral("%1 sticks out of its parent").arg(nameOf(*child));
        for (const QObject *other : parent->children()) {
            const auto *sibling = qobject_cast<const QWidget *>(other);
            if (sibling && sibling != child && sibling->isVisible() && sibling->geometry().intersects(place))
                found << QStringLiteral("%1 lies on %2").arg(nameOf(*child), nameOf(*sibling));
        }
    }
    return found;
}

} // namespace unprojector::gui
