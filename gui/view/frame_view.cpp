#include "gui/view/frame_view.h"

#include "gui/view/opengl_check.h"

#include <QEvent>
#include <QFontInfo>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSurfaceFormat>
#include <QWindow>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

/// A frame unchanged for so long is at rest.
constexpr int kRestMilliseconds = 120;

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Window).lightnessF() < 0.5F;
}

/// The background colours at the bottom and at the top: light or dark like the window.
std::array<QColor, 2> backgroundOf(const QPalette &palette)
{
    return isDark(palette) ? std::array{QColor(0x25, 0x27, 0x2a), QColor(0x36, 0x39, 0x3e)}
                           : std::array{QColor(0xd4, 0xd9, 0xde), QColor(0xf2, 0xf5, 0xf7)};
}

/// The colour beside the viewport: darker than any background, so that its edges are visible.
QColor aroundOf(const QPalette &palette)
{
    return isDark(palette) ? QColor(0x17, 0x18, 0x1a) : QColor(0xcc, 0xd1, 0xd6);
}

/// The names of Mesa's, Windows' and Chromium's OpenGL for machines without a graphics card.
bool isSoftwareRenderer(const QString &name)
{
    constexpr std::array kNames{"llvmpipe", "softpipe", "Software Rasterizer", "SWR", "SwiftShader", "Basic Render"};
    return std::any_of(kNames.begin(), kNames.end(),
                       [&name](const char *known) { return name.contains(QLatin1String(known)); });
}

} // namespace

QSurfaceFormat FrameView::preCreateWindow()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);
    return format;
}

FrameView::FrameView(QWidget *parent) : QOpenGLWidget(parent)
{
    setFormat(preCreateWindow());
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    m_restTimer.setSingleShot(true);
    connect(&m_restTimer, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    m_refineTimer.setSingleShot(true);
    connect(&m_refineTimer, &QTimer::timeout, this, &FrameView::takeRest);
}

QSize FrameView::sizeHint() const
{
    return maximumSize() == QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX) ? QOpenGLWidget::sizeHint() : maximumSize();
}

void FrameView::setSmoothEdges(bool smooth)
{
    m_smoothEdges = smooth;
    update();
}

void FrameView::setShading(Shading shading)
{
    m_meshes.setShading(std::move(shading));
    m_isStale = true;
    update();
}

bool FrameView::awaitPicture()
{
    // A widget that is not on a screen is painted only for a grab, and never by itself.
    const QWindow *screenWindow = window()->windowHandle();
    const bool isOnAScreen = isVisible() && screenWindow && screenWindow->isExposed();
    m_isTelling = m_isTelling || (m_isCreated && m_isStale && isOnAScreen);
    return m_isTelling;
}

bool FrameView::createFrame()
{
    initializeOpenGLFunctions();
    if (const QString problem = openGLProblem(*context()); !problem.isEmpty()) {
        emit failed(problem);
        return false;
    }
    const auto text = [this](GLenum name) {
        return QString::fromLatin1(reinterpret_cast<const char *>(glGetString(name)));
    };
    m_openGLName = QStringLiteral("%1, %2").arg(text(GL_VERSION), text(GL_RENDERER));
    for (Frame &frame : m_frames)
        frame.initialize();
    m_background.initialize();
    m_meshes.initialize(m_frames[0].ids(), isSoftwareRenderer(text(GL_RENDERER)));
    m_painter.initialize();
    m_canvas.initialize();
    m_isCreated = true;
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &FrameView::releaseGL, Qt::UniqueConnection);
    return true;
}

void FrameView::releaseFrame()
{
    for (Frame &frame : m_frames)
        frame.release();
    m_refineTimer.stop();
    m_isRefining = m_isCoarse = false;
    tellDrawn(1.0);
    m_background.release();
    m_meshes.release();
    m_painter.release();
    m_canvas.release();
    m_isCreated = false;
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &FrameView::releaseGL);
}

bool FrameView::beginFrame(Frame &frame, const FrameContents &contents, bool isTransparent)
{
    if (!frame.begin(contents.drawn, isTransparent ? QColor(Qt::transparent) : aroundOf(palette())))
        return false;
    if (!isTransparent)
        m_background.draw(backgroundOf(palette()));
    frame.beginObjects();
    return true;
}

