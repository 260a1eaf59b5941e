#pragma once

#include "core/lessons/highlights.h"
#include "gui/document/scene_document.h"
#include "gui/view/observer_picture.h"

#include <QColor>
#include <QFont>
#include <QLineF>
#include <QPointF>
#include <QRectF>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

class QPainter;

namespace unprojector::gui {
using lessons::Highlight;
using lessons::Letter;

/// What a step of a lesson writes into a picture, in logical pixels of its surface, origin top-left.
struct HighlightMarks {
    enum class Tips {
        End,     ///< of an axis
        Both,    ///< of a length
        None,    ///< a plain line, lettered as a length is
        Towards, ///< the axis is seen end-on and points to the viewer: a ring with a dot, as in drawings on paper
        Away     ///< the same, pointing away: a ring with a cross
    };
    struct Arrow {
        QLineF line;
        Tips tips;
        QColor color;
    };
    struct Text {
        QPointF at; ///< beside this: of an axis its tip, of a length its middle
        Letter letter;
        QColor color;
        std::optional<std::size_t> arrow = std::nullopt; ///< its place among the arrows
    };
    std::vector<Arrow> arrows; ///< those of axes that are seen upon each other are one, which has the names of all
    std::vector<Text> texts;
    std::vector<QLineF> lines;  ///< of the scene: no letter stands on them while there is room elsewhere
    std::vector<QRectF> things; ///< such as marks: the same

    bool isEmpty() const { return arrows.empty() && texts.empty(); }
    void add(HighlightMarks more);
};

/// Whether the letter of an arrow stands beside its line, and not at its tip.
inline bool isLength(const HighlightMarks::Arrow &arrow)
{
    return arrow.tips == HighlightMarks::Tips::Both || arrow.tips == HighlightMarks::Tips::None;
}

/// How the marks are coloured.
namespace mark_color {
inline const std::array<QColor, 3> kAxes{QColor(0xb4, 0x1c, 0x20), QColor(0x1b, 0x74, 0x2a), QColor(0x1c, 0x48, 0xb8)};
inline const QColor kDark(0x18, 0x1a, 0x1c);
// Of the planes in View from Outside, as text.
inline const QColor kNear(0x0c, 0x4c, 0x9c), kFar(0x9c, 0x4a, 0x00);
} // namespace mark_color

/// Of an axis that is seen across, logical pixels.
double axisLength(const geometry::Setup &setup);

/// Those of the view: axes and viewport. Axes whose origin or end is behind the eye or in it, as the eye's own are in a perspective,
/// are not in it.
HighlightMarks highlightsInView(const SceneDocument &document, const std::set<Highlight> &highlights);

/// Those of View from Outside: axes, the volume's sides, and the numbers at the cube once the volume has nearly become it.
HighlightMarks highlightsFromOutside(const SceneDocument &document, const ObserverPicture &picture,
                                     const std::set<Highlight> &highlights);

/// How far View from Outside has come to show the normalised cube, 0 to 1, at a place of its morph.
float cubeOpacity(double t);

/// Where the letters stand: none overlaps another nor an arrow nor leaves the area. One of an axis is at its tip, outwards where that
/// is free, and nearer to it than to any other tip; where there is no such place, farther away with a leader. One of a length is
/// beside it, outside of the middle of the area. One that finds no room is null.
/// @param font   of the widget, its size in pixels
/// @param taken  what is there already
std::vector<QRectF> boxesOf(const HighlightMarks &marks, const QFont &font, const QRectF &area,
                            const std::vector<QRectF> &taken);

/// The line from what a letter is of to its box, where the box is not right beside it.
std::optional<QLineF> leaderOf(const HighlightMarks &marks, std::size_t text, const QRectF &box);

/// Draws arrows, leaders and letters, dark or coloured in a light rim: to be seen on any surface.
void drawHighlights(QPainter &painter, const HighlightMarks &marks, const std::vector<QRectF> &boxes);

/// The logical pixels that a clip-space point of a picture is seen at; nothing behind the eye.
std::optional<QPointF> placeInPicture(const geometry::Setup &setup, const glm::dvec4 &clip);
/// The part of a line of clip space in front of the eye, logical pixels.
std::optional<QLineF> lineInPicture(const geometry::Setup &setup, glm::dvec4 from, glm::dvec4 to);

} // namespace unprojector::gui
