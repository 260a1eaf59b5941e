#pragma once

#include "core/geometry/spaces.h"

#include <QColor>
#include <QRectF>
#include <QString>

#include <vector>

class QFont;
class QPainter;

namespace unprojector::gui {

class Picks;
class SceneDocument;

/// A coordinate of the picked point, beside the line from the point along its axis.
struct DropLabel {
    QString text; ///< "x 0.457"
    QColor color; ///< of the axis
    QRectF box;   ///< logical pixels of the view
};

/// The uncertainty of the picked point: the snapped point's, else the surface's. @pre there is a
/// pick
geometry::WorldVector pickedUncertainty(const Picks &picks);

/// The labels of lines that are long enough in the view.
/// @param taken  rectangles of other texts, logical pixels
std::vector<DropLabel> dropLabels(const SceneDocument &document, const QFont &font, const std::vector<QRectF> &taken);

void drawDropLabels(QPainter &painter, const std::vector<DropLabel> &labels);

} // namespace unprojector::gui
