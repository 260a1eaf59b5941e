#include "gui/view/highlight_marks.h"

#include "core/geometry/camera_motion.h"
#include "gui/document/given_points.h"
#include "gui/document/picks.h"
#include "gui/view/letter_places.h"
#include "gui/view/painters/scene_lines.h"

#include <glm/gtc/quaternion.hpp>

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

using Tips = HighlightMarks::Tips;

const QColor kRim(0xff, 0xff, 0xff, 225);
constexpr double kHead = 8.0;

/// @param origin, tip  clip space of the view
void addAxis(HighlightMarks &marks, const Setup &setup, const glm::dvec4 &origin, const glm::dvec4 &tip,
             std::size_t axis, const std::string &name)
{
    const std::optional<QPointF> from = placeInPicture(setup, origin), to = placeInPicture(setup, tip);
    if (!from || !to)
        return;
    const QLineF line(*from, *to);
    constexpr double kMostShare = 8.0;
    if (!(line.length() < kMostShare * axisLength(setup)))
        return;                     // it ends beside the eye
    constexpr double kLeast = 10.0; // a shorter axis counts as end-on
    Tips tips = Tips::End;
    if (line.length() < kLeast)
        tips = tip.z / tip.w < origin.z / origin.w ? Tips::Towards : Tips::Away;
    const std::string letter(1, "xyz"[axis]);
    for (HighlightMarks::Text &text : marks.texts) {
        if (!text.arrow || text.letter.letter != letter)
            continue;
        constexpr double kSame = 2.0;
        const HighlightMarks::Arrow &other = marks.arrows[*text.arrow];
        if (other.tips == tips && QLineF(other.line.p1(), *from).length() < kSame
            && QLineF(other.line.p2(), *to).length() < kSame) {
            text.letter.index += ", " + name;
            return;
        }
    }
    marks.texts.push_back({*to, {letter, name}, mark_color::kAxes[axis], marks.arrows.size()});
    marks.arrows.push_back({line, tips, mark_color::kAxes[axis]});
}

void drawArrow(QPainter &painter, const HighlightMarks::Arrow &arrow)
{
    const auto draw = [&](const QColor &color, double width, double rim) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
        painter.setBrush(Qt::NoBrush);
        const QPointF &to = arrow.line.p2();
        if (arrow.tips == Tips::Towards || arrow.tips == Tips::Away) {
            painter.drawEllipse(to, kRing, kRing);
            const double arm = kRing * std::sqrt(0.5);
            if (arrow.tips == Tips::Away) {
                painter.drawLine(to - QPointF(arm, arm), to + QPointF(arm, arm));
                painter.drawLine(to - QPointF(arm, -arm), to + QPointF(arm, -arm));
                return;
            }
            painter.setBrush(color);
            painter.drawEllipse(to, 1.5, 1.5);
            return;
        }
        if (arrow.tips == Tips::None) {
            painter.drawLine(arrow.line);
            return;
        }
        const double length = arrow.line.length();
        const QPointF way = (to - arrow.line.p1()) / length, aside(-way.y(), way.x());
        const double head = std::min(kHead, length * (arrow.tips == Tips::Both ? 0.5 : 1.0));
        const bool isBoth = arrow.tips == Tips::Both;
        painter.drawLine(arrow.line.p1() + way * (isBoth ? head : 0.0), to - way * head);
        painter.setPen(rim > 0.0 ? QPen(color, rim, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin) : QPen(Qt::NoPen));
        painter.setBrush(color);
        const auto tip = [&](const QPointF &at, const QPointF &along) {
            const QPointF neck = at - along * head;
            painter.drawPolygon(QPolygonF({at, neck + aside * kHalfHead, neck - aside * kHalfHead}));
        };
        tip(to, way);
        if (isBoth)
            tip(arrow.line.p1(), -way);
    };
    draw(kRim, 4.0, 2.0);
    draw(arrow.color, 1.75, 0.0);
}

void drawLetter(QPainter &painter, const QFont &usual, const HighlightMarks::Text &text, const QRectF &box)
{
    const QString letter = QString::fromStdString(text.letter.letter),
                  index = QString::fromStdString(text.letter.index);
    const QFont font = letterFont(usual), small = letterIndexFont(font);
    const QFontMetricsF metrics(font), ofIndex(small);
    const double width = metrics.horizontalAdvance(letter) + ofIndex.horizontalAdvance(index);
    const QPointF start(box.center().x() - width / 2.0,
                        box.center().y() + (metrics.ascent() - metrics.descent()) / 2.0);
    const auto write = [&](const QPointF &at) {
        painter.setFont(font);
        painter.drawText(at, letter);
        painter.setFont(small);
        painter.drawText(at + QPointF(metrics.horizontalAdvance(letter), metrics.descent() * 0.8), index);
    };
    painter.setPen(kRim);
    constexpr double kWidth = 1.5;
    for (const QPointF &way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1), QPointF(0.7, 0.7),
                               QPointF(-0.7, 0.7), QPointF(0.7, -0.7), QPointF(-0.7, -0.7)})
        write(start + way * kWidth);
    painter.setPen(text.color);
    write(start);
}

} // namespace

