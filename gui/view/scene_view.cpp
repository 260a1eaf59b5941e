#include "gui/view/scene_view.h"

#include "gui/painters/scene_lines.h"

#include <QElapsedTimer>
#include <QMimeData>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

double milliseconds(const QElapsedTimer &timer)
{
    return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

} // namespace

QSurfaceFormat SceneView::preCreateWindow(int samples)
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(samples);
    return format;
}

SceneView::SceneView(SceneDocument &document, int samples, QWidget *parent)
    : QOpenGLWidget(parent), m_document(document)
{
    setFormat(preCreateWindow(samples));
    // The depth buffer is read between two pictures, so its content must outlive the drawing.
    setUpdateBehavior(QOpenGLWidget::PartialUpdate);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumSize(160, 120);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("3-D view"));
    setAccessibleDescription(tr("Press the left button on the model to read the world coordinate of that pixel"));

    connect(&m_document, &SceneDocument::objectsChanged, this, [this] {
        m_needsUpload = true;
        redraw();
    });
    connect(&m_document, &SceneDocument::geometryChanged, this, &SceneView::redraw);
    connect(&m_document, &SceneDocument::pickChanged, this, &SceneView::redraw);
}

SceneView::~SceneView()
{
    onDestroy();
}

void SceneView::redraw()
{
    m_needsDraw = true;
    update();
}

void SceneView::onCreate()
{
    QElapsedTimer timer;
    timer.start();
    initializeOpenGLFunctions();
    const QSurfaceFormat actual = context()->format();
    if (actual.version() < qMakePair(3, 3)) {
        emit failed(tr("OpenGL %1.%2 is too old: the view needs 3.3. Update the graphics driver.")
                        .arg(actual.majorVersion())
                        .arg(actual.minorVersion()));
        return;
    }
    m_depthReader.initialize();
    m_background.initialize();
    m_meshes.initialize();
    m_lines.initialize();
    m_pickPainter.initialize();
    m_needsUpload = true;
    m_isCreated = true;
    const QSurfaceFormat asked = format();
    emit happened({LifecycleEvent::Kind::PreCreateWindow, QString(),
                   QStringLiteral("OpenGL %1.%2 core, depth %3 bits, stencil %4 bits, %5 samples")
                       .arg(asked.majorVersion())
                       .arg(asked.minorVersion())
                       .arg(asked.depthBufferSize())
                       .arg(asked.stencilBufferSize())
                       .arg(std::max(0, asked.samples())),
                   0.0});
    emit happened({LifecycleEvent::Kind::OnCreate, QString(),
                   QStringLiteral("glCreateProgram, glCreateShader, glCompileShader, glLinkProgram"),
                   milliseconds(timer)});
    // The context is a new one when the widget moves to another window: everything in the old one is released first.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneView::onDestroy, Qt::UniqueConnection);
}

Surface SceneView::currentSurface() const
{
    return surfaceFromWidget(width(), height(), devicePixelRatio());
}

void SceneView::onSize()
{
    QElapsedTimer timer;
    timer.start();
    m_needsDraw = true;
    const Surface surface = currentSurface();
    m_document.setSurface(surface);
    const Viewport &v = m_document.geometry().viewport;
    emit happened({LifecycleEvent::Kind::OnSize,
                   QStringLiteral("%1, %2").arg(surface.widthPixels).arg(surface.heightPixels),
                   QStringLiteral("glViewport(%1, %2, %3, %4)")
                       .arg(std::lround(v.x))
                       .arg(std::lround(v.y))
                       .arg(std::lround(v.width))
                       .arg(std::lround(v.height)),
                   milliseconds(timer)});
}

void SceneView::onDraw()
{
    if (!m_isCreated)
        return;
    QElapsedTimer timer;
    timer.start();
    draw();
    emit happened({LifecycleEvent::Kind::OnDraw, QString(), QStringLiteral("glClear, glDrawElements, glDrawArrays"),
                   milliseconds(timer)});
}

