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

std::string matrixRows(const glm::dmat4 &matrix)
{
    const glm::dmat4 rows = glm::transpose(matrix);
    std::string text = "np.array([\n";
    for (int row = 0; row < 4; ++row)
        text += "    [" + list({rows[row].x, rows[row].y, rows[row].z, rows[row].w}, kStyle) + "],\n";
    return text + "])";
}

const char *const kFrustum = R"(clip_from_eye = np.array([
    [2 * near / (right - left), 0, (right + left) / (right - left), 0],
    [0, 2 * near / (top - bottom), (top + bottom) / (top - bottom), 0],
    [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)],
    [0, 0, -1, 0],
])
)";

const char *const kOrtho = R"(clip_from_eye = np.array([
    [2 / (right - left), 0, 0, -(right + left) / (right - left)],
    [0, 2 / (top - bottom), 0, -(top + bottom) / (top - bottom)],
    [0, 0, -2 / (far - near), -(far + near) / (far - near)],
    [0, 0, 0, 1],
])
)";

std::string edges(const ProjectionWindow &window, const std::string &from)
{
    return "left, right, bottom, top, near, far = " + list(window, kStyle) + "  # " + from + '\n';
}

std::string shear(const Oblique &o)
{
    return "cot_theta, cot_phi = " + list({cotangent(o.theta), cotangent(o.phi)}, kStyle)
           + "  # of the shear's angles\n";
}

/// The lines that assign the projection's parameters by name and build its matrix.
std::string projection(const Setup &setup)
{
    struct Visitor {
        const Setup &setup;
        std::string operator()(const Frustum &f) const
        {
            if (f.skew == 0.0)
                return edges(projectionWindow(f), "glFrustum") + kFrustum;
            return edges(projectionWindow(f), "glFrustum") + "skew = " + number(f.skew) + '\n' + kFrustum
                   + "clip_from_eye = clip_from_eye @ np.array([  # x += skew y\n"
                     "    [1, skew, 0, 0],\n    [0, 1, 0, 0],\n    [0, 0, 1, 0],\n    [0, 0, 0, 1],\n])\n";
        }
        std::string operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        std::string operator()(const Ortho &o) const { return edges(projectionWindow(o), "glOrtho") + kOrtho; }
        std::string operator()(const Perspective &p) const
        {
            return "fovy, aspect, near, far = " + number(p.verticalFov.degrees()) + ", "
                   + (hasViewportsAspect(setup) ? "width / height" : number(p.aspect.value)) + ", "
                   + list({p.nearDistance, p.farDistance}, kStyle)
                   + "  # gluPerspective\n"
                     "top = near * np.tan(np.radians(fovy) / 2)\n"
                     "bottom, left, right = -top, -top * aspect, top * aspect\n"
                   + kFrustum;
        }
        std::string operator()(const Oblique &o) const
        {
            return edges(projectionWindow(o), "glOrtho") + shear(o) + kOrtho
                   + "clip_from_eye = clip_from_eye @ np.array([  # x += cot(theta) z, y += cot(phi) z\n"
                     "    [1, 0, cot_theta, 0],\n    [0, 1, cot_phi, 0],\n    [0, 0, 1, 0],\n    [0, 0, 0, 1],\n])\n";
        }
    };
    return std::visit(Visitor{setup}, setup.projection());
}

const char *const kLookAt = R"(forward = unit(np.subtract(center, eye))
side = unit(np.cross(forward, unit(up)))
eye_from_world = np.eye(4)
eye_from_world[:3, :3] = side, np.cross(side, forward), -forward
eye_from_world[:3, 3] = -eye_from_world[:3, :3] @ eye
)";

std::string camera(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return "eye_from_world = " + matrixRows(*matrix) + '\n';
    const LookAt &look = setup.camera();
    const auto of = [](const auto &v) { return '(' + list({v.x, v.y, v.z}, kStyle) + ')'; };
    return "# gluLookAt\neye = " + of(look.eye) + "\ncenter = " + of(look.center) + "\nup = " + of(look.up) + '\n'
           + kLookAt;
}

const char *const kUnit = R"(

def unit(vector):
    """The direction of a vector, of length 1."""
    vector = vector / np.abs(vector).max()  # so that no square overflows
    return vector / np.linalg.norm(vector)

)";

const char *const kSteps = R"(

def translate(x, y, z):
    """The matrix of glTranslate."""
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def rotate(degrees, *axis):
    """The matrix of glRotate."""
    x, y, z = axis = unit(axis)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.eye(4)
    matrix[:3, :3] = (c * np.eye(3) + (1 - c) * np.outer(axis, axis)
                      + s * np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]))
    return matrix