std::optional<QPointF> placeInPicture(const Setup &setup, const glm::dvec4 &clip)
{
    if (!(clip.w > 0.0))
        return std::nullopt;
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    const WindowPoint window = windowFromNdc(setup.viewport, setup.depthRange, ndc, ndcDepthOf(setup));
    const WidgetPoint widget = widgetFromDevice(setup.surface, deviceFromWindow(setup.surface, window));
    return QPointF(widget.x, widget.y);
}

std::optional<QLineF> lineInPicture(const Setup &setup, glm::dvec4 from, glm::dvec4 to)
{
    const double least = 1e-3 * std::max(from.w, to.w);
    if (from.w < least)
        std::swap(from, to);
    if (to.w < least)
        to = glm::mix(from, to, (from.w - least) / (from.w - to.w));
    const std::optional<QPointF> one = placeInPicture(setup, from), other = placeInPicture(setup, to);
    return one && other ? std::optional(QLineF(*one, *other)) : std::nullopt;
}

double axisLength(const Setup &setup)
{
    constexpr double kMostLogical = 64.0, kMostShare = 0.16;
    return std::min(kMostLogical, kMostShare * std::min(setup.viewport.width, setup.viewport.height)
                                      / setup.surface.devicePixelRatio);
}

void HighlightMarks::add(HighlightMarks more)
{
    for (Text &text : more.texts) {
        if (text.arrow)
            *text.arrow += arrows.size();
        texts.push_back(std::move(text));
    }
    arrows.insert(arrows.end(), more.arrows.begin(), more.arrows.end());
    lines.insert(lines.end(), more.lines.begin(), more.lines.end());
    things.insert(things.end(), more.things.begin(), more.things.end());
}

HighlightMarks highlightsInView(const SceneDocument &document, const std::set<Highlight> &highlights)
{
    HighlightMarks marks;
    const Setup &g = document.setup();
    const Result<EyeFrame> eye = eyeFrame(g.camera());
    const Result<glm::dmat4> clip = clipFromWorld(g);
    if (highlights.contains(Highlight::Axes) && eye && clip) {
        const auto clipOf = [&](const WorldPoint &point) { return *clip * glm::dvec4(point.coordinates(), 1.0); };
        // The eye's depth in a perspective is 0 up to rounding.
        const double least = isPerspective(g.projection()) ? 1e-3 * projectionWindow(g.projection()).nearDistance : 0.0;
        for (const lessons::NamedAxes &axes : lessons::namedAxes(document.scene(), *eye)) {
            const glm::dvec4 origin = clipOf(axes.origin);
            if (!(origin.w > least))
                continue;
            const double length = axisLength(g) * worldPerLogicalPixel(g, axes.origin);
            for (std::size_t axis = 0; axis < 3; ++axis)
                addAxis(marks, g, origin, clipOf(axes.origin + axes.directions[axis] * length), axis, axes.name);
        }
    }
    if (highlights.contains(Highlight::Viewport)) {
        constexpr double kInset = 6.0;
        const auto seen = [&g](const WindowPoint &point) {
            const WidgetPoint at = widgetFromDevice(g.surface, deviceFromWindow(g.surface, point));
            return QPointF(at.x, at.y);
        };
        for (const lessons::LetteredArrow &arrow :
             lessons::viewportArrows(g.viewport, g.surface, kInset * g.surface.devicePixelRatio)) {
            const bool isAxis = arrow.kind == lessons::LetteredArrow::Kind::Axis;
            const QLineF line(seen(arrow.from), seen(arrow.to));
            const QColor color = isAxis ? mark_color::kAxes[arrow.letter.letter == "x" ? 0 : 1] : mark_color::kDark;
            marks.texts.push_back({isAxis ? line.p2() : line.center(), arrow.letter, color, marks.arrows.size()});
            marks.arrows.push_back({line, isAxis ? Tips::End : Tips::Both, color});
        }
    }
    if (marks.isEmpty() || !clip)
        return marks;
    for (const LineSegment &axis : axisLines(document.ground().box)) {
        if (const std::optional<QLineF> line =
                lineInPicture(g, *clip * glm::dvec4(axis.from, 1.0), *clip * glm::dvec4(axis.to, 1.0)))
            marks.lines.push_back(*line);
    }
    for (const std::optional<WorldPoint> &point :
         {document.picks().pickedPoint(), givenWorld(document.scene(), document.setup())}) {
        const std::optional<QPointF> at =
            point ? placeInPicture(g, *clip * glm::dvec4(point->coordinates(), 1.0)) : std::nullopt;
        constexpr double kHalf = 15.0; // the arms of the crosshair
        if (at)
            marks.things.emplace_back(*at - QPointF(kHalf, kHalf), QSizeF(2.0 * kHalf, 2.0 * kHalf));
    }
    return marks;
}

