#include "gui/panels/comparison_table.h"

#include "gui/panels/certain_digits_delegate.h"
#include "gui/panels/comparison_model.h"
#include "gui/panels/copy_menu.h"
#include "gui/panels/digits_font.h"
#include "gui/text/number_text.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr int kPadding = 8; ///< of a cell, both sides

/// Of the methods' columns: "-1.23456" and all that a double has.
constexpr int kLeastCharacters = 8;
constexpr int kMostCharacters = 19;
constexpr int kMostInFloat = 10; // "-0.0000000"

/// Room for the longest texts to expect, so that the columns stand still from click to click. The methods' columns take
/// what is left.
int charactersIn(int column)
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

} // namespace

ComparisonTable::ComparisonTable(ComparisonModel *model, QWidget *parent) : QTableView(parent), m_model(model)
{
    setModel(model);
    setItemDelegate(new CertainDigitsDelegate(this));
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setTextElideMode(Qt::ElideNone);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setColumnHidden(ComparisonModel::MatrixInFloat, true);
    setColumnHidden(ComparisonModel::FloatDifference, true);
    useFonts();
}

void ComparisonTable::useFonts()
{
    const QFont text = QApplication::font(this);
    setFont(digitsFont(text));
    const QFont heads = headsFont(text);
    horizontalHeader()->setFont(heads);
    verticalHeader()->setFont(heads);
    verticalHeader()->setDefaultSectionSize(std::max(fontMetrics().height(), QFontMetrics(heads).height()) + 4);
    // The names of a background's rows are longer than those of a surface's; room is for all of them.
    int longest = 0;
    for (const QString &name : ComparisonModel::pointNames())
        longest = std::max(longest, QFontMetrics(heads).horizontalAdvance(name + QStringLiteral(" x")));
    verticalHeader()->setFixedWidth(longest + 2 * kPadding);
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

int ComparisonTable::columnWidthFor(int column, int characters) const
{
    const int head =
        horizontalHeader()->fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal).toString());
    return std::max(characters * fontMetrics().horizontalAdvance(u'0'), head) + kPadding;
}

void ComparisonTable::fitColumns()
{
    const int available = width() - verticalHeader()->minimumWidth() - 2 * frameWidth();
    int others = 0;
    for (int column = 0; column < ComparisonModel::ColumnCount; ++column) {
        if (isElastic(column))
            continue;
        const int fitting = columnWidthFor(column, charactersIn(column));
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
        characters = std::min(characters, (columnWidth(column) - kPadding) / fontMetrics().horizontalAdvance(u'0'));
    }
    m_model->setCapacity(characters);
    const int shown = others + columnWidth(ComparisonModel::Formula) + columnWidth(ComparisonModel::Matrix);
    const int scrollBar = shown > available ? style()->pixelMetric(QStyle::PM_ScrollBarExtent) : 0;
    setFixedHeight(horizontalHeader()->sizeHint().height()
                   + m_model->rowCount() * verticalHeader()->defaultSectionSize() + 2 * frameWidth() + scrollBar);
}

QSize ComparisonTable::minimumSizeHint() const
{
    return {verticalHeader()->minimumWidth() + 2 * frameWidth()
                + columnWidthFor(ComparisonModel::Certain, charactersIn(ComparisonModel::Certain)),
            minimumHeight()};
}

void ComparisonTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

void ComparisonTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange)
        useFonts();
}

void ComparisonTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        if (const QString text = selectedText(); !text.isEmpty())
            copyToClipboard(text);
        return;
    }
    QTableView::keyPressEvent(event);
}

/// Of the cell under the pointer, or by the key of the current one.
void ComparisonTable::contextMenuEvent(QContextMenuEvent *event)
{
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = isByKey ? currentIndex() : indexAt(viewport()->mapFromGlobal(event->globalPos()));
    if (!index.isValid())
        return;
    const QVariant value = index.data(ComparisonModel::kValueRole);
    const QPoint place = isByKey ? viewport()->mapToGlobal(visualRect(index).center()) : event->globalPos();
    showCopyMenu(*this, place, {{}, value.isValid() ? std::vector{value.toDouble()} : std::vector<double>()},
                 {m_model->pointNameAt(index), m_model->pointAt(index)});
}

QString ComparisonTable::selectedText() const
{
    QModelIndexList selected = selectionModel()->selectedIndexes();
    std::sort(selected.begin(), selected.end());
    QString text;
    int row = -1;
    for (const QModelIndex &index : selected) {
        if (!text.isEmpty())
            text += index.row() == row ? u'\t' : u'\n';
        row = index.row();
        const QVariant value = index.data(ComparisonModel::kValueRole);
        text += value.isValid() ? shortestText(value.toDouble()) : index.data().toString();
    }
    return text;
}

} // namespace unprojector::gui
