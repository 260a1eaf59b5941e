#include "gui/panels/number_grid.h"

#include "gui/panels/number_grid_model.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

/// Left and right of a number, logical pixels.
constexpr int kCellMargin = 4;
constexpr int kBracketWidth = 5;
/// Characters of "m[12]" and a blank.
constexpr int kLabelLength = 6;

} // namespace

NumberGrid::NumberGrid(NumberGridModel *model, Frame frame, QWidget *parent)
    : QTableView(parent), m_model(model), m_frame(frame)
{
    setModel(model);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    setEditTriggers(NoEditTriggers);
    horizontalHeader()->hide();
    verticalHeader()->hide();
    horizontalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    if (frame == Frame::Brackets)
        viewport()->setAutoFillBackground(false);
    useFont();
    connect(model, &QAbstractItemModel::modelReset, this, [this] {
        fitHeight();
        fitColumns();
    });
}

void NumberGrid::useFont()
{
    QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    digits.setPointSizeF(QApplication::font().pointSizeF() * 0.92);
    setFont(digits);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 3);
    fitHeight();
}

void NumberGrid::fitHeight()
{
    setFixedHeight(std::max(1, m_model->rowCount()) * verticalHeader()->defaultSectionSize());
}

void NumberGrid::fitColumns()
{
    const int columns = m_model->columnCount();
    if (columns == 0)
        return;
    const int width = viewport()->width();
    for (int column = 0; column < columns; ++column)
        setColumnWidth(column, width * (column + 1) / columns - width * column / columns);
    const bool hasLabels = m_model->index(0, 0).data(NumberGridModel::kLabelRole).toString().size() > 0;
    const int room = width / columns - 2 * kCellMargin;
    const int characters = static_cast<int>(room / QFontMetricsF(font()).horizontalAdvance(u'0'));
    m_model->setCapacity(characters - (hasLabels ? kLabelLength + 1 : 0));
}

QSize NumberGrid::minimumSizeHint() const
{
    constexpr int kShortest = 8; // "-0.12345"
    return {4 * (kShortest * fontMetrics().horizontalAdvance(u'0') + 2 * kCellMargin), height()};
}

/// Only text: what a table and its style do for each cell would cost ten times the rest of the panel, with every step of
/// the mouse that turns the view.
void NumberGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    const QFontMetricsF metrics(font());
    // All digits are equally wide, so that no text has to be laid out to know where it begins.
    const double digitWidth = metrics.horizontalAdvance(u'0');
    const int rowHeight = verticalHeader()->defaultSectionSize();
    const double ascent = (rowHeight - metrics.height()) / 2.0 + metrics.ascent();
    const QColor text = palette().color(QPalette::Text), selectedText = palette().color(QPalette::HighlightedText);
    QColor labelText = text;
    labelText.setAlphaF(0.6f);
    for (int row = 0; row < m_model->rowCount(); ++row) {
        for (int column = 0; column < m_model->columnCount(); ++column) {
            const QModelIndex index = m_model->index(row, column);
            const QRect cell(columnViewportPosition(column), rowViewportPosition(row), columnWidth(column), rowHeight);
            const bool isSelected = selectionModel()->isSelected(index);
            if (isSelected)
                painter.fillRect(cell, palette().brush(QPalette::Highlight));
            if (const QString label = index.data(NumberGridModel::kLabelRole).toString(); !label.isEmpty()) {
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
    if (m_frame == Frame::None)
        return;
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
    fitColumns();
}

void NumberGrid::wheelEvent(QWheelEvent *event)
{
    event->ignore(); // it is the panel that scrolls
}

void NumberGrid::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange) {
        useFont();
        fitColumns();
    }
}

void NumberGrid::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        if (const QString text = selectedText(); !text.isEmpty())
            QApplication::clipboard()->setText(text);
        return;
    }
    QTableView::keyPressEvent(event);
}

void NumberGrid::focusOutEvent(QFocusEvent *event)
{
    QTableView::focusOutEvent(event);
    // One selection among all the grids of a panel is enough; a menu takes the focus only for a while.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        clearSelection();
}

QString NumberGrid::selectedText() const
{
    QModelIndexList selected = selectionModel()->selectedIndexes();
    std::sort(selected.begin(), selected.end());
    QString text;
    int row = -1;
    for (const QModelIndex &index : selected) {
        if (!index.data().isValid())
            continue;
        if (!text.isEmpty())
            text += index.row() == row ? u'\t' : u'\n';
        row = index.row();
        text += m_model->fullText(index.row(), index.column());
    }
    return text;
}

} // namespace unprojector::gui
