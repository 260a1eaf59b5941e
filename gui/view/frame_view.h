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

/// A widget that shows a Frame: objects are drawn into the frame when something has changed, and onto the widget goes a
/// copy of it, over which the rest is drawn.
///
/// What takes too long to draw while the view moves is shown by stand-ins, and drawn itself bit by bit into a second frame
/// as soon as the view rests; that frame takes the first one's place when it is whole. Nothing is ever read from a frame
/// that is not: who reads completes it first.
///
/// Edges are smooth if wanted, as soon as the frame rests for a moment: where smoothing is slow, a frame in motion is
/// shown without. A grabbed picture is always the one at rest.
class FrameView : public QOpenGLWidget, protected QOpenGLExtraFunctions {
    Q_OBJECT
public:
    /// The surface format of a view: OpenGL 3.3 core, 24-bit depth, one sample. Stands for the pixel format that the
    /// paper sets up before the window exists.
    static QSurfaceFormat preCreateWindow();
    /// As large as it may be, where that is bounded.
    QSize sizeHint() const override;

    /// Where the stand-ins come from; without it there are none. It outlives the view.
    void setModelStore(ModelStore &models) { m_models = &models; }
    /// What takes no longer than this, in milliseconds, is drawn whole while the view moves, however many triangles it
    /// has; with 0, large models always have their stand-ins.
    void setMotionBudget(double milliseconds) { m_budget.motion = milliseconds; }

    /// Of a large model so much is drawn at once, in milliseconds: the window stays awake in between. With 0, a piece.
    void setSlice(int milliseconds) { m_budget.slice = milliseconds; }

    /// A matter of looks alone: the depths that are read are the same.
    void setSmoothEdges(bool smooth);
    bool smoothEdges() const { return m_smoothEdges; }

    bool isReady() const { return m_isCreated; }
    /// Whether stand-ins are shown, or what was there before, until all is drawn.
    bool isCoarse() const { return m_isCoarse; }
    /// Asks to be told of the picture that is to be drawn, also where it comes at once: `drawingProgressed` then says when it is
    /// there.
    /// @return whether there is one to be drawn on the screen
    bool awaitPicture();
    /// The longest side of a picture that OpenGL draws here, pixels; 0 before the view is ready.
    int largestPicture() const { return m_isCreated ? m_frames[0].largestSide() : 0; }
    /// How this driver tells the object under a pixel; valid once the view is ready.
    ObjectIds objectIds() const { return m_frames[0].ids(); }

    /// Draws a surface of this size in the middle of the widget, whatever the widget's own size; a larger one is shown scaled
    /// down. Nothing: the surface is the widget's.
    void setFixedSurface(const std::optional<geometry::Surface> &surface);
    /// The widget's size in device pixels.
    geometry::Surface widgetSurface() const;
    /// Where the surface is shown on the widget.
    SurfacePlace place() const;
    /// The surface, logical pixels.
    QRectF surfaceRect() const;
    /// The position on the surface of a mouse event, corrected for fractional pixel ratios: Qt composes the view onto whole
    /// device pixels, while the event's position is relative to the view's logical corner.
    geometry::WidgetPoint widgetPosition(const QPointF &local) const;
    /// Where a position on the surface is shown on the widget.
    QPointF localPosition(const geometry::WidgetPoint &position) const;
    /// What a rectangle of the widget covers of the surface.
    QRectF surfaceBox(const QRect &local) const;
    /// Whether a position of a mouse event is one on the surface.
    bool isOnSurface(const QPointF &local) const;
    /// A way of the mouse as one on the surface.
    QPointF surfaceWay(const QPointF &way) const;
    /// The pixels of what has been drawn, the top row first, black outside the view. While the view is painted.
    /// @param wanted  device pixels, origin top-left
    QImage pixelsIn(const QRect &wanted);

