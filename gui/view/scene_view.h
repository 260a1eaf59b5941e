#pragma once

#include "core/lessons/lesson.h"
#include "gui/document/scene_document.h"
#include "gui/view/frame_view.h"
#include "gui/view/lifecycle_event.h"
#include "gui/view/painters/snap_mark.h"

#include <QImage>
#include <QPointer>
#include <QRect>
#include <QTimer>
#include <QUrl>

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
class ViewTool;

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

    /// Puts the crosshair there and picks.
    void pickAt(const WidgetPoint &position);
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

    /// What a hand does besides navigating and picking. It lives as long as the view.
    void setTool(ViewTool &tool);

    // For the tool.

    /// What is under a position in a picture that is up to date; nothing outside of it, and where OpenGL cannot read it.
    std::optional<PixelClick> clickAt(const WidgetPoint &position);
    /// The pixels of what has been drawn, the top row first, black outside the view. While the view is painted.
    /// @param wanted  device pixels, origin top-left
    QImage pixelsIn(const QRect &wanted);
    /// Tells what is there, as where the pointer is.
    void reportHover(const WidgetPoint &position);
    /// The drag of the tool is over, whatever buttons are down.
    void endToolDrag();
    /// How much of the view's width the widget over the upper right corner takes, logical pixels.
    int cornerWidth() const;

signals:
    void hovered(const unprojector::unproject::PixelClick &click);
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
    enum class Drag { None, Orbit, Pan, Tool };

    void onCreate();
    void onSize();
    void onDraw();
    void onDestroy();

    /// Draws the objects into the frame where it does not show the document as it is.
    /// @return what it drew
    Drawn updateFrame();
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

    /// Marks what a click at a position would take of the meshes; on a whole surface there is nothing to mark.
    void markAt(const WidgetPoint &position);
    void clearMark();

    void drawMap();
    /// The letters of a lesson, and what the tool draws.
    void drawTexts();
    /// What letters have to keep clear of: the axes in the corner and the widget over the other one.
    std::vector<QRectF> takenCorners() const;

    // Keys do at the crosshair what the mouse does at the pointer.

    /// The pixel last clicked or moved to, at first that in the middle of the viewport.
    DevicePixel crosshair() const;
    /// Onto the pixel under a position; outside the view it stays.
    void putCrosshair(const WidgetPoint &position);
    void setCrosshairShown(bool isShown);

    // The pointer's readout waits for nothing: it is asked for, and reported when the GPU has it.
    void reportHover(const QPointF &local);
    void requestHover();
    void takeHover();

    SceneDocument &m_document;
    std::unique_ptr<SceneOverlay> m_overlay;

    QImage m_map;
    std::set<lessons::Highlight> m_highlights;
    QPointer<QWidget> m_corner;
    std::optional<SnapMark> m_mark;
    std::optional<WidgetPoint> m_pointed;  ///< what is told of; told again of the next picture
    std::optional<WidgetPoint> m_hovered;  ///< to be read
    std::optional<PixelClick> m_requested; ///< being read
    QTimer m_hoverTimer;

    ViewTool *m_tool = nullptr;
    bool m_toolTakesClick = false; ///< the press was none of the tool's own, and its release may be a click
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
