#pragma once

#include "core/geometry/viewport.h"
#include "core/ray/scene_rays.h"

#include <QImage>
#include <QLineF>
#include <QRect>
#include <QRectF>

#include <vector>

class QPainter;

namespace unprojector::gui {

// A loupe: the pixels about a position of the picture, large, with the mesh's edges and the grid of the pixels.

constexpr int kLoupePixels = 19; ///< device pixels across, odd: one is in the middle
constexpr int kLoupeZoom = 8;    ///< logical pixels for each of them

/// The pixels that it shows, device pixels, origin top-left; they may reach over the picture's rim.
QRect loupePixels(const geometry::DevicePoint &at);

/// Where it stands: in a corner of the view on the right, out of the way of the position. Logical pixels.
/// @param taken  how much of the view's width at the top right something else takes, logical pixels: it stands beside that, and
///     below where there is no room
QRectF loupeBox(const geometry::Surface &surface, const geometry::DevicePoint &at, double taken = 0.0);

/// The edges of the triangles in sight there, device pixels.
std::vector<QLineF> loupeEdges(const ray::SceneRays &rays, const geometry::DevicePoint &at);

/// @param pixels  of loupePixels(at), the top row first
void drawLoupe(QPainter &painter, const QRectF &box, const geometry::DevicePoint &at, const QImage &pixels,
               const std::vector<QLineF> &edges);

} // namespace unprojector::gui
