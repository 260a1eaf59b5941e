#include "gui/view/quantity_marks.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/view_volume.h"
#include "core/lessons/highlights.h"
#include "gui/document/picks.h"

#include <algorithm>
#include <array>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

using Tips = HighlightMarks::Tips;

struct EyeLine {
    EyePoint from, to;
    Tips tips;
    std::string letter; ///< may be empty
    QColor color = mark_color::kDark;
};

/// A side of the near plane's window, by its term, between two of the volume's corners.
struct Side {
    char term;
    std::size_t from, to;
};
constexpr std::array kSides{Side{'l', 0, 2}, Side{'r', 1, 3}, Side{'b', 0, 1}, Side{'t', 2, 3}};
constexpr const Side &kLeft = kSides[0], &kBottom = kSides[2], &kTop = kSides[3];

/// The side with this term; null if there is none.
const Side *sideOf(const QString &term)
{
    const auto found = std::find_if(kSides.begin(), kSides.end(),
                                    [&term](const Side &side) { return term == QLatin1Char(side.term); });
    return found == kSides.end() ? nullptr : &*found;
}

std::optional<EyePoint> eyeOf(const Setup &setup, const Result<WorldPoint> &world)
{
    const Result<glm::dmat4> view = eyeFromWorld(setup);
    if (!view || !world)
        return std::nullopt;
    return EyePoint(glm::dvec3(*view * glm::dvec4(world->coordinates(), 1.0)));
}

/// The lines of a term that is marked alike in both views: along the eye's axes to the point, or
/// along a ray.
std::vector<EyeLine> linesOf(const Setup &setup, const Pick &pick, const QString &term)
{
    if (!pick.hit()) {
        const auto enter = eyeOf(setup, pick.rayNear.world[Method::Formula]),
                   leave = eyeOf(setup, pick.rayFar.world[Method::Formula]);
        if (term == u"near" && enter)
            return {{*enter, *enter, Tips::Towards, "near"}};
        if (term == u"way" && enter && leave)
            return {{*enter, *leave, Tips::Both, "far − near"}};
        return {};
    }
    const std::optional<EyePoint> point = eyeOf(setup, pick.point.world[Method::Formula]);
    if (!point)
        return {};
    const auto &[x, y, z] = std::array{point->x, point->y, point->z};
    if (term == u"x")
        return {{EyePoint(0.0, y, z), *point, Tips::Both, "x", mark_color::kAxes[0]}};
    if (term == u"y")
        return {{EyePoint(x, 0.0, z), *point, Tips::Both, "y", mark_color::kAxes[1]}};
    if (term == u"z" || term == u"d") { // z begins at the eye, the depth at the near plane
        const double from = term == u"z" ? 0.0 : -projectionWindow(setup.projection()).nearDistance;
        return {{EyePoint(0.0, 0.0, from), EyePoint(0.0, 0.0, z), Tips::Both, term.toStdString(), mark_color::kAxes[2]},
                {EyePoint(0.0, 0.0, z), *point, Tips::None, {}, mark_color::kAxes[2]}};
    }
    if (term == u"world")
        return {{*point, *point, Tips::Towards, "world"}};
    return {};
}

/// The eye's axes that a term names, from an origin on the view axis.
std::vector<EyeLine> axesOf(const QString &term, double originZ, double length)
{
    std::vector<EyeLine> axes;
    const EyePoint origin(0.0, 0.0, originZ);
    const auto add = [&](const char *name, const char *letter, const EyePoint &tip, std::size_t axis) {
        if (term == u"eye" || term == QLatin1String(name))
            axes.push_back({origin, tip, Tips::End, letter, mark_color::kAxes[axis]});
    };
    add("s", "s", EyePoint(length, 0.0, originZ), 0);
    add("u", "u", EyePoint(0.0, length, originZ), 1);
    add("forward", "f", EyePoint(0.0, 0.0, originZ - length), 2);
    return axes;
}

/// @param line  logical pixels
void add(HighlightMarks &marks, const QLineF &line, Tips tips, const std::string &letter, const QColor &color)
{
    constexpr double kEndOn = 10.0, kNothing = 1.0; // logical pixels
    if (tips == Tips::None && line.length() < kNothing)
        return;
    if (tips != Tips::None && tips != Tips::Towards && line.length() < kEndOn)
        tips = Tips::Away; // seen from the eye, along its axis
    const HighlightMarks::Arrow arrow{line, tips, color};
    if (!letter.empty())
        marks.texts.push_back({isLength(arrow) ? line.center() : line.p2(), {letter, {}}, color, marks.arrows.size()});
    marks.arrows.push_back(arrow);
}

void add(HighlightMarks &marks, const Setup &setup, const glm::dmat4 &clipFromEye, const std::vector<EyeLine> &lines)
{
    const auto clip = [&](const EyePoint &point) { return clipFromEye * glm::dvec4(point.coordinates(), 1.0); };
    for (const EyeLine &line : lines) {
        if (const std::optional<QLineF> seen = lineInPicture(setup, clip(line.from), clip(line.to)))
            add(marks, *seen, line.tips, line.letter, line.color);
    }
}