    /// Version and renderer, as OpenGL names them; empty before the view is ready.
    QString openGLName() const { return m_openGLName; }

signals:
    /// OpenGL cannot draw here, or not all of it, or not read depths; for a message.
    void failed(const QString &reason);
    /// How much is drawn of a picture that is long in coming, while another one or none is shown: from 0 up to 1, when it is
    /// shown or no longer wanted. Not told where stand-ins are shown, but for the end of what is awaited.
    void drawingProgressed(double share);

protected:
    explicit FrameView(QWidget *parent);

    // All of these up to showFrame() need the OpenGL context current.

    /// @return whether OpenGL is new enough; when it is not, `failed` has told so, and nothing can be drawn
    bool createFrame();
    void releaseFrame();
    /// What a frame shows of its objects.
    enum class Drawn {
        Nothing, ///< of these: OpenGL gives no such frame, or the last one, empty if none of it is left, stays until all is
                 ///< drawn
        StandIns, ///< of the large ones, until all is drawn
        Objects
    };
    /// Draws objects into the frame, with a background behind them. What cannot be drawn is told by `failed`. Only on the
    /// screen may the frame be coarse, or the last one, until all is drawn.
    Drawn drawFrame(FrameContents contents);
    /// Draws what is missing of the frame.
    void completeFrame();
    Frame &frame() { return m_frames[m_shown]; }
    /// Puts the frame onto the widget; where there is none, clears the widget.
    /// @return whether there is one; then finishFrame() ends what is drawn over it
    bool showFrame();
    /// Shows the surface on the widget where it is not the widget's own.
    void finishFrame();

    /// Draws contents at their own size, whole, for a picture that is not the view's.
    /// @param isTransparent  nothing is drawn behind the objects
    /// @param drawOver       draws on over the objects; meanwhile currentSurface() is the picture's
    /// @return without pixels where OpenGL gives no such framebuffer
    QImage drawnPicture(const FrameContents &contents, bool isTransparent, const std::function<void()> &drawOver);

    /// Paints over what OpenGL has drawn, in the widget's font; then OpenGL tests and blends nothing.
    /// @param devicePixelRatio  device pixels to a unit of the painter: that of the surface for logical pixels
    void paintOver(double devicePixelRatio, const std::function<void(QPainter &)> &paint);

    /// Tells of a picture that is awaited or long in coming, see drawingProgressed.
    void tellDrawn(double share);

    /// Whether a picture of another size is being drawn.
    bool isDrawingPicture() const { return m_picture.has_value(); }
    /// The size of what is drawn: the widget's, the fixed one, or that of a picture of another size while it is drawn.
    geometry::Surface currentSurface() const;
    /// To release all that was made in the context, if anything was. It is called when the context goes, as it does when
    /// the widget moves to another window; a destructor has to call it itself.
    virtual void releaseGL() = 0;

    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

    bool m_isStale = true; ///< the frame does not show what there is to be seen

private:
    bool beginFrame(Frame &frame);
    /// @return whether OpenGL gives such a frame; then objects can be drawn
    bool beginFrame(Frame &frame, const FrameContents &contents, bool isTransparent);
    void keepModels();
    void refine(const Deadline &deadline);
    void takeRest();

    ModelStore *m_models = nullptr;
    std::array<Frame, 2> m_frames;
    std::size_t m_shown = 0; ///< of m_frames
    FrameContents m_contents;
    MeshPainter::Place m_place; ///< in the contents: so far they are drawn into the frame that is not shown
    bool m_isCoarse = false;
    bool m_isRefining = false; ///< drawing into it has begun
    bool m_isTelling = false;  ///< by `drawingProgressed`
    struct Budget {            ///< milliseconds
        double motion = 30.0;
        int slice = 30;
    };
    Budget m_budget;
    bool m_isFast = false; ///< these objects can be drawn while the view moves, however many they are
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
    bool m_isOnScreen = false; ///< what is being painted is for the screen, not for somebody who grabs it
    QElapsedTimer m_sinceDrawn;
    QTimer m_restTimer;
};

} // namespace unprojector::gui
