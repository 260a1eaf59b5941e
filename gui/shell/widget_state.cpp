#include "gui/shell/widget_state.h"

#include "gui/parameters/parameter_group.h"
#include "gui/pipeline/matrix_section.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QHash>
#include <QLineEdit>
#include <QPointer>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QtDebug>

#include <map>
#include <utility>
#include <vector>

namespace unprojector::gui {
namespace {

/// Its name, or its class and a number among those of the class.
using PartKey = std::pair<QString, int>;

/// Those within a window, in the order in which they were made.
std::vector<std::pair<PartKey, QPointer<QWidget>>> partsOf(const QWidget &widget)
{
    std::vector<std::pair<PartKey, QPointer<QWidget>>> parts;
    QHash<QString, int> counts;
    for (QWidget *part : widget.findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        if (part->isWindow())
            continue;
        const QString name =
            part->objectName().isEmpty() ? QString::fromLatin1(part->metaObject()->className()) : part->objectName();
        parts.emplace_back(PartKey(name, counts[name]++), part);
    }
    return parts;
}

bool canBeSet(const QWidget &part)
{
    const auto *button = qobject_cast<const QAbstractButton *>(&part);
    return (button && button->isCheckable()) || qobject_cast<const QComboBox *>(&part)
           || qobject_cast<const QLineEdit *>(&part) || qobject_cast<const QSpinBox *>(&part)
           || qobject_cast<const QSlider *>(&part) || qobject_cast<const QSplitter *>(&part)
           || qobject_cast<const MatrixSection *>(&part);
}

void warnOf(const PartKey &key, const QWidget &whole)
{
    qWarning("Part %s %d of a %s has no counterpart that could take over its state.", qPrintable(key.first), key.second,
             whole.metaObject()->className());
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
    } else if (auto *number = qobject_cast<QSpinBox *>(&now)) {
        number->setValue(static_cast<const QSpinBox &>(former).value());
    } else if (auto *slider = qobject_cast<QSlider *>(&now)) {
        const auto &other = static_cast<const QSlider &>(former);
        if (slider->minimum() == other.minimum() && slider->maximum() == other.maximum())
            slider->setValue(other.value());
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
    // What it has says what the document once said, which is not to be said again.
    if (const auto *group = qobject_cast<const ParameterGroup *>(&former); group && group->isStale())
        return;
    takeOverOwn(now, former);
    if (qobject_cast<const QSpinBox *>(&now) || qobject_cast<const QComboBox *>(&now))
        return; // their parts are Qt's matter
    const auto formerParts = partsOf(former);
    std::map<PartKey, QPointer<QWidget>> others(formerParts.begin(), formerParts.end());
    for (const auto &[key, part] : partsOf(now)) {
        if (!part)
            continue; // what was set before it has taken it away
        const auto other = others.find(key);
        if (other != others.end()) {
            if (other->second)
                takeOverState(*part, *other->second);
            others.erase(other);
        } else if (canBeSet(*part)) {
            warnOf(key, now);
        }
    }
    for (const auto &[key, other] : others) {
        if (other && canBeSet(*other))
            warnOf(key, former);
    }
}

} // namespace unprojector::gui
