#include "gui/outside/observer_view.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/framing.h"
#include "core/geometry/numbers.h"
#include "gui/document/given_points.h"
#include "gui/document/picks.h"
#include "gui/text/error_text.h"
#include "gui/view/navigation.h"
#include "gui/view/quantity_marks.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

/// The keys that this view takes before the window's shortcuts see them.
bool isOwnKey(const QKeyEvent &event)
{
    if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier)
        return false;
    switch (event.key()) {
    case Qt::Key_F:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: return true;
    default: return false;
    }
}

} // namespace

ObserverView::ObserverView(SceneDocument &document, QWidget *parent)
    : FrameView(parent), m_document(document), m_overlay(document)
{
    setAccessibleName(tr("Observer view"));
    setAccessibleDescription(
        tr("The camera and its view volume from outside. Arrow keys turn the view, plus and minus zoom, F fits it."));
    m_observer.projection() = Perspective{Angle::fromDegrees(35.0), 1.0, 0.1, 100.0};

    // A hidden view is notified as well, but draws nothing.
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects) {
            m_isPlaced = m_isTouched = false;
            m_drag = Drag::None;
            setHotPlane(std::nullopt);
        }
        m_isStale |= bool(changes & (kVisibleChanges | Change::Preview));
        if (changes & (kVisibleChanges | Change::Preview | Change::Pick | Change::GivenPoint | Change::WrongPoints))
            update();
    });
}

ObserverView::~ObserverView()
{
    releaseGL();
}

void ObserverView::setMorph(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    if (t == m_t)
        return;
    m_t = t;
    update();
    emit morphChanged(m_t);
}

void ObserverView::setHighlights(const std::set<lessons::Highlight> &highlights)
{
    m_highlights = highlights;
    update();
}

void ObserverView::setMarkedTerm(const QString &term)
{
    m_markedTerm = term;
    update();
}

void ObserverView::initializeGL()
{
    if (!createFrame())
        return;
    m_overlay.initialize();
    m_isStale = true;
}

void ObserverView::releaseGL()
{
    if (!isReady())
        return;
    makeCurrent();
    releaseFrame();
    m_overlay.release();
    doneCurrent();
}

void ObserverView::resizeGL(int, int)
{
    updateSurface();
}

void ObserverView::updateSurface()
{
    const Surface surface = currentSurface();
    if (surface == m_observer.surface || !check(surface))
        return;
    m_observer.surface = surface;
    m_observer.viewport = wholeSurface(surface);
    m_observer.projection() = withAspect(m_observer.projection(), aspectOf(m_observer.viewport));
    if (!m_isTouched)
        m_isPlaced = false;
}

void ObserverView::placeObserver()
{
    const Setup &g = m_document.setup();
    const bool isResized = !m_isTouched && m_placedFor != g.surface;
    if (m_isPlaced && !isResized)
        return;
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<ViewVolumeMorph> morph = viewVolumeMorph(g.projection());
    if (!frame || !morph)
        return;
    m_observer.camera() = observerOf(*frame, worldFromEye(*frame, morph->center));
    m_isPlaced = true;
    m_placedFor = g.surface;
    fit();
}

void ObserverView::fit()
{
    const Setup &g = m_document.setup();
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<ViewVolumeMorph> morph = viewVolumeMorph(g.projection());
    if (!frame || !morph)
        return;
    m_reference = placementOf(*frame, *morph);
    if (const std::optional<ObserverPicture> p = picture()) {
        Framing framing(m_observer);
        for (const WorldPoint &point : pointsToFit(*p))
            framing.add(point);
        for (const WrongPointMark &mark : m_document.picks().wrongPoints())
            framing.add(mark.got);
        m_observer.camera() = framing.setup().camera();
        // The camera symbol has a constant size in the view: its world size follows from a first
        // fit.
        const double size = cameraSignSize(m_observer, frame->eye);
        for (const WorldVector &axis : {frame->side, frame->upward, frame->forward}) {
            for (const double sign : {-1.0, 1.0})
                framing.add(frame->eye + axis * (sign * size));
        }
        m_observer.camera() = framing.setup().camera();
    }
    update();
}

std::optional<ObserverPicture> ObserverView::picture() const
{
    Box extent = m_document.bounds();
    extent.add(m_document.ground().box);
    return observerPicture(m_document.setup(), extent, m_reference, m_observer, m_t);
}

std::optional<QPointF> ObserverView::placeOf(const WorldPoint &point) const
{
    const std::optional<ObserverPicture> p = picture();
    if (!p)
        return std::nullopt;
    const glm::dvec4 drawn = p->drawnFromWorld * glm::dvec4(point.coordinates(), 1.0);
    const glm::dvec4 clip = p->clipFromDrawn * drawn;
    return drawn.w > 0.0 ? placeInPicture(p->observer, clip) : std::nullopt;
}

