#include "gui/click/earlier_picks_view.h"

#include "gui/click/pick_rows.h"
#include "gui/document/scene_document.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/whole_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

enum Column { Object, Coordinate, Pixel, ColumnCount };

} // namespace

EarlierPicksView::EarlierPicksView(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_history(new PickHistory(document, this)),
      m_table(new WholeTable(0, ColumnCount)), m_difference(new QLabel)
{
    m_table->setAccessibleName(tr("Picks of this scene"));
    m_table->setToolTip(tr("Click a row to show that pick again. Ctrl + click a second row to compare the two"));
    m_table->setHorizontalHeaderLabels({tr("Object"), tr("World coordinate"), tr("Pixel")});
    m_table->horizontalHeaderItem(Coordinate)->setToolTip(tr("To the last certain digit; world units"));
    m_table->horizontalHeaderItem(Pixel)->setToolTip(
        tr("Column and row from the top-left corner of the framebuffer, in device pixels"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_difference->setTextFormat(Qt::PlainText);
    m_difference->setWordWrap(true);
    m_difference->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_difference->setAccessibleName(tr("Differences of two picks"));

    auto *menu = new QMenu(this);
    menu->addAction(tr("Copy as &text"), this,
                    [this] { copyToClipboard(pickRowsText(m_picks, m_document.objects())); });
    menu->addAction(tr("Copy as &CSV"), this, [this] { copyToClipboard(pickRowsCsv(m_picks, m_document.objects())); });
    auto *copy = new QToolButton;
    copy->setText(tr("Copy all"));
    copy->setToolTip(tr("Copy all picks: as text as they are shown, as CSV with all digits"));
    copy->setAutoRaise(true);
    copy->setPopupMode(QToolButton::InstantPopup);
    copy->setMenu(menu);
    auto *line = new QHBoxLayout;
    line->addStretch();
    line->addWidget(copy);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(line);
    layout->addWidget(m_table);
    layout->addWidget(m_difference);
    connect(m_history, &PickHistory::changed, this, &EarlierPicksView::showRows);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &EarlierPicksView::followSelection);
    connect(m_table, &QTableWidget::customContextMenuRequested, this, &EarlierPicksView::showMenu);
    showRows();
}

QString EarlierPicksView::difference() const
{
    return m_difference->text();
}

void EarlierPicksView::showRows()
{
    const bool isOtherShown = std::exchange(m_shown, m_history->shownNumber()) != m_history->shownNumber();
    std::vector<int> wanted = selected();
    m_picks = m_history->picks();
    std::reverse(m_picks.begin(), m_picks.end());
    if (isOtherShown || wanted.size() < 2)
        wanted = {m_shown};
    {
        const QScopedValueRollback filling(m_isFilling, true);
        m_table->setRowCount(static_cast<int>(m_picks.size()));
        for (int row = 0; row < m_table->rowCount(); ++row)
            setRow(row);
        select(wanted);
    }
    m_table->fit();
    showDifference();
    emit filled(!m_picks.empty());
}

void EarlierPicksView::setRow(int row)
{
    const EarlierPick &earlier = m_picks[static_cast<std::size_t>(row)];
    const auto [object, coordinate, pixel] = pickRow(earlier, m_document.objects());
    constexpr int kMostDigits = 14; // of the object's name, so that the coordinate stays in sight
    const int width = kMostDigits * m_table->fontMetrics().horizontalAdvance(u'0');
    const bool isShown = earlier.number == m_shown;
    const auto set = [&](int column, const QString &text, const QString &toolTip) {
        if (!m_table->item(row, column))
            m_table->setItem(row, column, new QTableWidgetItem);
        m_table->item(row, column)->setText(text);
        m_table->item(row, column)->setToolTip(toolTip);
    };
    set(Object, m_table->fontMetrics().elidedText(object, Qt::ElideMiddle, width), object);
    set(Coordinate, coordinate.isEmpty() ? QStringLiteral("–") : coordinate, {});
    set(Pixel, pixel, {});
    auto *head =
        new QTableWidgetItem(isShown ? QStringLiteral("• %1").arg(earlier.number) : QString::number(earlier.number));
    head->setToolTip(isShown ? tr("This pick is shown above") : tr("Pick %1").arg(earlier.number));
    m_table->setVerticalHeaderItem(row, head);
}

void EarlierPicksView::select(const std::vector<int> &numbers)
{
    m_table->clearSelection();
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (std::find(numbers.begin(), numbers.end(), m_picks[static_cast<std::size_t>(row)].number) == numbers.end())
            continue;
        const QModelIndex index = m_table->model()->index(row, 0);
        if (m_table->selectionModel()->hasSelection())
            m_table->selectionModel()->select(index, QItemSelectionModel::Select | QItemSelectionModel::Rows);
        else
            m_table->selectionModel()->setCurrentIndex(index, QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
}

std::vector<int> EarlierPicksView::selected() const
{
    std::vector<int> numbers;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows()) {
        if (const auto row = static_cast<std::size_t>(index.row()); row < m_picks.size())
            numbers.push_back(m_picks[row].number);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

void EarlierPicksView::followSelection()
{
    if (m_isFilling)
        return;
    if (const std::vector<int> numbers = selected(); numbers.size() == 1)
        m_history->show(numbers.front());
    showDifference();
}

void EarlierPicksView::showDifference()
{
    const std::vector<int> numbers = selected();
    const auto pickOf = [this](int number) {
        return std::find_if(m_picks.begin(), m_picks.end(),
                            [number](const EarlierPick &earlier) { return earlier.number == number; });
    };
    m_difference->setText(numbers.size() == 2
                              ? pickDifferenceText(*pickOf(numbers[0]), *pickOf(numbers[1]), m_document.objects())
                              : tr("Select two rows to compare them (Ctrl + click, or Shift with the arrow keys)."));
}

void EarlierPicksView::showMenu(const QPoint &position)
{
    const QTableWidgetItem *item = m_table->itemAt(position);
    if (!item)
        return;
    const std::optional<WorldPoint> point = pickedPoint(m_picks[static_cast<std::size_t>(item->row())].kept);
    if (point)
        showCopyMenu(*m_table, m_table->viewport()->mapToGlobal(position), {},
                     {QStringLiteral("world"), {point->x, point->y, point->z}});
}

} // namespace unprojector::gui
