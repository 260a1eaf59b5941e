#include "gui/landmarks/landmarks_table.h"

#include "gui/document/landmark_views.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/landmarks_model.h"
#include "gui/text/short_name.h"
#include "gui/widgets/certain_digits_delegate.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/number_delegate.h"
#include "gui/widgets/quiet_selection.h"

#include <QAbstractItemDelegate>
#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStyle>
#include <QStyledItemDelegate>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr int kLeastNameRoom = 12; // characters
constexpr int kWholeNameRoom = 20; // a name this long has its width before coordinates and ±
constexpr int kLeastRoom = 3;      // of a number

/// Shortens the words of a name without enough room: a template's names may differ in any word.
class NameDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
        const QRect text = style->subElementRect(QStyle::SE_ItemViewItemText, &item, item.widget);
        const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
        const int width = item.rect.right() + 1 - text.left() - 2 * margin;
        item.text = shortName(item.text, item.fontMetrics, width).value_or(item.text); // else it is elided
        style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    }
};

} // namespace

LandmarksTable::LandmarksTable(SceneDocument &document, LandmarksModel *model, QWidget *parent)
    : QTreeView(parent), m_document(document), m_rows(new QSortFilterProxyModel(this))
{
    m_rows->setSourceModel(model);
    m_rows->setSortRole(LandmarksModel::kSortRole);
    m_rows->setSortCaseSensitivity(Qt::CaseInsensitive);
    m_rows->setSortLocaleAware(true);
    setModel(m_rows);
    useQuietSelection(*this);
    setItemDelegateForColumn(LandmarksModel::Name, new NameDelegate(this));
    auto *digits = new CertainDigitsDelegate(this);
    for (const int column : {LandmarksModel::X, LandmarksModel::Y, LandmarksModel::Z})
        setItemDelegateForColumn(column, digits);
    setItemDelegateForColumn(LandmarksModel::PlusMinus, new NumberDelegate(this));
    setAccessibleName(tr("Placed landmarks"));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setTextElideMode(Qt::ElideMiddle); // notes and single words may also differ at their ends
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setDragDropMode(InternalMove);
    setDragDropOverwriteMode(false);
    setContextMenuPolicy(Qt::CustomContextMenu);
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    header()->setSortIndicatorClearable(true);
    header()->setSortIndicator(-1, Qt::AscendingOrder);
    setSortingEnabled(true);
    connect(header(), &QHeaderView::sortIndicatorChanged, this, [this](int column, Qt::SortOrder order) {
        setDragEnabled(column < 0 || (column == LandmarksModel::Number && order == Qt::AscendingOrder));
    });
    useFonts();

    connect(this, &QTreeView::doubleClicked, this, [this](const QModelIndex &index) {
        if (!(index.flags() & Qt::ItemIsEditable)) // an editable cell opens its editor instead
            goToLandmark(m_document, static_cast<std::size_t>(m_rows->mapToSource(index).row()));
    });
    // A click on a row that is already selected: a landmark to place becomes the next one.
    connect(this, &QTreeView::clicked, this, &LandmarksTable::tellSelection);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &LandmarksTable::tellSelection);
    connect(selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex &current) {
        if (selectionModel()->isSelected(current)) // otherwise the selection is about to change
            tellSelection();
    });
    connect(m_rows, &QAbstractItemModel::modelReset, this, &LandmarksTable::showSelection);
    connect(header(), &QHeaderView::sectionResized, this, [this](int column) {
        if (!m_isFitting)
            m_ownWidths.insert(column);
    });
    connect(model, &QAbstractItemModel::modelReset, this, [this, model] {
        m_widestName = 0;
        widen(0, model->rowCount() - 1);
    });
    connect(model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex &from, const QModelIndex &to) { widen(from.row(), to.row()); });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::LandmarkSelection | Change::Landmarks))
            showSelection();
    });
    showSelection();
}

int LandmarksTable::widthFor(int column, int characters) const
{
    const int digit = QFontMetrics(font()).horizontalAdvance(u'0');
    const int head = header()->fontMetrics().horizontalAdvance(model()->headerData(column, Qt::Horizontal).toString());
    return std::max(characters * digit, head) + digit;
}

void LandmarksTable::widen(int first, int last)
{
    const QScopedValueRollback<bool> fitting(m_isFitting, true);
    const QFontMetrics metrics(font());
    const int margin = metrics.horizontalAdvance(u'0');
    const QAbstractItemModel &rows = *m_rows->sourceModel();
    for (const int column :
         {LandmarksModel::Number, LandmarksModel::X, LandmarksModel::Y, LandmarksModel::Z, LandmarksModel::PlusMinus}) {
        if (m_ownWidths.contains(column))
            continue;
        int width = header()->sectionSize(column);
        for (int row = first; row <= last; ++row)
            width = std::max(width, metrics.horizontalAdvance(rows.index(row, column).data().toString()) + margin);
        if (width > header()->sectionSize(column))
            header()->resizeSection(column, width);
    }
    const int around = style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, this)
                       + 4 * (style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, this) + 1);
    for (int row = first; row <= last; ++row) {
        const QModelIndex name = rows.index(row, LandmarksModel::Name);
        const int swatch = name.data(Qt::DecorationRole).isValid() ? iconSize().width() + margin : 0;
        m_widestName = std::max(m_widestName, around + swatch + metrics.horizontalAdvance(name.data().toString()));
    }
    fitName();
}

