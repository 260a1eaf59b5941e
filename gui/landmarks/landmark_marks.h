#pragma once

#include "gui/document/scene_document.h"

#include <QColor>
#include <QFontMetricsF>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

class QPainter;

namespace unprojector::gui {

/// Where a placed point is seen in the picture.
struct LandmarkMark {
    std::size_t index = 0; ///< in SceneDocument::landmarks()
    QPointF at;            ///< logical pixels of the surface, origin top-left
    bool isBehind = false; ///< something is in front of it, or it is cut away
    bool isSelected = false;
    bool isCurrent = false;
    QColor color;
    QString label;
};

/// Radius of a mark, and how far from its middle a pointer still means it; logical pixels.
constexpr double kMarkRadius = 4.5;
constexpr double kMarkReach = 8.0;

/// The marks of all points that are not hidden, not missing and in the picture. While a model is not prepared for rays none
/// counts as behind it. One ray a point: of 500 on a million triangles a few milliseconds.
std::vector<LandmarkMark> landmarkMarks(const SceneDocument &document);

/// The mark that a pointer means: the nearest within kMarkReach, one in sight before one behind.
/// @param isInSightOnly  none that is behind something: what is clicked there is what is in front of it
const LandmarkMark *markUnder(const std::vector<LandmarkMark> &marks, const QPointF &pointer,
                              bool isInSightOnly = false);

/// Where a mark's label stands.
struct PlacedLabel {
    std::size_t mark = 0; ///< its place among the marks
    QRectF box;
    bool hasLeader = false; ///< it stands so far away that a line leads to it
};

/// Labels beside their marks: none overlaps another, nor another mark, nor leaves the area. The current point's comes first, then
/// those that are selected. One that finds no room is left out.
/// @param area   logical pixels
/// @param lines, taken  that no label covers, such as arrows and other texts; logical pixels
std::vector<PlacedLabel> placedLabels(const std::vector<LandmarkMark> &marks, const QFontMetricsF &metrics,
                                      const QRectF &area, const std::vector<QLineF> &lines = {},
                                      const std::vector<QRectF> &taken = {});

/// Draws marks, filled where they are in sight and hollow behind something, and their labels.
void drawLandmarks(QPainter &painter, const std::vector<LandmarkMark> &marks, const std::vector<PlacedLabel> &labels);

/// What the tool tip of a mark says.
QString landmarkTip(const SceneDocument &document, const LandmarkMark &mark);

} // namespace unprojector::gui
