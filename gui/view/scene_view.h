#pragma once

#include "core/lessons/lesson.h"
#include "gui/document/scene_document.h"
#include "gui/view/axis_dragger.h"
#include "gui/view/frame_view.h"
#include "gui/view/lifecycle_event.h"
#include "gui/view/painters/snap_mark.h"
#include "gui/view/point_marks.h"

#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QUrl>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;

namespace unprojector::gui {

class SceneOverlay;

/// The picture of a document's scene. Its life mirrors the paper's MFC view (Weng et al. 2008, section 4) by name:
/// preCreateWindow, onCreate, onSize, onDraw, onLButtonDown, onDestroy, called from Qt's own hooks. It reads depths
/// and asks the document what is there; it never unprojects. Clicks are read from its frame; what is drawn over that cannot be clicked.
class SceneView : public FrameView {
    Q_OBJECT
public:
    explicit SceneView(SceneDocument &document, QWidget *parent = nullptr);
    ~SceneView() override;

    /// The left button pressed at a widget position in logical pixels: the depth there is read and picked. Where a drag
    /// follows, what was picked before comes back. A position outside the view is ignored.
    void onLButtonDown(const WidgetPoint &position);

    /// Puts the crosshair onto a pixel and picks there, as Enter does. One outside the view is ignored.
    void pickPixel(const DevicePixel &pixel);

    /// The widget position of a mouse event, corrected for fractional pixel ratios: Qt composes the view onto whole
    /// device pixels, while the event's position is relative to the view's logical corner.
    WidgetPoint widgetPosition(const QPointF &local) const;

    /// Colours over the objects, below points, picks and crosshair; device pixels, null: none.
    void setMap(const QImage &map);
    /// How far this renderer moves corners, see DepthSample.
    double cornerShiftPixels();
    /// A widget over the upper right corner: while it is seen, the loupe stands beside it.
    void setCornerWidget(QWidget *widget) { m_corner = widget; }

    /// What a lesson letters in the picture.
    void setHighlights(const std::set<lessons::Highlight> &highlights);

    /// Whether a click places a point, where it is released; a drag navigates as ever. Marks of points are selected and dragged
    /// in either case.
    bool isPlacing() const { return m_isPlacing; }
    void setPlacing(bool isPlacing);

signals:
    void placingChanged(bool isPlacing);
    void hovered(const unprojector::geometry::WidgetPoint &position, const unprojector::unproject::DepthSample &sample);
    void pointerLeft();
    /// A step of the view's life has been taken; for a log.
    void happened(const unprojector::gui::LifecycleEvent &event);
    void filesDropped(const QList<QUrl> &urls);

protected:
    void initializeGL() override { onCreate(); }
    void resizeGL(int, int) override { onSize(); }
    void paintGL() override { onDraw(); }
    void releaseGL() override { onDestroy(); }

    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    enum class Drag { None, Orbit, Pan, Point, Axis };

    void onCreate();
    void onSize();
    void onDraw();
    void onDestroy();

    /// Draws the objects into the frame where it does not show the document as it is.
    /// @return what it drew
    Drawn updateFrame();
    /// What is under a position in a picture that is up to date.
    std::optional<DepthSample> sampleAt(const WidgetPoint &position);
    /// Of an object that is a cloud: of the dot that a point is drawn as.
    DepthSample withDot(DepthSample sample) const;
    void redraw();

    /// The point to turn about, to move with and to zoom to at a position.
    WorldPoint pivotAt(const WidgetPoint &position);
    /// The camera was moved so that a point stays where it is: at the same position the next step goes about it as well.
    void keepPivot(const WidgetPoint &position, const WorldPoint &pivot);
    void zoomAt(const WidgetPoint &position, double notches, const QString &mergeKey);
    /// Moves the camera so that the scene goes a way in logical pixels at the depth of the pivot.
    void pan(const QPointF &way, const WorldPoint &pivot, const QString &mergeKey);

    void showMenu(const WidgetPoint &position, const QPoint &global);
    void nameItself();

    /// Marks what a click at a position would take of the meshes; on a whole surface there is nothing to mark.
    void markAt(const WidgetPoint &position);
    void clearMark();

    // Placed points: scene_view_points.cpp.

