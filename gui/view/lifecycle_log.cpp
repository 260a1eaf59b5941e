#include "gui/view/lifecycle_log.h"

#include "gui/text/number_text.h"

#include <QStringList>

#include <utility>

namespace unprojector::gui {
namespace {

using Kind = LifecycleEvent::Kind;

/// The names of the paper's MFC view, which are not translated, and the parameters.
QString nameOf(Kind kind)
{
    switch (kind) {
    case Kind::PreCreateWindow: return QStringLiteral("PreCreateWindow");
    case Kind::OnCreate: return QStringLiteral("OnCreate");
    case Kind::OnSize: return QStringLiteral("OnSize");
    case Kind::OnDraw: return QStringLiteral("OnDraw");
    case Kind::OnLButtonDown: return QStringLiteral("OnLButtonDown");
    case Kind::OnDestroy: return QStringLiteral("OnDestroy");
    case Kind::Viewport: return LifecycleLog::tr("Viewport");
    case Kind::Projection: return LifecycleLog::tr("Projection");
    case Kind::Camera: break;
    }
    return LifecycleLog::tr("Camera");
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

LifecycleLog::LifecycleLog(QObject *parent) : QAbstractItemModel(parent) {}

void LifecycleLog::append(const LifecycleEvent &event)
{
    if (!m_clock.isValid())
        m_clock.start();
    const double now = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
    if (rowCount() == kMostRows) {
        beginRemoveRows({}, 0, 0);
        m_rows.pop_front();
        ++m_gone;
        endRemoveRows();
    }
    Row row;
    row.steps.push_back({event, now});
    row.firstSeconds = now;
    row.standIns = event.hasStandIns ? 1 : 0;
    row.totalMilliseconds = event.milliseconds;
    beginInsertRows({}, rowCount(), rowCount());
    m_rows.push_back(std::move(row));
    endInsertRows();
    if (event.kind == Kind::OnDraw)
        fold();
}

void LifecycleLog::fold()
{
    const int end = rowCount();
    int first = end - 1; // of this frame
    while (first > 0 && m_rows[std::size_t(first - 1)].event().isParameter())
        --first;
    const int steps = end - first;
    if (first < steps)
        return;
    for (int i = first; i < end; ++i) {
        if (m_rows[std::size_t(i)].event().kind != m_rows[std::size_t(i - steps)].event().kind)
            return;
    }
    std::deque<Happened> repeated;
    for (int i = first; i < end; ++i)
        repeated.push_back(m_rows[std::size_t(i)].steps.back());
    beginRemoveRows({}, first, end - 1);
    m_rows.resize(std::size_t(first));
    endRemoveRows();
    for (int i = 0; i < steps; ++i)
        foldInto(first - steps + i, repeated[std::size_t(i)]);
}

void LifecycleLog::foldInto(int row, const Happened &step)
{
    Row &into = m_rows[std::size_t(row)];
    const QModelIndex folded = index(row, 0);
    const int kept = int(into.steps.size());
    if (kept == kMostRepeats) {
        beginRemoveRows(folded, 0, 0);
        into.steps.pop_front();
        endRemoveRows();
    }
    const int behind = int(into.steps.size());
    beginInsertRows(folded, kept == 1 ? 0 : behind, behind); // the first becomes a child with the second
    into.steps.push_back(step);
    endInsertRows();
    ++into.count;
    into.standIns += step.event.hasStandIns ? 1 : 0;
    into.totalMilliseconds += step.event.milliseconds;
    emit dataChanged(folded, index(row, ColumnCount - 1));
}

void LifecycleLog::clear()
{
    beginResetModel();
    m_gone += m_rows.size();
    m_rows.clear();
    endResetModel();
}

QString LifecycleLog::text(int first, int last) const
{
    QString text;
    for (int row = first; row <= last; ++row)
        text += this->text(index(row, 0));
    return text;
}

QString LifecycleLog::text(const QModelIndex &index) const
{
    QStringList cells;
    for (int column = 0; column < ColumnCount; ++column)
        cells << index.siblingAtColumn(column).data().toString();
    return cells.join(u'\t') + u'\n';
}

QModelIndex LifecycleLog::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? m_gone + quintptr(parent.row()) + 1 : quintptr(0));
}

QModelIndex LifecycleLog::parent(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() <= m_gone)
        return {};
    return createIndex(int(index.internalId() - m_gone - 1), 0, quintptr(0));
}