def scale(x, y, z):
    """The matrix of glScale."""
    return np.diag([x, y, z, 1.0])

)";

std::string stepCall(const TransformStep &step)
{
    struct Visitor {
        std::string operator()(const Translate &t) const { return "translate(" + list(t.offset, kStyle) + ')'; }
        std::string operator()(const Rotate &r) const
        {
            return "rotate(" + number(r.degrees) + ", " + list(axisForCode(r.axis), kStyle) + ')';
        }
        std::string operator()(const Scale &s) const { return "scale(" + list(s.factors, kStyle) + ')'; }
    };
    return std::visit(Visitor{}, step);
}

std::string objectMatrix(const SceneFileObject &object, const std::string &id)
{
    std::string text = "\n# " + whatIs(object) + ".\nworld_from_" + id + " = ";
    if (object.transform.empty())
        return text + "np.eye(4)\n";
    std::string product;
    for (const TransformStep &step : object.transform)
        product += (product.empty() ? "" : "\n    @ ") + stepCall(step);
    return text + (object.transform.size() == 1 ? product : "(\n    " + product + "\n)") + '\n';
}

std::string clipPlanes(const SceneFile &scene)
{
    if (scene.clipPlanes.empty())
        return {};
    std::string text = "\n# A x + B y + C z + D, world space.\nclip_planes = np.array([\n";
    for (const glm::dvec4 &p : scene.clipPlanes)
        text += "    [" + list({p.x, p.y, p.z, p.w}, kStyle) + "],\n";
    return text
           + "])\n\n\ndef is_drawn(world):\n"
             "    \"\"\"Whether a world point lies on the side of each clip plane that is drawn.\"\"\"\n"
             "    return bool((clip_planes @ np.append(world, 1.0) >= 0).all())\n\n";
}

std::string viewportLines(const Setup &p)
{
    return "window_width, window_height = " + std::to_string(p.surface.widthPixels) + ", "
           + std::to_string(p.surface.heightPixels)
           + "  # device pixels\n"
             "vx, vy, width, height = "
           + list({p.viewport.x, p.viewport.y, p.viewport.width, p.viewport.height}, kStyle)
           + "  # glViewport: x, y from the bottom\n"
             "at_near, at_far = "
           + list({p.depthRange.atNear, p.depthRange.atFar}, kStyle)
           + "  # glDepthRange\n\n"
             "window_from_ndc = np.array([\n"
             "    [width / 2, 0, 0, vx + width / 2],\n"
             "    [0, height / 2, 0, vy + height / 2],\n"
           + (isDepthZeroToOne(p) ? "    [0, 0, at_far - at_near, at_near],  # NDC depths go from 0 to 1\n"
                                  : "    [0, 0, (at_far - at_near) / 2, (at_far + at_near) / 2],\n")
           + "    [0, 0, 0, 1],\n])\n";
}

const char *const kForward = R"(

def project(world):
    """The window point of a world point: x and y in device pixels from the bottom left, and the depth."""
    clip = clip_from_eye @ eye_from_world @ np.append(world, 1.0)
    return (window_from_ndc @ (clip / clip[3]))[:3]


def window_point(i, j, depth):
    """The window point of a pixel's centre: i counts device pixels from the window's left, j from its top."""
    return np.array([i + 0.5, window_height - j - 0.5, depth])


def world_by_inverse(window):
    """The world point, by the inverted matrix."""
    world = np.linalg.inv(window_from_ndc @ clip_from_eye @ eye_from_world) @ np.append(window, 1.0)
    return world[:3] / world[3]

)";

/// The lines of formulas (9) to (12), with the script's parameters.
std::string eyeLines(const Projection &projection)
{
    if (isPerspective(projection))
        return std::string("    z = near * far / (far * (1 - d) + near * d)  # in front of the eye\n"
                           "    x = ((xv - vx) * (right - left) / width + left) * z / near  # (9)\n"
                           "    y = ((yv - vy) * (top - bottom) / height + bottom) * z / near  # (10)\n")
               + (projectionWindow(projection).skew == 0.0 ? "" : "    x -= skew * y  # the skew undone\n");
    return std::string("    z = near * (1 - d) + far * d  # in front of the eye\n"
                       "    x = (xv - vx) * (right - left) / width + left  # (11)\n"
                       "    y = (yv - vy) * (top - bottom) / height + bottom  # (12)\n")
           + (std::holds_alternative<Oblique>(projection)
                  ? "    x += cot_theta * z  # the shear undone\n    y += cot_phi * z\n"
                  : "");
}

