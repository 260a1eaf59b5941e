#include "gui/pipeline/factor_drawing.h"

#include "core/geometry/view_volume.h"
#include "gui/widgets/contrast.h"

#include <QPainter>
#include <QPainterPath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr std::array kLetters{'l', 'r', 'b', 't', 'n', 'f'};
const QColor kNear(0x1c, 0x6c, 0xd4), kFar(0xd4, 0x6c, 0x10);
constexpr double kAxis = 1.35; ///< the length of the axes, in half cube sides from the centre

std::array<glm::dvec3, 8> cubeCorners()
{
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0};
    return corners;
}

std::array<glm::dvec3, 3> axisEnds()
{
    return {glm::dvec3(kAxis, 0, 0), glm::dvec3(0, kAxis, 0), glm::dvec3(0, 0, kAxis)};
}

/// The projection to the paper, y downwards: a parallel one, in which lengths along z are
/// shortened.
QPointF onPaper(const glm::dvec3 &p)
{
    constexpr double kAzimuth = 0.6, kElevation = 0.35; // radians
    const double across = std::cos(kAzimuth) * p.x - std::sin(kAzimuth) * p.z;
    const double towards = std::sin(kAzimuth) * p.x + std::cos(kAzimuth) * p.z;
    return {across, -(std::cos(kElevation) * p.y - std::sin(kElevation) * towards)};
}

/// The corners of a side, in order around it.
/// @param bit, value  of the corners' indices
std::array<std::size_t, 4> sideOf(std::size_t bit, bool value)
{
    const std::size_t first = bit == 1 ? 2 : 1, second = bit == 4 ? 2 : 4, from = value ? bit : 0;
    return {from, from + first, from + first + second, from + second};
}

void drawEdges(QPainter &painter, const std::array<QPointF, 8> &corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (const std::size_t bit : {1u, 2u, 4u}) {
            if ((i & bit) == 0)
                painter.drawLine(corners[i], corners[i + bit]);
        }
    }
}