int LifecycleLog::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return int(m_rows.size());
    const bool isRow = parent.internalId() == 0 && parent.column() == 0 && parent.row() < int(m_rows.size());
    const std::size_t steps = isRow ? m_rows[std::size_t(parent.row())].steps.size() : 0;
    return steps > 1 ? int(steps) : 0;
}

int LifecycleLog::columnCount(const QModelIndex &) const
{
    return ColumnCount;
}

const LifecycleLog::Row &LifecycleLog::rowOf(const QModelIndex &index) const
{
    const QModelIndex folded = parent(index);
    return m_rows[std::size_t(folded.isValid() ? folded.row() : index.row())];
}

QVariant LifecycleLog::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return alignment(index.column());
    if (role == Qt::ToolTipRole)
        return toolTip(index);
    if (role != Qt::DisplayRole)
        return {};
    const Row &row = rowOf(index);
    const bool isStep = parent(index).isValid();
    const Happened &step = isStep ? row.steps[std::size_t(index.row())] : row.steps.back();
    switch (index.column()) {
    case Time: return tr("%1 s").arg(secondsText(isStep ? step.seconds : row.firstSeconds));
    case Step: return stepText(index);
    case StandsFor: return callsText(index);
    default: break;
    }
    // The surface format is set before there is anything to time.
    if (step.event.kind == Kind::PreCreateWindow || step.event.isParameter())
        return QStringLiteral("–");
    return tr("%1 ms").arg(millisecondsText(step.event.milliseconds));
}

QString LifecycleLog::stepText(const QModelIndex &index) const
{
    const Row &row = rowOf(index);
    const bool isFolded = row.count > 1 && !parent(index).isValid();
    const LifecycleEvent &event = row.event();
    if (event.kind == Kind::OnDraw || event.isParameter())
        return isFolded ? QStringLiteral("%1 × %2").arg(nameOf(event.kind)).arg(row.count) : nameOf(event.kind);
    return QStringLiteral("%1(%2)").arg(nameOf(event.kind), event.arguments);
}

QString LifecycleLog::callsText(const QModelIndex &index) const
{
    const Row &row = rowOf(index);
    const bool isStep = parent(index).isValid();
    const LifecycleEvent &event = isStep ? row.steps[std::size_t(index.row())].event : row.event();
    if (isStep ? event.hasStandIns : row.count == 1 && row.standIns > 0)
        return tr("%1; large models were drawn coarsely").arg(event.calls);
    if (!isStep && row.standIns > 0)
        return tr("%1; in %2 of %3 frames large models were drawn coarsely")
            .arg(event.calls)
            .arg(row.standIns)
            .arg(row.count);
    return event.calls;
}

QString LifecycleLog::toolTip(const QModelIndex &index) const
{
    const Row &row = rowOf(index);
    const bool isFolded = row.count > 1 && !parent(index).isValid();
    const QString text = index.data().toString();
    switch (index.column()) {
    case Time:
        return isFolded
                   ? tr("From %1 s to %2 s").arg(secondsText(row.firstSeconds), secondsText(row.steps.back().seconds))
                   : text;
    case Step: return text + u'\n' + headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString();
    case StandsFor:
        return row.standIns == 0 ? text
                                 : text + u'\n'
                                       + tr("While the view moves, large models are drawn coarsely. Clicks always read "
                                            "the full model.");
    default: break;
    }
    return isFolded && !row.event().isParameter() ? tr("The last of %1. Mean: %2 ms")
                                                        .arg(row.count)
                                                        .arg(millisecondsText(row.totalMilliseconds / row.count))
                                                  : text;
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
        case StandsFor: return tr("OpenGL calls");
        case Took: return tr("Took");
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Time: return tr("Seconds since the view's first step; a folded row shows its first step");
        case Step:
            return tr("Name of the step in Weng et al. 2008 with its arguments, or the changed parameter. Sizes are in "
                      "device pixels, positions in logical pixels from the top-left corner");
        case StandsFor: return tr("OpenGL calls of the step, or the call that takes the parameter");
        case Took: return tr("Duration of the step in milliseconds; a folded row shows its last step");
        }
    }
    return {};
}

} // namespace unprojector::gui
