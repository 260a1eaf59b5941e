#include "core/scene_code/code_text.h"
#include "core/scene_code/dialects.h"
#include "core/scene_code/mfc_handlers.h"

#include <cmath>

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;

namespace {

constexpr NumberStyle kStyle = NumberStyle::Double;

std::string number(double value)
{
    return literal(value, kStyle);
}

std::string call(const std::string &function, const std::string &arguments)
{
    return "    " + function + '(' + arguments + ");\n";
}

std::string matrixCall(const std::string &function, const std::string &name, const glm::dmat4 &matrix)
{
    return "    const GLdouble " + name + "[16] = { // column by column\n        "
           + list(matrix, MatrixOrder::ByColumns, kStyle, "        ") + "};\n" + call(function, name);
}

std::string projectionCalls(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return matrixCall("glMultMatrixd", "projection", matrix->clipFromEye);
    struct Visitor {
        const Setup &setup;
        std::string operator()(const Frustum &f) const
        {
            return call("glFrustum", list(projectionWindow(f), kStyle))
                   + (f.skew == 0.0 ? std::string() : matrixCall("glMultMatrixd", "shear", shearOf(f)));
        }
        std::string operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        std::string operator()(const Ortho &o) const { return call("glOrtho", list(projectionWindow(o), kStyle)); }
        std::string operator()(const Perspective &p) const
        {
            std::string aspect = number(p.aspect.value);
            if (hasViewportsAspect(setup) && isWholeWindow(setup))
                aspect = "GLdouble(windowWidth) / windowHeight";
            return call("gluPerspective", number(p.verticalFov.degrees()) + ", " + aspect + ", "
                                              + list({p.nearDistance, p.farDistance}, kStyle));
        }
        std::string operator()(const Oblique &o) const
        {
            return call("glOrtho", list(projectionWindow(o), kStyle))
                   + matrixCall("glMultMatrixd", "shear", shearOf(o));
        }
    };
    return std::visit(Visitor{setup}, setup.projection());
}

std::string cameraCalls(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return matrixCall("glMultMatrixd", "view", *matrix);
    const LookAt &look = setup.camera();
    return call("gluLookAt", list({look.eye.x, look.eye.y, look.eye.z}, kStyle) + ", "
                                 + list({look.center.x, look.center.y, look.center.z}, kStyle) + ", "
                                 + list({look.up.x, look.up.y, look.up.z}, kStyle));
}

std::string stepCall(const TransformStep &step)
{
    struct Visitor {
        std::string operator()(const Translate &t) const { return call("glTranslated", list(t.offset, kStyle)); }
        std::string operator()(const Rotate &r) const
        {
            return call("glRotated", number(r.degrees) + ", " + list(axisForCode(r.axis), kStyle));
        }
        std::string operator()(const Scale &s) const { return call("glScaled", list(s.factors, kStyle)); }
    };
    return std::visit(Visitor{}, step);
}

std::string viewportCalls(const Setup &setup)
{
    const Viewport &v = setup.viewport;
    const DepthRange &range = setup.depthRange;
    std::string text;
    if (isWholeWindow(setup)) {
        text = "    glViewport(0, 0, windowWidth, windowHeight);\n";
    } else {
        std::string pixels;
        bool isWhole = true;
        for (const double value : {v.x, v.y, v.width, v.height}) {
            pixels += (pixels.empty() ? "" : ", ") + std::to_string(std::llround(value));
            isWhole = isWhole && value == std::round(value);
        }
        if (!isWhole)
            text = "    // The scene has " + list({v.x, v.y, v.width, v.height}, kStyle)
                   + ": OpenGL takes whole pixels only, so this is not quite its picture.\n";
        text += call("glViewport", pixels);
    }
    const auto isOutside = [](double depth) { return depth < 0.0 || depth > 1.0; };
    if (isOutside(range.atNear) || isOutside(range.atFar))
        text += "    // OpenGL cuts a depth range to [0, 1], so these are not the scene's depths.\n";
    return text + call("glDepthRange", list({range.atNear, range.atFar}, kStyle));
}

std::string setUpCalls(const Setup &setup)
{
    std::string text;
    if (isDepthZeroToOne(setup))
        text += "    // The projection's depths go from 0 to 1. OpenGL 4.5 has a call for that, which must be loaded "
                "first:\n"
                "    // glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);\n";
    text += "    glEnable(GL_DEPTH_TEST);\n";
    text += isNearGreater(setup) ? "    glDepthFunc(GL_GREATER); // near has the greater depths\n"
                                 : "    glDepthFunc(GL_LESS);\n";
    return text + call("glClearDepth", number(clearDepth(setup)));
}

std::string clipPlaneCalls(const SceneFile &scene)
{
    std::string text;
    for (std::size_t k = 0; k < scene.clipPlanes.size(); ++k) {
        const glm::dvec4 &p = scene.clipPlanes[k];
        const std::string n = std::to_string(k);
        text += "    const GLdouble plane" + n + "[4] = {" + list({p.x, p.y, p.z, p.w}, kStyle) + "};\n"
                + call("glClipPlane", "GL_CLIP_PLANE0 + " + n + ", plane" + n)
                + call("glEnable", "GL_CLIP_PLANE0 + " + n);
    }
    return text;
}

std::string objectFunctions(const SceneFileObject &object, const std::string &id)
{
    std::string text =
        "\n// " + whatIs(object) + ": from its own coordinates to the world's.\nvoid place_" + id + "()\n{\n";
    for (const TransformStep &step : object.transform)
        text += stepCall(step);
    text += "}\n";
    if (!object.isHidden)
        text += "void draw_" + id + "(); // to be written: its vertices, in its own coordinates\n";
    return text;
}

std::string drawCalls(const SceneFileObject &object, const std::string &id)
{
    if (object.isHidden)
        return {};
    return "    glPushMatrix();\n    place_" + id + "();\n    draw_" + id + "();\n    glPopMatrix();\n";
}

} // namespace

