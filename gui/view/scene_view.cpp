#include "gui/view/scene_view.h"

#include "core/scene/point_size.h"
#include "gui/document/camera_looks.h"
#include "gui/text/number_text.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/scene_overlay.h"
#include "gui/view/view_tool.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QPainter>
#include <QSurfaceFormat>

#include <algorithm>
#include <cstddef>
#include <utility>

// The hand is in scene_view_input.cpp, the keys are in scene_view_keys.cpp.

namespace unprojector::gui {
namespace {

const QString kObjectCalls = QStringLiteral("glBindFramebuffer, glClearBuffer, glDrawElements");

double milliseconds(const QElapsedTimer &timer)
{
    return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

} // namespace

SceneView::SceneView(SceneDocument &document, QWidget *parent)
    : FrameView(parent), m_document(document), m_overlay(std::make_unique<SceneOverlay>())
{
    setAcceptDrops(true);
    setCursor(Qt::CrossCursor);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("3-D view"));
    setAccessibleDescription(
        tr("Click the model, or press Enter, to read the world coordinate of the pixel under the "
           "pointer or the crosshair. Arrow keys turn, with Shift they move, with Ctrl they move the "
           "crosshair; plus and minus zoom"));
    m_hoverTimer.setSingleShot(true);

    // Its pixel says nothing of another scene, and what a hand turns or is about to place is not there any more.
    connect(&m_document, &SceneDocument::opened, this, [this] {
        m_crosshair.reset();
        m_drag = Drag::None;
        m_toolTakesClick = false;
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects) // the former pick may be on one that went
            m_formerPick.reset();
        if (changes & kSeen)
            redraw();
        else if (changes
                 & (Change::Pick | Change::GivenPoint | Change::WrongPoints | Change::Ray | Change::Landmarks
                    | Change::LandmarkSelection | Change::Curves))
            update(); // they are drawn over the frame
        if (changes & Change::Snap)
            clearMark();
    });
    connect(&m_hoverTimer, &QTimer::timeout, this, &SceneView::takeHover);
}

SceneView::~SceneView()
{
    onDestroy();
}

void SceneView::redraw()
{
    m_isStale = true;
    m_stillPivot.reset();
    m_mark.reset();
    update();
}

void SceneView::setMap(const QImage &map)
{
    if (m_map.isNull() && map.isNull())
        return;
    m_map = map;
    update();
}

void SceneView::setHighlights(const std::set<lessons::Highlight> &highlights)
{
    m_highlights = highlights;
    update();
}

void SceneView::onCreate()
{
    QElapsedTimer timer;
    timer.start();
    if (!createFrame())
        return;
    m_overlay->initialize();
    m_isStale = true;
    const auto described = [](const QSurfaceFormat &format) {
        return tr("OpenGL %1.%2 core, depth %3 bits, stencil %4 bits, %5 samples")
            .arg(format.majorVersion())
            .arg(format.minorVersion())
            .arg(format.depthBufferSize())
            .arg(format.stencilBufferSize())
            .arg(std::max(0, format.samples()));
    };
    emit happened({LifecycleEvent::Kind::PreCreateWindow, QString(),
                   tr("asked for: %1; came: %2").arg(described(preCreateWindow()), described(context()->format())),
                   0.0});
    emit happened({LifecycleEvent::Kind::OnCreate, QString(),
                   QStringLiteral("glCreateProgram, glCreateShader, glCompileShader, glLinkProgram"),
                   milliseconds(timer)});
}

void SceneView::onSize()
{
    QElapsedTimer timer;
    timer.start();
    const Surface surface = currentSurface();
    m_document.setSurface(surface);
    const Result<Drawable> drawn = drawable(m_document.geometry());
    if (!drawn)
        return;
    emit happened(
        {LifecycleEvent::Kind::OnSize, QStringLiteral("%1, %2").arg(surface.widthPixels).arg(surface.heightPixels),
         QStringLiteral("glViewport(%1, %2, %3, %4)").arg(drawn->x).arg(drawn->y).arg(drawn->width).arg(drawn->height),
         milliseconds(timer)});
}

void SceneView::onDraw()
{
    if (!isReady())
        return;
    QElapsedTimer timer;
    timer.start();
    const Drawn drawn = updateFrame();
    if (showFrame()) {
        drawMap();
        m_overlay->draw(m_document, m_isCrosshairShown ? std::optional(crosshair()) : std::nullopt, m_mark);
        drawTexts();
    }
    emit happened({LifecycleEvent::Kind::OnDraw, QString(),
                   drawn == Drawn::Nothing ? tr("glDrawArrays: the objects are as they were drawn before")
                                           : kObjectCalls + QStringLiteral(", glDrawArrays"),
                   milliseconds(timer), drawn == Drawn::StandIns});
    requestHover();
}