/// The terms that are marked in the window itself.
HighlightMarks windowMarks(const Setup &g, const Pick &pick, const QString &term)
{
    HighlightMarks marks;
    const auto seen = [&g](double x, double y) {
        const WidgetPoint at = widgetFromDevice(g.surface, deviceFromWindow(g.surface, WindowPoint(x, y, 0.0)));
        return QPointF(at.x, at.y);
    };
    const double inset = 6.0 * g.surface.devicePixelRatio;
    for (const lessons::LetteredArrow &arrow : lessons::viewportArrows(g.viewport, g.surface, inset)) {
        if (arrow.kind == lessons::LetteredArrow::Kind::Length && arrow.letter.letter == term.toStdString())
            add(marks, {seen(arrow.from.x, arrow.from.y), seen(arrow.to.x, arrow.to.y)}, Tips::Both,
                arrow.letter.letter, mark_color::kDark);
    }
    // px and py are measured in the window of the click.
    const bool isSameWindow = pick.setup.surface == g.surface;
    if (term == u"px" && isSameWindow)
        add(marks, {seen(0.0, pick.window.y), seen(pick.window.x, pick.window.y)}, Tips::Both, "px",
            mark_color::kAxes[0]);
    if (term == u"py" && isSameWindow)
        add(marks, {seen(pick.window.x, g.surface.heightPixels), seen(pick.window.x, pick.window.y)}, Tips::Both, "py",
            mark_color::kAxes[1]);
    // The near plane's edges coincide with the viewport's, and both planes fill the viewport.
    const double left = g.viewport.x + inset, right = g.viewport.x + g.viewport.width - inset;
    const double bottom = g.viewport.y + inset, top = g.viewport.y + g.viewport.height - inset;
    const std::array corners{seen(left, bottom), seen(right, bottom), seen(left, top), seen(right, top)};
    const Side *side = sideOf(term);
    if (marks.isEmpty() && term == u"vx") // 0: the viewport begins at the window's edge
        side = &kLeft;
    if (marks.isEmpty() && term == u"vy")
        side = &kBottom;
    const auto addSide = [&](const Side &one, const std::string &letter, const QColor &color) {
        add(marks, {corners[one.from], corners[one.to]}, Tips::None, letter, color);
    };
    if (side)
        addSide(*side, term.toStdString(), mark_color::kNear);
    if (term == u"n" || term == u"f") {
        for (const Side &one : kSides)
            addSide(one, &one == &kBottom ? term.toStdString() : std::string(),
                    term == u"n" ? mark_color::kNear : mark_color::kFar);
    }
    return marks;
}

} // namespace

HighlightMarks termInView(const SceneDocument &document, const QString &term)
{
    const std::optional<Pick> &pick = document.picks().pick();
    const Setup &g = document.setup();
    const Result<glm::dmat4> clip = clipFromEye(g);
    if (!pick || !clip || term.isEmpty())
        return {};
    HighlightMarks marks = pick->hit() ? windowMarks(g, *pick, term) : HighlightMarks();
    add(marks, g, *clip, linesOf(g, *pick, term));
    // The eye itself is not visible, so its axes are drawn at the point's distance.
    const Result<EyeFrame> eye = eyeFrame(g.camera());
    const std::optional<EyePoint> point = eyeOf(g, pick->point.world[Method::Formula]);
    if (pick->hit() && eye && point && point->z < 0.0) {
        const double pixel = worldPerLogicalPixel(g, worldFromEye(*eye, EyePoint(0.0, 0.0, point->z)));
        add(marks, g, *clip, axesOf(term, point->z, axisLength(g) * pixel));
    }
    return marks;
}

HighlightMarks termFromOutside(const SceneDocument &document, const ObserverPicture &picture, const QString &term)
{
    const std::optional<Pick> &pick = document.picks().pick();
    if (!pick || term.isEmpty())
        return {};
    HighlightMarks marks;
    const glm::dmat4 clip = picture.clipFromDrawn * picture.drawnFromEye;
    const auto addLines = [&](const std::vector<EyeLine> &lines) { add(marks, picture.observer, clip, lines); };
    addLines(linesOf(document.setup(), *pick, term));
    if (!pick->hit())
        return marks;
    const auto addSide = [&](const Side &side, std::size_t plane, Tips tips, const QColor &color) {
        addLines(
            {{picture.corners[plane + side.from], picture.corners[plane + side.to], tips, term.toStdString(), color}});
    };
    constexpr std::size_t kNearPlane = 0, kFarPlane = 4; // their first corners
    if (const Side *side = sideOf(term))
        addSide(*side, kNearPlane, Tips::None, mark_color::kNear);
    if (term == u"width")
        addSide(kBottom, kNearPlane, Tips::Both, mark_color::kDark);
    if (term == u"height")
        addSide(kLeft, kNearPlane, Tips::Both, mark_color::kDark);
    if (term == u"n") // the overlay draws the whole plane
        addSide(kTop, kNearPlane, Tips::None, mark_color::kNear);
    if (term == u"f")
        addSide(kTop, kFarPlane, Tips::None, mark_color::kFar);
    if (term == u"px" || term == u"py") {
        if (const auto pixel = eyeOf(document.setup(), pick->rayNear.world[Method::Formula]))
            addLines({{*pixel, *pixel, Tips::Towards, term.toStdString()}});
    }
    const std::optional<WorldPoint> eye = picture.drawnPoint(EyePoint());
    if (eye && eyeOpacity(picture.projection, picture.t) > 0.0f)
        addLines(axesOf(term, 0.0, axisLength(picture.observer) * worldPerLogicalPixel(picture.observer, *eye)));
    return marks;
}

} // namespace unprojector::gui