/// The lines of the formulas for a matrix of a known form, with its numbers.
std::string eyeLines(const ProjectionCoefficients &form, bool isZeroToOne)
{
    return std::string("    m = clip_from_eye\n"
                       "    x_ndc, y_ndc = 2 * (xv - vx) / width - 1, 2 * (yv - vy) / height - 1\n")
           + (isZeroToOne ? "    z_ndc = d\n" : "    z_ndc = 2 * d - 1\n")
           + (form.perspective ? "    z = m[2, 3] / (m[3, 2] * z_ndc - m[2, 2])  # along the eye's axis\n"
                                 "    x = (m[3, 2] * x_ndc - m[0, 2]) * z / m[0, 0]\n"
                                 "    y = (m[3, 2] * y_ndc - m[1, 2]) * z / m[1, 1]\n"
                                     + std::string(form.xSkew == 0.0 ? "" : "    x -= m[0, 1] * y / m[0, 0]\n")
                               : "    z = (m[3, 3] * z_ndc - m[2, 3]) / m[2, 2]  # along the eye's axis\n"
                                 "    x = (m[3, 3] * x_ndc - m[0, 3] - m[0, 2] * z) / m[0, 0]\n"
                                 "    y = (m[3, 3] * y_ndc - m[1, 3] - m[1, 2] * z) / m[1, 1]\n");
}

/// The function world_by_formula; empty for a matrix of no known form.
std::string formula(const Setup &setup)
{
    std::string eye;
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    if (!matrix)
        eye = eyeLines(setup.projection());
    else if (const Result<RecognisedProjection> form = recognised(*matrix))
        eye = eyeLines(form->coefficients, isDepthZeroToOne(setup));
    else
        return {};
    const std::string z = matrix ? "z" : "-z";
    return R"(
def world_by_formula(window):
    """The world point, by the formulas of Weng et al. 2008: the projection is not inverted as a matrix."""
    xv, yv, depth = window
    d = (depth - at_near) / (at_far - at_near)
)" + eye
           + (std::holds_alternative<LookAt>(setup.pose)
                  ? "    return eye + np.array([x, y, " + z + "]) @ eye_from_world[:3, :3]\n\n"
                  : "    world = np.linalg.solve(eye_from_world, [x, y, " + z
                        + ", 1.0])\n    return world[:3] / world[3]\n\n");
}

std::string lens(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return "clip_from_eye = " + matrixRows(matrix->clipFromEye) + '\n';
    return projection(setup);
}

} // namespace

std::string numpyCode(const SceneFile &scene)
{
    const Setup p = setupOf(scene);
    const std::string formulas = formula(p);
    const std::string method = formulas.empty() ? "world_by_inverse" : "world_by_formula";
    const bool needsUnit = !scene.objects.empty() || std::holds_alternative<LookAt>(p.pose);
    std::string text =
        headerComment(scene, "The matrices of a setup, the projection of a point and its inverse, with NumPy alone",
                      "#")
        + "\nimport numpy as np\n" + (needsUnit ? kUnit : "") + (scene.objects.empty() ? "" : kSteps) + '\n'
        + viewportLines(p) + '\n' + lens(p) + '\n' + camera(p) + ofEachObject(scene, objectMatrix) + clipPlanes(scene)
        + kForward + formulas;
    text += "\n"
            "def screen2world(i, j, depth):\n"
            "    \"\"\"The world point of a pixel's centre, for the depth that is read there: in an image whose rows "
            "count\n"
            "    from the bottom, as those of glReadPixels do, at row window_height - 1 - j. "
            + list({clearDepth(p)}, NumberStyle::JavaScript)
            + " is the background.\"\"\"\n"
              "    return "
            + method + "(window_point(i, j, depth))\n";
    text += "\n\n"
            "if __name__ == \"__main__\":\n"
            "    i, j = int(vx + width / 2), int(window_height - vy - height / 2)\n"
            "    window = window_point(i, j, (at_near + at_far) / 2)\n"
            "    print(f\"pixel {i}, {j}, window point\", window)\n"
            + std::string(formulas.empty() ? "" : "    print(\"world by formula:\", world_by_formula(window))\n")
            + "    print(\"world by inverse:\", world_by_inverse(window))\n"
              "    print(\"projected again: \", project("
            + method + "(window)))\n";
    return text;
}

} // namespace unprojector::scene_code