void ObserverView::paintGL()
{
    if (!isReady())
        return;
    updateSurface(); // a pixel ratio can change without a change of size
    placeObserver();
    const std::optional<ObserverPicture> p = picture();
    if (!p) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        return;
    }
    updateFrame(*p);
    if (!showFrame())
        return;
    // A lesson that letters the same axes names them otherwise, and has another f.
    m_overlay.draw(*p,
                   m_hotPlane             ? m_hotPlane
                   : m_markedTerm == u"n" ? std::optional(ClipPlane::Near)
                   : m_markedTerm == u"f" ? std::optional(ClipPlane::Far)
                                          : std::nullopt,
                   !m_highlights.contains(lessons::Highlight::Axes)
                       && !m_highlights.contains(lessons::Highlight::Volume));
    tellWrongPoints(*p);
    drawHighlighted();
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
}

std::vector<glm::dvec4> ObserverView::cuttingPlanes(const ObserverPicture &p) const
{
    // First the near plane, so that points behind the eye are not folded over; then the scene's own
    // planes; then as many other sides of the volume as OpenGL supports.
    constexpr std::size_t kRoom = 8;
    std::vector<glm::dvec4> planes;
    if (p.t > 0.0)
        planes.push_back(p.planes[0]);
    const std::vector<glm::dvec4> &own = m_document.scene().clipPlanes;
    planes.insert(planes.end(), own.begin(), own.end());
    for (std::size_t i = 1; i < p.planes.size() && p.t > 0.0 && planes.size() < kRoom; ++i)
        planes.push_back(p.planes[i]);
    return planes;
}

void ObserverView::updateFrame(const ObserverPicture &p)
{
    const glm::dmat4 clipFromWorld = p.clipFromDrawn * p.drawnFromWorld;
    // A failed frame is reported once, and retried when something else is to be drawn.
    if (!m_isStale && m_drawnOn == p.observer.surface && m_drawnFrom == clipFromWorld)
        return;
    m_isStale = false;
    m_drawnOn = p.observer.surface;
    m_drawnFrom = clipFromWorld;
    const Result<Drawable> drawn = drawable(p.observer);
    if (drawn)
        drawFrame({*drawn, m_document.objects(), clipFromWorld, p.observerFromWorld, cuttingPlanes(p)});
    else
        emit failed(errorText(drawn.error()));
}

void ObserverView::tellWrongPoints(const ObserverPicture &p)
{
    const std::vector<WrongPointMark> &marks = m_document.picks().wrongPoints();
    const bool areSeen = std::all_of(marks.begin(), marks.end(), [&](const WrongPointMark &mark) {
        const std::optional<QPointF> place = p.holds(mark.got) ? placeOf(mark.got) : std::nullopt;
        return place && QRectF(rect()).contains(*place);
    });
    if (std::exchange(m_areWrongPointsSeen, areSeen) != areSeen)
        emit wrongPointsSeen(areSeen);
}

HighlightMarks ObserverView::highlightMarks() const
{
    const std::optional<ObserverPicture> p = picture();
    if (!p)
        return {};
    HighlightMarks marks = highlightsFromOutside(m_document, *p, m_highlights);
    marks.add(termFromOutside(m_document, *p, m_markedTerm));
    return marks;
}

void ObserverView::drawHighlighted()
{
    const HighlightMarks marks = highlightMarks();
    if (marks.isEmpty())
        return;
    paintOver(m_observer.surface.devicePixelRatio, [&](QPainter &painter) {
        drawHighlights(painter, marks, boxesOf(marks, painter.font(), QRectF(rect()), {}));
    });
}

void ObserverView::setHotPlane(const std::optional<ClipPlaneDrag> &drag)
{
    const std::optional<ClipPlane> plane = drag ? std::optional(drag->plane()) : std::nullopt;
    if (drag) {
        const glm::dvec2 rate = drag->pixelsPerUnit();
        setCursor(std::abs(rate.x) >= std::abs(rate.y) ? Qt::SizeHorCursor : Qt::SizeVerCursor);
    } else {
        unsetCursor();
    }
    if (plane == m_hotPlane)
        return;
    m_hotPlane = plane;
    update();
    emit quantityPointed(!plane ? QString() : plane == ClipPlane::Near ? QStringLiteral("n") : QStringLiteral("f"));
}

