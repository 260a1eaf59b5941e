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

/// A coordinate of the picked point, beside the line that runs from the point along its axis.
struct DropLabel {
    QString text; ///< "x 0.457"
    QColor color; ///< of the axis
    QRectF box;   ///< logical pixels of the view
};

/// The uncertainty of the picked point: that of the snapped place, else that of the surface. @pre there is a pick
geometry::WorldVector pickedUncertainty(const Picks &picks);

/// The labels of those lines that are long enough in the view.
/// @param taken  where other texts stand, logical pixels
std::vector<DropLabel> dropLabels(const SceneDocument &document, const QFont &font, const std::vector<QRectF> &taken);

void drawDropLabels(QPainter &painter, const std::vector<DropLabel> &labels);

} // namespace unprojector::gui
