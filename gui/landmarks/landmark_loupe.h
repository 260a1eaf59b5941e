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

// A loupe: enlarged pixels around a position of the view, with the mesh's edges and the pixel grid.

constexpr int kLoupePixels = 19; ///< device pixels across, odd: one is in the middle
constexpr int kLoupeZoom = 8;    ///< logical pixels for each of them

/// The choice of when the loupe shows the edges of the mesh.
enum class LoupeEdges {
    WhereLong, ///< where they don't cover the surface, see leaveSurfaceVisible
    Always,
    Never
};

/// The shown pixels, device pixels, origin top-left; they may extend beyond the view's edge.
QRect loupePixels(const geometry::DevicePoint &at);

/// The loupe's box: in a corner of the view on the right, away from the position. Logical pixels.
/// @param taken  occupied width at the top right of the view, logical pixels: the loupe is beside
/// it, or below if there is no room
QRectF loupeBox(const geometry::Surface &surface, const geometry::DevicePoint &at, double taken = 0.0);

/// The edges of the visible triangles there, device pixels.
std::vector<QLineF> loupeEdges(const ray::SceneRays &rays, const geometry::DevicePoint &at);

/// Returns whether edges leave the surface between them visible: their median is longer than six
/// pixels, and they belong to few triangles, not to many thin ones.
/// @param edges  three for each triangle
bool leaveSurfaceVisible(const std::vector<QLineF> &edges);

/// @param pixels  of loupePixels(at), the top row first
void drawLoupe(QPainter &painter, const QRectF &box, const geometry::DevicePoint &at, const QImage &pixels,
               const std::vector<QLineF> &edges);

} // namespace unprojector::gui