/// @return whether OpenGL can create such a frame
bool FrameView::beginFrame(Frame &frame)
{
    if (!beginFrame(frame, m_contents, false)) {
        const Surface &surface = m_contents.drawn.setup.surface;
        emit failed(tr("OpenGL cannot draw %1 × %2 pixels. Make the window smaller, or update the graphics driver.")
                        .arg(surface.widthPixels)
                        .arg(surface.heightPixels));
        return false;
    }
    return true;
}

QImage FrameView::drawnPicture(const FrameContents &contents, bool isTransparent, const std::function<void()> &drawOver)
{
    const Surface &surface = contents.drawn.setup.surface;
    QOpenGLFramebufferObject target(surface.widthPixels, surface.heightPixels,
                                    QOpenGLFramebufferObject::CombinedDepthStencil);
    Frame drawn;
    drawn.initialize();
    QImage picture;
    if (target.isValid() && beginFrame(drawn, contents, isTransparent)) {
        MeshPainter::Place place;
        m_meshes.drawOn(contents, place, Deadline({}));
        drawn.end();
        target.bind();
        m_painter.setStale();
        m_painter.draw({drawn.framebuffer(), drawn.colors(), drawn.depths(), surface.widthPixels, surface.heightPixels},
                       m_smoothEdges);
        m_painter.setStale();
        const QScopedValueRollback at(m_picture, std::optional(surface));
        drawOver();
        picture = target.toImage();
        if (!isTransparent)
            picture = picture.convertToFormat(QImage::Format_RGB32);
    }
    drawn.release();
    target.release();
    for (const QString &failure : m_meshes.takeFailures())
        emit failed(failure);
    return picture;
}

/// Keeps only the shown models, and their stand-ins, in the graphics memory.
void FrameView::keepModels()
{
    std::set<const Model *> models;
    for (const SceneObject &object : m_contents.objects)
        models.insert(object.model.get());
    if (const auto standIns = m_models ? m_models->standInsFor(m_contents.objects) : std::nullopt) {
        for (const SceneObject &object : *standIns)
            models.insert(object.model.get());
    }
    m_meshes.keepOnly(models);
}

void FrameView::tellDrawn(double share)
{
    if (!m_isTelling)
        return;
    m_isTelling = share < 1.0;
    emit drawingProgressed(share);
}

FrameView::Drawn FrameView::drawFrame(FrameContents contents)
{
    const auto haveSameModels = [](const std::vector<SceneObject> &a, const std::vector<SceneObject> &b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SceneObject &x, const SceneObject &y) {
            return x.model == y.model && x.isHidden == y.isHidden;
        });
    };
    const auto isThereStill = [&contents](const SceneObject &old) {
        return std::any_of(contents.objects.begin(), contents.objects.end(),
                           [&old](const SceneObject &object) { return object.model == old.model; });
    };
    const bool isAnotherScene = std::none_of(m_contents.objects.begin(), m_contents.objects.end(), isThereStill);
    m_isFast = m_isFast && haveSameModels(contents.objects, m_contents.objects);
    m_painter.setStale();
    m_sinceDrawn.start();
    m_isRefining = false;
    m_refineTimer.stop();
    m_contents = std::move(contents);
    keepModels();
    const bool isLarge = m_models && ModelStore::areLarge(m_contents.objects);
    m_isCoarse = isLarge && m_isOnScreen && !m_isFast;
    const auto standIns = m_isCoarse ? m_models->standInsFor(m_contents.objects) : std::nullopt;
    if (m_isCoarse) {
        m_refineTimer.start(standIns ? kRestMilliseconds : 0);
        if (!standIns) {
            m_isTelling = true;
            tellDrawn(0.0);
            // A new scene's name must not appear with the image of the old one.
            if (isAnotherScene && beginFrame(frame()))
                frame().end();
            return Drawn::Nothing;
        }
    }
    tellDrawn(1.0);
    QElapsedTimer timer;
    timer.start();
    if (!beginFrame(frame()))
        return Drawn::Nothing;
    MeshPainter::Place place;
    if (standIns) {
        FrameContents coarse = m_contents;
        coarse.objects = *standIns;
        coarse.areStandIns = true;
        m_meshes.drawOn(coarse, place, Deadline({}));
    } else {
        m_meshes.drawOn(m_contents, place, Deadline({}));
        if (m_isFast) {
            glFinish();
            m_isFast = static_cast<double>(timer.nsecsElapsed()) * 1e-6 < 2.0 * m_budget.motion;
        }
    }
    frame().end();
    for (const QString &failure : m_meshes.takeFailures())
        emit failed(failure);
    return m_isCoarse ? Drawn::StandIns : Drawn::Objects;
}

