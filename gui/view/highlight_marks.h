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

/// The labels and arrows that a step of a lesson draws over an image, in logical pixels of its
/// surface, origin top-left.
struct HighlightMarks {
    enum class Tips {
        End,     ///< an arrowhead at the end: an axis
        Both,    ///< arrowheads at both ends: a length
        None,    ///< a plain line; its letter is placed like a length's
        Towards, ///< the axis is seen end-on and points to the viewer: a ring with a dot, as in drawings on paper
        Away     ///< the same, pointing away: a ring with a cross
    };
    struct Arrow {
        QLineF line;
        Tips tips;
        QColor color;
    };
    struct Text {
        QPointF at; ///< the letter is beside this: an axis's tip or a length's middle
        Letter letter;
        QColor color;
        std::optional<std::size_t> arrow = std::nullopt; ///< its index among the arrows
    };
    std::vector<Arrow> arrows; ///< axes that coincide in the view are one arrow with all their names
    std::vector<Text> texts;
    std::vector<QLineF> lines;  ///< lines of the scene; letters avoid them if there is room elsewhere
    std::vector<QRectF> things; ///< areas such as the crosshair; letters avoid them too

    bool isEmpty() const { return arrows.empty() && texts.empty(); }
    void add(HighlightMarks more);
};

/// Returns whether the letter of an arrow is beside its line and not at its tip.
inline bool isLength(const HighlightMarks::Arrow &arrow)
{
    return arrow.tips == HighlightMarks::Tips::Both || arrow.tips == HighlightMarks::Tips::None;
}

/// The colours of the marks.
namespace mark_color {
inline const std::array<QColor, 3> kAxes{QColor(0xb4, 0x1c, 0x20), QColor(0x1b, 0x74, 0x2a), QColor(0x1c, 0x48, 0xb8)};
inline const QColor kDark(0x18, 0x1a, 0x1c);
// The planes' colours in View from Outside, dark enough for text.
inline const QColor kNear(0x0c, 0x4c, 0x9c), kFar(0x9c, 0x4a, 0x00);
} // namespace mark_color

/// The length of an axis that is parallel to the image plane, logical pixels.
double axisLength(const geometry::Setup &setup);

/// The marks of the view: axes and viewport. Omits axes with an end at the eye or behind it, such
/// as the eye's own axes in a perspective.
HighlightMarks highlightsInView(const SceneDocument &document, const std::set<Highlight> &highlights);

/// The marks of View from Outside: axes, the volume's sides, and the numbers at the cube once the
/// volume has nearly become it.
HighlightMarks highlightsFromOutside(const SceneDocument &document, const ObserverPicture &picture,
                                     const std::set<Highlight> &highlights);

/// The opacity of the normalised cube in View from Outside, 0 to 1, at a position of its morph.
float cubeOpacity(double t);

/// The boxes of the letters: they overlap neither each other nor an arrow and stay in the area. An
/// axis letter is at its tip, outwards if that is free, and nearer to it than to any other tip;
/// without room there, farther away with a leader. A length's letter is beside it, outside the
/// middle of the area. A letter without room has a null box.
/// @param font   of the widget, its size in pixels
/// @param taken  occupied rectangles
std::vector<QRectF> boxesOf(const HighlightMarks &marks, const QFont &font, const QRectF &area,
                            const std::vector<QRectF> &taken);

/// The leader line from a letter's object to its box, if the box is not right beside it.
std::optional<QLineF> leaderOf(const HighlightMarks &marks, std::size_t text, const QRectF &box);

/// Draws arrows, leaders and letters, dark or coloured with a light rim: visible on any surface.
void drawHighlights(QPainter &painter, const HighlightMarks &marks, const std::vector<QRectF> &boxes);

/// The logical pixel position of a clip-space point; nothing behind the eye.
std::optional<QPointF> placeInPicture(const geometry::Setup &setup, const glm::dvec4 &clip);
/// The part of a line of clip space in front of the eye, logical pixels.
std::optional<QLineF> lineInPicture(const geometry::Setup &setup, glm::dvec4 from, glm::dvec4 to);

} // namespace unprojector::gui
