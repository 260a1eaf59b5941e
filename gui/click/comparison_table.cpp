#include "gui/click/comparison_table.h"

#include "gui/click/comparison_model.h"

#include <algorithm>

namespace unprojector::gui {
namespace {

/// Of the methods' columns: "-1.23456" and all that a double has.
constexpr int kLeastCharacters = 8;
constexpr int kMostCharacters = 19;
constexpr int kMostInFloat = 10; // "-0.0000000"

/// Room for the longest texts to expect, so that the columns stand still from click to click. The methods' columns take
/// what is left.
int charactersOf(int column)
{
    switch (column) {
    case ComparisonModel::Certain: return ComparisonModel::kCertainRoom;
    case ComparisonModel::Ulps: return 6; // "-88888"
    default: return 8;                    // "-8.8e-16"
    }
}

bool isElastic(int column)
{
    return column == ComparisonModel::Formula || column == ComparisonModel::Matrix
           || column == ComparisonModel::MatrixInFloat;
}

/// The names of a background's rows are longer than those of a surface's.
QStringList rowNames()
{
    QStringList names = ComparisonModel::pointNames();
    for (QString &name : names)
        name += QStringLiteral(" x");
    return names;
}

} // namespace

ComparisonTable::ComparisonTable(ComparisonModel *model, QWidget *parent)
    : CoordinatesTable(model, rowNames(), parent), m_model(model)
{
    setColumnHidden(ComparisonModel::MatrixInFloat, true);
    setColumnHidden(ComparisonModel::FloatDifference, true);
    fitColumns();
}

bool ComparisonTable::showsFloat() const
{
    return !isColumnHidden(ComparisonModel::MatrixInFloat);
}

void ComparisonTable::setShowsFloat(bool shows)
{
    // In the place of the difference between the methods, which is nothing beside what float is off by: there is room for
    // one of them, without a scroll bar.
    setColumnHidden(ComparisonModel::Difference, shows);
    setColumnHidden(ComparisonModel::Ulps, shows);
    setColumnHidden(ComparisonModel::MatrixInFloat, !shows);
    setColumnHidden(ComparisonModel::FloatDifference, !shows);
    fitColumns();
}

int ComparisonTable::leastWidth() const
{
    const auto widthOf = [this](int column) {
        return columnWidthFor(column, isElastic(column) ? kLeastCharacters : charactersOf(column));
    };
    return widthOf(ComparisonModel::Certain) + widthOf(ComparisonModel::Formula) + widthOf(ComparisonModel::Matrix)
           + std::max(widthOf(ComparisonModel::Difference) + widthOf(ComparisonModel::Ulps),
                      widthOf(ComparisonModel::MatrixInFloat) + widthOf(ComparisonModel::FloatDifference));
}

void ComparisonTable::shareWidth(int available)
{
    int others = 0;
    for (int column = 0; column < ComparisonModel::ColumnCount; ++column) {
        if (isElastic(column))
            continue;
        const int fitting = columnWidthFor(column, charactersOf(column));
        setColumnWidth(column, fitting);
        others += isColumnHidden(column) ? 0 : fitting;
    }
    if (showsFloat()) { // it has fewer digits to show than the others, and never more room
        const int inFloat =
            std::clamp((available - others) / 3, columnWidthFor(ComparisonModel::MatrixInFloat, kLeastCharacters),
                       columnWidthFor(ComparisonModel::MatrixInFloat, kMostInFloat));
        setColumnWidth(ComparisonModel::MatrixInFloat, inFloat);
        others += inFloat;
    }
    int characters = kMostCharacters;
    for (const int column : {ComparisonModel::Formula, ComparisonModel::Matrix}) {
        const int least = columnWidthFor(column, kLeastCharacters);
        const int most = columnWidthFor(column, kMostCharacters);
        setColumnWidth(column, std::clamp((available - others) / 2, least, most));
        characters = std::min(characters, charactersIn(column));
    }
    m_model->setCapacity(characters);
}

} // namespace unprojector::gui
