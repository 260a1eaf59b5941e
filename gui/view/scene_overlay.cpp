#include "gui/view/scene_overlay.h"

#include "gui/document/given_points.h"
#include "gui/document/picks.h"
#include "gui/view/curve_shapes.h"
#include "gui/view/frame.h"
#include "gui/view/painters/clip_plane_shapes.h"
#include "gui/view/painters/scene_lines.h"
#include "gui/view/wrong_point_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

glm::vec2 viewportPixels(const Setup &g)
{
    return glm::vec2(g.viewport.width, g.viewport.height);
}

float pixelRatio(const Setup &g)
{
    return static_cast<float>(g.surface.devicePixelRatio);
}

} // namespace

void SceneOverlay::initialize()
{
    initializeOpenGLFunctions();
    m_lines.initialize();
    m_faces.initialize();
    m_pick.initialize();
}

void SceneOverlay::release()
{
    m_lines.release();
    m_faces.release();
    m_pick.release();
}

void SceneOverlay::draw(const SceneDocument &document, const PictureMarks &marks,
                        const std::optional<DevicePixel> &crosshair, const std::optional<SnapMark> &mark)
{
    const Setup &g = document.setup();
    const Result<glm::dmat4> matrix = clipFromWorld(g);
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<Drawable> drawn = drawable(g);
    if (!matrix || !frame || !drawn)
        return;
    glViewport(drawn->x, drawn->y, drawn->width, drawn->height);
    glDepthRangef(drawn->depthAtNear, drawn->depthAtFar);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(drawn->depthAtNear < drawn->depthAtFar ? GL_LESS : GL_GREATER);
    glDepthMask(GL_FALSE);
    if (marks.grid)
        m_lines.draw(groundLines(document.ground().box, document.ground().spacing), *matrix, viewportPixels(g),
                     pixelRatio(g));
    if (marks.axes)
        m_lines.draw(axisLines(document.ground().box), *matrix, viewportPixels(g), 2.0f * pixelRatio(g));
    if (marks.grid)
        drawClipPlanes(document, *matrix);
    if (marks.curves)
        drawCurves(document, *matrix);
    glEnable(GL_DEPTH_TEST);
    if (marks.pick)
        drawPick(document, *matrix);
    glDisable(GL_DEPTH_TEST);
    if (mark)
        drawMark(*mark, g, *matrix);
    if (marks.axes)
        drawAxes(*frame, *drawn);
    if (crosshair)
        drawCrosshair(*crosshair, g.surface);
    glDepthMask(GL_TRUE);
}

void SceneOverlay::drawClipPlanes(const SceneDocument &document, const glm::dmat4 &clipFromWorld)
{
    const Setup &g = document.setup();
    for (const glm::dvec4 &plane : document.scene().clipPlanes) {
        const ClipPlaneShape shape = clipPlaneShape(plane, document.bounds());
        m_faces.draw(shape.faces, clipFromWorld);
        m_lines.draw(shape.border, clipFromWorld, viewportPixels(g), pixelRatio(g));
    }
}

void SceneOverlay::drawCurves(const SceneDocument &document, const glm::dmat4 &clipFromWorld)
{
    constexpr float kWidthLogical = 2.5f, kRimLogical = 4.5f, kDotLogical = 9.0f;
    const Setup &g = document.setup();
    const CurveShapes shapes = curveShapes(document);
    const auto draw = [&](const std::vector<LineSegment> &lines, float widthLogical) {
        m_lines.draw(lines, clipFromWorld, viewportPixels(g), widthLogical * pixelRatio(g));
    };
    glDisable(GL_DEPTH_TEST);
    draw(faded(shapes.lines), kWidthLogical);
    draw(faded(shapes.former), kWidthLogical);
    glEnable(GL_DEPTH_TEST);
    draw(dark(shapes.lines), kRimLogical);
    draw(dark(shapes.dots), kDotLogical);
    draw(shapes.lines, kWidthLogical);
    draw(shapes.dots, kDotLogical - 2.0f);
}

void SceneOverlay::drawPick(const SceneDocument &document, const glm::dmat4 &clipFromWorld)
{
    const Setup &g = document.setup();
    if (const std::optional<WorldPoint> given = givenWorld(document.scene(), document.setup())) {
        glDisable(GL_DEPTH_TEST);
        m_pick.draw(*given, clipFromWorld, viewportPixels(g), pixelRatio(g), PickPainter::Mark::Given);
    }
    glDisable(GL_DEPTH_TEST);
    drawWrongPoints(document.picks().wrongPoints(), clipFromWorld, viewportPixels(g), pixelRatio(g), m_lines, m_pick);
    const std::optional<Pick> &pick = document.picks().pick();
    if (pick && !pick->hit()) { // no surface, but a ray: its far end is under the click
        if (const Result<WorldPoint> &end = pick->rayFar.world[Method::Formula])
            m_pick.draw(*end, clipFromWorld, viewportPixels(g), pixelRatio(g), PickPainter::Mark::Background);
        return;
    }
    const std::optional<WorldPoint> point = document.picks().pickedPoint();
    if (!point)
        return;
    glEnable(GL_DEPTH_TEST);
    const std::vector<LineSegment> drops = dropLines(*point, document.ground().box);
    m_lines.draw(drops, clipFromWorld, viewportPixels(g), 2.0f * pixelRatio(g));
    glDisable(GL_DEPTH_TEST);
    m_lines.draw(faded(drops), clipFromWorld, viewportPixels(g), 1.5f * pixelRatio(g));
    m_pick.draw(*point, clipFromWorld, viewportPixels(g), pixelRatio(g));
}