/// Continues drawing into the hidden frame, and shows it when complete.
void FrameView::refine(const Deadline &deadline)
{
    QElapsedTimer timer;
    timer.start();
    Frame &next = m_frames[1 - m_shown];
    if (m_isRefining) {
        next.beginObjects();
    } else {
        m_place = {};
        m_refineMilliseconds = 0.0;
        if (!beginFrame(next)) {
            m_isCoarse = false; // no retry before something else is drawn
            tellDrawn(1.0);
            return;
        }
        m_isRefining = true;
    }
    const bool isDone = m_meshes.drawOn(m_contents, m_place, deadline);
    if (isDone)
        next.end();
    else
        next.pause();
    for (const QString &failure : m_meshes.takeFailures())
        emit failed(failure);
    if (!isDone) {
        m_refineMilliseconds += static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        tellDrawn(std::min(m_meshes.shareDone(m_contents, m_place), 0.999));
        return;
    }
    glFinish();
    m_refineMilliseconds += static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    m_isFast = m_refineMilliseconds < m_budget.motion;
    m_isRefining = m_isCoarse = false;
    m_shown = 1 - m_shown;
    m_painter.setStale();
    tellDrawn(1.0);
}

void FrameView::paintOver(double devicePixelRatio, const std::function<void(QPainter &)> &paint)
{
    {
        // Not onto the widget itself: while it is grabbed, painting on it goes elsewhere.
        const Surface surface = currentSurface();
        QOpenGLPaintDevice device(surface.widthPixels, surface.heightPixels);
        device.setDevicePixelRatio(devicePixelRatio);
        QPainter painter(&device);
        QFont letters = font(); // in pixels, because this device has no points of its own
        letters.setPixelSize(QFontInfo(font()).pixelSize());
        painter.setFont(letters);
        paint(painter);
    }
    // QPainter leaves these enabled, which later drawing does not expect.
    for (const GLenum what : {GL_BLEND, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_DEPTH_TEST})
        glDisable(what);
}

void FrameView::completeFrame()
{
    m_refineTimer.stop();
    if (m_isCoarse)
        refine(Deadline({}));
}

void FrameView::takeRest()
{
    if (!m_isCreated || !m_isCoarse)
        return;
    makeCurrent();
    refine(Deadline(m_budget.slice));
    doneCurrent();
    if (m_isCoarse) {
        m_refineTimer.start(0);
        return;
    }
    m_models->makeStandIns(m_contents.objects);
    update();
}

bool FrameView::showFrame()
{
    if (!m_isOnScreen)
        completeFrame();
    if (!frame().setup()) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); // the reason was reported
        return false;
    }
    if (!place().isWidget() && !m_canvas.begin()) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        return false;
    }
    const bool isInMotion = m_isOnScreen && m_painter.isSmoothingSlow() && !m_sinceDrawn.hasExpired(kRestMilliseconds);
    const Surface &surface = frame().setup()->surface;
    m_painter.draw(
        {frame().framebuffer(), frame().colors(), frame().depths(), surface.widthPixels, surface.heightPixels},
        m_smoothEdges && !isInMotion);
    if (m_smoothEdges && isInMotion)
        m_restTimer.start(kRestMilliseconds);
    return true;
}

void FrameView::finishFrame()
{
    if (!place().isWidget())
        m_canvas.show(defaultFramebufferObject(), widgetSurface(), place(), aroundOf(palette()));
}

Surface FrameView::widgetSurface() const
{
    return m_picture ? *m_picture : surfaceFromWidget(width(), height(), devicePixelRatio());
}

