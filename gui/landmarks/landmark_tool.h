#pragma once

#include "gui/document/scene_document.h"
#include "gui/landmarks/axis_dragger.h"
#include "gui/landmarks/landmark_drawing.h"
#include "gui/view/view_tool.h"

#include <QObject>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::gui {

class ExpectedLandmarks;
class SceneView;

/// The tool for landmarks in the view: draws, selects and drags their marks, moves them by keys,
/// and places new ones by clicks.
class LandmarkTool : public QObject, public ViewTool {
    Q_OBJECT
public:
    LandmarkTool(SceneDocument &document, SceneView &view);
    /// Sets the expected places that are drawn with the marks.
    /// @param expected  outlives the tool
    void setExpected(ExpectedLandmarks &expected);

    /// Returns whether a click places a landmark on release; a drag still navigates. Marks can be
    /// selected and dragged in both modes.
    bool isPlacing() const { return m_isPlacing; }
    void setPlacing(bool isPlacing);

    /// Shows arrows along the axes at the current landmark until another one is current, or hides
    /// them. Without this, they appear only while the pointer is on its mark.
    /// @return false if no placed landmark is current
    bool setArrowsShown(bool areShown);

    const LandmarkLooks &looks() const { return m_drawing.looks(); }
    void setLooks(const LandmarkLooks &looks) { m_drawing.setLooks(looks); }

    /// Refuses the second press of a double-click: a landmark there would be on the same pixel.
    bool refuses(const QMouseEvent &event) override;
    /// Selects a visible mark. A mark that was already selected can be dragged; in placing mode,
    /// any mark can.
    Press press(const QMouseEvent &event, const QString &mergeKey) override;
    void dragTo(const QPointF &local) override;
    void release(const QPointF &local) override;
    bool takesClicks() const override { return m_isPlacing; }
    void click(const QPointF &local) override;
    void hover(const std::optional<QPointF> &local) override;
    bool isKey(const QKeyEvent &event) const override;
    void pressKey(const QKeyEvent &event, bool isDragged) override;
    bool showMenu(const QPointF &local, const QPoint &global) override;
    bool showTip(const QHelpEvent &event) override;
    bool prepareToDraw() override;
    void draw(QPainter &painter, const std::vector<QRectF> &taken) override;
    void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) override
    {
        m_drawing.drawPicture(painter, area, taken);
    }

signals:
    void placingChanged(bool isPlacing);
    /// Emitted when the menu of the selected landmarks is wanted: a right click on a mark.
    void menuRequested(const QPoint &global);
    /// Emitted when arrows requested by setArrowsShown appear or disappear.
    void arrowsChanged(bool areShown);

private:
    enum class Drag {
        None,
        Pressed, ///< a mark, while a name waits: a click places the name, a drag moves the mark
        Landmark,
        Axis
    };
    /// A press while placing.
    struct PlacingPress {
        QPointF at;           ///< logical pixels
        quint64 milliseconds; ///< of the event; 0: unknown
    };
    enum class Arrows {
        Hidden,
        Hovered, ///< as long as the pointer is at the landmark or at an arrow
        Asked    ///< until another landmark is current
    };

    /// Moves the landmark to the surface under the pointer, and the other selected ones by as many
    /// pixels.
    void dragLandmark(const QPointF &local);
    /// The current landmark, if it is placed and not hidden.
    std::optional<std::size_t> visibleCurrent() const;
    /// The shown arrows, which move the current landmark off the surface.
    std::optional<std::array<AxisArrow, 3>> arrows() const;
    void setArrows(Arrows arrows);
    /// Shows and hides the arrows as the pointer comes to the current landmark's mark and leaves.
    /// While a name waits for a click, the pointer doesn't show them.
    void hoverArrows(const std::optional<QPointF> &local);
    /// @return whether an arrow was pressed
    bool pressArrow(const QPointF &pointer);
    void dragAlongAxis(const QPointF &local);
    /// Ends the drag of a landmark, also when the list changes meanwhile.
    void endDrag();
    /// The selected landmarks that are not hidden.
    std::vector<std::size_t> selectedInView() const;
    /// Moves the selected visible landmarks on the surface. @param way  device pixels
    void nudge(const QPointF &way);
    /// Reports how many selected landmarks could not be moved.
    void tellUnmoved(std::size_t count, const QPointF &at);
    /// The centre of the pixel under a position; nothing outside the view.
    std::optional<geometry::DevicePoint> pointedAt(const QPointF &local) const;

    SceneDocument &m_document;
    SceneView &m_view;
    LandmarkDrawing m_drawing;
    bool m_isPlacing = false;
    std::optional<PlacingPress> m_lastPress; ///< nothing if the last press was not while placing
    Arrows m_arrows = Arrows::Hidden;
    std::optional<std::size_t> m_arrowsOf; ///< the landmark that was current when they appeared
    bool m_isOverCurrent = false;          ///< the pointer is on the current landmark's mark
    Drag m_drag = Drag::None;
    QString m_mergeKey;        ///< of the drag
    std::size_t m_dragged = 0; ///< its index
    QPointF m_dragStart;       ///< position of its mark at the press
    /// The other selected visible landmarks, and the start positions of their marks.
    std::vector<std::pair<std::size_t, QPointF>> m_draggedWith;
    std::size_t m_leftBehind = 0; ///< number of selected landmarks that the drag has not moved
    bool m_isMoving = false;      ///< the tool itself is changing the document
    bool m_hasMoved = false;
    QPointF m_grab;        ///< from the pointer to the dragged mark
    int m_stepAtPress = 0; ///< index in the undo stack when the drag began
    int m_axis = 0;
    geometry::WorldPoint m_axisStart; ///< start position of the dragged landmark
    double m_axisFrom = 0.0;          ///< where along the axis it was grabbed, relative to m_axisStart
};

} // namespace unprojector::gui
