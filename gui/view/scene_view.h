#pragma once

#include "gui/document/scene_document.h"
#include "gui/painters/background_painter.h"
#include "gui/painters/line_painter.h"
#include "gui/painters/mesh_painter.h"
#include "gui/painters/pick_painter.h"
#include "gui/view/depth_reader.h"
#include "gui/view/lifecycle_event.h"

#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QUrl>

namespace unprojector::gui {

/// The picture of a document's scene. Its life mirrors the paper's MFC view (Weng et al. 2008, section 4) by name:
/// preCreateWindow, onCreate, onSize, onDraw, onLButtonDown, onDestroy, called from Qt's own hooks. It reads depths
/// and reports positions; it never unprojects.
class SceneView : public QOpenGLWidget, protected QOpenGLExtraFunctions {
    Q_OBJECT
public:
    /// The surface format of a view: OpenGL 3.3 core, 24-bit depth. Stands for the pixel format that the paper sets
    /// up before the window exists.
    /// @param samples  for multisampling; 0: none, and a depth is then read where it is unprojected, at the centre
    ///                 of the pixel, instead of at the driver's first sample
    static QSurfaceFormat preCreateWindow(int samples);

    SceneView(SceneDocument &document, int samples, QWidget *parent = nullptr);
    ~SceneView() override;

    /// The left button pressed at a widget position in logical pixels: the depth there is read and `clicked` emitted.
    /// A position outside the view is ignored.
    void onLButtonDown(const WidgetPoint &position);

    /// The widget position of a mouse event, corrected for fractional pixel ratios: Qt composes the view onto whole
    /// device pixels, while the event's position is relative to the view's logical corner.
    WidgetPoint widgetPosition(const QPointF &local) const;

    bool isReady() const { return m_isCreated; }

signals:
    void clicked(const unprojector::geometry::WidgetPoint &position, const unprojector::unproject::DepthSample &sample);
    void hovered(const unprojector::geometry::WidgetPoint &position, const unprojector::unproject::DepthSample &sample);
    void pointerLeft();
    /// OpenGL cannot draw here, or not read depths; for a message.
    void failed(const QString &reason);
    /// A step of the view's life has been taken; for a log.
    void happened(const unprojector::gui::LifecycleEvent &event);
    void filesDropped(const QList<QUrl> &urls);

protected:
    void initializeGL() override { onCreate(); }
    void resizeGL(int, int) override { onSize(); }
    void paintGL() override { onDraw(); }

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
    /// The picture itself, into the framebuffer that is bound.
    void draw();

    Surface currentSurface() const;
    /// The depth at a position, of a picture that is up to date.
    std::optional<DepthSample> depthAt(const WidgetPoint &position);
    void reportHover(const QPointF &local);
    void drawAxes(const EyeFrame &frame);
    void redraw();

    SceneDocument &m_document;
    DepthReader m_depthReader;
    BackgroundPainter m_background;
    MeshPainter m_meshes;
    LinePainter m_lines;
    PickPainter m_pickPainter;

    bool m_isCreated = false;
    bool m_needsUpload = true;
    bool m_needsDraw = true; ///< the framebuffer does not show the document as it is
    Drag m_drag = Drag::None;
    bool m_hasMoved = false; ///< far enough from the press to be a drag
    QPointF m_lastPosition;
    WorldPoint m_pivot;
    QString m_gesture; ///< the drag that is under way, undone as one
    int m_gestureCount = 0;
};

} // namespace unprojector::gui
