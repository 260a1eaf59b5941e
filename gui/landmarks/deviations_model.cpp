#include "gui/landmarks/deviations_model.h"

#include "gui/text/number_text.h"
#include "gui/widgets/number_delegate.h"

#include <QFont>
#include <QGuiApplication>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;

void DeviationsModel::show(Deviations deviations, QStringList names, QStringList scans, std::vector<Pair> pairs)
{
    beginResetModel();
    m_deviations = std::move(deviations);
    m_names = std::move(names);
    m_scans = std::move(scans);
    m_pairs = std::move(pairs);
    endResetModel();
}

int DeviationsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_deviations.worstFirst.size());
}

QString DeviationsModel::outcomeOf(const Deviation &deviation) const
{
    if (!deviation.swappedWith)
        return deviation.isOutOfPlace ? tr("out of place") : QString();
    const Pair here{deviation.landmark, *deviation.swappedWith}, back{here.right, here.left};
    const bool isPair =
        std::any_of(m_pairs.begin(), m_pairs.end(), [&](const Pair &pair) { return pair == here || pair == back; });
    const auto &whole = m_deviations.swappedSpecimens;
    if (isPair && std::find(whole.begin(), whole.end(), deviation.specimen) != whole.end())
        return tr("left and right are swapped on the whole scan");
    return isPair ? tr("left and right are swapped") : tr("swapped with %1").arg(landmarkName(here.right));
}

QVariant DeviationsModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Deviation &deviation = at(index.row());
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) {
        switch (index.column()) {
        case Scan: return m_scans.value(static_cast<qsizetype>(deviation.specimen));
        case Landmark: return landmarkName(deviation.landmark);
        case Distance: return significantText(deviation.distance, 3);
        case Spreads: return fixedText(deviation.spreads(), 1);
        case Outcome: return outcomeOf(deviation);
        default: return {};
        }
    }
    if (role == NumberDelegate::kTextsRole && index.column() == Distance)
        return QStringList{significantText(deviation.distance, 3), significantText(deviation.distance, 2),
                           significantText(deviation.distance, 1)};
    if (role == NumberDelegate::kTextsRole && index.column() == Spreads)
        return QStringList{fixedText(deviation.spreads(), 1), fixedText(deviation.spreads(), 0)};
    if (role == Qt::TextAlignmentRole && (index.column() == Distance || index.column() == Spreads))
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::FontRole && deviation.isOutOfPlace) {
        QFont font = QGuiApplication::font();
        font.setBold(true);
        return font;
    }
    return {};
}

QVariant DeviationsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::ToolTipRole) {
        if (section == Distance)
            return tr("Distance from where the other scans put it, in units of the scan");
        if (section == Spreads)
            return tr("The same, divided by the usual distance of this landmark on the other scans");
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (section) {
    case Scan: return tr("Scan");
    case Landmark: return tr("Landmark");
    case Distance: return tr("Distance");
    case Spreads: return tr("Spreads");
    case Outcome: return tr("Result");
    default: return {};
    }
}

} // namespace unprojector::gui
