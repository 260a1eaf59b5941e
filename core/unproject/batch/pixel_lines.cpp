#include "core/unproject/batch/pixel_lines.h"

#include "core/geometry/finite.h"
#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/batch/line_constants.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <variant>

namespace unprojector::unproject {
using namespace geometry;
namespace {

glm::dvec3 vectorOf(const double (&v)[3])
{
    return {v[0], v[1], v[2]};
}

/// The distance from the plane of the eye as a function of a world point: the row times
/// (x, y, z, 1).
Result<glm::dvec4> distanceRow(const Setup &setup, bool isPerspective)
{
    const Result<glm::dmat4> projection = clipFromEye(setup), view = eyeFromWorld(setup);
    if (!projection)
        return projection.error();
    if (!view)
        return view.error();
    double wSign = 1.0;
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens)) {
        const Result<RecognisedProjection> form = recognised(*matrix);
        if (!form)
            return form.error();
        wSign = wInFront(*matrix);
    }
    glm::dvec4 ofEye(0.0, 0.0, -1.0, 0.0); // of a box; a perspective's w tells it
    if (isPerspective) {
        const glm::dvec4 w((*projection)[0][3], (*projection)[1][3], (*projection)[2][3], (*projection)[3][3]);
        ofEye = wSign * w / glm::length(glm::dvec3(w));
    }
    return ofEye * *view / (*view)[3][3];
}

} // namespace

Result<ClipDistances> clipDistances(const Setup &setup)
{
    if (const auto *projection = std::get_if<Projection>(&setup.lens)) {
        if (const Check valid = check(*projection); !valid)
            return valid.error();
        const ProjectionWindow w = projectionWindow(*projection);
        return ClipDistances{w.nearDistance, w.farDistance};
    }
    const Result<RecognisedProjection> form = recognised(*std::get_if<MatrixProjection>(&setup.lens));
    if (!form)
        return form.error();
    ClipDistances distances = std::visit(
        [](const auto &p) {
            if constexpr (requires { p.box; })
                return ClipDistances{p.box.nearDistance, p.box.farDistance};
            else
                return ClipDistances{p.nearDistance, p.farDistance};
        },
        form->parameters);
    if (form->infiniteFar)
        distances.atFar = std::numeric_limits<double>::infinity();
    return distances;
}

Result<PixelLines> PixelLines::byFormula(const Setup &setup)
{
    const Result<LineConstants> constants = lineConstants(setup, {});
    if (!constants)
        return constants.error();
    const batch::ClosedFormConstants &c = constants->numbers;
    PixelLines lines;
    lines.m_isPerspective = constants->perspective;
    lines.m_start.rest = vectorOf(c.origin);
    lines.m_ahead.rest = vectorOf(c.ahead);
    Sum &moved = constants->perspective ? lines.m_ahead : lines.m_start;
    moved.across = vectorOf(c.across);
    moved.down = vectorOf(c.down);
    lines.m_axisX = c.axisX;
    lines.m_axisXRest = c.axisXRest;
    lines.m_axisY = c.axisY;
    lines.m_axisYRest = c.axisYRest;
    lines.m_focalPixels = 1.0 / glm::length(vectorOf(c.across));
    if (constants->perspective)
        lines.m_perspective = c;
    return lines;
}

Result<PixelLines> PixelLines::byMatrix(const Setup &setup)
{
    const Result<glm::dmat4> inverse = spaceFromDevice(setup, {}), projection = clipFromEye(setup);
    if (!inverse)
        return inverse.error();
    PixelLines lines;
    lines.m_isPerspective = (*projection)[2][3] != 0.0;
    const Result<glm::dvec4> row = distanceRow(setup, lines.m_isPerspective);
    if (!row)
        return row.error();
    const glm::dvec3 slope(*row);
    const glm::dmat4 &m = *inverse;
    if (lines.m_isPerspective) {
        const glm::dvec3 eye = glm::dvec3(m[2]) / m[2].w;
        const auto fromEye = [&](const glm::dvec4 &p) { return glm::dvec3(p) - p.w * eye; };
        lines.m_start.rest = eye;
        lines.m_ahead = {fromEye(m[0]), fromEye(m[1]), fromEye(m[3])};
        lines.m_rate = {glm::dot(slope, lines.m_ahead.across), glm::dot(slope, lines.m_ahead.down),
                        glm::dot(slope, lines.m_ahead.rest)};
        const glm::dvec3 across = lines.m_ahead.across / lines.m_rate.z; // the rate is the same for all pixels
        lines.m_focalPixels = 1.0 / glm::length(across);
    } else {
        const glm::dvec3 ahead = glm::dvec3(m[2]) / glm::dot(slope, glm::dvec3(m[2]));
        const auto onEyePlane = [&](const glm::dvec4 &p, double w) {
            const glm::dvec3 point = glm::dvec3(p) / m[3].w;
            return point - (glm::dot(slope, point) + w * row->w) * ahead;
        };
        lines.m_ahead.rest = ahead;
        lines.m_start = {onEyePlane(m[0], 0.0), onEyePlane(m[1], 0.0), onEyePlane(m[3], 1.0)};
    }
    for (const Sum &sum : {lines.m_start, lines.m_ahead}) {
        for (const glm::dvec3 &v : {sum.across, sum.down, sum.rest}) {
            if (!isFinite({v.x, v.y, v.z}))
                return Error{ErrorCode::SingularMatrix};
        }
    }
    return lines;
}

PixelLine PixelLines::at(double px, double py) const
{
    const double x = (px - m_axisX) - m_axisXRest, y = (py - m_axisY) - m_axisYRest;
    return {m_start.at(x, y), m_ahead.at(x, y) / (m_rate.x * x + (m_rate.y * y + m_rate.z))};
}

namespace {

template <class Line, class Scalar>
void perspectiveLine(const batch::ClosedFormConstants &constants, const Line &line, Scalar *points)
{
    batch::loopsOf<Scalar>(availableInstructionSets().back()).perspectiveDistances(constants, line, points);
}

} // namespace

template <class Scalar>
void PixelLines::line(const batch::DepthLine &line, Scalar *points) const
{
    if (m_perspective) {
        perspectiveLine(*m_perspective, line, points);
        return;
    }
    for (std::size_t i = 0; i < line.count; ++i) {
        const PixelLine of = at(line.px + static_cast<double>(i), line.py);
        const glm::dvec3 point = of.start + line.values[i] * of.ahead;
        for (glm::length_t k = 0; k < 3; ++k)
            *points++ = static_cast<Scalar>(point[k]);
    }
}

template <class Scalar>
void PixelLines::line(const batch::FloatLine &line, Scalar *points) const
{
    perspectiveLine(*m_perspective, line, points);
}

template void PixelLines::line(const batch::DepthLine &, double *) const;
template void PixelLines::line(const batch::DepthLine &, float *) const;
template void PixelLines::line(const batch::FloatLine &, double *) const;
template void PixelLines::line(const batch::FloatLine &, float *) const;

} // namespace unprojector::unproject
