#include "gui/outside/observer_overlay.h"

#include "core/geometry/camera_motion.h"
#include "gui/document/given_points.h"
#include "gui/document/picks.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/painters/clip_plane_shapes.h"
#include "gui/view/painters/observer_shapes.h"
#include "gui/view/painters/scene_lines.h"
#include "gui/view/wrong_point_marks.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

constexpr double kSignPixels = 30.0;

glm::vec2 sizePixels(const ObserverPicture &p)
{
    return glm::vec2(p.observer.surface.widthPixels, p.observer.surface.heightPixels);
}

float pixelRatio(const ObserverPicture &p)
{
    return static_cast<float>(p.observer.surface.devicePixelRatio);
}

glm::vec4 withAlpha(glm::vec4 color, float alpha)
{
    color.a = alpha;
    return color;
}

} // namespace

double cameraSignSize(const Setup &observer, const WorldPoint &point)
{
    return kSignPixels * worldPerLogicalPixel(observer, point);
}

void ObserverOverlay::initialize()
{
    initializeOpenGLFunctions();
    m_lines.initialize();
    m_faces.initialize();
    m_points.initialize();
}

void ObserverOverlay::release()
{
    m_lines.release();
    m_faces.release();
    m_points.release();
}

void ObserverOverlay::draw(const ObserverPicture &p, std::optional<ClipPlane> hotPlane, bool hasCameraAxes)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    drawGround(p);
    drawClipPlanes(p);
    drawVolume(p, hotPlane);
    drawCamera(p, hasCameraAxes);
    drawPick(p);
}

void ObserverOverlay::drawGround(const ObserverPicture &p)
{
    glDepthMask(GL_FALSE);
    const float opacity = static_cast<float>(0.8 - 0.4 * p.t);
    m_lines.draw(clippedLines(groundLines(m_document.ground().box, m_document.ground().spacing), p.planes, opacity),
                 p.clipFromDrawn * p.drawnFromWorld, sizePixels(p), pixelRatio(p));
    glDepthMask(GL_TRUE);
}

void ObserverOverlay::drawClipPlanes(const ObserverPicture &p)
{
    glDepthMask(GL_FALSE);
    const glm::dmat4 clipFromWorld = p.clipFromDrawn * p.drawnFromWorld;
    const std::vector<glm::dvec4> bounds(p.planes.begin(), p.planes.end());
    for (const glm::dvec4 &plane : m_document.scene().clipPlanes) {
        const ClipPlaneShape shape = clipPlaneShape(plane, m_document.bounds(), bounds);
        m_faces.draw(shape.faces, clipFromWorld);
        m_lines.draw(shape.border, clipFromWorld, sizePixels(p), pixelRatio(p));
    }
    glDepthMask(GL_TRUE);
}

void ObserverOverlay::drawVolume(const ObserverPicture &p, std::optional<ClipPlane> hotPlane)
{
    glDepthMask(GL_FALSE);
    const glm::dmat4 clipFromEye = p.clipFromDrawn * p.drawnFromEye;
    const std::array<glm::dvec3, 4> nearCorners = planeCorners(p.corners, 0), farCorners = planeCorners(p.corners, 4);
    const auto isHot = [hotPlane](ClipPlane plane) { return hotPlane == plane; };
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
    drawLines(p, sideEdges(p.corners), clipFromEye, kWidth);
    drawLines(p, outline(farCorners, observer_color::kFarPlane), clipFromEye,
              isHot(ClipPlane::Far) ? kHotWidth : kPlaneWidth);
    drawLines(p, outline(nearCorners, observer_color::kNearPlane), clipFromEye,
              isHot(ClipPlane::Near) ? kHotWidth : kPlaneWidth);
    if (isPerspective(p.projection) && p.t < 1.0)
        drawLines(p, edgesFromEye(p.corners, 0.6f * eyeOpacity(p.projection, p.t)), clipFromEye, 1.2);

    // The axes of NDC, from the cube's centre to slightly outside it.
    if (const float opacity = cubeOpacity(p.t); opacity > 0.0f) {
        const glm::dmat4 drawnFromNdc = matrixOf(p.placement) * p.morph.morphedFromNdc;
        const glm::dvec3 origin(drawnFromNdc[3]);
        std::array<glm::dvec3, 3> tips;
        for (int axis = 0; axis < 3; ++axis)
            tips[static_cast<std::size_t>(axis)] = origin + glm::dvec3(drawnFromNdc[axis]) * 1.35;
        const double letter = 5.5 * worldPerLogicalPixel(p.observer, WorldPoint(origin));
        drawLines(p,
                  letteredAxes(origin, tips, "xyz", (p.observerFrame.side * letter).coordinates(),
                               (p.observerFrame.upward * letter).coordinates(), opacity),
                  p.clipFromDrawn, 1.6);
    }
    glDepthMask(GL_TRUE);
}

