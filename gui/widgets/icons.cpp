#include "gui/widgets/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <array>

namespace unprojector::gui {
namespace {

// All drawings use a sheet of 24 x 24, y down.
constexpr double kSheet = 24.0;
constexpr double kPen = 1.7;

QPainterPath polyline(std::initializer_list<QPointF> points, bool isClosed = false)
{
    QPainterPath path;
    path.moveTo(*points.begin());
    for (auto point = points.begin() + 1; point != points.end(); ++point)
        path.lineTo(*point);
    if (isClosed)
        path.closeSubpath();
    return path;
}

constexpr QPointF kApex(12, 4), kLeftFoot(3, 19), kRightFoot(21, 19);

QPainterPath triangle()
{
    return polyline({kApex, kRightFoot, kLeftFoot}, true);
}

/// An arrow that bends back to the left.
QPainterPath undoArrow()
{
    QPainterPath path;
    path.moveTo(5, 9);
    path.lineTo(14, 9);
    path.cubicTo(22, 9, 22, 19, 14, 19);
    path.lineTo(9, 19);
    path.addPath(polyline({{9, 5}, {5, 9}, {9, 13}}));
    return path;
}

struct Sheet {
    QPainterPath lines;
    QPainterPath areas = {}; ///< filled
    bool isInk = false;      ///< filled as dark as the lines
};

Sheet sheetOf(Drawing drawing)
{
    switch (drawing) {
    case Drawing::Click: {
        // A pointer over its pixel.
        QPainterPath pixel;
        pixel.addRect(3, 3, 9, 9);
        QPainterPath pointer =
            polyline({{8, 8}, {20, 13}, {15, 15}, {19.5, 19.5}, {17.5, 21.5}, {13, 17}, {11, 21.5}}, true);
        return {pixel.united(pointer), pointer};
    }
    case Drawing::Pipeline: {
        QPainterPath boxes;
        for (const double x : {2.0, 9.5, 17.0})
            boxes.addRect(x, 9, 5, 6);
        QPainterPath lines = boxes;
        lines.addPath(polyline({{7, 12}, {9.5, 12}}));
        lines.addPath(polyline({{14.5, 12}, {17, 12}}));
        return {lines, boxes};
    }
    case Drawing::Doctor: {
        // A magnifying glass over a cross.
        QPainterPath glass;
        glass.addEllipse(QPointF(10, 10), 7, 7);
        QPainterPath lines = glass;
        lines.addPath(polyline({{15.2, 15.2}, {21, 21}}));
        lines.addPath(polyline({{7, 7}, {13, 13}}));
        lines.addPath(polyline({{13, 7}, {7, 13}}));
        return {lines};
    }
    case Drawing::Lessons: {
        QPainterPath book = polyline({{12, 6}, {12, 20}, {3, 18}, {3, 4}, {12, 6}, {21, 4}, {21, 18}, {12, 20}});
        book.addPath(polyline({{5.5, 9}, {9.5, 10}}));
        book.addPath(polyline({{5.5, 13}, {9.5, 14}}));
        return {book};
    }
    case Drawing::Help: {
        QPainterPath mark;
        mark.addEllipse(QPointF(12, 12), 9, 9);
        mark.moveTo(9, 9.5);
        mark.cubicTo(9, 5.5, 15, 5.5, 15, 9.5);
        mark.cubicTo(15, 12, 12, 11.5, 12, 14.5);
        QPainterPath dot;
        dot.addEllipse(QPointF(12, 17.5), 1.1, 1.1);
        return {mark, dot, true};
    }
    case Drawing::Open: {
        QPainterPath folder = polyline({{3, 19}, {3, 6}, {9, 6}, {11, 8}, {19, 8}, {19, 11}});
        folder.addPath(polyline({{3, 19}, {6.5, 11}, {22, 11}, {18.5, 19}}, true));
        return {folder};
    }
    case Drawing::Save: {
        QPainterPath disk = polyline({{4, 4}, {16, 4}, {20, 8}, {20, 20}, {4, 20}}, true);
        disk.addPath(polyline({{7.5, 4}, {7.5, 9}, {14.5, 9}, {14.5, 4}}));
        disk.addRect(7.5, 13, 9, 7);
        return {disk};
    }
    case Drawing::Undo: return {undoArrow()};
    case Drawing::Redo: return {QTransform(-1, 0, 0, 1, kSheet, 0).map(undoArrow())};
    case Drawing::Fit: {
        QPainterPath corners = polyline({{4, 9}, {4, 4}, {9, 4}});
        corners.addPath(polyline({{15, 4}, {20, 4}, {20, 9}}));
        corners.addPath(polyline({{20, 15}, {20, 20}, {15, 20}}));
        corners.addPath(polyline({{9, 20}, {4, 20}, {4, 15}}));
        QPainterPath middle;
        middle.addEllipse(QPointF(12, 12), 4, 4);
        return {corners, middle};
    }
    case Drawing::Home: {
        QPainterPath house = polyline({{3, 12}, {12, 4}, {21, 12}});
        house.addPath(polyline({{6, 10}, {6, 20}, {18, 20}, {18, 10}}));
        house.addPath(polyline({{10, 20}, {10, 14}, {14, 14}, {14, 20}}));
        return {house};
    }
    case Drawing::Perspective: {
        // The view volume from above: the eye, the near plane, the far plane.
        QPainterPath volume = polyline({{4, 4}, {20, 4}, {15, 13}, {9, 13}}, true);
        volume.addPath(polyline({{9, 13}, {12, 19}, {15, 13}}));
        QPainterPath eye;
        eye.addEllipse(QPointF(12, 19.5), 2, 2);
        return {volume, eye};
    }
    case Drawing::FromOutside: {
        // The same volume from the side, in the frame of a smaller view.
        QPainterPath frame;
        frame.addRoundedRect(QRectF(3, 4, 18, 16), 1.5, 1.5);
        frame.addPath(polyline({{7, 12}, {17, 7.5}, {17, 16.5}}, true));
        frame.addPath(polyline({{11, 10.2}, {11, 13.8}}));
        QPainterPath eye;
        eye.addEllipse(QPointF(7, 12), 1.8, 1.8);
        return {frame, eye};
    }
    case Drawing::Surface: {
        // A curved patch, and the ray that hits it.
        QPainterPath patch;
        patch.moveTo(3, 15);
        patch.cubicTo(8, 9, 12, 20, 17, 13);
        patch.lineTo(21, 18);
        patch.cubicTo(16, 25, 12, 14, 7, 20);
        patch.closeSubpath();
        QPainterPath lines = patch;
        lines.addPath(polyline({{17, 3}, {12, 12}}));
        lines.addPath(polyline({{11.5, 8}, {12, 12}, {15.5, 10}}));
        return {lines, patch};
    }
    case Drawing::Vertex: {
        QPainterPath dot;
        dot.addEllipse(kApex, 3.2, 3.2);
        QPainterPath lines = triangle();
        lines.addPath(dot);
        return {lines, dot, true};
    }
    case Drawing::Edge: {
        QPainterPath edge = polyline({{10.2, 3}, {13.8, 5}, {4.8, 20}, {1.2, 18}}, true);
        return {triangle(), edge, true};
    }
    case Drawing::Face: return {triangle(), triangle()};
    case Drawing::Points: {
        // A pin in the surface.
        QPainterPath pin;
        pin.moveTo(12, 18);
        pin.cubicTo(12, 14, 6.5, 12.5, 6.5, 8.5);
        pin.cubicTo(6.5, 1.5, 17.5, 1.5, 17.5, 8.5);
        pin.cubicTo(17.5, 12.5, 12, 14, 12, 18);
        pin.closeSubpath();
        QPainterPath lines = pin;
        lines.addPath(polyline({{3, 17}, {7, 21}, {17, 21}, {21, 17}}));
        QPainterPath head;
        head.addEllipse(QPointF(12, 8.5), 2.4, 2.4);
        return {lines, head, true};
    }
    case Drawing::ToDock: {
        QPainterPath window;
        window.addRoundedRect(QRectF(3, 4, 18, 16), 1.5, 1.5);
        QPainterPath column;
        column.addRect(13.5, 4, 7.5, 16);
        return {window, column};
    }
    case Drawing::Close: {
        QPainterPath cross = polyline({{6, 6}, {18, 18}});
        cross.addPath(polyline({{18, 6}, {6, 18}}));
        return {cross};
    }
    }
    return {};
}

/// Draws on demand: with the present colours and pixels.
class DrawnIconEngine : public QIconEngine {
public:
    explicit DrawnIconEngine(Drawing drawing) : m_drawing(drawing) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        const QPalette palette = QGuiApplication::palette();
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor color = palette.color(group, QPalette::ButtonText);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / kSheet, rect.height() / kSheet);
        const Sheet sheet = sheetOf(m_drawing);
        painter->setPen(QPen(color, kPen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(sheet.lines);
        QColor area = color;
        area.setAlphaF(area.alphaF() * (sheet.isInk ? 1.0F : 0.45F));
        painter->fillPath(sheet.areas, area);
        painter->restore();
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new DrawnIconEngine(*this); }

private:
    Drawing m_drawing;
};

} // namespace

QIcon drawnIcon(Drawing drawing)
{
    return QIcon(new DrawnIconEngine(drawing));
}

QIcon programIcon()
{
    QIcon icon;
    for (const int size : std::array{16, 24, 32, 48, 64, 128, 256})
        icon.addFile(QStringLiteral(":/icons/unprojector-%1.png").arg(size));
    return icon;
}

} // namespace unprojector::gui