Surface FrameView::currentSurface() const
{
    return m_picture ? *m_picture : m_canvas.fixedSurface.value_or(widgetSurface());
}

SurfacePlace FrameView::place() const
{
    return {widgetSurface(), currentSurface()};
}

void FrameView::paintEvent(QPaintEvent *event)
{
    // QOpenGLWidget paints a resized view at once, and then again with the window. Once is enough,
    // and a window in layout, such as one that opens, is not painted at every step.
    if (m_isResizing)
        return;
    const QScopedValueRollback onScreen(m_isOnScreen, true);
    QOpenGLWidget::paintEvent(event);
}

void FrameView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange) {
        m_isStale = true;
        update();
    }
    QOpenGLWidget::changeEvent(event);
}

void FrameView::resizeEvent(QResizeEvent *event)
{
    {
        const QScopedValueRollback resizing(m_isResizing, true);
        QOpenGLWidget::resizeEvent(event);
    }
    update(); // the window doesn't repaint a view if only its height changes
}

WidgetPoint FrameView::widgetPosition(const QPointF &local) const
{
    const QPointF corner = mapTo(window(), QPointF(0.0, 0.0));
    return place().onSurface(
        widgetOnSurface(widgetSurface(), WidgetPoint(local.x(), local.y()), WidgetPoint(corner.x(), corner.y())));
}

QPointF FrameView::localPosition(const WidgetPoint &position) const
{
    const WidgetPoint local = place().onWidget(position);
    return {local.x, local.y};
}

QRectF FrameView::surfaceBox(const QRect &local) const
{
    const auto corner = [this](int x, int y) {
        const WidgetPoint position = place().onSurface(WidgetPoint(x, y));
        return QPointF(position.x, position.y);
    };
    return QRectF(corner(local.x(), local.y()), corner(local.x() + local.width(), local.y() + local.height()))
        .intersected(surfaceRect());
}

bool FrameView::isOnSurface(const QPointF &local) const
{
    const WidgetPoint position = widgetPosition(local);
    return QRectF(rect()).contains(local) && surfaceRect().contains(position.x, position.y);
}

QPointF FrameView::surfaceWay(const QPointF &way) const
{
    const WidgetPoint from = place().onSurface({0.0, 0.0}), to = place().onSurface({way.x(), way.y()});
    return {to.x - from.x, to.y - from.y};
}

QRectF FrameView::surfaceRect() const
{
    const Surface surface = currentSurface();
    return {0.0, 0.0, surface.widthPixels / surface.devicePixelRatio, surface.heightPixels / surface.devicePixelRatio};
}

void FrameView::setFixedSurface(const std::optional<Surface> &surface)
{
    if (surface == m_canvas.fixedSurface)
        return;
    m_canvas.fixedSurface = surface;
    m_isStale = true;
    update();
}

QImage FrameView::pixelsIn(const QRect &wanted)
{
    const Surface surface = currentSurface();
    const QRect there = wanted & QRect(0, 0, surface.widthPixels, surface.heightPixels);
    QImage pixels(wanted.size(), QImage::Format_RGBA8888);
    pixels.fill(Qt::black);
    if (there.isEmpty())
        return pixels;
    QImage read(there.size(), QImage::Format_RGBA8888);
    // Four bytes a pixel: no row is padded.
    glReadPixels(there.left(), framebufferRow(surface, {there.left(), there.bottom()}), there.width(), there.height(),
                 GL_RGBA, GL_UNSIGNED_BYTE, read.bits());
    for (int row = 0; row < there.height(); ++row) {
        const uchar *from = read.constScanLine(there.height() - 1 - row);
        const std::ptrdiff_t beside = there.left() - wanted.left();
        uchar *to = pixels.scanLine(there.top() - wanted.top() + row) + 4 * beside;
        for (std::ptrdiff_t i = 0; i < there.width(); ++i) {
            std::copy_n(from + 4 * i, 3, to + 4 * i);
            to[4 * i + 3] = 255; // ignores the framebuffer's alpha
        }
    }
    return pixels;
}

} // namespace unprojector::gui
