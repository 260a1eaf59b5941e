#include "core/base/number_text.h"
#include "core/scene_code/code_text.h"
#include "core/scene_code/dialects.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;
using namespace base;
namespace {

constexpr NumberStyle kStyle = NumberStyle::Float;

std::string number(double value)
{
    return literal(value, kStyle);
}

std::string vector3(const glm::dvec3 &v)
{
    return "QVector3D(" + list(v, kStyle) + ')';
}

std::string matrix4(const glm::dmat4 &matrix)
{
    return "QMatrix4x4( // row by row\n        " + list(matrix, MatrixOrder::ByRows, kStyle, "        ") + ')';
}

std::string call(const std::string &function, const std::string &arguments)
{
    return "    m." + function + '(' + arguments + ");\n";
}

std::string projectionCalls(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return "    m = " + matrix4(matrix->clipFromEye) + ";\n";
    struct Visitor {
        const Setup &setup;
        std::string operator()(const Frustum &f) const
        {
            return call("frustum", list(projectionWindow(f), kStyle))
                   + (f.skew == 0.0 ? std::string() : "    m *= " + matrix4(shearOf(f)) + ";\n");
        }
        std::string operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        std::string operator()(const Ortho &o) const { return call("ortho", list(projectionWindow(o), kStyle)); }
        std::string operator()(const Perspective &p) const
        {
            std::string aspect = number(p.aspect.value);
            if (hasViewportsAspect(setup))
                aspect = "float(viewportWidth / viewportHeight)";
            return call("perspective", number(p.verticalFov.degrees()) + ", " + aspect + ", "
                                           + list({p.nearDistance, p.farDistance}, kStyle));
        }
        std::string operator()(const Oblique &o) const
        {
            return (*this)(o.box) + "    m *= " + matrix4(shearOf(o)) + ";\n";
        }
    };
    return std::visit(Visitor{setup}, setup.projection());
}

std::string cameraCalls(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return "    m = " + matrix4(*matrix) + ";\n";
    const LookAt &look = setup.camera();
    const glm::dvec3 eye(look.eye.x, look.eye.y, look.eye.z), center(look.center.x, look.center.y, look.center.z);
    const Result<glm::dmat4> view = eyeFromWorld(setup);
    constexpr double kLeastDistance = 1e-3;
    if (view && glm::distance(eye, center) < kLeastDistance)
        return "    // QMatrix4x4::lookAt does nothing where eye and center are as close as here\n    m = "
               + matrix4(*view) + ";\n";
    return call("lookAt", vector3(eye) + ", " + vector3(center) + ", " + vector3({look.up.x, look.up.y, look.up.z}));
}

std::string stepCall(const TransformStep &step)
{
    struct Visitor {
        std::string operator()(const Translate &t) const { return call("translate", list(t.offset, kStyle)); }
        std::string operator()(const Rotate &r) const
        {
            return call("rotate", number(r.degrees) + ", " + list(axisForCode(r.axis), kStyle));
        }
        std::string operator()(const Scale &s) const { return call("scale", list(s.factors, kStyle)); }
    };
    return std::visit(Visitor{}, step);
}

std::string matrixFunction(const std::string &name, const std::string &calls)
{
    return "QMatrix4x4 " + name + "()\n{\n    QMatrix4x4 m;\n" + calls + "    return m;\n}\n";
}

std::string objectFunction(const SceneFileObject &object, const std::string &id)
{
    std::string calls;
    for (const TransformStep &step : object.transform)
        calls += stepCall(step);
    return "\n// " + whatIs(object) + ".\n" + matrixFunction("worldFrom_" + id, calls);
}

std::string clipPlanes(const SceneFile &scene)
{
    if (scene.clipPlanes.empty())
        return {};
    std::string text =
        "\n// Drawn is only what lies on the side of each plane where A x + B y + C z + D >= 0, world space. In the "
        "vertex shader:\n// gl_ClipDistance[k] = dot(clipPlanes[k], worldPosition), and "
        "glEnable(GL_CLIP_DISTANCE0 + k).\nconst QVector4D clipPlanes[] = {\n";
    for (const glm::dvec4 &p : scene.clipPlanes)
        text += "    QVector4D(" + list({p.x, p.y, p.z, p.w}, kStyle) + "),\n";
    return text + "};\n";
}

/// The rounding error of a float coordinate as large as the eye's.
double eyeRounding(const Setup &setup)
{
    const Result<glm::dmat4> view = eyeFromWorld(setup);
    if (!view)
        return 0.0;
    const glm::dmat4 worldFromEye = glm::inverse(*view);
    const double largest =
        std::max({std::abs(worldFromEye[3].x), std::abs(worldFromEye[3].y), std::abs(worldFromEye[3].z)});
    return largest * std::ldexp(1.0, -24);
}

} // namespace

