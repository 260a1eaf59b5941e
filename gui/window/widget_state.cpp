#include "gui/window/widget_state.h"

#include "gui/panels/matrix_section.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QSplitter>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// Those within a window, in the order in which they were made.
QList<QWidget *> partsOf(const QWidget &widget)
{
    QList<QWidget *> parts = widget.findChildren<QWidget *>(Qt::FindDirectChildrenOnly);
    parts.removeIf([](const QWidget *part) { return part->isWindow(); });
    return parts;
}

void takeOverOwn(QWidget &now, const QWidget &former)
{
    if (auto *button = qobject_cast<QAbstractButton *>(&now)) {
        if (button->isCheckable())
            button->setChecked(static_cast<const QAbstractButton &>(former).isChecked());
    } else if (auto *box = qobject_cast<QComboBox *>(&now)) {
        const auto &other = static_cast<const QComboBox &>(former);
        if (box->count() == other.count() && box->currentIndex() != other.currentIndex()) {
            box->setCurrentIndex(other.currentIndex());
            emit box->activated(box->currentIndex()); // as if somebody had chosen it
        }
    } else if (auto *field = qobject_cast<QLineEdit *>(&now)) {
        const QString text = static_cast<const QLineEdit &>(former).text();
        if (field->text() != text)
            field->setText(text);
    } else if (auto *splitter = qobject_cast<QSplitter *>(&now)) {
        splitter->restoreState(static_cast<const QSplitter &>(former).saveState());
    } else if (auto *section = qobject_cast<MatrixSection *>(&now)) {
        section->setOpen(static_cast<const MatrixSection &>(former).isOpen());
    }
}

} // namespace

void takeOverState(QWidget &now, const QWidget &former)
{
    if (now.metaObject() != former.metaObject())
        return;
    takeOverOwn(now, former);
    const QList<QWidget *> parts = partsOf(now), others = partsOf(former);
    for (qsizetype i = 0; i < std::min(parts.size(), others.size()); ++i)
        takeOverState(*parts[i], *others[i]);
}

} // namespace unprojector::gui
