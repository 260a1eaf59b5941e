#include "gui/landmarks/landmark_loupe.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr double kSide = kLoupePixels * kLoupeZoom;

std::optional<QPointF> seenAt(const glm::dmat4 &clipFromWorld, const Setup &setup, const WorldPoint &point)
{
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(point.coordinates(), 1.0);
    if (!(clip.w > 0.0))
        return std::nullopt;
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    const DevicePoint at =
        deviceFromWindow(setup.surface, windowFromNdc(setup.viewport, setup.depthRange, ndc, ndcDepthOf(setup)));
    return QPointF(at.x, at.y);
}

} // namespace

QRect loupePixels(const DevicePoint &at)
{
    constexpr int kHalf = kLoupePixels / 2;
    return {static_cast<int>(std::floor(at.x)) - kHalf, static_cast<int>(std::floor(at.y)) - kHalf, kLoupePixels,
            kLoupePixels};
}

QRectF loupeBox(const Surface &surface, const DevicePoint &at, double taken)
{
    constexpr double kMargin = 12.0;
    const double ratio = surface.devicePixelRatio;
    const double width = surface.widthPixels / ratio, height = surface.heightPixels / ratio;
    const double beside = width - taken - kSide - kMargin, bottom = height - kSide - kMargin;
    const bool hasRoom = taken <= 0.0 || beside >= kMargin;
    // The box goes below if there is no room beside the occupied area: on the right, or on the
    // left.
    QRectF box(std::max(kMargin, hasRoom ? beside : width - kSide - kMargin), hasRoom ? kMargin : bottom, kSide, kSide);
    constexpr double kApart = 40.0;
    if (box.adjusted(-kApart, -kApart, kApart, kApart).contains(at.x / ratio, at.y / ratio))
        box.moveTopLeft(hasRoom ? QPointF(box.left(), bottom) : QPointF(kMargin, bottom));
    return box;
}

std::vector<QLineF> loupeEdges(const ray::SceneRays &rays, const DevicePoint &at)
{
    std::vector<QLineF> edges;
    const Setup &setup = rays.rays().setup();
    const Result<glm::dmat4> matrix = clipFromWorld(setup);
    if (!matrix)
        return edges;
    const QRect pixels = loupePixels(at);
    std::set<std::pair<std::size_t, std::uint32_t>> known;
    for (int j = pixels.top(); j <= pixels.bottom(); ++j) {
        for (int i = pixels.left(); i <= pixels.right(); ++i) {
            const Result<std::optional<ray::SceneHit>> hit = rays.at(pixelCenter({i, j}));
            if (!hit || !*hit || !(*hit)->triangle
                || !known.insert({(*hit)->object, (*hit)->triangle->triangle}).second)
                continue;
            const std::array<WorldPoint, 3> corners = rays.corners(**hit);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto from = seenAt(*matrix, setup, corners[k]);
                const auto to = seenAt(*matrix, setup, corners[(k + 1) % 3]);
                if (from && to)
                    edges.emplace_back(*from, *to);
            }
        }
    }
    return edges;
}

bool leaveSurfaceVisible(const std::vector<QLineF> &edges)
{
    constexpr double kLongPixels = 6.0;
    constexpr std::size_t kMostTriangles = 48; // of 7 to 8 pixels each
    if (edges.size() > 3 * kMostTriangles)
        return false;
    std::vector<double> lengths;
    for (const QLineF &edge : edges)
        lengths.push_back(edge.length());
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return middle != lengths.end() && *middle > kLongPixels;
}

void drawLoupe(QPainter &painter, const QRectF &box, const DevicePoint &at, const QImage &pixels,
               const std::vector<QLineF> &edges)
{
    const QRect shown = loupePixels(at);
    const auto placeOf = [&](const QPointF &device) { return box.topLeft() + (device - shown.topLeft()) * kLoupeZoom; };
    painter.save();
    painter.setClipRect(box);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.fillRect(box, Qt::black);
    painter.drawImage(box, pixels);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(QColor(128, 128, 128, 70), 0.0));
    std::vector<QLineF> grid;
    for (int i = 1; i < kLoupePixels; ++i) {
        const double way = i * kLoupeZoom;
        grid.emplace_back(box.left() + way, box.top(), box.left() + way, box.bottom());
        grid.emplace_back(box.left(), box.top() + way, box.right(), box.top() + way);
    }
    painter.drawLines(grid.data(), static_cast<int>(grid.size()));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto &[color, width] :
         {std::pair(QColor(0, 0, 0, 130), 2.5), std::pair(QColor(255, 255, 255, 220), 1.0)}) {
        painter.setPen(QPen(color, width));
        for (const QLineF &edge : edges)
            painter.drawLine(placeOf(edge.p1()), placeOf(edge.p2()));
    }
    // The exact position, with fractions of a pixel.
    const QPointF middle = placeOf({at.x, at.y});
    constexpr double kGap = 3.0, kArm = 12.0;
    for (const auto &[color, width] : {std::pair(QColor(0, 0, 0), 3.5), std::pair(QColor(255, 194, 46), 1.5)}) {
        painter.setPen(QPen(color, width));
        for (const QPointF &way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(middle + way * kGap, middle + way * kArm);
    }
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(24, 26, 28), 3.0));
    painter.drawRect(box);
    painter.setPen(QPen(QColor(255, 255, 255), 1.0));
    painter.drawRect(box);
    painter.restore();
}

} // namespace unprojector::gui