void SceneView::draw()
{
    // A pixel ratio can change without a change of size.
    if (m_document.geometry().surface != currentSurface())
        m_document.setSurface(currentSurface());
    if (m_needsUpload) {
        m_meshes.upload(m_document.objects());
        m_needsUpload = false;
    }

    const ViewGeometry &g = m_document.geometry();
    const Result<glm::dmat4> matrix = clipFromWorld(g);
    const Result<EyeFrame> frame = eyeFrame(g.camera);
    if (!matrix || !frame)
        return;

    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glClearColor(0.80f, 0.82f, 0.84f, 1.0f);
    glClearDepthf(static_cast<float>(g.depthRange.atFar));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glViewport(std::lround(g.viewport.x), std::lround(g.viewport.y), std::lround(g.viewport.width),
               std::lround(g.viewport.height));
    glDepthRangef(static_cast<float>(g.depthRange.atNear), static_cast<float>(g.depthRange.atFar));

    m_background.draw();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(g.depthRange.atNear < g.depthRange.atFar ? GL_LESS : GL_GREATER);
    m_meshes.draw(m_document.objects(), *matrix, eyeFromWorld(*frame), m_document.scene().clipPlanes);

    // What is only drawn must not be picked: it leaves the depth buffer alone.
    glDepthMask(GL_FALSE);
    const float ratio = static_cast<float>(g.surface.devicePixelRatio);
    const glm::vec2 viewportSize(g.viewport.width, g.viewport.height);
    m_lines.draw(groundLines(m_document.ground(), m_document.groundSpacing()), *matrix, viewportSize, ratio);
    m_lines.draw(axisLines(m_document.ground()), *matrix, viewportSize, 2.0f * ratio);
    if (const auto &pick = m_document.pick(); pick && pick->hit && pick->point.world.formula) {
        const WorldPoint &point = *pick->point.world.formula;
        const std::vector<LineSegment> drops = dropLines(point, m_document.ground());
        m_lines.draw(drops, *matrix, viewportSize, 2.0f * ratio);
        glDisable(GL_DEPTH_TEST);
        m_lines.draw(faded(drops), *matrix, viewportSize, 1.5f * ratio);
        m_pickPainter.draw(point, *matrix, viewportSize, ratio);
    }
    glDisable(GL_DEPTH_TEST);
    drawAxes(*frame);
    glDepthMask(GL_TRUE);
    m_needsDraw = false;
}

void SceneView::drawAxes(const EyeFrame &frame)
{
    const Surface surface = m_document.geometry().surface;
    const double ratio = surface.devicePixelRatio;
    const int side = static_cast<int>(std::lround(84 * ratio));
    if (surface.widthPixels < 3 * side || surface.heightPixels < 3 * side)
        return;
    glViewport(0, 0, side, side);
    const Result<glm::dmat4> box = clipFromEye(Ortho{-1.45, 1.45, -1.45, 1.45, -2.0, 2.0});
    if (box)
        m_lines.draw(triadLines(frame), *box, glm::vec2(side, side), 2.0f * static_cast<float>(ratio));
}

void SceneView::onDestroy()
{
    if (!m_isCreated)
        return;
    QElapsedTimer timer;
    timer.start();
    makeCurrent();
    m_depthReader.release();
    m_background.release();
    m_meshes.release();
    m_lines.release();
    m_pickPainter.release();
    m_isCreated = false;
    m_needsUpload = true;
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneView::onDestroy);
    doneCurrent();
    emit happened({LifecycleEvent::Kind::OnDestroy, QString(),
                   QStringLiteral("glDeleteProgram, glDeleteBuffers, glDeleteVertexArrays, glDeleteTextures"),
                   milliseconds(timer)});
}

std::optional<DepthSample> SceneView::depthAt(const WidgetPoint &position)
{
    makeCurrent();
    if (!m_isCreated)
        return std::nullopt;
    glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    if (m_needsDraw)
        onDraw();
    const Surface surface = m_document.geometry().surface;
    const Result<DevicePixel> pixel = devicePixelFromWidget(surface, position);
    std::optional<DepthSample> sample;
    if (pixel) {
        sample =
            m_depthReader.read(defaultFramebufferObject(), surface, *pixel, m_document.geometry().depthRange.atFar);
        if (!sample)
            emit failed(tr("The depth of this pixel could not be read: OpenGL reported an error."));
    }
    doneCurrent();
    return sample;
}

