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

/// The mark of a landmark in the view.
struct LandmarkMark {
    std::size_t index = 0; ///< in SceneDocument::landmarks()
    QPointF at;            ///< logical pixels of the surface, origin top-left
    bool isBehind = false; ///< hidden behind a surface, or cut away
    bool isSelected = false;
    bool isCurrent = false;
    bool isFree = false; ///< no anchor holds it on a surface
    QColor color;
    QString label;
};

/// The radius of a mark of medium size, and the distance from its centre within which the pointer
/// hits a mark of any size; logical pixels.
constexpr double kMarkRadius = 4.5;
constexpr double kMarkReach = 8.0;

/// The marks of all visible, placed landmarks in the view. While a model is not prepared for rays,
/// no landmark counts as hidden behind it. Casts one ray a landmark: 500 on a million triangles
/// take a few milliseconds.
std::vector<LandmarkMark> landmarkMarks(const SceneDocument &document);

/// The mark under a pointer: the nearest within kMarkReach, visible ones before hidden ones.
/// @param isInSightOnly  ignores marks behind a surface: a click there hits the surface
const LandmarkMark *markUnder(const std::vector<LandmarkMark> &marks, const QPointF &pointer,
                              bool isInSightOnly = false);

/// The placement of a mark's label.
struct PlacedLabel {
    std::size_t mark = 0; ///< its index among the marks
    QRectF box;
    bool hasLeader = false; ///< a leader line connects a distant label with its mark
};

/// The placement of labels beside their marks: they overlap neither each other nor another mark,
/// and stay in the area. The current landmark's comes first, then the selected ones. Labels without
/// room and empty ones are left out.
/// @param area   logical pixels
/// @param lines, taken  arrows, texts and the like that no label may cover; logical pixels
/// @param radius  of the marks, logical pixels
std::vector<PlacedLabel> placedLabels(const std::vector<LandmarkMark> &marks, const QFontMetricsF &metrics,
                                      const QRectF &area, const std::vector<QLineF> &lines = {},
                                      const std::vector<QRectF> &taken = {}, double radius = kMarkRadius);

/// Draws marks, filled if visible and hollow if hidden behind a surface, and their labels. A free
/// landmark has a diamond instead of a disc.
void drawLandmarks(QPainter &painter, const std::vector<LandmarkMark> &marks, const std::vector<PlacedLabel> &labels,
                   double radius = kMarkRadius);

/// The tooltip of a mark.
QString landmarkTip(const SceneDocument &document, const LandmarkMark &mark);

} // namespace unprojector::gui