float cubeOpacity(double t)
{
    return static_cast<float>(std::clamp((t - 0.6) / 0.4, 0.0, 1.0));
}

HighlightMarks highlightsFromOutside(const SceneDocument &document, const ObserverPicture &picture,
                                     const std::set<Highlight> &highlights)
{
    HighlightMarks marks;
    const Setup &g = picture.observer;
    const auto add = [&](const glm::dvec4 &drawn, const Letter &letter, const QColor &color) {
        if (const std::optional<QPointF> at = placeInPicture(g, picture.clipFromDrawn * drawn))
            marks.texts.push_back({*at, letter, color});
    };
    if (highlights.contains(Highlight::Axes)) {
        for (const lessons::NamedAxes &axes : lessons::namedAxes(document.scene(), picture.watched)) {
            const glm::dvec4 origin = picture.drawnFromWorld * glm::dvec4(axes.origin.coordinates(), 1.0);
            if (!(origin.w > 0.0) || !picture.holds(axes.origin))
                continue; // it has receded from the cube
            const double length = axisLength(g) * worldPerLogicalPixel(g, WorldPoint(glm::dvec3(origin) / origin.w));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const WorldPoint end = axes.origin + axes.directions[axis] * length;
                const glm::dvec4 tip = picture.drawnFromWorld * glm::dvec4(end.coordinates(), 1.0);
                if (tip.w > 0.0 && picture.holds(end))
                    addAxis(marks, g, picture.clipFromDrawn * origin, picture.clipFromDrawn * tip, axis, axes.name);
            }
        }
    }
    if (highlights.contains(Highlight::Volume)) {
        const auto letters = lessons::volumeLetters(picture.projection);
        for (std::size_t side = 0; side < letters.size(); ++side)
            add(picture.drawnFromEye * glm::dvec4(letters[side].at.coordinates(), 1.0), letters[side].letter,
                side == 4   ? mark_color::kNear
                : side == 5 ? mark_color::kFar
                            : mark_color::kDark);
    }
    if (highlights.contains(Highlight::Cube) && cubeOpacity(picture.t) > 0.0f) {
        const glm::dmat4 drawnFromNdc = matrixOf(picture.placement) * picture.morph.morphedFromNdc;
        const auto letters = lessons::cubeLetters();
        for (std::size_t i = 0; i < letters.size(); ++i)
            add(drawnFromNdc * glm::dvec4(letters[i].at.coordinates(), 1.0), letters[i].letter,
                mark_color::kAxes[i / 2]);
    }
    // The camera symbol: a body behind the eye.
    if (const std::optional<WorldPoint> eye = picture.drawnPoint(EyePoint());
        eye && eyeOpacity(picture.projection, picture.t) > 0.0f) {
        constexpr double kMiddle = 18.0, kHalf = 18.0; // logical pixels
        const double pixel = worldPerLogicalPixel(g, *eye);
        const glm::dvec3 body =
            eye->coordinates() + glm::mat3_cast(picture.placement.rotation) * glm::dvec3(0.0, 0.0, kMiddle * pixel);
        if (const std::optional<QPointF> at = placeInPicture(g, picture.clipFromDrawn * glm::dvec4(body, 1.0)))
            marks.things.emplace_back(*at - QPointF(kHalf, kHalf), QSizeF(2.0 * kHalf, 2.0 * kHalf));
    }
    return marks;
}

void drawHighlights(QPainter &painter, const HighlightMarks &marks, const std::vector<QRectF> &boxes)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont font = painter.font();
    for (const HighlightMarks::Arrow &arrow : marks.arrows)
        drawArrow(painter, arrow);
    for (std::size_t i = 0; i < marks.texts.size(); ++i) {
        const std::optional<QLineF> leader = leaderOf(marks, i, boxes[i]);
        if (!leader)
            continue;
        for (const QPen &pen : {QPen(kRim, 3.0), QPen(marks.texts[i].color, 1.0)}) {
            painter.setPen(pen);
            painter.drawLine(*leader);
        }
    }
    for (std::size_t i = 0; i < marks.texts.size(); ++i) {
        if (!boxes[i].isNull())
            drawLetter(painter, font, marks.texts[i], boxes[i]);
    }
    painter.setFont(font);
}

} // namespace unprojector::gui