/// Draws a letter with a rim of the base's colour: readable on any line.
void drawLetter(QPainter &painter, const QPointF &middle, const QString &letter, const QColor &ink, const QColor &base)
{
    const QFontMetricsF metrics(painter.font());
    QPainterPath path;
    path.addText(middle.x() - metrics.horizontalAdvance(letter) / 2.0, middle.y() + metrics.xHeight() / 2.0,
                 painter.font(), letter);
    painter.strokePath(path, QPen(base, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

} // namespace

FactorDrawing::FactorDrawing(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("The view volume and the cube from −1 to 1"));
    setToolTip(tr("Solid: the view volume after the factors, its near side blue, its far side orange.\nDashed: the "
                  "cube from −1 to 1 with its axes, the result of the whole product.\nBoth are scaled to fit."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void FactorDrawing::setVolume(const Projection &projection, const glm::dmat4 &carried)
{
    const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec4 clip = carried * glm::dvec4(corners[i].coordinates(), 1.0);
        m_corners[i] = glm::dvec3(clip) / clip.w;
    }
    update();
}

FactorDrawing::Extent FactorDrawing::extent() const
{
    Extent extent{m_corners.front(), m_corners.front()};
    for (const glm::dvec3 &corner : m_corners) {
        extent.least = glm::min(extent.least, corner);
        extent.most = glm::max(extent.most, corner);
    }
    return extent;
}

QSize FactorDrawing::sizeHint() const
{
    return {16 * fontMetrics().height(), 13 * fontMetrics().height()};
}

QSize FactorDrawing::minimumSizeHint() const
{
    return {10 * fontMetrics().height(), 13 * fontMetrics().height()};
}

void FactorDrawing::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor base = palette().color(QPalette::Window), ink = palette().color(QPalette::WindowText),
                 quiet = quietInk(ink, base);
    const bool isDark = base.lightness() < ink.lightness();
    const QColor nearInk = isDark ? kNear.lighter(150) : kNear.darker(140),
                 farInk = isDark ? kFar.lighter(140) : kFar.darker(160);

    const Paper paper = this->paper();
    // The cube, and its axes if there is room for their letters.
    const std::array<QPointF, 8> places = paper.placed(m_corners);
    painter.setPen(QPen(quiet, 1.0, Qt::DashLine));
    drawEdges(painter, paper.placed(cubeCorners()));
    painter.setPen(QPen(quiet, 1.0));
    for (const glm::dvec3 &end : axisEnds())
        painter.drawLine(paper.placed(glm::dvec3(0.0)), paper.placed(end));

    // The volume: the coloured sides, then its edges.
    for (const bool isFar : {true, false}) {
        QPolygonF side;
        for (const std::size_t corner : sideOf(4, isFar))
            side << places[corner];
        QColor fill = isFar ? kFar : kNear;
        fill.setAlphaF(0.28f);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawPolygon(side);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 1.5));
    drawEdges(painter, places);
    for (const bool isFar : {true, false}) {
        QPolygonF side;
        for (const std::size_t corner : sideOf(4, isFar))
            side << places[corner];
        painter.setPen(QPen(isFar ? farInk : nearInk, 2.0));
        painter.drawPolygon(side);
    }

    const std::vector<QPointF> ofAxes = axisLetters(paper);
    for (std::size_t axis = 0; axis < ofAxes.size(); ++axis)
        drawLetter(painter, ofAxes[axis], QString(QLatin1Char("xyz"[axis])), quiet, base);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const std::array<QRectF, 6> boxes = letterBoxes();
    for (std::size_t side = 0; side < kLetters.size(); ++side) {
        drawLetter(painter, boxes[side].center(), QString(QLatin1Char(kLetters[side])),
                   side == 4   ? nearInk
                   : side == 5 ? farInk
                               : ink,
                   base);
    }
}

QPointF FactorDrawing::Paper::placed(const glm::dvec3 &point) const
{
    return (onPaper(point) - from) * scale + middle;
}

std::array<QPointF, 8> FactorDrawing::Paper::placed(const std::array<glm::dvec3, 8> &points) const
{
    std::array<QPointF, 8> places;
    std::transform(points.begin(), points.end(), places.begin(), [this](const glm::dvec3 &p) { return placed(p); });
    return places;
}

FactorDrawing::Paper FactorDrawing::paper() const
{
    // The bounds of the drawing, and its largest scale.
    QRectF bounds(onPaper(glm::dvec3(0.0)), QSizeF(0.0, 0.0));
    const auto include = [&bounds](const auto &points) {
        for (const glm::dvec3 &point : points) {
            const QPointF at = onPaper(point);
            bounds.setCoords(std::min(bounds.left(), at.x()), std::min(bounds.top(), at.y()),
                             std::max(bounds.right(), at.x()), std::max(bounds.bottom(), at.y()));
        }
    };
    include(cubeCorners());
    include(m_corners);
    include(axisEnds());
    const double margin = 1.3 * QFontMetricsF(font()).height();
    return {bounds.center(), QPointF(width() / 2.0, height() / 2.0),
            std::min((width() - 2.0 * margin) / bounds.width(), (height() - 2.0 * margin) / bounds.height())};
}

std::vector<QPointF> FactorDrawing::axisLetters(const Paper &paper) const
{
    std::vector<QPointF> letters;
    if (kAxis * paper.scale > 3.0 * QFontMetricsF(font()).height()) {
        for (const glm::dvec3 &end : axisEnds())
            letters.push_back(paper.placed(end * 1.12));
    }
    return letters;
}

QRectF FactorDrawing::cubeBox() const
{
    QPolygonF corners;
    for (const QPointF &corner : paper().placed(cubeCorners()))
        corners << corner;
    return corners.boundingRect();
}

std::array<QRectF, 6> FactorDrawing::letterBoxes() const
{
    const QFontMetricsF metrics(font());
    const Paper paper = this->paper();
    std::vector<QRectF> taken;
    const double half = metrics.xHeight() / 2.0 + 2.0;
    for (const QPointF &at : axisLetters(paper))
        taken.push_back(QRectF(at, QSizeF()).marginsAdded(QMarginsF(half, half, half, half)));
    // A cube so small that a letter would cover it.
    const QRectF cube = cubeBox();
    if (std::max(cube.width(), cube.height()) < 3.0 * metrics.height())
        taken.push_back(cube);
    // Each letter is beside the middle of its side, away from the centre.
    const std::array<QPointF, 8> places = paper.placed(m_corners);
    QPointF center;
    for (const QPointF &place : places)
        center += place / 8.0;
    std::array<QRectF, 6> boxes;
    for (std::size_t side = 0; side < boxes.size(); ++side) {
        QPointF at;
        for (const std::size_t corner : sideOf(std::size_t(1) << (side / 2), side % 2 == 1))
            at += places[corner] / 4.0;
        const QPointF way = at - center;
        const double length = std::hypot(way.x(), way.y());
        // A flat volume has two sides at one position.
        const QPointF step =
            length > 1.0 ? way / length : QPointF(side % 2 == 1 ? 1.0 : -1.0, side % 2 == 1 ? -0.5 : 0.5);
        QRectF &box = boxes[side];
        box.setSize({metrics.averageCharWidth() + 4.0, metrics.xHeight() + 6.0});
        box.moveCenter(at + step * (metrics.height() * 0.5));
        const auto isTaken = [&] {
            return std::any_of(taken.begin(), taken.end(), [&](const QRectF &one) { return one.intersects(box); });
        };
        for (int trial = 0; trial < 12 && isTaken(); ++trial)
            box.translate(step * 4.0);
        taken.push_back(box);
    }
    return boxes;
}

} // namespace unprojector::gui
