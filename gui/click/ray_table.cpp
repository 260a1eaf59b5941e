#include "gui/click/ray_table.h"

#include "gui/click/ray_model.h"

#include <QHeaderView>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr int kLeastCharacters = 8; // "-1.23456", "-8.8e-16", "-0.12345"
constexpr int kMostCharacters = 19; // all that a double has

} // namespace

RayTable::RayTable(RayModel *model, QWidget *parent)
    : CoordinatesTable(model, RayModel::rowNames(), parent), m_model(model)
{
    fitColumns();
}

int RayTable::leastWidthOf(int column) const
{
    int least = columnWidthFor(column, kLeastCharacters);
    if (column == RayModel::Taken) { // whatever it is called
        for (const QString &name : RayModel::takenNames())
            least = std::max(least, horizontalHeader()->fontMetrics().horizontalAdvance(name) + kPadding);
    }
    return least;
}

int RayTable::leastWidth() const
{
    int least = 0;
    for (int column = 0; column < RayModel::ColumnCount; ++column)
        least += leastWidthOf(column);
    return least;
}

void RayTable::shareWidth(int available)
{
    int others = 0;
    for (const int column : {RayModel::OffBy, RayModel::Normal}) {
        const int fitting = leastWidthOf(column);
        setColumnWidth(column, fitting);
        others += fitting;
    }
    int characters = kMostCharacters;
    for (const int column : {RayModel::Met, RayModel::Taken}) {
        const int least = leastWidthOf(column);
        const int most = std::max(columnWidthFor(column, kMostCharacters), least);
        setColumnWidth(column, std::clamp((available - others) / 2, least, most));
        characters = std::min(characters, charactersIn(column));
    }
    m_model->setCapacity(characters);
}

} // namespace unprojector::gui
