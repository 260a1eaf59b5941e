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

/// What a frame of the document's scene is drawn of; nothing where there is no valid setup.
std::optional<FrameContents> frameContentsOf(const SceneDocument &document);
/// See gui/view/scene_picture.h.
geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

/// The picture of a document's scene. Its life mirrors the paper's MFC view (Weng et al. 2008, section 4) by name:
/// preCreateWindow, onCreate, onSize, onDraw, onLButtonDown, onDestroy, called from Qt's own hooks. It reads depths
/// and asks the document what is there; it never unprojects. Clicks are read from its frame; what is drawn over that cannot be clicked.
class SceneView : public FrameView {
    Q_OBJECT
    friend geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

public:
    explicit SceneView(SceneDocument &document, QWidget *parent = nullptr);
    ~SceneView() override;

    /// The left button pressed at a widget position in logical pixels: the depth there is read and picked. Where a drag
    /// follows, what was picked before comes back. A position outside the view is ignored.
    void onLButtonDown(const geometry::WidgetPoint &position);

    /// Puts the crosshair there and picks.
    void pickAt(const geometry::WidgetPoint &position);
    /// Puts the crosshair onto a pixel and picks there, as Enter does. One outside the view is ignored.
    void pickPixel(const geometry::DevicePixel &pixel);

    /// Colours over the objects, below points, picks and crosshair; device pixels, null: none.
    void setMap(const QImage &map);
    bool hasMap() const { return !m_map.isNull(); }
    /// How far this renderer moves corners, see DepthSample.
    double cornerShiftPixels();
    /// A widget over the upper right corner: while it is seen, the loupe stands beside it.
    void setCornerWidget(QWidget *widget) { m_corner = widget; }

    /// What a lesson letters in the picture.
    void setHighlights(const std::set<lessons::Highlight> &highlights);

    /// Marks a quantity of the pick's formulas, see quantity_marks.h; empty: none.
    void setMarkedTerm(const QString &term);

    /// Whether the coordinates of the picked point stand beside its lines along the axes.
    void setHasDropLabels(bool hasThem);

    /// What a hand does besides navigating and picking. It lives as long as the view.
    void setTool(ViewTool &tool) { m_tool = &tool; }

    // For the tool.

    /// What is under a position in a picture that is up to date; nothing outside of it, and where OpenGL cannot read it.
    std::optional<unproject::PixelClick> clickAt(const geometry::WidgetPoint &position);
    /// Reports what is at a position, as it does where the pointer is.
    void reportHover(const geometry::WidgetPoint &position) { m_hover.follow(position); }
    /// The drag of the tool is over, whatever buttons are down.
    void endToolDrag();
    /// How much of the surface's width the widget over the upper right corner takes, logical pixels.
    int cornerWidth() const { return qRound(cornerBox().width()); }

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
    void redraw();

    /// The point to turn about, to move with and to zoom to at a position.
    geometry::WorldPoint pivotAt(const geometry::WidgetPoint &position);
    /// Marks what a click at a position would take of the meshes, and reports what is there.
    void lookAt(const geometry::WidgetPoint &position);
    /// The pointer is over nothing any more.
    void leaveSurface();
    /// Shows a mark, or none.
    void setMark(const std::optional<SnapMark> &mark);

    /// Draws what lies over the objects.
    void drawOver(const PictureMarks &marks);
    /// What the widget over the upper right corner takes of the surface.
    QRectF cornerBox() const;
    void drawMap();
    /// The letters of a lesson, and what the tool draws.
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
    bool m_toolTakesClick = false; ///< the press was none of the tool's own, and its release may be a click
    Drag m_drag = Drag::None;
    bool m_hasMoved = false;               ///< far enough from the press to be a drag
    std::optional<QPointF> m_menuPosition; ///< where the right button was pressed and has not dragged yet
    std::optional<KeptPick> m_formerPick;  ///< the press has picked; a drag puts this back
    QPointF m_lastPosition;
};

} // namespace unprojector::gui
