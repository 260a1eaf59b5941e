#include "core/scene_code/code_text.h"
#include "core/scene_code/dialects.h"

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;

namespace {

constexpr NumberStyle kStyle = NumberStyle::Double;

std::string number(double value)
{
    return literal(value, kStyle);
}

std::string vec3(const glm::dvec3 &v)
{
    return "glm::dvec3(" + list(v, kStyle) + ')';
}

std::string mat4(const glm::dmat4 &matrix)
{
    return "glm::dmat4( // column by column\n        " + list(matrix, MatrixOrder::ByColumns, kStyle, "        ") + ')';
}

std::string projection(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return mat4(matrix->clipFromEye);
    struct Visitor {
        const Setup &setup;
        std::string operator()(const Frustum &f) const
        {
            return "glm::frustumRH_NO(" + list(projectionWindow(f), kStyle) + ')'
                   + (f.skew == 0.0 ? std::string() : "\n        * " + mat4(shearOf(f)));
        }
        std::string operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        std::string operator()(const Ortho &o) const
        {
            return "glm::orthoRH_NO(" + list(projectionWindow(o), kStyle) + ')';
        }
        std::string operator()(const Perspective &p) const
        {
            std::string aspect = number(p.aspect.value);
            if (hasViewportsAspect(setup))
                aspect = "viewport[2] / viewport[3]";
            return "glm::perspectiveRH_NO(glm::radians(" + number(p.verticalFov.degrees()) + "), " + aspect + ", "
                   + list({p.nearDistance, p.farDistance}, kStyle) + ')';
        }
        std::string operator()(const Oblique &o) const { return (*this)(o.box) + "\n        * " + mat4(shearOf(o)); }
    };
    return std::visit(Visitor{setup}, setup.projection());
}

std::string camera(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return mat4(*matrix);
    const LookAt &look = setup.camera();
    const auto of = [](const auto &v) { return vec3({v.x, v.y, v.z}); };
    return "glm::lookAtRH(" + of(look.eye) + ", " + of(look.center) + ", " + of(look.up) + ')';
}

std::string stepCall(const TransformStep &step)
{
    struct Visitor {
        std::string operator()(const Translate &t) const { return "glm::translate(m, " + vec3(t.offset) + ')'; }
        std::string operator()(const Rotate &r) const
        {
            return "glm::rotate(m, glm::radians(" + number(r.degrees) + "), " + vec3(axisForCode(r.axis)) + ')';
        }
        std::string operator()(const Scale &s) const { return "glm::scale(m, " + vec3(s.factors) + ')'; }
    };
    return "    m = " + std::visit(Visitor{}, step) + ";\n";
}

std::string objectFunction(const SceneFileObject &object, const std::string &id)
{
    std::string text = "\n// " + whatIs(object) + ".\nglm::dmat4 worldFrom_" + id + "()\n{\n    glm::dmat4 m(1.0);\n";
    for (const TransformStep &step : object.transform)
        text += stepCall(step);
    return text + "    return m;\n}\n";
}

std::string clipPlanes(const SceneFile &scene)
{
    if (scene.clipPlanes.empty())
        return {};
    std::string text =
        "\n// Drawn is only what lies on the side of each plane where A x + B y + C z + D >= 0, world space. In the "
        "vertex shader:\n// gl_ClipDistance[k] = dot(clipPlanes[k], worldPosition), and "
        "glEnable(GL_CLIP_DISTANCE0 + k).\nconst glm::dvec4 clipPlanes[] = {\n";
    for (const glm::dvec4 &p : scene.clipPlanes)
        text += "    glm::dvec4(" + list({p.x, p.y, p.z, p.w}, kStyle) + "),\n";
    return text + "};\n";
}

} // namespace

std::string glmCode(const SceneFile &scene)
{
    const Setup p = setupOf(scene);
    std::string text = headerComment(scene, "The matrices of a setup and the inverse from a pixel, with GLM in double "
                                            "precision");
    if (isDepthZeroToOne(p))
        text += "// The projection's depths go from 0 to 1: glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE), Vulkan or "
                "Direct3D.\n";
    text += "\n"
            "#include <glm/glm.hpp>\n"
            "#include <glm/gtc/matrix_transform.hpp>\n"
            "\n"
            "const int windowWidth = "
            + std::to_string(p.surface.widthPixels) + ", windowHeight = " + std::to_string(p.surface.heightPixels)
            + "; // device pixels\n"
              "// glViewport: x, y from the bottom, width, height\n"
              "const glm::dvec4 viewport("
            + list({p.viewport.x, p.viewport.y, p.viewport.width, p.viewport.height}, kStyle)
            + ");\n"
              "// glDepthRange"
            + (isNearGreater(p) ? "; near has the greater depths: glDepthFunc(GL_GREATER), glClearDepth(0)" : "")
            + "\nconst double depthAtNear = " + number(p.depthRange.atNear)
            + ", depthAtFar = " + number(p.depthRange.atFar)
            + ";\n"
              "\n"
              "glm::dmat4 clipFromEye()\n{\n    return "
            + projection(p)
            + ";\n}\n"
              "\n"
              "glm::dmat4 eyeFromWorld()\n{\n    return "
            + camera(p) + ";\n}\n" + ofEachObject(scene, objectFunction) + clipPlanes(scene);
    text += "\n"
            "// The world coordinate of a pixel's centre, for the depth that is read there. i counts device pixels "
            "from the window's "
            "left,\n"
            "// j from its top. OpenGL counts rows from the bottom:\n"
            "// glReadPixels(i, windowHeight - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth); "
            + list({clearDepth(p)}, NumberStyle::JavaScript)
            + " is the background.\n"
              "glm::dvec3 screen2world(int i, int j, double depth)\n{\n"
              "    const double share = (depth - depthAtNear) / (depthAtFar - depthAtNear); // unProject knows no "
              "depth range\n"
              "    const glm::dvec3 window(i + 0.5, windowHeight - j - 0.5, share);\n"
              "    return glm::"
            + (isDepthZeroToOne(p) ? "unProjectZO" : "unProjectNO")
            + "(window, eyeFromWorld(), clipFromEye(), viewport);\n}\n";
    return text;
}

} // namespace unprojector::scene_code