    /// As they are seen now.
    const std::vector<PointMark> &marks();
    void drawMap();
    void drawMarks();
    /// What letters have to keep clear of: the axes in the corner and the widget over the other one.
    std::vector<QRectF> takenCorners() const;
    bool pressMark(const QMouseEvent &event);
    bool isPointDragged() const { return m_drag == Drag::Point || m_drag == Drag::Axis; }
    /// Slides the point on the surface under the pointer, and those that are selected besides by as many pixels.
    void dragPoint(const QPointF &local);
    /// The arrows by which the current point is moved off the surface: while points are placed.
    std::optional<std::array<AxisArrow, 3>> arrows() const;
    /// @return whether one was pressed
    bool pressArrow(const QPointF &pointer);
    void dragAlongAxis(const QPointF &local);
    void placePointAt(const QPointF &local);
    /// Whether a key is for points as things are.
    /// A point that is dragged is let go, as where the list of points changes below the hand.
    void endPointDrag();
    /// Places of the selected points that are not hidden.
    std::vector<std::size_t> selectedInView() const;
    bool isPointKey(const QKeyEvent &event) const;
    void pressPointKey(const QKeyEvent &event);
    /// Moves the selected points that are in sight on the surface. @param way  device pixels
    void nudge(const QPointF &way);
    /// Says of how many selected points that they stayed.
    void tellUnmoved(std::size_t count, const QPointF &at);
    void showTip(const QHelpEvent &event);
    /// Shows a place large while points are placed and dragged.
    /// @param at  device pixels; nothing: no more
    void aimLoupe(const std::optional<DevicePoint> &at);
    /// The centre of the pixel under a position; nothing outside the view.
    std::optional<DevicePoint> pointedAt(const QPointF &local) const;
    /// The pixels about a place of what has been drawn, the top row first.
    QImage pixelsAbout(const DevicePoint &at);

    // Keys do at the crosshair what the mouse does at the pointer.

    /// The pixel last clicked or moved to, at first that in the middle of the viewport.
    DevicePixel crosshair() const;
    /// Onto the pixel under a position; outside the view it stays.
    void putCrosshair(const WidgetPoint &position);
    void setCrosshairShown(bool isShown);

    // The pointer's readout waits for nothing: it is asked for, and reported when the GPU has it.
    void reportHover(const QPointF &local);
    void reportHover(const WidgetPoint &position);
    void requestHover();
    void takeHover();

    SceneDocument &m_document;
    std::unique_ptr<SceneOverlay> m_overlay;

    QImage m_map;
    std::set<lessons::Highlight> m_highlights;
    QPointer<QWidget> m_corner;
    std::optional<SnapMark> m_mark;
    std::optional<WidgetPoint> m_pointed;   ///< what is told of; told again of the next picture
    std::optional<WidgetPoint> m_hovered;   ///< to be read
    std::optional<WidgetPoint> m_requested; ///< being read
    QTimer m_hoverTimer;

    bool m_isPlacing = false;
    bool m_placesAtRelease = false;                ///< the press was not on a mark
    std::optional<std::vector<PointMark>> m_marks; ///< nothing: to be looked for
    std::size_t m_draggedPoint = 0;                ///< its place
    QPointF m_dragStart;                           ///< where its mark was at the press
    /// The other selected points in sight, and where their marks were.
    std::vector<std::pair<std::size_t, QPointF>> m_draggedWith;
    std::size_t m_leftBehind = 0; ///< selected points that a drag has not moved
    bool m_isMovingPoint = false; ///< what changes now is what the hand does
    QPointF m_pointGrab;          ///< from the pointer to the dragged mark
    int m_stepAtPress = 0;        ///< of undo, when the drag of a point began
    bool m_hasMovedPoint = false;
    int m_draggedAxis = 0;
    WorldPoint m_axisStart;  ///< where the dragged point was
    double m_axisFrom = 0.0; ///< where along the axis it was grabbed, from there
    std::optional<DevicePoint> m_loupeAt;

    Drag m_drag = Drag::None;
    bool m_hasMoved = false;               ///< far enough from the press to be a drag
    std::optional<QPointF> m_menuPosition; ///< where the right button was pressed and has not dragged yet
    std::optional<KeptPick> m_formerPick;  ///< the press has picked; a drag puts this back
    QPointF m_lastPosition;
    WorldPoint m_pivot;
    WidgetPoint m_stillPosition;
    std::optional<WorldPoint> m_stillPivot; ///< under m_stillPosition; gone with the next change of the document
    QString m_gesture;                      ///< the drag that is under way, undone as one
    int m_gestureCount = 0;

    std::optional<DevicePixel> m_crosshair; ///< where a hand has put it; none: in the middle
    bool m_isCrosshairShown = false;        ///< keys are being used
};

} // namespace unprojector::gui