void ObserverView::dragPlane(const QPointF &position)
{
    const Scene &scene = m_document.scene();
    const std::optional<Projection> projection =
        m_planeDrag->projectionAt(scene.projection, {position.x(), position.y()});
    if (!projection)
        return;
    // A step without a valid setup is skipped.
    static_cast<void>(m_document.edit(
        {m_planeDrag->plane() == ClipPlane::Near ? tr("Near plane") : tr("Far plane"), m_gesture}, [&](Scene &changed) {
            changed.projection = *projection;
            changed.clipDistancesFitObjects = false;
        }));
}

std::optional<ClipPlaneDrag> ObserverView::planeAt(const QPointF &position) const
{
    const std::optional<ObserverPicture> p = picture();
    return p ? clipPlaneAt(*p, {width(), height()}, {position.x(), position.y()}) : std::nullopt;
}

void ObserverView::setCamera(const LookAt &camera)
{
    m_observer.camera() = camera;
    m_isTouched = true;
    update();
}

void ObserverView::turn(int right, int down)
{
    setCamera(orbited(observer(), observer().center, right * kKeyTurnRadians, down * kKeyTurnRadians));
}

void ObserverView::zoom(const QPointF &position, double notches)
{
    const Result<EyeFrame> frame = eyeFrame(m_observer.camera());
    if (!frame)
        return;
    // Keeps the point under the pointer at the depth of the centre.
    const double scale = worldPerLogicalPixel(m_observer, m_observer.camera().center);
    const WorldPoint anchor = m_observer.camera().center + frame->side * ((position.x() - width() / 2.0) * scale)
                              - frame->upward * ((position.y() - height() / 2.0) * scale);
    Setup next = zoomed(m_observer, anchor, zoomFactor(notches));
    // Closer, the view would lose digits; farther, it shows nothing.
    const double away = distance(next.camera().center, next.camera().eye);
    if (away < 1e-3 * m_reference.scale || away > 1e3 * m_reference.scale || !check(next))
        return;
    setCamera(next.camera());
}

bool ObserverView::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && isOwnKey(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    const bool isHandled = QOpenGLWidget::event(event);
    // The view has a new, empty framebuffer in another part of the window, and Qt paints widgets
    // over it only on request.
    if (event->type() == QEvent::Show)
        update();
    return isHandled;
}

void ObserverView::mousePressEvent(QMouseEvent *event)
{
    const bool pans = isPan(event->button(), event->modifiers());
    if (m_drag != Drag::None || (!pans && event->button() != Qt::LeftButton))
        return;
    m_lastPosition = event->position();
    m_gesture = QStringLiteral("observer drag %1").arg(++m_gestureCount);
    m_planeDrag = pans ? std::nullopt : planeAt(event->position());
    setHotPlane(m_planeDrag);
    m_drag = pans ? Drag::Pan : m_planeDrag ? Drag::Plane : Drag::Orbit;
}

void ObserverView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF delta = event->position() - m_lastPosition;
    m_lastPosition = event->position();
    switch (m_drag) {
    case Drag::None: setHotPlane(planeAt(event->position())); return;
    case Drag::Plane:
        if (!delta.isNull())
            dragPlane(event->position());
        return;
    case Drag::Orbit: setCamera(turnedBy(delta, observer(), observer().center, height())); return;
    case Drag::Pan: setCamera(pannedBy(delta, m_observer, observer().center)); return;
    }
}

void ObserverView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->buttons() != Qt::NoButton)
        return;
    m_drag = Drag::None;
    m_planeDrag.reset();
    setHotPlane(rect().contains(event->position().toPoint()) ? planeAt(event->position()) : std::nullopt);
}

void ObserverView::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event); // two quick drags are not a double click
}

void ObserverView::wheelEvent(QWheelEvent *event)
{
    zoom(event->position(), event->angleDelta().y() / 120.0);
    setHotPlane(planeAt(event->position()));
    event->accept();
}

void ObserverView::keyPressEvent(QKeyEvent *event)
{
    if (!isOwnKey(*event)) {
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
    case Qt::Key_F: fit(); break;
    case Qt::Key_Left: turn(-1, 0); break;
    case Qt::Key_Right: turn(1, 0); break;
    case Qt::Key_Up: turn(0, -1); break;
    case Qt::Key_Down: turn(0, 1); break;
    case Qt::Key_Minus: zoom(middle, -1.0); break;
    default: zoom(middle, 1.0); break;
    }
}

void ObserverView::leaveEvent(QEvent *event)
{
    QOpenGLWidget::leaveEvent(event);
    if (m_drag == Drag::None)
        setHotPlane(std::nullopt);
}

} // namespace unprojector::gui
