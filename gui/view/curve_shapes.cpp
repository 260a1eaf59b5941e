#include "gui/view/curve_shapes.h"

#include "core/geometry/camera_motion.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Curve;
using landmarks::Landmark;

const glm::vec4 kUsualColor(1.0f, 0.76f, 0.18f, 1.0f), kMeasureColor(1.0f, 1.0f, 1.0f, 1.0f);

/// Moves a line off its surface, towards the eye.
class Lifted {
public:
    Lifted(const Setup &setup, const EyeFrame &frame)
        : m_setup(setup), m_eye(frame.eye), m_backward(-frame.forward.coordinates())
    {
        const Result<glm::dmat4> clip = clipFromEye(setup);
        m_isPerspective = clip && (*clip)[2][3] != 0.0;
    }
    glm::dvec3 operator()(const WorldPoint &point) const
    {
        constexpr double kPixels = 4.0; // logical; enough for lines on surfaces seen at an angle
        const glm::dvec3 toEye = (m_eye - point).coordinates();
        const glm::dvec3 way = m_isPerspective && glm::length(toEye) > 0.0 ? glm::normalize(toEye) : m_backward;
        return point.coordinates() + kPixels * worldPerLogicalPixel(m_setup, point) * way;
    }

private:
    const Setup &m_setup;
    WorldPoint m_eye;
    glm::dvec3 m_backward;
    bool m_isPerspective = false;
};

void addPath(std::vector<LineSegment> &lines, const std::vector<WorldPoint> &path, const glm::vec4 &color,
             const Lifted &lifted)
{
    for (std::size_t i = 1; i < path.size(); ++i)
        lines.push_back({lifted(path[i - 1]), lifted(path[i]), color});
}

/// The colour of its first landmark; nothing if one of them is hidden.
std::optional<glm::vec4> colorOf(const Curve &curve, const std::vector<Landmark> &landmarks)
{
    glm::vec4 color = kUsualColor;
    for (const Landmark &landmark : landmarks) {
        if (std::find(curve.points.begin(), curve.points.end(), landmark.name) == curve.points.end())
            continue;
        if (landmark.isHidden)
            return std::nullopt;
        if (landmark.name == curve.points.front() && landmark.color)
            color = glm::vec4(glm::vec3(*landmark.color) / 255.0f, 1.0f);
    }
    return color;
}

} // namespace

CurveShapes curveShapes(const SceneDocument &document)
{
    CurveShapes shapes;
    const SceneCurves &curves = document.curves();
    const std::optional<ShownMeasure> &measure = curves.shownMeasure();
    const bool isMeasured = measure && measure->shape == ShownMeasure::Shape::Surface;
    if (curves.all().empty() && !isMeasured)
        return shapes;
    const Setup &setup = document.setup();
    const Result<EyeFrame> frame = eyeFrame(setup.camera());
    if (!frame)
        return shapes;
    const Lifted lifted(setup, *frame);
    for (std::size_t i = 0; i < curves.all().size(); ++i) {
        const Curve &curve = curves.all()[i];
        const SceneCurves::Line &line = curves.line(i);
        const std::optional<glm::vec4> color = colorOf(curve, document.landmarks());
        if (!color || !line.line)
            continue;
        addPath(line.isComputing ? shapes.former : shapes.lines, line.line->path, *color, lifted);
        if (line.isComputing || line.line->path.empty())
            continue;
        const std::vector<WorldPoint> semilandmarks =
            curve.points.empty() ? curve.semilandmarks : unprojector::curves::resampled(line.line->path, curve.count);
        for (const WorldPoint &place : semilandmarks) {
            // A line of equal length and width is a dot; without any length it would have no
            // direction.
            const glm::dvec3 at = lifted(place);
            const glm::dvec3 half = 3.5 * worldPerLogicalPixel(setup, place) * frame->upward.coordinates();
            shapes.dots.push_back({at - half, at + half, *color});
        }
    }
    if (const SceneCurves::Line *line = curves.throughSelected();
        isMeasured && line && line->line && !line->isComputing)
        addPath(shapes.lines, line->line->path, kMeasureColor, lifted);
    return shapes;
}

} // namespace unprojector::gui
