#include "gui/widgets/number_grid.h"

#include "gui/widgets/contrast.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/number_grid_model.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QScopedValueRollback>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

/// The margin left and right of a number, logical pixels.
constexpr int kCellMargin = 4;
constexpr int kBracketWidth = 5;
/// The width of a single column: "-0.123456789" and a little more.
constexpr int kCharactersInColumn = 14;
/// The share of the selection's colour in the background of a marked number, on which the text
/// stays readable.
constexpr double kMarkedShare = 0.3;

} // namespace

NumberGrid::NumberGrid(NumberGridModel *model, QWidget *parent) : QTableView(parent), m_model(model)
{
    setModel(model);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed); // of cells that the model makes editable
    horizontalHeader()->hide();
    verticalHeader()->hide();
    horizontalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setHorizontalScrollMode(ScrollPerPixel);
    viewport()->setAutoFillBackground(false);
    useFont();
    connect(model, &QAbstractItemModel::modelReset, this, &NumberGrid::fit);
}

void NumberGrid::useFont()
{
    setFont(digitsFont(QApplication::font()));
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 3);
    fit();
}

void NumberGrid::setLabelsShown(bool areShown)
{
    m_showsLabels = areShown;
    fit();
}

void NumberGrid::hideScrollBar()
{
    m_hasScrollBar = false;
    fit();
}

/// The characters of the longest label and a blank.
int NumberGrid::labelLength() const
{
    if (!m_showsLabels)
        return 0;
    qsizetype longest = 0;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        for (int column = 0; column < m_model->columnCount(); ++column)
            longest =
                std::max(longest, m_model->index(row, column).data(NumberGridModel::kLabelRole).toString().size());
    }
    return longest > 0 ? static_cast<int>(longest) + 2 : 0;
}

int NumberGrid::widthOf(int characters) const
{
    return static_cast<int>(std::ceil(characters * QFontMetricsF(font()).horizontalAdvance(u'0'))) + 2 * kCellMargin;
}

void NumberGrid::fit()
{
    const int columns = m_model->columnCount();
    if (columns == 0)
        return;
    const int labels = labelLength(), least = m_model->leastCapacity();
    const bool isColumn = columns == 1;
    setMaximumWidth(isColumn ? widthOf(labels + std::max(least, kCharactersInColumn)) + 2 * kBracketWidth
                             : QWIDGETSIZE_MAX);
    const int available = std::min(width(), maximumWidth());
    const int wanted = least > 0 ? columns * widthOf(labels + least) : 0;
    const int shared = std::max(available, wanted);
    for (int column = 0; column < columns; ++column)
        setColumnWidth(column, shared * (column + 1) / columns - shared * column / columns);
    const int room = shared / columns - 2 * kCellMargin;
    const int characters = static_cast<int>(room / QFontMetricsF(font()).horizontalAdvance(u'0'));
    m_model->setCapacity(characters - labels);
    const bool scrolls = m_hasScrollBar && wanted > available;
    setHorizontalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    setFixedHeight(std::max(1, m_model->rowCount()) * verticalHeader()->defaultSectionSize()
                   + (scrolls ? style()->pixelMetric(QStyle::PM_ScrollBarExtent) : 0));
}

QSize NumberGrid::minimumSizeHint() const
{
    constexpr int kShortest = 8, kColumns = 4; // "-0.12345"
    return {kColumns * widthOf(kShortest), height()};
}

/// Draws only text: a table with a style needs ten times as long as the rest of the panel, at every
/// mouse move that turns the view.
void NumberGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    const QFontMetricsF metrics(font());
    // All digits are equally wide, so that the start is known without a text layout.
    const double digitWidth = metrics.horizontalAdvance(u'0');
    const int rowHeight = verticalHeader()->defaultSectionSize();
    const double ascent = (rowHeight - metrics.height()) / 2.0 + metrics.ascent();
    const QColor text = palette().color(QPalette::WindowText),
                 selectedText = palette().color(QPalette::HighlightedText);
    const QColor labelText = quietInk(text, palette().color(QPalette::Window));
    const QColor marked = mixed(palette().color(QPalette::Window), palette().color(QPalette::Highlight), kMarkedShare);
    for (int row = 0; row < m_model->rowCount(); ++row) {
        for (int column = 0; column < m_model->columnCount(); ++column) {
            const QModelIndex index = m_model->index(row, column);
            const QRect cell(columnViewportPosition(column), rowViewportPosition(row), columnWidth(column), rowHeight);
            const bool isSelected = selectionModel()->isSelected(index);
            if (isSelected)
                painter.fillRect(cell, palette().brush(QPalette::Highlight));
            else if (index.data(NumberGridModel::kMarkedRole).toBool())
                painter.fillRect(cell, marked);
            if (const QString label = index.data(NumberGridModel::kLabelRole).toString();
                m_showsLabels && !label.isEmpty()) {
                painter.setPen(isSelected ? selectedText : labelText);
                painter.drawText(QPointF(cell.x() + kCellMargin + kBracketWidth, cell.y() + ascent), label);
            }
            const QString number = index.data().toString();
            const double right = cell.right() + 1.0 - kCellMargin;
            painter.setPen(isSelected ? selectedText : text);
            painter.drawText(QPointF(right - static_cast<double>(number.size()) * digitWidth, cell.y() + ascent),
                             number);
            if (hasFocus() && index == currentIndex()) {
                painter.setPen(text);
                painter.drawRect(cell.adjusted(0, 0, -1, -1));
            }
        }
    }
    painter.setPen(text);
    const int right = viewport()->width() - 1, bottom = viewport()->height() - 1;
    for (const auto &[edge, inner] : {std::pair(0, kBracketWidth - 1), std::pair(right, right - kBracketWidth + 1)}) {
        painter.drawLine(edge, 0, edge, bottom);
        painter.drawLine(edge, 0, inner, 0);
        painter.drawLine(edge, bottom, inner, bottom);
    }
}

