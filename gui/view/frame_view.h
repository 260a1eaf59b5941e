#pragma once

#include "gui/painters/background_painter.h"
#include "gui/painters/frame_painter.h"
#include "gui/painters/mesh_painter.h"
#include "gui/view/frame.h"

#include <QElapsedTimer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QTimer>

namespace unprojector::gui {

/// A widget that shows a Frame: objects are drawn into the frame when something has changed, and onto the widget goes a
/// copy of it, over which the rest is drawn.
///
/// Edges are smooth if wanted, as soon as the frame rests for a moment: where smoothing is slow, a frame in motion is
/// shown without. A grabbed picture is always the one at rest.
class FrameView : public QOpenGLWidget, protected QOpenGLExtraFunctions {
    Q_OBJECT
public:
    /// The surface format of a view: OpenGL 3.3 core, 24-bit depth, one sample. Stands for the pixel format that the
    /// paper sets up before the window exists.
    static QSurfaceFormat preCreateWindow();

    /// A matter of looks alone: the depths that are read are the same.
    void setSmoothEdges(bool smooth);
    bool smoothEdges() const { return m_smoothEdges; }

    bool isReady() const { return m_isCreated; }
    /// How this driver tells the object under a pixel; valid once the view is ready.
    ObjectIds objectIds() const { return m_frame.ids(); }

    /// Version and renderer, as OpenGL names them; empty before the view is ready.
    QString openGLName() const { return m_openGLName; }

signals:
    /// OpenGL cannot draw here, or not all of it, or not read depths; for a message.
    void failed(const QString &reason);

protected:
    explicit FrameView(QWidget *parent);

    // All of these up to showFrame() need the OpenGL context current.

    /// @return whether OpenGL is new enough; when it is not, `failed` has told so, and nothing can be drawn
    bool createFrame();
    void releaseFrame();
    /// Draws objects into the frame, with a background behind them. What cannot be drawn is told by `failed`.
    /// @param clipPlanes  world space; what lies on the negative side of one is not drawn. At most 8
    /// @return false when OpenGL gives no such frame
    bool drawFrame(const Drawable &drawn, const std::vector<SceneObject> &objects, const glm::dmat4 &clipFromWorld,
                   const glm::dmat4 &eyeFromWorld, const std::vector<glm::dvec4> &clipPlanes);
    /// Puts the frame onto the widget; where there is none, clears the widget.
    /// @return whether there is one
    bool showFrame();

    /// The widget's size in device pixels.
    Surface currentSurface() const;
    /// To release all that was made in the context, if anything was. It is called when the context goes, as it does when
    /// the widget moves to another window; a destructor has to call it itself.
    virtual void releaseGL() = 0;

    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

    Frame m_frame;
    bool m_isStale = true; ///< the frame does not show what there is to be seen

private:
    BackgroundPainter m_background;
    MeshPainter m_meshes;
    FramePainter m_painter;
    QString m_openGLName;
    bool m_isCreated = false;
    bool m_smoothEdges = true;
    bool m_isResizing = false;
    bool m_isOnScreen = false; ///< what is being painted is for the screen, not for somebody who grabs it
    QElapsedTimer m_sinceDrawn;
    QTimer m_restTimer;
};

} // namespace unprojector::gui