void LandmarksTable::fitName()
{
    if (m_ownWidths.contains(LandmarksModel::Name))
        return;
    const QScopedValueRollback<bool> fitting(m_isFitting, true);
    const int digit = QFontMetrics(font()).horizontalAdvance(u'0');
    int others = 0;
    for (int column = 0; column <= LandmarksModel::PlusMinus; ++column)
        others += column == LandmarksModel::Name ? 0 : header()->sectionSize(column);
    const int room = std::max(viewport()->width() - others, kWholeNameRoom * digit);
    header()->resizeSection(LandmarksModel::Name, std::max(kLeastNameRoom * digit, std::min(m_widestName, room)));
}

void LandmarksTable::resizeEvent(QResizeEvent *event)
{
    QTreeView::resizeEvent(event);
    fitName();
}

void LandmarksTable::useFonts()
{
    header()->setFont(headsFont(QApplication::font(this)));
    fitColumns();
}

void LandmarksTable::fitColumns()
{
    const auto fit = [this](int column, int characters) {
        header()->resizeSection(column, widthFor(column, characters));
    };
    const QScopedValueRollback<bool> fitting(m_isFitting, true);
    m_ownWidths.clear();
    m_widestName = 0;
    fit(LandmarksModel::Name, kLeastNameRoom);
    for (const int column :
         {LandmarksModel::Number, LandmarksModel::X, LandmarksModel::Y, LandmarksModel::Z, LandmarksModel::PlusMinus})
        fit(column, kLeastRoom - 1); // with the margin
    fit(LandmarksModel::Object, 10);
    fit(LandmarksModel::HeldBy, 13);
    fit(LandmarksModel::Note, 16);
    widen(0, m_rows->sourceModel()->rowCount() - 1); // if more digits are certain
}

QSize LandmarksTable::sizeHint() const
{
    int width = 2 * frameWidth() + verticalScrollBar()->sizeHint().width() // appears with many landmarks
                + kLeastNameRoom * QFontMetrics(font()).horizontalAdvance(u'0');
    // The usual width of the columns, once they have digits.
    constexpr int kNumberRoom = 3, kPlusMinusRoom = 8;
    constexpr int kCoordinates = LandmarksModel::kCoordinateRoom;
    for (const auto &[column, characters] :
         {std::pair(LandmarksModel::Number, kNumberRoom), std::pair(LandmarksModel::X, kCoordinates),
          std::pair(LandmarksModel::Y, kCoordinates), std::pair(LandmarksModel::Z, kCoordinates),
          std::pair(LandmarksModel::PlusMinus, kPlusMinusRoom)})
        width += std::max(header()->sectionSize(column), widthFor(column, characters));
    return {width, QTreeView::sizeHint().height()};
}

void LandmarksTable::changeEvent(QEvent *event)
{
    QTreeView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange || event->type() == QEvent::FontChange)
        useFonts();
}

std::vector<std::size_t> LandmarksTable::selectedIndices() const
{
    QModelIndexList rows = selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    std::vector<std::size_t> indices;
    for (const QModelIndex &row : rows)
        indices.push_back(static_cast<std::size_t>(m_rows->mapToSource(row).row()));
    return indices;
}

void LandmarksTable::showSelection()
{
    const QScopedValueRollback<bool> showing(m_isShowing, true);
    const SceneLandmarks &landmarks = m_document.sceneLandmarks();
    const int count = m_rows->sourceModel()->rowCount();
    const auto rowOf = [this](std::size_t index) {
        return m_rows->mapFromSource(m_rows->sourceModel()->index(static_cast<int>(index), LandmarksModel::Name));
    };
    QItemSelection selection;
    for (const std::size_t index : landmarks.selection()) {
        if (static_cast<int>(index) < count)
            selection.select(rowOf(index), rowOf(index));
    }
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    const bool isNew = !currentIndex().isValid();
    if (landmarks.current() && static_cast<int>(*landmarks.current()) < count) {
        const QModelIndex current = rowOf(*landmarks.current());
        if (currentIndex().row() != current.row() || isNew) {
            selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
            scrollTo(current);
        }
    }
    // The next landmark to place stays visible, unless the user has scrolled to another one since.
    const std::optional<std::size_t> unplaced = landmarks.nextUnplaced();
    if (unplaced && static_cast<int>(*unplaced) < count && (isNew || unplaced != m_shownUnplaced))
        scrollTo(rowOf(*unplaced));
    m_shownUnplaced = unplaced;
}

void LandmarksTable::tellSelection()
{
    if (m_isShowing)
        return;
    std::optional<std::size_t> current;
    if (currentIndex().isValid())
        current = static_cast<std::size_t>(m_rows->mapToSource(currentIndex()).row());
    m_document.sceneLandmarks().select(selectedIndices(), current);
}

void LandmarksTable::renameCurrent()
{
    if (currentIndex().isValid())
        edit(currentIndex().siblingAtColumn(LandmarksModel::Name));
}

void LandmarksTable::applyTyped()
{
    for (QLineEdit *editor : viewport()->findChildren<QLineEdit *>()) {
        if (editor->isHidden()) // it is closed and about to be deleted
            continue;
        commitData(editor);
        closeEditor(editor, QAbstractItemDelegate::NoHint);
    }
}

void LandmarksTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        emit copyRequested();
        return;
    }
    switch (event->key()) {
    case Qt::Key_Delete: emit removeRequested(); return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (state() != EditingState) // the Enter that ends editing arrives here too
            renameCurrent();
        return;
    default: QTreeView::keyPressEvent(event);
    }
}

} // namespace unprojector::gui