void SceneView::onLButtonDown(const WidgetPoint &position)
{
    QElapsedTimer timer;
    timer.start();
    const std::optional<DepthSample> sample = depthAt(position);
    if (!sample)
        return;
    const Surface &surface = m_document.geometry().surface;
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(surface, position)) {
        emit happened({LifecycleEvent::Kind::OnLButtonDown, QStringLiteral("%1, %2").arg(position.x).arg(position.y),
                       QStringLiteral("glReadPixels(%1, %2, 1, 1, GL_DEPTH_COMPONENT, …) = %3")
                           .arg(pixel->i)
                           .arg(framebufferRow(surface, *pixel))
                           .arg(sample->depth, 0, 'g', 9),
                       milliseconds(timer)});
    }
    m_pivot = m_document.pivotAt(position, *sample);
    emit clicked(position, *sample);
}

WidgetPoint SceneView::widgetPosition(const QPointF &local) const
{
    const QPointF corner = mapTo(window(), QPointF(0.0, 0.0));
    return widgetOnSurface(currentSurface(), WidgetPoint(local.x(), local.y()), WidgetPoint(corner.x(), corner.y()));
}

void SceneView::mousePressEvent(QMouseEvent *event)
{
    const bool pans = event->button() == Qt::MiddleButton
                      || (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    if (!pans && event->button() != Qt::LeftButton)
        return;
    m_lastPosition = event->position();
    m_hasMoved = false;
    m_gesture = QStringLiteral("drag %1").arg(++m_gestureCount);
    const WidgetPoint position = widgetPosition(event->position());
    if (pans) {
        if (const std::optional<DepthSample> sample = depthAt(position))
            m_pivot = m_document.pivotAt(position, *sample);
        m_drag = Drag::Pan;
        return;
    }
    onLButtonDown(position);
    m_drag = Drag::Orbit;
}

void SceneView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF delta = event->position() - m_lastPosition;
    // A hand that only clicks trembles by a pixel or two: that is no drag yet.
    constexpr double kTremblePixels = 3.0;
    if (m_drag != Drag::None && !m_hasMoved && std::hypot(delta.x(), delta.y()) < kTremblePixels)
        return;
    m_hasMoved = true;
    m_lastPosition = event->position();
    const ViewGeometry &g = m_document.geometry();
    switch (m_drag) {
    case Drag::None:
        if (event->buttons() == Qt::NoButton)
            reportHover(event->position());
        return;
    case Drag::Orbit: {
        // Half a turn for the height of the view.
        const double radiansPerPixel = 3.14159265358979323846 / std::max(1, height());
        m_document.setCamera(orbited(g.camera, m_pivot, delta.x() * radiansPerPixel, delta.y() * radiansPerPixel),
                             m_gesture);
        return;
    }
    case Drag::Pan: {
        const Result<EyeFrame> frame = eyeFrame(g.camera);
        if (!frame)
            return;
        const double scale = worldPerPixel(g, m_pivot) * g.surface.devicePixelRatio;
        m_document.setCamera(moved(g.camera, (frame->upward * delta.y() - frame->side * delta.x()) * scale), m_gesture);
        return;
    }
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    m_drag = Drag::None;
    if (event->buttons() == Qt::NoButton && rect().contains(event->position().toPoint()))
        reportHover(event->position());
}

void SceneView::reportHover(const QPointF &local)
{
    const WidgetPoint position = widgetPosition(local);
    if (const std::optional<DepthSample> sample = depthAt(position))
        emit hovered(position, *sample);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const WidgetPoint position = widgetPosition(event->position());
    const std::optional<DepthSample> sample = depthAt(position);
    if (!sample || !sample->hit)
        return;
    emit clicked(position, *sample);
    m_document.setCamera(recentered(m_document.geometry(), m_document.pivotAt(position, *sample)));
}

void SceneView::wheelEvent(QWheelEvent *event)
{
    const WidgetPoint position = widgetPosition(event->position());
    const std::optional<DepthSample> sample = depthAt(position);
    if (!sample)
        return;
    const double notches = event->angleDelta().y() / 120.0;
    const double factor = std::pow(1.2, notches);
    const ViewGeometry next = zoomed(m_document.geometry(), m_document.pivotAt(position, *sample), factor);
    m_document.setView(next.camera, next.projection, QStringLiteral("wheel"));
    reportHover(event->position());
    event->accept();
}

void SceneView::leaveEvent(QEvent *event)
{
    QOpenGLWidget::leaveEvent(event);
    emit pointerLeft();
}

void SceneView::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void SceneView::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    emit filesDropped(event->mimeData()->urls());
}

} // namespace unprojector::gui
