#include "gui/landmarks/series_model.h"

#include "core/landmarks/name_key.h"
#include "gui/landmarks/protocol_rows.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace unprojector::gui {

SeriesModel::SeriesModel(ScanSeries &series, QObject *parent)
    : QAbstractTableModel(parent), m_series(series), m_names(series.landmarkNames()), m_measures(series.measures()),
      m_rows(static_cast<int>(series.scans().size()))
{
    connect(&m_series, &ScanSeries::changed, this, [this] {
        QStringList names = m_series.landmarkNames();
        const int rows = static_cast<int>(m_series.scans().size());
        if (names == m_names && rows == m_rows && m_measures == m_series.measures()) {
            if (rows > 0)
                emit dataChanged(index(0, 0), index(rows - 1, columnCount() - 1));
            return;
        }
        beginResetModel();
        m_names = std::move(names);
        m_measures = m_series.measures();
        m_rows = rows;
        endResetModel();
    });
}

int SeriesModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int SeriesModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : FirstLandmark + static_cast<int>(m_names.size() + m_measures.size());
}

const landmarks::KeptMeasure *SeriesModel::measureOf(int column) const
{
    const auto index = static_cast<std::size_t>(column - FirstLandmark) - static_cast<std::size_t>(m_names.size());
    return column >= FirstLandmark && index < m_measures.size() ? &m_measures[index] : nullptr;
}

QVariant SeriesModel::text(const QModelIndex &index) const
{
    const auto &scan = m_series.scans()[static_cast<std::size_t>(index.row())];
    if (index.column() == Scan)
        return pathText(scan.file.filename());
    if (index.column() == Placed)
        return scan.problem.isEmpty() ? m_series.progressText(scan) : tr("not read");
    if (const landmarks::KeptMeasure *measure = measureOf(index.column()))
        return protocolText(*measure, scan.points);
    const QString &name = m_names[index.column() - FirstLandmark];
    const auto &points = scan.points.landmarks;
    const auto found = std::find_if(points.begin(), points.end(), [&](const landmarks::Landmark &landmark) {
        const QString own = landmark.name.empty() ? QString::number(&landmark - points.data() + 1)
                                                  : QString::fromStdString(landmark.name);
        return landmarks::isSameName(own.toStdString(), name.toStdString());
    });
    if (found == points.end() || found->isToPlace())
        return QStringLiteral("–");
    return found->isPlaced() ? QStringLiteral("●") : QStringLiteral("×");
}

QVariant SeriesModel::data(const QModelIndex &index, int role) const
{
    // Another folder may have fewer scans before the rows are updated.
    if (!index.isValid() || static_cast<std::size_t>(index.row()) >= m_series.scans().size())
        return {};
    const auto &scan = m_series.scans()[static_cast<std::size_t>(index.row())];
    const bool isInView = m_series.inView() == static_cast<std::size_t>(index.row());
    switch (role) {
    case Qt::DisplayRole: return text(index);
    case Qt::ToolTipRole:
        if (const landmarks::KeptMeasure *measure = measureOf(index.column()))
            return plainToolTip(protocolTip(*measure, scan.points));
        return plainToolTip(scan.problem.isEmpty() ? pathText(scan.file) : pathText(scan.file) + u'\n' + scan.problem);
    case Qt::FontRole: {
        QFont font = QGuiApplication::font();
        font.setBold(isInView);
        return isInView ? QVariant(font) : QVariant();
    }
    case Qt::TextAlignmentRole: return index.column() >= FirstLandmark ? QVariant(Qt::AlignCenter) : QVariant();
    case Qt::ForegroundRole:
        return scan.placedCount() == 0 ? QVariant(QGuiApplication::palette().brush(QPalette::PlaceholderText))
                                       : QVariant();
    default: return {};
    }
}

QVariant SeriesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    if (section == Scan)
        return tr("Scan");
    if (section == Placed)
        return tr("Placed");
    if (const landmarks::KeptMeasure *measure = measureOf(section))
        return QString::fromStdString(measure->name);
    return m_names.value(section - FirstLandmark);
}

} // namespace unprojector::gui