std::string qtCode(const SceneFile &scene)
{
    const Setup p = setupOf(scene);
    const double rounding = eyeRounding(p);
    std::string text = headerComment(scene, "The matrices of a setup and the inverse from a pixel, with Qt");
    text += "// QMatrix4x4 and QVector3D hold single precision, seven digits";
    if (rounding > 0.0 && std::isfinite(rounding))
        text += ": the eye's place alone is rounded by up to " + boundText(rounding);
    text += ".\n";
    const std::string matrices = matrixFunction("clipFromEye", projectionCalls(p)) + '\n'
                                 + matrixFunction("eyeFromWorld", cameraCalls(p)) + ofEachObject(scene, objectFunction)
                                 + clipPlanes(scene);
    if (const std::string lost = beyondFloat(matrices); !lost.empty())
        text += "//" + lost + '\n';
    if (isDepthZeroToOne(p))
        text += "// The projection's depths go from 0 to 1: glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE), Vulkan or "
                "Direct3D.\n";
    text += std::string("\n#include <QMatrix4x4>\n#include <QVector3D>\n")
            + (scene.clipPlanes.empty() ? "" : "#include <QVector4D>\n")
            + "\n"
              "const int windowWidth = "
            + std::to_string(p.surface.widthPixels) + ", windowHeight = " + std::to_string(p.surface.heightPixels)
            + "; // device pixels: width() and height() times devicePixelRatioF()\n"
              "// glViewport: x, y from the bottom, width, height\n"
              "const double viewportX = "
            + literal(p.viewport.x, NumberStyle::Double) + ", viewportY = " + literal(p.viewport.y, NumberStyle::Double)
            + ", viewportWidth = " + literal(p.viewport.width, NumberStyle::Double)
            + ", viewportHeight = " + literal(p.viewport.height, NumberStyle::Double) + ";\n// glDepthRange"
            + (isNearGreater(p) ? "; near has the greater depths: glDepthFunc(GL_GREATER), glClearDepthf(0)" : "")
            + "\nconst double depthAtNear = " + literal(p.depthRange.atNear, NumberStyle::Double)
            + ", depthAtFar = " + literal(p.depthRange.atFar, NumberStyle::Double) + ";\n\n" + matrices;
    text += "\n"
            "// The world coordinate of a pixel's centre, for the depth that is read there. i counts device pixels "
            "from the window's "
            "left,\n"
            "// j from its top. OpenGL counts rows from the bottom:\n"
            "// glReadPixels(i, windowHeight - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth); "
            + list({clearDepth(p)}, NumberStyle::JavaScript)
            + " is the background.\n"
              "// QVector3D::unproject does the same, but knows no depth range, and beyond a distance of 100000 it "
              "forgets to "
              "divide by w.\n"
              "QVector3D screen2world(int i, int j, double depth)\n{\n"
              "    const double share = (depth - depthAtNear) / (depthAtFar - depthAtNear);\n"
              "    const QVector3D ndc(float(2.0 * (i + 0.5 - viewportX) / viewportWidth - 1.0),\n"
              "                        float(2.0 * (windowHeight - j - 0.5 - viewportY) / viewportHeight - 1.0),\n"
              "                        float("
            + (isDepthZeroToOne(p) ? "share" : "2.0 * share - 1.0")
            + "));\n"
              "    return (clipFromEye() * eyeFromWorld()).inverted().map(ndc);\n}\n";
    return text;
}

} // namespace unprojector::scene_code
