#include "gui/pipeline/corners_model.h"

#include "gui/text/number_text.h"
#include "gui/widgets/contrast.h"

#include <QGuiApplication>
#include <QPalette>
#include <QPointF>
#include <QStringList>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// Two numbers, to a hundredth at most.
QString pairText(const QString &x, const QString &y)
{
    return QStringLiteral("(%1, %2)").arg(x, y);
}

bool isInside(const NdcPoint &ndc)
{
    return std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0;
}

} // namespace

CornersModel::CornersModel(QObject *parent) : QAbstractTableModel(parent) {}

CornersModel::Position CornersModel::position(const WidgetPoint &widget, const DevicePixel &pixel) const
{
    const WindowPoint window = windowFromDevice(m_geometry.surface, pixelCenter(pixel), m_geometry.depthRange.atNear);
    return {widget, pixel, window, ndcFromWindow(m_geometry.viewport, m_geometry.depthRange, window)};
}

void CornersModel::setSetup(const Setup &setup)
{
    m_geometry = setup;
    const Surface &surface = setup.surface;
    const int right = surface.widthPixels - 1, bottom = surface.heightPixels - 1;
    const auto at = [this, &surface](int i, int j) {
        return position(widgetFromDevice(surface, DevicePoint(i, j)), {i, j});
    };
    m_rows[TopLeft] = at(0, 0);
    m_rows[TopRight] = at(right, 0);
    m_rows[BottomLeft] = at(0, bottom);
    m_rows[BottomRight] = at(right, bottom);
    m_rows[Centre] = at(surface.widthPixels / 2, surface.heightPixels / 2);
    findPointer();
    emit dataChanged(index(0, 0), index(RowCount - 1, ColumnCount - 1));
}

void CornersModel::setPointer(const std::optional<WidgetPoint> &position)
{
    m_pointer = position;
    findPointer();
    emit dataChanged(index(Pointer, 0), index(Pointer, ColumnCount - 1));
}

void CornersModel::findPointer()
{
    m_rows[Pointer].reset();
    if (!m_pointer)
        return;
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(m_geometry.surface, *m_pointer))
        m_rows[Pointer] = position(*m_pointer, *pixel);
}

std::optional<WindowPoint> CornersModel::pointerWindow() const
{
    if (!m_rows[Pointer])
        return std::nullopt;
    return m_rows[Pointer]->window;
}

int CornersModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : RowCount;
}

int CornersModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant CornersModel::value(const Position &p, int column) const
{
    switch (column) {
    case Widget: return QPointF(p.widget.x, p.widget.y);
    case Device: return QPointF(p.pixel.i, p.pixel.j);
    case Window: return QPointF(p.window.x, p.window.y);
    case Ndc: return QPointF(p.ndc.x, p.ndc.y);
    }
    return {};
}

QVariant CornersModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const std::optional<Position> &p = m_rows[static_cast<std::size_t>(index.row())];
    if (!p)
        return role == Qt::DisplayRole ? QVariant(QStringLiteral("–")) : QVariant();
    switch (role) {
    case kValueRole: return value(*p, index.column());
    case Qt::DisplayRole:
        switch (index.column()) {
        case Widget: return pairText(pixelText(p->widget.x), pixelText(p->widget.y));
        case Device: return pairText(QString::number(p->pixel.i), QString::number(p->pixel.j));
        case Window: return pairText(pixelText(p->window.x), pixelText(p->window.y));
        case Ndc: return pairText(fixedText(p->ndc.x, 4), fixedText(p->ndc.y, 4));
        }
        break;
    case Qt::ForegroundRole:
        if (index.column() == Ndc && !isInside(p->ndc))
            return quietInk(QGuiApplication::palette().color(QPalette::Text),
                            QGuiApplication::palette().color(QPalette::Base));
        break;
    case Qt::ToolTipRole:
        if (index.column() == Ndc && !isInside(p->ndc))
            return tr("Beyond [-1, 1]: outside the viewport, nothing is drawn there");
        break;
    }
    return {};
}

QVariant CornersModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isColumn = orientation == Qt::Horizontal;
    if (role == Qt::DisplayRole && isColumn) {
        switch (section) {
        case Widget: return tr("Widget");
        case Device: return tr("Device pixel");
        case Window: return tr("Window");
        case Ndc: return tr("NDC");
        }
    }
    if (role == Qt::DisplayRole && !isColumn) {
        switch (section) {
        case TopLeft: return tr("Top left");
        case TopRight: return tr("Top right");
        case BottomLeft: return tr("Bottom left");
        case BottomRight: return tr("Bottom right");
        case Centre: return tr("Centre");
        case Pointer: return tr("Pointer");
        }
    }
    if (role == Qt::ToolTipRole && isColumn) {
        switch (section) {
        case Widget: return tr("Logical pixels from the top-left corner, y down; mouse events report this position");
        case Device: return tr("Column and row in device pixels from the top-left corner: widget × device pixel ratio");
        case Window: return tr("The pixel's centre in device pixels from the bottom-left corner, y up");
        case Ndc: return tr("The pixel's centre, −1 to 1 across the viewport, y up; no unit");
        }
    }
    if (role == Qt::ToolTipRole && !isColumn) {
        return section == Pointer  ? tr("The pixel of the window under the pointer")
               : section == Centre ? tr("The pixel right below the window's centre: half its width and half its height")
                                   : tr("The pixel in this corner of the window, not of the viewport");
    }
    return {};
}

QString CornersModel::text() const
{
    QStringList heads{QString()};
    for (int column = 0; column < ColumnCount; ++column) {
        const QString head = headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        heads << head + QStringLiteral(" x") << head + QStringLiteral(" y");
    }
    QStringList lines{heads.join(u'\t')};
    for (int row = 0; row < RowCount; ++row) {
        const std::optional<Position> &p = m_rows[static_cast<std::size_t>(row)];
        if (!p)
            continue;
        QStringList cells{headerData(row, Qt::Vertical, Qt::DisplayRole).toString()};
        for (int column = 0; column < ColumnCount; ++column) {
            const QPointF pair = value(*p, column).toPointF();
            cells << shortestText(pair.x()) << shortestText(pair.y());
        }
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace unprojector::gui