void NumberGrid::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fit();
}

void NumberGrid::wheelEvent(QWheelEvent *event)
{
    event->ignore(); // the panel scrolls
}

void NumberGrid::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange) {
        useFont();
    }
}

bool NumberGrid::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        // Keys typed here are for the grid, even if it is read-only: a number may begin with a
        // letter, as sqrt(2) does. They must not turn the camera or change the view. Home goes to
        // the first number.
        const auto &key = *static_cast<QKeyEvent *>(event);
        const bool isPlain = !(key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
        const bool isTyped = !key.text().isEmpty() && key.text().front().isPrint();
        const bool isPaste = key.matches(QKeySequence::Paste) && m_model->isTypable();
        if (isPaste || (isPlain && (isTyped || key.key() == Qt::Key_Home || key.key() == Qt::Key_End))) {
            event->accept();
            return true;
        }
    }
    return QTableView::event(event);
}

void NumberGrid::applyTyped()
{
    for (QLineEdit *editor : viewport()->findChildren<QLineEdit *>()) {
        if (editor->isHidden()) // it is closed and about to be deleted
            continue;
        commitData(editor);
        closeEditor(editor, QAbstractItemDelegate::NoHint);
    }
}

void NumberGrid::paste()
{
    m_model->typeAll(QGuiApplication::clipboard()->text());
}

void NumberGrid::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        if (const QString text = selectedText(); !text.isEmpty())
            copyToClipboard(text);
        return;
    }
    if (event->matches(QKeySequence::Paste) && m_model->isTypable()) {
        paste();
        return;
    }
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && state() != EditingState && currentIndex().flags() & Qt::ItemIsEditable) {
        edit(currentIndex());
        return;
    }
    QTableView::keyPressEvent(event);
}

Copyable NumberGrid::numberAt(const QPoint &globalPosition) const
{
    const QVariant value = indexAt(viewport()->mapFromGlobal(globalPosition)).data(NumberGridModel::kValueRole);
    return value.isValid() ? Copyable{{}, {value.toDouble()}} : Copyable();
}

void NumberGrid::contextMenuEvent(QContextMenuEvent *event)
{
    const Copyable number = numberAt(event->globalPos()), whole = m_model->copyable();
    if (!m_model->isTypable()) {
        showCopyMenu(*this, event->globalPos(), number, whole);
        return;
    }
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addCopyActions(*menu, number, whole);
    menu->addSeparator();
    const QModelIndex index = indexAt(viewport()->mapFromGlobal(event->globalPos()));
    if (index.flags() & Qt::ItemIsEditable)
        menu->addAction(tr("T&ype a number…"), this, [this, index] { edit(index); });
    menu->addAction(tr("&Paste all coordinates"), this, &NumberGrid::paste)
        ->setEnabled(!QGuiApplication::clipboard()->text().isEmpty());
    menu->popup(event->globalPos());
}

void NumberGrid::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (current.isValid() && !m_isReached)
        emit entered(current);
}

void NumberGrid::focusInEvent(QFocusEvent *event)
{
    const bool isByTab = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    {
        // the first focus sets the first number as the current one
        const QScopedValueRollback reaching(m_isReached, isByTab);
        QTableView::focusInEvent(event);
    }
    const bool isNew = event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason;
    if (!isNew || !currentIndex().isValid())
        return;
    if (isByTab)
        emit reached(currentIndex());
    else
        emit entered(currentIndex());
}

void NumberGrid::focusOutEvent(QFocusEvent *event)
{
    QTableView::focusOutEvent(event);
    // A panel's grids have one selection together; a menu takes the focus only for a while.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        clearSelection();
}

QString NumberGrid::selectedText() const
{
    return selectedCells(*selectionModel(),
                         [this](const QModelIndex &index) { return m_model->fullText(index.row(), index.column()); });
}

} // namespace unprojector::gui
