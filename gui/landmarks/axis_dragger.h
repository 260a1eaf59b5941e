#pragma once

#include "core/geometry/setup.h"
#include "core/ray/ray.h"

#include <QPointF>

#include <array>
#include <optional>

class QPainter;

namespace unprojector::gui {

/// An arrow along a world axis that moves a landmark off the surface.
struct AxisArrow {
    QPointF from, to;      ///< logical pixels
    bool isUsable = false; ///< long enough in the view to be dragged
};

/// Arrows along x, y and z from a point, about equally long in the view at every distance. Red,
/// green and blue.
std::array<AxisArrow, 3> axisArrows(const geometry::Setup &setup, const geometry::WorldPoint &point);

/// The axis whose arrow is under the pointer; nothing near the point itself, which takes
/// precedence.
std::optional<int> axisUnder(const std::array<AxisArrow, 3> &arrows, const QPointF &pointer);

/// The position along an axis from a point at which the line is closest to a ray; nothing if they
/// are nearly parallel.
std::optional<double> wayAlong(const geometry::WorldPoint &point, int axis, const ray::Ray<geometry::WorldSpace> &ray);

void drawAxes(QPainter &painter, const std::array<AxisArrow, 3> &arrows, std::optional<int> dragged);

} // namespace unprojector::gui
