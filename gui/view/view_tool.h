#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace unprojector::gui {

/// What a hand does in the view besides navigating and picking, and what that draws over the picture. The view asks it
/// first. Positions are logical pixels of the view, as its events have them.
class ViewTool {
public:
    enum class Press {
        Passed,    ///< the press is none of the tool's
        Navigates, ///< the tool has taken it; what may be dragged is the view
        Drags      ///< the drag that may follow is the tool's
    };

    ViewTool() = default;
    virtual ~ViewTool() = default;
    ViewTool(const ViewTool &) = delete;
    ViewTool &operator=(const ViewTool &) = delete;

    /// The left button goes down.
    /// @param mergeKey  of the drag that may follow, which is undone as one
    virtual Press press(const QMouseEvent &event, const QString &mergeKey) = 0;
    virtual void dragTo(const QPointF &local) = 0;
    /// The drag of the tool, or one that turned the view, ends.
    virtual void release(const QPointF &local) = 0;
    /// Whether a click that the tool has passed is the tool's all the same, where it is released: then none picks.
    virtual bool takesClicks() const = 0;
    virtual void click(const QPointF &local) = 0;
    /// The pointer moves with no button down, or has left the view.
    virtual void hover(const std::optional<QPointF> &local) = 0;

    /// Whether a key is for the tool as things are.
    virtual bool isKey(const QKeyEvent &event) const = 0;
    /// @param isDragged  a hand drags something, the view or what the tool has
    virtual void pressKey(const QKeyEvent &event, bool isDragged) = 0;
    /// @return whether the tool has tips here, and has shown or hidden one
    virtual bool showTip(const QHelpEvent &event) = 0;

    /// Whether there is anything to draw. OpenGL's context is current, and the picture is drawn.
    virtual bool prepareToDraw() = 0;
    /// @param taken  where other texts stand, logical pixels
    virtual void draw(QPainter &painter, const std::vector<QRectF> &taken) = 0;
    /// Draws what belongs to the scene, and nothing of the hand's, into a picture of another size.
    /// @param area  of the picture, logical pixels
    virtual void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) = 0;
};

} // namespace unprojector::gui