void ObserverOverlay::drawCamera(const ObserverPicture &p, bool hasAxes)
{
    const float opacity = eyeOpacity(p.projection, p.t);
    const std::optional<WorldPoint> eye = p.drawnPoint(EyePoint());
    if (!eye || opacity < 0.02f || !(eyeFromWorld(p.observerFrame, *eye).z < 0.0))
        return;
    const glm::dmat4 clipFromGlyph =
        p.clipFromDrawn * matrixOf({eye->coordinates(), p.placement.rotation, cameraSignSize(p.observer, *eye)});
    m_faces.draw(cameraFaces(opacity), clipFromGlyph);
    glDepthMask(GL_FALSE);
    drawLines(p, cameraLines(opacity), clipFromGlyph, 1.3);
    glDepthMask(GL_TRUE);
    if (!hasAxes)
        return;

    glDepthMask(GL_FALSE);
    const glm::dmat3 glyphFromObserver = glm::transpose(glm::mat3_cast(p.placement.rotation));
    constexpr double kHalfLetter = 5.0 / kSignPixels, kLength = 1.7;
    drawLines(
        p,
        letteredAxes(glm::dvec3(0.0),
                     {glm::dvec3(kLength, 0.0, 0.0), glm::dvec3(0.0, kLength, 0.0), glm::dvec3(0.0, 0.0, -kLength)},
                     "suf", glyphFromObserver * p.observerFrame.side.coordinates() * kHalfLetter,
                     glyphFromObserver * p.observerFrame.upward.coordinates() * kHalfLetter, opacity),
        clipFromGlyph, 2.0);
    glDepthMask(GL_TRUE);
}

void ObserverOverlay::drawPick(const ObserverPicture &p)
{
    const glm::dmat4 clipFromWorld = p.clipFromDrawn * p.drawnFromWorld;
    const auto drawMark = [&](const WorldPoint &point, PickPainter::Mark mark) {
        m_points.draw(point, clipFromWorld, sizePixels(p), pixelRatio(p), mark);
    };
    // The panel shows the user's point outside the view volume, too.
    if (const std::optional<WorldPoint> given = givenWorld(m_document.scene(), m_document.setup());
        given && p.holds(*given)) {
        glDisable(GL_DEPTH_TEST);
        drawMark(*given, PickPainter::Mark::Given);
    }
    drawWrong(p);
    const std::optional<Pick> &pick = m_document.picks().pick();
    if (!pick)
        return;
    glEnable(GL_DEPTH_TEST);
    if (const std::optional<Segment> ray = rayThrough(*pick, p)) {
        glDepthMask(GL_FALSE);
        drawLines(p, clippedLines({{ray->from, ray->to, observer_color::kRay}}, p.planes, 1.0f), clipFromWorld, 2.2);
        glDepthMask(GL_TRUE);
    }
    glDisable(GL_DEPTH_TEST);
    if (pick->hit() && pick->point.world[Method::Formula] && p.holds(*pick->point.world[Method::Formula]))
        drawMark(*pick->point.world[Method::Formula], PickPainter::Mark::Picked);
}

void ObserverOverlay::drawWrong(const ObserverPicture &p)
{
    std::vector<WrongPointMark> marks;
    for (WrongPointMark mark : m_document.picks().wrongPoints()) {
        if (!p.holds(mark.got))
            continue;
        if (mark.right && !p.holds(*mark.right))
            mark.right.reset();
        marks.push_back(mark);
    }
    glDisable(GL_DEPTH_TEST);
    drawWrongPoints(marks, p.clipFromDrawn * p.drawnFromWorld, sizePixels(p), pixelRatio(p), m_lines, m_points);
}

void ObserverOverlay::drawLines(const ObserverPicture &p, const std::vector<LineSegment> &lines,
                                const glm::dmat4 &clipFromSource, double widthLogical)
{
    const float widthPixels = static_cast<float>(widthLogical * p.observer.surface.devicePixelRatio);
    m_lines.draw(lines, clipFromSource, sizePixels(p), widthPixels);
    glDisable(GL_DEPTH_TEST);
    std::vector<LineSegment> hidden = lines;
    for (LineSegment &line : hidden)
        line.color.a *= 0.4f;
    m_lines.draw(hidden, clipFromSource, sizePixels(p), widthPixels);
    glEnable(GL_DEPTH_TEST);
}

} // namespace unprojector::gui
