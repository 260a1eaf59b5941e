#include "gui/outside/observer_view.h"

#include "core/geometry/angle.h"
#include "core/geometry/framing.h"
#include "gui/text/error_text.h"
#include "gui/view/painters/clip_plane_shapes.h"
#include "gui/view/painters/observer_shapes.h"
#include "gui/view/painters/scene_lines.h"
#include "gui/view/wrong_point_marks.h"

#include <QPainter>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// The hand is in observer_view_input.cpp.

namespace unprojector::gui {
namespace {

constexpr double kSignPixels = 30.0;

/// World size of the camera's sign at a point of the picture: always as many pixels, because it is a sign, not a thing.
double signSize(const Picture &observer, const WorldPoint &point)
{
    return kSignPixels * worldPerLogicalPixel(observer, point);
}

glm::vec4 withAlpha(glm::vec4 color, float alpha)
{
    color.a = alpha;
    return color;
}

} // namespace

ObserverView::ObserverView(SceneDocument &document, QWidget *parent) : FrameView(parent), m_document(document)
{
    setAccessibleName(tr("Observer view"));
    setAccessibleDescription(
        tr("The camera and its view volume from outside. Arrow keys turn the view, plus and minus zoom, F fits it."));
    m_observer.projection() = Perspective{radiansFromDegrees(35.0), 1.0, 0.1, 100.0};

    // A hidden view is told as well, and draws nothing.
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects) {
            m_isPlaced = m_isTouched = false;
            m_drag = Drag::None;
            setHotPlane(std::nullopt);
        }
        m_isStale |= bool(changes & kSeen);
        if (changes & (kSeen | Change::Pick | Change::GivenPoint | Change::WrongPoints))
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

void ObserverView::initializeGL()
{
    if (!createFrame())
        return;
    m_lines.initialize();
    m_faces.initialize();
    m_pickPainter.initialize();
    m_isStale = true;
}

void ObserverView::releaseGL()
{
    if (!isReady())
        return;
    makeCurrent();
    releaseFrame();
    m_lines.release();
    m_faces.release();
    m_pickPainter.release();
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
    m_observer.projection() =
        withAspect(m_observer.projection(), m_observer.viewport.width / m_observer.viewport.height);
    if (!m_isTouched)
        m_isPlaced = false;
}

void ObserverView::placeObserver()
{
    const Picture &g = m_document.geometry();
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
    const Picture &g = m_document.geometry();
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<ViewVolumeMorph> morph = viewVolumeMorph(g.projection());
    if (!frame || !morph)
        return;
    m_reference = placementOf(*frame, *morph);
    if (const std::optional<ObserverPicture> p = picture()) {
        Framing framing(m_observer);
        for (const WorldPoint &point : pointsToFit(*p))
            framing.add(point);
        for (const WrongPointMark &mark : m_document.wrongPoints())
            framing.add(mark.got);
        m_observer.camera() = framing.picture().camera();
        // The camera's sign has a constant size in the picture: how large it is follows from the first try.
        const double size = signSize(m_observer, frame->eye);
        for (const WorldVector &axis : {frame->side, frame->upward, frame->forward}) {
            for (const double sign : {-1.0, 1.0})
                framing.add(frame->eye + axis * (sign * size));
        }
        m_observer.camera() = framing.picture().camera();
    }
    update();
}

std::optional<ObserverPicture> ObserverView::picture() const
{
    Box extent = m_document.bounds();
    extent.add(m_document.ground());
    return observerPicture(m_document.geometry(), extent, m_reference, m_observer, m_t);
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
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    drawGround(*p);
    drawClipPlanes(*p);
    drawVolume(*p);
    drawCamera(*p);
    drawPick(*p);
    drawHighlighted();
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
}

std::vector<glm::dvec4> ObserverView::cuttingPlanes(const ObserverPicture &p) const
{
    // First the near plane, which keeps what is behind the eye from being folded over; then the scene's own planes; then
    // as many of the volume's other sides as OpenGL has room for.
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
    // A frame that cannot be drawn is told of once, and tried again when there is something else to draw.
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

void ObserverView::drawGround(const ObserverPicture &p)
{
    glDepthMask(GL_FALSE);
    const float opacity = static_cast<float>(0.8 - 0.4 * p.t);
    const Surface &surface = p.observer.surface;
    const glm::vec2 size(surface.widthPixels, surface.heightPixels);
    const float ratio = static_cast<float>(surface.devicePixelRatio);
    m_lines.draw(clippedLines(groundLines(m_document.ground(), m_document.groundSpacing()), p.planes, opacity),
                 p.clipFromDrawn * p.drawnFromWorld, size, ratio);
    glDepthMask(GL_TRUE);
}

void ObserverView::drawClipPlanes(const ObserverPicture &p)
{
    glDepthMask(GL_FALSE);
    const glm::dmat4 clipFromWorld = p.clipFromDrawn * p.drawnFromWorld;
    const Surface &surface = p.observer.surface;
    const std::vector<glm::dvec4> bounds(p.planes.begin(), p.planes.end());
    for (const glm::dvec4 &plane : m_document.scene().clipPlanes) {
        const ClipPlaneShape shape = clipPlaneShape(plane, m_document.bounds(), bounds);
        m_faces.draw(shape.faces, clipFromWorld);
        m_lines.draw(shape.border, clipFromWorld, glm::vec2(surface.widthPixels, surface.heightPixels),
                     static_cast<float>(surface.devicePixelRatio));
    }
    glDepthMask(GL_TRUE);
}

void ObserverView::drawLines(const std::vector<LineSegment> &lines, const glm::dmat4 &clipFromSource,
                             double widthLogical)
{
    const Surface &surface = m_observer.surface;
    const glm::vec2 size(surface.widthPixels, surface.heightPixels);
    const float widthPixels = static_cast<float>(widthLogical * surface.devicePixelRatio);
    m_lines.draw(lines, clipFromSource, size, widthPixels);
    glDisable(GL_DEPTH_TEST);
    std::vector<LineSegment> hidden = lines;
    for (LineSegment &line : hidden)
        line.color.a *= 0.4f;
    m_lines.draw(hidden, clipFromSource, size, widthPixels);
    glEnable(GL_DEPTH_TEST);
}

void ObserverView::drawVolume(const ObserverPicture &p)
{
    glDepthMask(GL_FALSE);
    const glm::dmat4 clipFromEye = p.clipFromDrawn * p.drawnFromEye;
    const std::array<glm::dvec3, 4> nearCorners = planeCorners(p.corners, 0), farCorners = planeCorners(p.corners, 4);
    const auto isHot = [this](ClipPlane plane) { return m_hotPlane == plane; };
    const Face nearFace{nearCorners, withAlpha(observer_color::kNearPlane, isHot(ClipPlane::Near) ? 0.34f : 0.22f)};
    const Face farFace{farCorners, withAlpha(observer_color::kFarPlane, isHot(ClipPlane::Far) ? 0.28f : 0.16f)};
    // The deeper one first, because they are blended.
    const auto depthOf = [&](const std::array<glm::dvec3, 4> &corners) {
        double z = 0.0;
        for (const glm::dvec3 &corner : corners) {
            if (const std::optional<WorldPoint> point = p.drawnPoint(EyePoint(corner)))
                z += eyeFromWorld(p.observerFrame, *point).z;
        }
        return z;
    };
    const bool isNearDeeper = depthOf(nearCorners) < depthOf(farCorners);
    m_faces.draw(isNearDeeper ? std::vector<Face>{nearFace, farFace} : std::vector<Face>{farFace, nearFace},
                 clipFromEye);

    constexpr double kWidth = 1.6, kPlaneWidth = 2.2, kHotWidth = 4.5;
    drawLines(sideEdges(p.corners), clipFromEye, kWidth);
    drawLines(outline(farCorners, observer_color::kFarPlane), clipFromEye,
              isHot(ClipPlane::Far) ? kHotWidth : kPlaneWidth);
    drawLines(outline(nearCorners, observer_color::kNearPlane), clipFromEye,
              isHot(ClipPlane::Near) ? kHotWidth : kPlaneWidth);
    if (isPerspective(p.projection) && p.t < 1.0)
        drawLines(edgesFromEye(p.corners, 0.6f * eyeOpacity(p.projection, p.t)), clipFromEye, 1.2);

    // The axes of NDC, from the cube's middle to a little outside of it.
    if (const float opacity = cubeOpacity(p.t); opacity > 0.0f) {
        const glm::dmat4 drawnFromNdc = matrixOf(p.placement) * p.morph.morphedFromNdc;
        const glm::dvec3 origin(drawnFromNdc[3]);
        std::array<glm::dvec3, 3> tips;
        for (int axis = 0; axis < 3; ++axis)
            tips[static_cast<std::size_t>(axis)] = origin + glm::dvec3(drawnFromNdc[axis]) * 1.35;
        const double letter = 5.5 * worldPerLogicalPixel(p.observer, WorldPoint(origin));
        drawLines(letteredAxes(origin, tips, "xyz", (p.observerFrame.side * letter).coordinates(),
                               (p.observerFrame.upward * letter).coordinates(), opacity),
                  p.clipFromDrawn, 1.6);
    }
    glDepthMask(GL_TRUE);
}

void ObserverView::drawCamera(const ObserverPicture &p)
{
    const float opacity = eyeOpacity(p.projection, p.t);
    const std::optional<WorldPoint> eye = p.drawnPoint(EyePoint());
    if (!eye || opacity < 0.02f || !(eyeFromWorld(p.observerFrame, *eye).z < 0.0))
        return;
    const glm::dmat4 clipFromGlyph =
        p.clipFromDrawn * matrixOf({eye->coordinates(), p.placement.rotation, signSize(p.observer, *eye)});
    m_faces.draw(cameraFaces(opacity), clipFromGlyph);
    glDepthMask(GL_FALSE);
    drawLines(cameraLines(opacity), clipFromGlyph, 1.3);
    glDepthMask(GL_TRUE);
    if (m_highlights.contains(lessons::Highlight::Axes) || m_highlights.contains(lessons::Highlight::Volume))
        return; // the lesson names the same axes otherwise, and has another f

    glDepthMask(GL_FALSE);
    const glm::dmat3 glyphFromObserver = glm::transpose(glm::mat3_cast(p.placement.rotation));
    constexpr double kHalfLetter = 5.0 / kSignPixels, kLength = 1.7;
    drawLines(
        letteredAxes(glm::dvec3(0.0),
                     {glm::dvec3(kLength, 0.0, 0.0), glm::dvec3(0.0, kLength, 0.0), glm::dvec3(0.0, 0.0, -kLength)},
                     "suf", glyphFromObserver * p.observerFrame.side.coordinates() * kHalfLetter,
                     glyphFromObserver * p.observerFrame.upward.coordinates() * kHalfLetter, opacity),
        clipFromGlyph, 2.0);
    glDepthMask(GL_TRUE);
}

void ObserverView::drawWrong(const ObserverPicture &p)
{
    std::vector<WrongPointMark> marks;
    bool areSeen = true;
    for (WrongPointMark mark : m_document.wrongPoints()) {
        const std::optional<QPointF> place = p.holds(mark.got) ? placeOf(mark.got) : std::nullopt;
        areSeen = areSeen && place && QRectF(rect()).contains(*place);
        if (!p.holds(mark.got))
            continue;
        if (mark.right && !p.holds(*mark.right))
            mark.right.reset();
        marks.push_back(mark);
    }
    const Surface &surface = p.observer.surface;
    glDisable(GL_DEPTH_TEST);
    drawWrongPoints(marks, p.clipFromDrawn * p.drawnFromWorld, glm::vec2(surface.widthPixels, surface.heightPixels),
                    static_cast<float>(surface.devicePixelRatio), m_lines, m_pickPainter);
    if (std::exchange(m_areWrongPointsSeen, areSeen) != areSeen)
        emit wrongPointsSeen(areSeen);
}

void ObserverView::drawPick(const ObserverPicture &p)
{
    const glm::dmat4 clipFromWorld = p.clipFromDrawn * p.drawnFromWorld;
    const auto drawMark = [&](const WorldPoint &point, PickPainter::Mark mark) {
        const Surface &surface = p.observer.surface;
        m_pickPainter.draw(point, clipFromWorld, glm::vec2(surface.widthPixels, surface.heightPixels),
                           static_cast<float>(surface.devicePixelRatio), mark);
    };
    // Also where it is not in the view volume: that is to be seen here.
    if (const std::optional<WorldPoint> given = m_document.givenWorld(); given && p.holds(*given)) {
        glDisable(GL_DEPTH_TEST);
        drawMark(*given, PickPainter::Mark::Given);
    }
    drawWrong(p);
    const std::optional<Pick> &pick = m_document.pick();
    if (!pick)
        return;
    glEnable(GL_DEPTH_TEST);
    if (const std::optional<Segment> ray = rayThrough(*pick, p)) {
        glDepthMask(GL_FALSE);
        drawLines(clippedLines({{ray->from, ray->to, observer_color::kRay}}, p.planes, 1.0f), clipFromWorld, 2.2);
        glDepthMask(GL_TRUE);
    }
    glDisable(GL_DEPTH_TEST);
    if (pick->hit() && pick->point.world[Method::Formula] && p.holds(*pick->point.world[Method::Formula]))
        drawMark(*pick->point.world[Method::Formula], PickPainter::Mark::Picked);
}

HighlightMarks ObserverView::highlightMarks() const
{
    const std::optional<ObserverPicture> p = picture();
    return p ? highlightsFromOutside(m_document, *p, m_highlights) : HighlightMarks();
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

} // namespace unprojector::gui
