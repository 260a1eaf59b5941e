#pragma once

#include "gui/landmarks/landmark_marks.h"

#include <QLineF>

#include <optional>
#include <vector>

class QPainter;

namespace unprojector::gui {

/// Where a measure is seen in the picture.
struct MeasureMark {
    std::vector<QLineF>
        lines;          ///< logical pixels of the surface; a way along the surface is drawn with the curves instead
    LandmarkMark label; ///< stands for it where labels are placed: its text, and the place that it belongs to
};

/// The measure that the document shows; nothing where there is none, or it is behind the eye.
std::optional<MeasureMark> measureMark(const SceneDocument &document);

/// @param label  where its label stands; nothing: it has found no room
void drawMeasure(QPainter &painter, const MeasureMark &mark, const std::optional<PlacedLabel> &label);

} // namespace unprojector::gui
