#pragma once

#include "gui/landmarks/landmark_marks.h"

#include <QLineF>
#include <QPolygonF>

#include <optional>
#include <vector>

class QPainter;

namespace unprojector::gui {

/// The drawing of a measure in the view.
struct MeasureMark {
    std::vector<QLineF> lines;   ///< logical pixels of the surface; a geodesic is drawn with the curves instead
    QPolygonF plane;             ///< a mirror plane's rectangle; empty: none, or a part is behind the eye
    std::vector<QPointF> images; ///< mirror images of landmarks
    LandmarkMark label;          ///< represents the measure in the label layout: its text and anchor position
};

/// The mark of the measure that the document shows; nothing if there is none, or it is behind the
/// eye.
std::optional<MeasureMark> measureMark(const SceneDocument &document);

/// @param label  the placement of its label; nothing: there is no room
void drawMeasure(QPainter &painter, const MeasureMark &mark, const std::optional<PlacedLabel> &label);

} // namespace unprojector::gui