void SceneOverlay::drawMark(const SnapMark &mark, const Setup &g, const glm::dmat4 &clipFromWorld)
{
    constexpr float kWidthLogical = 2.0f, kRimLogical = 4.5f;
    const SnapShape shape = snapShape(mark);
    const auto draw = [&](const std::vector<LineSegment> &lines, const glm::dmat4 &clipFromSource) {
        m_lines.draw(dark(lines), clipFromSource, viewportPixels(g), kRimLogical * pixelRatio(g));
        m_lines.draw(lines, clipFromSource, viewportPixels(g), kWidthLogical * pixelRatio(g));
    };
    m_faces.draw(shape.faces, clipFromWorld);
    draw(shape.lines, clipFromWorld);
    if (!shape.point)
        return;
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(shape.point->coordinates(), 1.0);
    if (!(clip.w > 0.0))
        return;
    // A square around it, of the same size at every distance.
    constexpr double kHalfLogical = 5.0;
    const glm::dvec2 middle = glm::dvec2(clip) / clip.w;
    const glm::dvec2 half = 2.0 * kHalfLogical * g.surface.devicePixelRatio / glm::dvec2(viewportPixels(g));
    std::vector<LineSegment> square;
    constexpr std::array<glm::dvec2, 4> kCorners{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
    for (std::size_t i = 0; i < kCorners.size(); ++i)
        square.push_back({glm::dvec3(middle + half * kCorners[i], 0.0),
                          glm::dvec3(middle + half * kCorners[(i + 1) % kCorners.size()], 0.0), kSnapColor});
    draw(square, glm::dmat4(1.0));
}

int SceneOverlay::axesSide(const Drawable &drawn)
{
    constexpr double kMostLogical = 84.0, kLeastLogical = 40.0;
    constexpr double kMostShare = 0.25; // of the viewport: the scene has priority
    const double ratio = drawn.setup.surface.devicePixelRatio;
    const double side = std::min(kMostLogical * ratio, kMostShare * std::min(drawn.width, drawn.height));
    return side < kLeastLogical * ratio ? 0 // its letters would be illegible
                                        : static_cast<int>(std::lround(side));
}

QRectF SceneOverlay::axesBox(const Drawable &drawn)
{
    const Setup &g = drawn.setup;
    const double side = axesSide(drawn);
    const WidgetPoint corner =
        widgetFromDevice(g.surface, deviceFromWindow(g.surface, WindowPoint(g.viewport.x, g.viewport.y + side, 0.0)));
    return {QPointF(corner.x, corner.y), QSizeF(side, side) / g.surface.devicePixelRatio};
}

void SceneOverlay::drawAxes(const EyeFrame &frame, const Drawable &drawn)
{
    const int pixels = axesSide(drawn);
    if (pixels == 0)
        return;
    glViewport(drawn.x, drawn.y, pixels, pixels);
    const Result<glm::dmat4> box = clipFromEye(Ortho{-1.45, 1.45, -1.45, 1.45, -2.0, 2.0});
    if (box)
        m_lines.draw(triadLines(frame), *box, glm::vec2(pixels, pixels), 2.0f * pixelRatio(drawn.setup));
}

void SceneOverlay::drawCrosshair(const DevicePixel &pixel, const Surface &surface)
{
    constexpr double kGapLogical = 4.0, kArmLogical = 14.0;
    const double ratio = surface.devicePixelRatio;
    const WindowPoint center = windowFromDevice(surface, pixelCenter(pixel), 0.0);
    const Result<glm::dmat4> pixels =
        clipFromEye(Ortho{0.0, double(surface.widthPixels), 0.0, double(surface.heightPixels), -1.0, 1.0});
    if (!pixels)
        return;
    const glm::vec2 size(surface.widthPixels, surface.heightPixels);
    glViewport(0, 0, surface.widthPixels, surface.heightPixels);
    // Dark around light: visible on any surface. The pixel itself stays free.
    const auto draw = [&](double rim, const glm::vec4 &color, double width) {
        std::vector<LineSegment> arms;
        for (const glm::dvec3 &way :
             {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)})
            arms.push_back({center.coordinates() + way * ((kGapLogical - rim) * ratio),
                            center.coordinates() + way * ((kArmLogical + rim) * ratio), color});
        m_lines.draw(arms, *pixels, size, static_cast<float>(width * ratio));
    };
    draw(1.0, {0.0f, 0.0f, 0.0f, 0.75f}, 3.5);
    draw(0.0, {1.0f, 1.0f, 1.0f, 1.0f}, 1.5);
}

std::vector<QRectF> takenCorners(const SceneDocument &document, const QRectF &corner)
{
    std::vector<QRectF> taken;
    if (const Result<Drawable> drawn = drawable(document.setup()))
        taken.push_back(SceneOverlay::axesBox(*drawn));
    if (!corner.isEmpty())
        taken.push_back(corner);
    return taken;
}

std::optional<SnapMark> snapMarkAt(const SceneDocument &document, const WidgetPoint &position)
{
    const ray::Snap snap = document.picks().snap();
    const ray::SceneRays *rays = snap == ray::Snap::Surface ? nullptr : document.picks().rays();
    const Result<DevicePixel> pixel = devicePixelFromWidget(document.setup().surface, position);
    if (!rays || !pixel)
        return std::nullopt;
    const Result<std::optional<ray::SceneHit>> hit = rays->at(pixelCenter(*pixel), snap);
    if (!hit || !*hit)
        return std::nullopt;
    SnapMark mark{snap, **hit, {}};
    if (mark.hit.triangle)
        mark.corners = rays->corners(mark.hit);
    return mark;
}

} // namespace unprojector::gui
