#pragma once

#include "gui/document/model_store.h"
#include "gui/view/frame.h"
#include "gui/view/painters/background_painter.h"
#include "gui/view/painters/frame_painter.h"
#include "gui/view/painters/mesh_painter.h"
#include "gui/view/surface_canvas.h"

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QRect>
#include <QRectF>
#include <QTimer>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

class QPainter;

namespace unprojector::gui {

/// A widget that shows a Frame: objects are drawn into the frame after each change; the widget
/// shows a copy of it and draws the rest over that.
///
/// Objects that take too long to draw while the view moves are shown by stand-ins. As soon as the
/// view rests, they are drawn piece by piece into a second frame, which replaces the first one when
/// complete. Samples are read only from a complete frame: readers complete it first.
///
/// Edges are smooth if wanted, once the frame rests for a moment: where smoothing is slow, a moving
/// frame is shown without. A grabbed image is always the one at rest.
class FrameView : public QOpenGLWidget, protected QOpenGLExtraFunctions {
    Q_OBJECT
public:
    /// The surface format of a view: OpenGL 3.3 core, 24-bit depth, one sample. Corresponds to the
    /// pixel format that the paper sets up before the window exists.
    static QSurfaceFormat preCreateWindow();
    /// The limit of its size, if there is one.
    QSize sizeHint() const override;

    /// Sets the source of stand-ins, which outlives the view; without it there are none.
    void setModelStore(ModelStore &models) { m_models = &models; }
    /// Sets the time, in milliseconds, within which a whole frame is drawn while the view moves,
    /// with any number of triangles; with 0, large models always use stand-ins.
    void setMotionBudget(double milliseconds) { m_budget.motion = milliseconds; }

    /// Sets the time of one piece of a large model, in milliseconds: the window stays responsive in
    /// between. With 0, the smallest piece.
    void setSlice(int milliseconds) { m_budget.slice = milliseconds; }

    /// Affects only the appearance: the depths that are read are the same.
    void setSmoothEdges(bool smooth);
    /// The same: sets the options of the colours.
    void setShading(Shading shading);
    bool smoothEdges() const { return m_smoothEdges; }

    bool isReady() const { return m_isCreated; }
    /// Returns whether stand-ins, or the former frame, are shown until all is drawn.
    bool isCoarse() const { return m_isCoarse; }
    /// Requests a `drawingProgressed` when the pending frame is shown, even if it is shown at once.
    /// @return whether a frame is to be drawn on the screen
    bool awaitPicture();
    /// The longest side of an image that OpenGL can draw here, pixels; 0 before the view is ready.
    int largestPicture() const { return m_isCreated ? m_frames[0].largestSide() : 0; }
    /// The encoding of object ids with this driver; valid once the view is ready.
    ObjectIds objectIds() const { return m_frames[0].ids(); }

    /// Draws a surface of this size in the middle of the widget, independent of the widget's size;
    /// a larger one is shown scaled down. Nothing: the surface is the widget's.
    void setFixedSurface(const std::optional<geometry::Surface> &surface);
    /// The widget's size in device pixels.
    geometry::Surface widgetSurface() const;
    /// The placement of the surface on the widget.
    SurfacePlace place() const;
    /// The surface, logical pixels.
    QRectF surfaceRect() const;
    /// The position on the surface of a mouse event, corrected for fractional pixel ratios: Qt
    /// composes the view onto whole device pixels, while the event's position is relative to the
    /// view's logical corner.
    geometry::WidgetPoint widgetPosition(const QPointF &local) const;
    /// The position on the widget of a position on the surface.
    QPointF localPosition(const geometry::WidgetPoint &position) const;
    /// The rectangle on the surface of a rectangle on the widget.
    QRectF surfaceBox(const QRect &local) const;
    /// Returns whether the position of a mouse event is on the surface.
    bool isOnSurface(const QPointF &local) const;
    /// Converts a movement of the mouse to one on the surface.
    QPointF surfaceWay(const QPointF &way) const;
    /// The drawn pixels, the top row first, black outside the view. Call it while the view is
    /// painted.
    /// @param wanted  device pixels, origin top-left
    QImage pixelsIn(const QRect &wanted);

