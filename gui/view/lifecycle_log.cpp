#include "gui/view/lifecycle_log.h"

#include "gui/text/number_text.h"

#include <QStringList>

namespace unprojector::gui {
namespace {

using Kind = LifecycleEvent::Kind;

/// The names of the paper's MFC view: they are not translated.
QString nameOf(Kind kind)
{
    switch (kind) {
    case Kind::PreCreateWindow: return QStringLiteral("PreCreateWindow");
    case Kind::OnCreate: return QStringLiteral("OnCreate");
    case Kind::OnSize: return QStringLiteral("OnSize");
    case Kind::OnDraw: return QStringLiteral("OnDraw");
    case Kind::OnLButtonDown: return QStringLiteral("OnLButtonDown");
    case Kind::OnDestroy: return QStringLiteral("OnDestroy");
    }
    return {};
}

QString millisecondsText(double milliseconds)
{
    return fixedText(milliseconds, 2);
}

QString secondsText(double seconds)
{
    return fixedText(seconds, 3);
}

QVariant alignment(int column)
{
    const bool isNumber = column == LifecycleLog::Time || column == LifecycleLog::Took;
    return QVariant(Qt::Alignment(Qt::AlignVCenter | (isNumber ? Qt::AlignRight : Qt::AlignLeft)));
}

} // namespace

LifecycleLog::LifecycleLog(QObject *parent) : QAbstractTableModel(parent) {}

void LifecycleLog::append(const LifecycleEvent &event)
{
    if (!m_clock.isValid())
        m_clock.start();
    const double now = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;

    if (event.kind == Kind::OnDraw && !m_rows.empty() && m_rows.back().event.kind == Kind::OnDraw) {
        Row &row = m_rows.back();
        row.event = event;
        row.lastSeconds = now;
        ++row.count;
        row.standIns += event.hasStandIns ? 1 : 0;
        row.totalMilliseconds += event.milliseconds;
        const int last = rowCount() - 1;
        emit dataChanged(index(last, 0), index(last, ColumnCount - 1));
        return;
    }
    if (rowCount() == kMostRows) {
        beginRemoveRows({}, 0, 0);
        m_rows.pop_front();
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    m_rows.push_back({event, now, now, 1, event.hasStandIns ? 1 : 0, event.milliseconds});
    endInsertRows();
}

void LifecycleLog::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

QString LifecycleLog::text(int first, int last) const
{
    QString text;
    for (int row = first; row <= last; ++row) {
        QStringList cells;
        for (int column = 0; column < ColumnCount; ++column)
            cells << index(row, column).data().toString();
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

int LifecycleLog::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int LifecycleLog::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LifecycleLog::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return alignment(index.column());
    if (role == Qt::ToolTipRole && index.column() == Time && row.count > 1)
        return tr("From %1 s to %2 s").arg(secondsText(row.firstSeconds), secondsText(row.lastSeconds));
    if (role == Qt::ToolTipRole && index.column() == Step)
        return index.data().toString() + u'\n' + headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString();
    if (role == Qt::ToolTipRole && index.column() == StandsFor && row.standIns > 0)
        return index.data().toString() + u'\n'
               + tr("While the view moves, large models are shown by coarse ones that stand in for them. Clicks always "
                    "read the full model.");
    if (role == Qt::ToolTipRole && index.column() == StandsFor)
        return row.event.calls;
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Time: return tr("%1 s").arg(secondsText(row.firstSeconds));
    case Step:
        if (row.event.kind == Kind::OnDraw)
            return row.count > 1 ? QStringLiteral("OnDraw × %1").arg(row.count) : nameOf(row.event.kind);
        return QStringLiteral("%1(%2)").arg(nameOf(row.event.kind), row.event.arguments);
    case StandsFor:
        if (row.standIns > 0)
            return row.count > 1 ? tr("%1; in %2 of %3 pictures large models were drawn coarse")
                                       .arg(row.event.calls)
                                       .arg(row.standIns)
                                       .arg(row.count)
                                 : tr("%1; large models were drawn coarse").arg(row.event.calls);
        return row.event.calls;
    case Took:
        // The surface format is set before there is anything to time.
        if (row.event.kind == Kind::PreCreateWindow)
            return QStringLiteral("–");
        if (row.count > 1) {
            return tr("%1 ms, mean %2 ms")
                .arg(millisecondsText(row.event.milliseconds), millisecondsText(row.totalMilliseconds / row.count));
        }
        return tr("%1 ms").arg(millisecondsText(row.event.milliseconds));
    }
    return {};
}

QVariant LifecycleLog::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return alignment(section);
    if (role == Qt::DisplayRole) {
        switch (section) {
        case Time: return tr("Time");
        case Step: return tr("Step");
        case StandsFor: return tr("Stands for");
        case Took: return tr("Took");
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Time: return tr("Seconds since the view's first step; of pictures in a row, when the first was drawn");
        case Step:
            return tr("The step under its name in Weng et al. 2008, with its arguments: sizes in device pixels, "
                      "positions in logical pixels from the top-left corner");
        case StandsFor: return tr("The OpenGL calls that the step makes");
        case Took: return tr("Milliseconds of the step; of pictures in a row, the last and the mean");
        }
    }
    return {};
}

} // namespace unprojector::gui
