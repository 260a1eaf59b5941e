#pragma once

#include "gui/document/scene_document.h"
#include "gui/view/frame_view.h"
#include "gui/view/lifecycle_event.h"

#include <QTimer>
#include <QUrl>

#include <memory>

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

    /// The widget position of a mouse event, corrected for fractional pixel ratios: Qt composes the view onto whole
    /// device pixels, while the event's position is relative to the view's logical corner.
    WidgetPoint widgetPosition(const QPointF &local) const;

signals:
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
    enum class Drag { None, Orbit, Pan };

    void onCreate();
    void onSize();
    void onDraw();
    void onDestroy();

    /// Draws the objects into the frame where it does not show the document as it is.
    /// @return whether it had to
    bool updateFrame();
    /// What is under a position in a picture that is up to date.
    std::optional<DepthSample> sampleAt(const WidgetPoint &position);
    void redraw();

    /// The point to turn about, to move with and to zoom to at a position.
    WorldPoint pivotAt(const WidgetPoint &position);
    /// The camera was moved so that a point stays where it is: at the same position the next step goes about it as well.
    void keepPivot(const WidgetPoint &position, const WorldPoint &pivot);
    void zoomAt(const WidgetPoint &position, double notches, const QString &mergeKey);
    /// Moves the camera so that the scene goes a way in logical pixels at the depth of the pivot.
    void pan(const QPointF &way, const WorldPoint &pivot, const QString &mergeKey);

    void showMenu(const WidgetPoint &position, const QPoint &global);

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

    std::optional<WidgetPoint> m_hovered;   ///< to be read
    std::optional<WidgetPoint> m_requested; ///< being read
    QTimer m_hoverTimer;

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
