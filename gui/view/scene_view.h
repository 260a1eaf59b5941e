#pragma once

#include "core/lessons/highlight.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/view/crosshair.h"
#include "gui/view/frame_view.h"
#include "gui/view/hover_reader.h"
#include "gui/view/lifecycle_event.h"
#include "gui/view/navigation.h"
#include "gui/view/painters/snap_mark.h"
#include "gui/view/picture_options.h"

#include <QImage>
#include <QPointer>
#include <QUrl>

#include <memory>
#include <optional>
#include <set>
#include <vector>

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;

namespace unprojector::gui {

class SceneOverlay;
class SceneView;
class ViewTool;

/// The content of a frame of the document's scene; nothing if there is no valid setup.
std::optional<FrameContents> frameContentsOf(const SceneDocument &document);
/// See gui/view/scene_picture.h.
geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

/// The view of a document's scene. Its functions mirror the paper's MFC view (Weng et al. 2008,
/// section 4) by name: preCreateWindow, onCreate, onSize, onDraw, onLButtonDown, onDestroy, called
/// from Qt's own hooks. It reads depths and lets the document unproject them. Clicks are read from
/// its frame; marks over the frame cannot be clicked.
class SceneView : public FrameView {
    Q_OBJECT
    friend geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

public:
    explicit SceneView(SceneDocument &document, QWidget *parent = nullptr);
    ~SceneView() override;

    /// Handles the left button pressed at a widget position in logical pixels: reads the depth
    /// there and picks. If a drag follows, the former pick is restored. Ignores positions outside
    /// the view.
    void onLButtonDown(const geometry::WidgetPoint &position);

    /// Moves the crosshair there and picks.
    void pickAt(const geometry::WidgetPoint &position);
    /// Moves the crosshair to a pixel and picks there, as Enter does. Ignores pixels outside the
    /// view.
    void pickPixel(const geometry::DevicePixel &pixel);

    /// Sets colours over the objects, below points, picks and crosshair; device pixels, null: none.
    void setMap(const QImage &map);
    bool hasMap() const { return !m_map.isNull(); }
    /// The distance by which this renderer moves corners, see DepthSample.
    double cornerShiftPixels();
    /// Sets a widget over the upper right corner: while it is visible, the loupe is beside it.
    void setCornerWidget(QWidget *widget) { m_corner = widget; }

    /// Sets the lesson's labels in the view.
    void setHighlights(const std::set<lessons::Highlight> &highlights);

    /// Marks a quantity of the pick's formulas, see quantity_marks.h; empty: none.
    void setMarkedTerm(const QString &term);

    /// Shows or hides the picked point's coordinates beside its lines along the axes.
    void setHasDropLabels(bool hasThem);

    /// Sets the tool that gets mouse and keys before navigation and picking. It lives as long as
    /// the view.
    void setTool(ViewTool &tool) { m_tool = &tool; }

    // Functions for the tool.

    /// The click at a position of an up-to-date frame; nothing outside the view, and if OpenGL
    /// cannot read it.
    std::optional<unproject::PixelClick> clickAt(const geometry::WidgetPoint &position);
    /// Reports a position as if the pointer were there.
    void reportHover(const geometry::WidgetPoint &position) { m_hover.follow(position); }
    /// Ends the tool's drag, even with buttons pressed.
    void endToolDrag();
    /// The width of the surface under the widget over the upper right corner, logical pixels.
    int cornerWidth() const { return qRound(cornerBox().width()); }

signals:
    void hovered(const unprojector::unproject::PixelClick &click);
    void pointerLeft();
    /// Emitted after each step of the view's life; for a log.
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

    /// Draws the objects into the frame if it is out of date.
    /// @return what it drew
    Drawn updateFrame();
    void redraw();

    /// The pivot at a position: to turn about, to pan with and to zoom to.
    geometry::WorldPoint pivotAt(const geometry::WidgetPoint &position);
    /// Shows the snap mark of a position, and reports what is there.
    void lookAt(const geometry::WidgetPoint &position);
    /// Opens the context menu at a position: the tool's, else the pixel's.
    void openMenu(const QPointF &local, const QPoint &global);
    /// Handles that the pointer has left the surface.
    void leaveSurface();
    /// Shows a mark, or none.
    void setMark(const std::optional<SnapMark> &mark);

    /// Draws the marks over the objects.
    void drawOver(const PictureMarks &marks);
    /// The part of the surface under the widget over the upper right corner.
    QRectF cornerBox() const;
    void drawMap();
    /// Draws the letters of a lesson and the tool's marks.
    void drawTexts(const PictureMarks &marks);
    void setCrosshairShown(bool isShown);

    SceneDocument &m_document;
    std::unique_ptr<SceneOverlay> m_overlay;

    QImage m_map;
    std::set<lessons::Highlight> m_highlights;
    QString m_markedTerm;
    bool m_hasDropLabels = true;
    QPointer<QWidget> m_corner;
    std::optional<SnapMark> m_mark;
    HoverReader m_hover;
    Navigation m_navigation;
    Crosshair m_crosshair;

    ViewTool *m_tool = nullptr;
    bool m_toolTakesClick = false; ///< the tool passed the press, but its release may be a click for the tool
    Drag m_drag = Drag::None;
    bool m_hasMoved = false;               ///< far enough from the press to be a drag
    std::optional<QPointF> m_menuPosition; ///< where the right button was pressed, until it drags
    std::optional<KeptPick> m_formerPick;  ///< the pick before the press; a drag restores it
    QPointF m_lastPosition;
};

} // namespace unprojector::gui