std::string gluCode(const SceneFile &scene)
{
    const Setup setup = setupOf(scene);
    const Surface &surface = setup.surface;
    std::string text = headerComment(scene, "The calls that make a setup, for OpenGL with GLU; for MFC, the view's "
                                            "handlers at the end");
    text += "// OpenGL's matrices and gluLookAt are in single precision with most drivers: seven digits.\n"
            "\n"
            "#ifdef _WIN32\n"
            "#include <windows.h>\n"
            "#endif\n"
            "#include <GL/gl.h>\n"
            "#include <GL/glu.h>\n"
            "\n"
            "// Device pixels. OnSize keeps them up to date.\n"
            "int windowWidth = "
            + std::to_string(surface.widthPixels) + ", windowHeight = " + std::to_string(surface.heightPixels)
            + ";\n"
              "\n"
              "// Once, when there is a rendering context.\n"
              "void setUp()\n{\n"
            + setUpCalls(setup)
            + "}\n"
              "\n"
              "// Whenever the window has another size: both of these.\n"
              "void setViewport()\n{\n"
            + viewportCalls(setup)
            + "}\n"
              "\n"
              "void setProjection()\n{\n"
              "    glMatrixMode(GL_PROJECTION);\n"
              "    glLoadIdentity();\n"
            + projectionCalls(setup)
            + "}\n"
              "\n"
              "void setCamera()\n{\n"
              "    glMatrixMode(GL_MODELVIEW);\n"
              "    glLoadIdentity();\n"
            + cameraCalls(setup) + "}\n" + ofEachObject(scene, objectFunctions)
            + "\n"
              "void drawScene()\n{\n"
              "    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
              "    setCamera();\n"
            + clipPlaneCalls(scene) + ofEachObject(scene, drawCalls) + "}\n";
    text += R"(
// The world coordinate of a pixel's centre, for the depth that is read there. i counts device pixels from the window's left,
// j from its top.
bool screen2world(int i, int j, GLdouble depth, GLdouble world[3])
{
    GLdouble modelview[16], projection[16], range[2];
    GLint viewport[4];
    setCamera(); // the camera alone: with an object's transform the answer is in that object's coordinates
    glGetDoublev(GL_MODELVIEW_MATRIX, modelview);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetDoublev(GL_DEPTH_RANGE, range);
    glGetIntegerv(GL_VIEWPORT, viewport);
)";
    text += isDepthZeroToOne(setup)
                ? "    // gluUnProject knows nothing of the depth range, and takes NDC depths from -1 to 1: half of "
                  "them here\n"
                  "    const GLdouble share = 0.5 + 0.5 * (depth - range[0]) / (range[1] - range[0]);\n"
                : "    // gluUnProject knows nothing of the depth range\n"
                  "    const GLdouble share = (depth - range[0]) / (range[1] - range[0]);\n";
    text +=
        R"(    return gluUnProject(i + 0.5, windowHeight - j - 0.5, share, modelview, projection, viewport, &world[0], &world[1],
                        &world[2]) == GL_TRUE;
}

// The same with the depth that stands in the buffer: false where nothing was drawn. Before the buffers are swapped.
bool screen2world(int i, int j, GLdouble world[3])
{
    GLfloat depth = 0.0f;
    glReadPixels(i, windowHeight - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth != )"
        + literal(clearDepth(setup), NumberStyle::Float) + R"( && screen2world(i, j, depth, world);
}
)";
    return text + kMfcHandlers;
}

} // namespace unprojector::scene_code
