#include "gui/parameters/parameters_panel.h"

#include "gui/parameters/clip_group.h"
#include "gui/parameters/group_heading.h"
#include "gui/parameters/model_group.h"
#include "gui/parameters/projection_group.h"
#include "gui/parameters/view_group.h"
#include "gui/parameters/viewport_group.h"

#include <QEvent>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr char kStateName[] = "folded";
constexpr int kFewestLines = 8; // of text, in the least height

/// Appends the widgets that Tab reaches, in layout order.
void appendTabStops(const QLayout &layout, QWidgetList &stops)
{
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem *item = layout.itemAt(i);
        if (item->layout())
            appendTabStops(*item->layout(), stops);
        QWidget *widget = item->widget();
        if (!widget)
            continue;
        if (const auto *row = qobject_cast<const ParameterRow *>(widget))
            stops += row->tabStops();
        else if (widget->layout())
            appendTabStops(*widget->layout(), stops);
        else if (widget->focusPolicy() & Qt::TabFocus)
            stops << widget;
    }
}

} // namespace

ParametersPanel::ParametersPanel(SceneDocument &document, QWidget *parent) : QScrollArea(parent)
{
    auto *column = new QWidget;
    auto *layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Parameters"));
    setWidget(column);
    // The panel's own colour, not a list's.
    viewport()->setAutoFillBackground(false);
    column->setAutoFillBackground(false);

    addGroup(new ViewGroup(document), QStringLiteral("viewGroup"), true);
    addGroup(new ProjectionGroup(document), QStringLiteral("projectionGroup"), true);
    addGroup(new ViewportGroup(document), QStringLiteral("viewportGroup"), false);
    addGroup(new ModelGroup(document), QStringLiteral("modelGroup"), false);
    addGroup(new ClipGroup(document), QStringLiteral("clipGroup"), false);
    layout->addStretch();
    alignRows();
    orderTabs();
    connect(&document, &SceneDocument::opened, this, [this] {
        // Pending text for one scene must not apply to another.
        for (ParameterGroup *group : m_groups)
            group->restoreFields();
    });
}

void ParametersPanel::addGroup(ParameterGroup *group, const QString &objectName, bool isOpen)
{
    group->setObjectName(objectName);
    group->setOpen(isOpen);
    widget()->layout()->addWidget(group);
    const std::size_t index = m_groups.size();
    m_groups.push_back(group);
    connect(group, &ParameterGroup::rowsChanged, this, [this] {
        alignRows();
        orderTabs();
    });
    connect(group, &ParameterGroup::bringUpRequested, this, &ParametersPanel::bringUp);
    connect(&group->heading(), &GroupHeading::neighbourRequested, this, [this, index](int direction) {
        const auto next = static_cast<std::ptrdiff_t>(index) + direction;
        if (next < 0 || next >= static_cast<std::ptrdiff_t>(m_groups.size()))
            return;
        QWidget *heading = m_groups[static_cast<std::size_t>(next)]->heading().button();
        heading->setFocus(Qt::TabFocusReason);
        bringUp(heading);
    });
}

void ParametersPanel::alignRows()
{
    const QList<ParameterRow *> rows = findChildren<ParameterRow *>();
    ParameterRow::Columns columns;
    for (const ParameterRow *row : rows) {
        const ParameterRow::Columns own = row->ownColumns();
        columns.title = std::max(columns.title, own.title);
        columns.unit = std::max(columns.unit, own.unit);
    }
    for (ParameterRow *row : rows)
        row->setColumns(columns);
    int least = 0;
    for (const ParameterGroup *group : m_groups)
        least = std::max(least, group->leastWidth());
    widget()->setMinimumWidth(least);
    updateGeometry();
}

void ParametersPanel::orderTabs()
{
    QWidgetList stops;
    appendTabStops(*widget()->layout(), stops);
    for (int i = 1; i < stops.size(); ++i)
        setTabOrder(stops[i - 1], stops[i]);
}

void ParametersPanel::bringUp(QWidget *widget)
{
    ensureWidgetVisible(widget, 0, fontMetrics().height() / 2);
}

void ParametersPanel::applyTyped()
{
    for (ParameterGroup *group : m_groups)
        group->applyTyped();
}

QByteArray ParametersPanel::saveState() const
{
    QByteArray state = kStateName;
    for (const ParameterGroup *group : m_groups) {
        if (!group->isOpen())
            state += ' ' + group->objectName().toLatin1();
    }
    return state;
}

bool ParametersPanel::restoreState(const QByteArray &state)
{
    const QList<QByteArray> words = state.split(' ');
    if (words.constFirst() != kStateName)
        return false;
    for (ParameterGroup *group : m_groups)
        group->setOpen(!words.contains(group->objectName().toLatin1()));
    return true;
}

QSize ParametersPanel::minimumSizeHint() const
{
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {widget()->minimumWidth() + bar + 2 * frameWidth(), kFewestLines * fontMetrics().lineSpacing()};
}

QSize ParametersPanel::sizeHint() const
{
    return {minimumSizeHint().width(), widget()->sizeHint().height()};
}

void ParametersPanel::changeEvent(QEvent *event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        alignRows();
}

} // namespace unprojector::gui
