#pragma once

#include <QPoint>
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

/// A tool of the view that handles mouse and keys before navigation and picking, and draws over the
/// frame. Positions are logical pixels of the view, as in its events.
class ViewTool {
public:
    enum class Press {
        Passed,    ///< the press is not for the tool
        Navigates, ///< the tool has used the press; a drag moves the view
        Drags      ///< a following drag is the tool's
    };

    ViewTool() = default;
    virtual ~ViewTool() = default;
    ViewTool(const ViewTool &) = delete;
    ViewTool &operator=(const ViewTool &) = delete;

    /// Returns whether the view ignores a press of the left button: the second one of a double-click,
    /// if the first one was the tool's. Tells the user.
    virtual bool refuses(const QMouseEvent &event) = 0;
    /// Handles the press of the left button.
    /// @param mergeKey  of a following drag, which is one step of undo
    virtual Press press(const QMouseEvent &event, const QString &mergeKey) = 0;
    virtual void dragTo(const QPointF &local) = 0;
    /// Ends a drag of the tool or of the view.
    virtual void release(const QPointF &local) = 0;
    /// Returns whether the tool handles the click when a passed press is released: then nothing is
    /// picked.
    virtual bool takesClicks() const = 0;
    virtual void click(const QPointF &local) = 0;
    /// Handles a move of the pointer with no button down; nothing: it has left the view.
    virtual void hover(const std::optional<QPointF> &local) = 0;

    /// Returns whether the tool handles a key in its present state.
    virtual bool isKey(const QKeyEvent &event) const = 0;
    /// @param isDragged  the view or the tool's object is being dragged
    virtual void pressKey(const QKeyEvent &event, bool isDragged) = 0;
    /// Opens the context menu of the tool's object at a position.
    /// @return false if there is none: the view then opens the menu of the pixel
    virtual bool showMenu(const QPointF &local, const QPoint &global) = 0;
    /// @return whether the tool has tips here, and has shown or hidden one
    virtual bool showTip(const QHelpEvent &event) = 0;

    /// Returns whether there is anything to draw. OpenGL's context is current, and the frame is
    /// drawn.
    virtual bool prepareToDraw() = 0;
    /// @param taken  rectangles of other texts, logical pixels
    virtual void draw(QPainter &painter, const std::vector<QRectF> &taken) = 0;
    /// Draws the marks of the scene, but not the pointer's, into an image of another size.
    /// @param area  of the image, logical pixels
    virtual void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) = 0;
};

} // namespace unprojector::gui
