#pragma once

#include "core/geometry/setup.h"

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QFont;
class QPainter;

namespace unprojector::gui {

class SceneDocument;

/// A coordinate of the picked point, beside the line from the point along its axis.
struct DropLabel {
    QString text; ///< "x 0.457"
    QColor color; ///< of the axis
    QRectF box;   ///< logical pixels of the view
};

/// The position of a world point in the view, logical pixels. Nothing if it lies behind the eye or
/// cannot be projected.
std::optional<QPointF> widgetOf(const geometry::Setup &setup, const geometry::WorldPoint &point);

/// The labels of lines that are long enough in the view.
/// @param taken  rectangles of other texts, logical pixels
std::vector<DropLabel> dropLabels(const SceneDocument &document, const QFont &font, const std::vector<QRectF> &taken);

void drawDropLabels(QPainter &painter, const std::vector<DropLabel> &labels);

} // namespace unprojector::gui