FrameView::Drawn SceneView::updateFrame()
{
    // A pixel ratio can change without a change of size.
    if (m_document.geometry().surface != currentSurface())
        m_document.setSurface(currentSurface());
    if (!m_isStale)
        return Drawn::Nothing;
    m_isStale = false;
    // What the pointer was to be told of the last picture is read in this one.
    if (const std::optional<PixelClick> dropped = std::exchange(m_requested, std::nullopt); dropped && !m_hovered)
        m_hovered = dropped->position;
    if (!m_hovered && m_drag == Drag::None) // the pointer rests, and what is under it is another place
        m_hovered = m_pointed;
    const Picture &g = m_document.geometry();
    const Result<glm::dmat4> matrix = clipFromWorld(g);
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<Drawable> drawn = drawable(g);
    if (!matrix || !frame || !drawn) {
        tellDrawn(1.0);
        return Drawn::Nothing;
    }
    return drawFrame({*drawn, m_document.objects(), *matrix, eyeFromWorld(*frame), m_document.scene().clipPlanes});
}

void SceneView::onDestroy()
{
    if (!isReady())
        return;
    QElapsedTimer timer;
    timer.start();
    makeCurrent();
    releaseFrame();
    m_overlay->release();
    m_requested.reset();
    doneCurrent();
    emit happened({LifecycleEvent::Kind::OnDestroy, QString(),
                   QStringLiteral("glDeleteFramebuffers, glDeleteProgram, glDeleteBuffers, glDeleteVertexArrays, "
                                  "glDeleteTextures"),
                   milliseconds(timer)});
}

double SceneView::cornerShiftPixels()
{
    if (!isReady())
        return kCornerShiftPixels;
    makeCurrent();
    const double shift = frame().cornerShiftPixels();
    doneCurrent();
    return shift;
}

std::optional<PixelClick> SceneView::clickAt(const WidgetPoint &position)
{
    if (!isReady())
        return std::nullopt;
    QElapsedTimer timer;
    timer.start();
    makeCurrent();
    if (updateFrame() != Drawn::Nothing)
        emit happened({LifecycleEvent::Kind::OnDraw, QString(), kObjectCalls, milliseconds(timer)});
    completeFrame();
    std::optional<PixelClick> click;
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, position)) {
        if (const std::optional<DepthSample> sample = frame().sample(*pixel))
            click = {position, *pixel, withDot(*sample)};
        else
            emit failed(tr("The depth of this pixel could not be read: OpenGL reported an error."));
    }
    doneCurrent();
    return click;
}

void SceneView::setTool(ViewTool &tool)
{
    m_tool = &tool;
}

void SceneView::endToolDrag()
{
    if (m_drag == Drag::Tool)
        m_drag = Drag::None;
}

int SceneView::cornerWidth() const
{
    return m_corner && m_corner->isVisible() ? m_corner->width() : 0;
}

void SceneView::drawMap()
{
    if (!m_map.isNull())
        paintOver(1.0, [this](QPainter &painter) { painter.drawImage(0, 0, m_map); }); // pixel on pixel
}

std::vector<QRectF> SceneView::takenCorners() const
{
    std::vector<QRectF> taken;
    const Picture &g = m_document.geometry();
    if (const Result<Drawable> drawn = drawable(g)) {
        const double side = SceneOverlay::axesSide(*drawn);
        const WidgetPoint low = widgetFromDevice(
            g.surface, deviceFromWindow(g.surface, WindowPoint(g.viewport.x, g.viewport.y + side, 0.0)));
        taken.emplace_back(QPointF(low.x, low.y), QSizeF(side, side) / g.surface.devicePixelRatio);
    }
    if (const int width = cornerWidth(); width > 0)
        taken.emplace_back(QRectF(rect().topRight() - QPoint(width, 0), QSizeF(m_corner->size())));
    return taken;
}

void SceneView::drawTexts()
{
    const HighlightMarks highlights = highlightsInView(m_document, m_highlights);
    const bool hasTool = m_tool && m_tool->prepareToDraw();
    if (!hasTool && highlights.isEmpty())
        return;
    paintOver(currentSurface().devicePixelRatio, [&](QPainter &painter) {
        const std::vector<QRectF> boxes = boxesOf(highlights, painter.font(), QRectF(rect()), takenCorners());
        drawHighlights(painter, highlights, boxes);
        if (hasTool)
            m_tool->draw(painter, boxes);
    });
}

QImage SceneView::pixelsIn(const QRect &wanted)
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
            to[4 * i + 3] = 255; // whatever the framebuffer has there
        }
    }
    return pixels;
}

DepthSample SceneView::withDot(DepthSample sample) const
{
    const std::vector<SceneObject> &objects = m_document.objects();
    if (sample.object && *sample.object < objects.size() && objects[*sample.object].model->pointCount() > 0)
        sample.dotPixels = pointPixels(m_document.geometry().surface);
    return sample;
}

void SceneView::onLButtonDown(const WidgetPoint &position)
{
    QElapsedTimer timer;
    timer.start();
    const std::optional<PixelClick> click = clickAt(position);
    if (!click)
        return;
    emit happened(
        {LifecycleEvent::Kind::OnLButtonDown, QStringLiteral("%1, %2").arg(position.x).arg(position.y),
         QStringLiteral("glReadPixels(%1, %2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth): depth = %3, object id %4")
             .arg(click->pixel.i)
             .arg(framebufferRow(m_document.geometry().surface, click->pixel))
             .arg(depthText(click->sample.depth))
             .arg(click->sample.object ? *click->sample.object + 1 : 0),
         milliseconds(timer)});
    const Result<Pick> pick = m_document.unprojected(*click);
    m_pivot = pivotOf(m_document.geometry().camera(), pick);
    m_document.setPick(pick);
}

} // namespace unprojector::gui
