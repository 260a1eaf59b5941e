#pragma once

#include "core/geometry/setup.h"
#include "core/ray/ray.h"

#include <QPointF>

#include <array>
#include <optional>

class QPainter;

namespace unprojector::gui {

/// An arrow along an axis of the world, by which a point is moved off the surface.
struct AxisArrow {
    QPointF from, to;      ///< logical pixels
    bool isUsable = false; ///< not so short in the picture that no hand could move along it
};

/// Arrows along x, y and z from a point, about as long in the picture at every distance. Red, green and blue.
std::array<AxisArrow, 3> axisArrows(const geometry::Setup &setup, const geometry::WorldPoint &point);

/// The axis whose arrow a pointer means, near its head: about the point itself it means the point.
std::optional<int> axisUnder(const std::array<AxisArrow, 3> &arrows, const QPointF &pointer);

/// How far along an axis from a point the line through it comes closest to a ray; nothing where they are nearly parallel.
std::optional<double> wayAlong(const geometry::WorldPoint &point, int axis, const ray::Ray<geometry::WorldSpace> &ray);

void drawAxes(QPainter &painter, const std::array<AxisArrow, 3> &arrows, std::optional<int> dragged);

} // namespace unprojector::gui