    /// Version and renderer, as OpenGL names them; empty before the view is ready.
    QString openGLName() const { return m_openGLName; }

signals:
    /// Emitted when OpenGL cannot draw here, only in part, or cannot read depths; for a message.
    void failed(const QString &reason);
    /// Emitted with the drawn share of a slow frame while another one or none is shown: from 0 to
    /// 1, when it is shown or no longer wanted. Not emitted while stand-ins are shown, except for
    /// the end of an awaited frame.
    void drawingProgressed(double share);

protected:
    explicit FrameView(QWidget *parent);

    // These functions, up to showFrame(), need the OpenGL context current.

    /// @return whether OpenGL is new enough; if not, `failed` was emitted, and nothing can be drawn
    bool createFrame();
    void releaseFrame();
    /// The content of a frame.
    enum class Drawn {
        /// no new objects: OpenGL cannot create the frame, or the former frame stays until all
        /// objects are drawn
        Nothing,
        StandIns, ///< stand-ins of the large objects, until all is drawn
        Objects
    };
    /// Draws objects into the frame, over a background. Emits `failed` for parts that cannot be
    /// drawn. Only on the screen may the frame be coarse, or the last one, until all is drawn.
    Drawn drawFrame(FrameContents contents);
    /// Draws the missing rest of the frame.
    void completeFrame();
    Frame &frame() { return m_frames[m_shown]; }
    /// Copies the frame to the widget; without a frame, clears the widget.
    /// @return whether there is one; then the caller draws over it and calls finishFrame()
    bool showFrame();
    /// Shows the surface on the widget if it is not the widget's own.
    void finishFrame();

    /// Draws contents completely at their own size, for an image that is not the view's.
    /// @param isTransparent  without a background behind the objects
    /// @param drawOver       draws over the objects; meanwhile currentSurface() is the image's
    /// @return an image without pixels if OpenGL cannot create such a framebuffer
    QImage drawnPicture(const FrameContents &contents, bool isTransparent, const std::function<void()> &drawOver);

    /// Paints over OpenGL's drawing, in the widget's font; afterwards OpenGL tests and blends
    /// nothing.
    /// @param devicePixelRatio  device pixels a unit of the painter: the surface's for logical
    /// pixels
    void paintOver(double devicePixelRatio, const std::function<void(QPainter &)> &paint);

    /// Reports progress of an awaited or slow frame, see drawingProgressed.
    void tellDrawn(double share);

    /// Returns whether an image of another size is being drawn.
    bool isDrawingPicture() const { return m_picture.has_value(); }
    /// The size of the current drawing: the widget's, the fixed one, or an image's other size while
    /// it is drawn.
    geometry::Surface currentSurface() const;
    /// Releases everything that was created in the context, if anything was. It is called when the
    /// context goes, as it does when the widget moves to another window; a destructor has to call
    /// it itself.
    virtual void releaseGL() = 0;

    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

    bool m_isStale = true; ///< the frame is out of date

private:
    bool beginFrame(Frame &frame);
    /// @return whether OpenGL can create such a frame; then objects can be drawn
    bool beginFrame(Frame &frame, const FrameContents &contents, bool isTransparent);
    void keepModels();
    void refine(const Deadline &deadline);
    void takeRest();

    ModelStore *m_models = nullptr;
    std::array<Frame, 2> m_frames;
    std::size_t m_shown = 0; ///< of m_frames
    FrameContents m_contents;
    MeshPainter::Place m_place; ///< in the contents: up to here they are drawn into the hidden frame
    bool m_isCoarse = false;
    bool m_isRefining = false; ///< drawing into the hidden frame has begun
    bool m_isTelling = false;  ///< emits `drawingProgressed`
    struct Budget {            ///< milliseconds
        double motion = 30.0;
        int slice = 30;
    };
    Budget m_budget;
    bool m_isFast = false; ///< these objects are fast enough to be drawn while the view moves
    double m_refineMilliseconds = 0.0;
    QTimer m_refineTimer;

    BackgroundPainter m_background;
    MeshPainter m_meshes;
    FramePainter m_painter;
    SurfaceCanvas m_canvas;
    QString m_openGLName;
    std::optional<geometry::Surface> m_picture; ///< of another size than the view's, while it is drawn
    bool m_isCreated = false;
    bool m_smoothEdges = true;
    bool m_isResizing = false;
    bool m_isOnScreen = false; ///< the painting is for the screen, not for a grabbed image
    QElapsedTimer m_sinceDrawn;
    QTimer m_restTimer;
};

} // namespace unprojector::gui
