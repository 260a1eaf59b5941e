#include "tests/support/wrong_programs.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace wrong_programs {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

dmat4 lookAt(const Scene &scene)
{
    const dvec3 f = glm::normalize(scene.target - scene.eye);
    const dvec3 s = glm::normalize(glm::cross(f, scene.up));
    const dvec3 u = glm::cross(s, f);
    const dvec3 moved(-glm::dot(s, scene.eye), -glm::dot(u, scene.eye), glm::dot(f, scene.eye));
    return {dvec4(s.x, u.x, -f.x, 0.0), dvec4(s.y, u.y, -f.y, 0.0), dvec4(s.z, u.z, -f.z, 0.0), dvec4(moved, 1.0)};
}

/// The state of a program at each step. A mistake changes the state before its step.
struct Program {
    const Scene &scene;
    Click click;
    double flipHeight;
    dvec4 viewport;
    dvec2 window{}; ///< origin bottom-left
    Lens lens;
    double halfWidth = 0.0, halfHeight = 0.0; ///< of the view, at distance 1 in perspective
    dmat4 projection{1.0}, view{1.0};
    dvec3 ndc{};
    dvec3 world{};

    explicit Program(const Scene &s, const Click &c)
        : scene(s), click(c), flipHeight(s.framebufferHeight), viewport(s.viewport), lens(s.lens)
    {
    }

    void flip() { window = {click.px, flipHeight - click.py}; }
    void measureLens()
    {
        halfHeight = lens.isPerspective ? std::tan(lens.fovyRadians / 2.0) : lens.height / 2.0;
        halfWidth = halfHeight * lens.aspect;
    }
    void makeMatrices()
    {
        const double n = lens.nearDistance, f = lens.farDistance;
        projection = dmat4(0.0);
        projection[0][0] = 1.0 / halfWidth;
        projection[1][1] = 1.0 / halfHeight;
        if (lens.isPerspective) {
            projection[2][2] = -(f + n) / (f - n);
            projection[3][2] = -2.0 * f * n / (f - n);
            projection[2][3] = -1.0;
        } else {
            projection[2][2] = -2.0 / (f - n);
            projection[3][2] = -(f + n) / (f - n);
            projection[3][3] = 1.0;
        }
        view = lookAt(scene);
    }
    void toNdc()
    {
        ndc = {2.0 * (window.x - viewport.x) / viewport.z - 1.0, 2.0 * (window.y - viewport.y) / viewport.w - 1.0,
               2.0 * click.depth - 1.0};
    }
    /// gluUnProject.
    void unproject() { divide(glm::inverse(projection * view) * dvec4(ndc, 1.0)); }
    void divide(const dvec4 &p) { world = dvec3(p) / p.w; }

    /// The distance in front of the eye from z_n, by the formulas.
    double distance() const
    {
        const double n = lens.nearDistance, f = lens.farDistance, d = (ndc.z + 1.0) / 2.0;
        return lens.isPerspective ? n * f / (f - d * (f - n)) : n + d * (f - n);
    }
    dvec3 eyePoint() const
    {
        const double z = distance(), size = lens.isPerspective ? z : 1.0;
        return {ndc.x * halfWidth * size, ndc.y * halfHeight * size, -z};
    }
    void fromEye(const dvec3 &p) { world = dvec3(glm::inverse(view) * dvec4(p, 1.0)); }
};

/// The steps, in order: before the y flip; after it; on the viewport; on the lens's numbers; on its
/// size in the view; on the matrices; on NDC; instead of gluUnProject; on the point.
enum class Step { Mouse, Window, Lens, Size, Matrices, Ndc, Unproject, Point };

struct Wrong {
    std::string_view id;
    int variants;
    Step step;
    void (*make)(Program &, int variant);
};

void setDistance(Program &p, double z)
{
    const double n = p.lens.nearDistance, f = p.lens.farDistance;
    p.click.depth = p.lens.isPerspective ? (f - n * f / z) / (f - n) : (z - n) / (f - n);
}

double trueDistance(Program &p)
{
    p.ndc.z = 2.0 * p.click.depth - 1.0;
    return p.distance();
}

const double kNoNumber = std::nan("");

/// A rotation by rows.
using Turn = std::array<std::array<double, 3>, 3>;

Turn operator*(const Turn &a, const Turn &b)
{
    Turn product{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t k = 0; k < 3; ++k)
                product[row][column] += a[row][k] * b[k][column];
        }
    }
    return product;
}

Turn transposed(const Turn &m)
{
    return {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
}

Turn turnOf(const dmat4 &view)
{
    return {{{view[0][0], view[1][0], view[2][0]},
             {view[0][1], view[1][1], view[2][1]},
             {view[0][2], view[1][2], view[2][2]}}};
}

dvec3 turned(const Turn &m, const dvec3 &p)
{
    return {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z, m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
            m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
}

dmat4 poseOf(const Turn &m, const dvec3 &moved)
{
    return {dvec4(m[0][0], m[1][0], m[2][0], 0.0), dvec4(m[0][1], m[1][1], m[2][1], 0.0),
            dvec4(m[0][2], m[1][2], m[2][2], 0.0), dvec4(moved, 1.0)};
}

/// Turns the view about the eye.
void setCamera(Program &p, const Turn &view)
{
    p.view = poseOf(view, -turned(view, p.scene.eye));
}

/// A rotation about x, y or z: 0, 1, 2.
Turn about(std::size_t axis, double angle)
{
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    Turn m{};
    m[axis][axis] = 1.0;
    m[b][b] = m[c][c] = std::cos(angle);
    m[c][b] = std::sin(angle);
    m[b][c] = -std::sin(angle);
    return m;
}

/// The angles whose product Rx Ry Rz is the rotation; Rz Ry Rx; Ry Rx Rz.
dvec3 anglesOfXyz(const Turn &m)
{
    return {std::atan2(-m[1][2], m[2][2]), std::asin(m[0][2]), std::atan2(-m[0][1], m[0][0])};
}

dvec3 anglesOfZyx(const Turn &m)
{
    return {std::atan2(m[2][1], m[2][2]), std::asin(-m[2][0]), std::atan2(m[1][0], m[0][0])};
}

dvec3 anglesOfYxz(const Turn &m)
{
    return {std::asin(-m[1][2]), std::atan2(m[0][2], m[2][2]), std::atan2(m[1][0], m[1][1])};
}

/// w, x, y, z, by the axis and the angle.
std::array<double, 4> quaternionOf(const Turn &m)
{
    const double trace = m[0][0] + m[1][1] + m[2][2], w = std::sqrt(std::max(0.0, 1.0 + trace)) / 2.0;
    const auto part = [&m, trace](std::size_t i) {
        return std::sqrt(std::max(0.0, 1.0 + 2.0 * m[i][i] - trace)) / 2.0;
    };
    return {w, std::copysign(part(0), m[2][1] - m[1][2]), std::copysign(part(1), m[0][2] - m[2][0]),
            std::copysign(part(2), m[1][0] - m[0][1])};
}

Turn turnBy(double w, double x, double y, double z)
{
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// Only a perspective can have the mistake.
void inPerspective(Program &p)
{
    if (!p.lens.isPerspective)
        p.world.x = kNoNumber;
}

const std::vector<Wrong> &wrongs()
{
    static const std::vector<Wrong> all{
        // The mouse and the window
        {"y-not-flipped", 1, Step::Window, [](Program &p, int) { p.window.y = p.click.py; }},
        {"row-above", 1, Step::Window, [](Program &p, int) { p.window.y += 1.0; }},
        // (i, H-1-j), the lower left corner; (i, H-j), the upper left one; the half added to y
        // alone, to x alone
        {"pixel-corner", 4, Step::Window,
         [](Program &p, int variant) {
             p.window.x -= variant == 3 ? 0.0 : 0.5;
             p.window.y += variant == 1 ? 0.5 : variant == 2 ? 0.0 : -0.5;
         }},
        // The window's coordinates, or the mouse's
        {"xy-swapped", 2, Step::Window,
         [](Program &p, int variant) {
             if (variant == 0)
                 std::swap(p.window.x, p.window.y);
             else
                 p.window = {p.click.py, p.flipHeight - p.click.px};
         }},
        {"ratio-logical-in-device", 1, Step::Mouse,
         [](Program &p, int) {
             p.click.px /= p.scene.pixelRatio;
             p.click.py /= p.scene.pixelRatio;
         }},
        {"ratio-logical-both", 1, Step::Mouse,
         [](Program &p, int) {
             p.click.px /= p.scene.pixelRatio;
             p.click.py /= p.scene.pixelRatio;
             p.flipHeight /= p.scene.pixelRatio;
         }},
        // glViewport's numbers in logical pixels; the flip by the logical height as well, or the
        // ratio multiplied twice, which is the same
        {"ratio-device-in-logical", 2, Step::Mouse,
         [](Program &p, int variant) {
             p.viewport /= p.scene.pixelRatio;
             if (variant == 1)
                 p.flipHeight /= p.scene.pixelRatio;
         }},
        {"viewport-origin-ignored", 1, Step::Window, [](Program &p, int) { p.viewport.x = p.viewport.y = 0.0; }},
        {"flipped-with-viewport-height", 1, Step::Mouse, [](Program &p, int) { p.flipHeight = p.scene.viewport.w; }},
        {"viewport-is-window", 1, Step::Window,
         [](Program &p, int) {
             p.viewport = {0.0, 0.0, p.scene.framebufferWidth, p.scene.framebufferHeight};
         }},
        // The lens
        {"aspect-integer", 1, Step::Lens,
         [](Program &p, int) {
             const int aspect = int(p.scene.viewport.z) / int(p.scene.viewport.w);
             p.lens.aspect = aspect;
         }},
        {"aspect-inverted", 1, Step::Lens, [](Program &p, int) { p.lens.aspect = 1.0 / p.lens.aspect; }},
        {"fov-degrees-as-radians", 1, Step::Lens,
         [](Program &p, int) { p.lens.fovyRadians *= 180.0 / std::numbers::pi; }},
        {"fov-half", 1, Step::Lens, [](Program &p, int) { p.lens.fovyRadians /= 2.0; }},
        {"fov-double", 1, Step::Lens, [](Program &p, int) { p.lens.fovyRadians *= 2.0; }},
        // The angle spans the width; or that angle is passed as gluPerspective's
        {"fov-horizontal", 2, Step::Size,
         [](Program &p, int variant) {
             const double share = variant == 0 ? 1.0 / p.lens.aspect : p.lens.aspect;
             if (p.lens.isPerspective) {
                 p.halfWidth *= share;
                 p.halfHeight *= share;
             }
         }},
        // 1/10, or ten times as far
        {"near-differs", 2, Step::Lens,
         [](Program &p, int variant) { p.lens.nearDistance *= variant == 0 ? 0.1 : 10.0; }},
        {"far-differs", 2, Step::Lens,
         [](Program &p, int variant) { p.lens.farDistance *= variant == 0 ? 10.0 : 0.1; }},
        // Depth
        {"depth-not-remapped", 1, Step::Ndc, [](Program &p, int) { p.ndc.z = p.click.depth; }},
        {"depth-remapped-twice", 1, Step::Ndc, [](Program &p, int) { p.ndc.z = 2.0 * p.ndc.z - 1.0; }},
        // A linear depth used as OpenGL's, or OpenGL's as a linear one
        {"depth-linear", 2, Step::Mouse,
         [](Program &p, int variant) {
             const double n = p.lens.nearDistance, f = p.lens.farDistance;
             if (variant == 0)
                 p.click.depth = (trueDistance(p) - n) / (f - n);
             else
                 setDistance(p, n + p.click.depth * (f - n));
         }},
        {"depth-zero", 1, Step::Mouse, [](Program &p, int) { p.click.depth = 0.0; }},
        {"depth-one", 1, Step::Mouse, [](Program &p, int) { p.click.depth = 1.0; }},
        {"depth-is-eye-distance", 1, Step::Mouse, [](Program &p, int) { p.click.depth = trueDistance(p); }},
        {"depth-reversed", 1, Step::Mouse, [](Program &p, int) { p.click.depth = 1.0 - p.click.depth; }},
        // Vector3.Unproject(v, x, y, w, h, near, far, m): the viewport's MinDepth and MaxDepth
        {"depth-range-is-planes", 1, Step::Mouse,
         [](Program &p, int) {
             p.click.depth = (p.click.depth - p.lens.nearDistance) / (p.lens.farDistance - p.lens.nearDistance);
         }},
        {"ray-length-as-z", 1, Step::Unproject,
         [](Program &p, int) {
             if (!p.lens.isPerspective)
                 return p.unproject();
             const dvec3 eye = p.eyePoint();
             p.fromEye(eye * (glm::length(eye) / -eye.z));
         }},
        {"z-as-ray-length", 1, Step::Unproject,
         [](Program &p, int) {
             if (!p.lens.isPerspective)
                 return p.unproject();
             const dvec3 eye = p.eyePoint();
             p.fromEye(glm::normalize(eye) * -eye.z);
         }},
        // The formulas
        // Each angle from its own edge; or both by the same angle a pixel
        {"linear-angle", 2, Step::Unproject,
         [](Program &p, int variant) {
             const double z = p.distance(), y = std::atan(p.halfHeight);
             const double x = variant == 0 ? std::atan(p.halfWidth) : y * p.lens.aspect;
             p.fromEye({std::tan(p.ndc.x * x) * z, std::tan(p.ndc.y * y) * z, -z});
             inPerspective(p);
         }},
        {"eye-z-positive", 1, Step::Unproject,
         [](Program &p, int) {
             const dvec3 eye = p.eyePoint();
             p.fromEye({eye.x, eye.y, -eye.z});
         }},
        {"eye-xy-mirrored", 1, Step::Unproject,
         [](Program &p, int) {
             const dvec3 eye = p.eyePoint();
             p.fromEye({-eye.x, -eye.y, eye.z});
         }},
        // (11), (12) with glFrustum's left, right, bottom, top
        {"ortho-formula", 1, Step::Unproject,
         [](Program &p, int) {
             const double n = p.lens.nearDistance;
             p.fromEye({p.ndc.x * p.halfWidth * n, p.ndc.y * p.halfHeight * n, -p.distance()});
             inPerspective(p);
         }},
        {"divided-by-far", 1, Step::Unproject,
         [](Program &p, int) {
             const double n = p.lens.nearDistance, z = p.distance(), share = n * z / p.lens.farDistance;
             p.fromEye({p.ndc.x * p.halfWidth * share, p.ndc.y * p.halfHeight * share, -z});
             inPerspective(p);
         }},
        // The matrices
        {"projection-transposed", 1, Step::Matrices,
         [](Program &p, int) { p.projection = glm::transpose(p.projection); }},
        {"view-transposed", 1, Step::Matrices, [](Program &p, int) { p.view = glm::transpose(p.view); }},
        {"both-transposed", 1, Step::Matrices,
         [](Program &p, int) {
             p.projection = glm::transpose(p.projection);
             p.view = glm::transpose(p.view);
         }},
        {"view-inverse-as-view", 1, Step::Matrices, [](Program &p, int) { p.view = glm::inverse(p.view); }},
        {"product-transposed", 1, Step::Unproject,
         [](Program &p, int) { p.divide(glm::inverse(glm::transpose(p.projection * p.view)) * dvec4(p.ndc, 1.0)); }},
        {"inverse-order", 1, Step::Unproject,
         [](Program &p, int) { p.divide(glm::inverse(p.projection) * glm::inverse(p.view) * dvec4(p.ndc, 1.0)); }},
        {"not-inverted", 1, Step::Unproject,
         [](Program &p, int) { p.divide(p.projection * p.view * dvec4(p.ndc, 1.0)); }},
        {"no-w-divide", 1, Step::Unproject,
         [](Program &p, int) { p.world = dvec3(glm::inverse(p.projection * p.view) * dvec4(p.ndc, 1.0)); }},
        {"overwritten-in-place", 1, Step::Unproject,
         [](Program &p, int) {
             // for each row: v[row] = m.row(row) . v
             const dmat4 m = glm::transpose(glm::inverse(p.projection * p.view));
             dvec4 v(p.ndc, 1.0);
             for (int row = 0; row < 4; ++row)
                 v[row] = glm::dot(m[row], v);
             p.divide(v);
         }},
        {"view-left-out", 1, Step::Matrices, [](Program &p, int) { p.view = dmat4(1.0); }},
        // The camera of a vision program: its axes, its pose, its K
        {"opencv-axes", 1, Step::Unproject,
         [](Program &p, int) {
             // The point by K, in the camera's axes of OpenCV, through OpenGL's pose
             const dvec3 eye = p.eyePoint();
             p.fromEye({eye.x, -eye.y, -eye.z});
         }},
        // R^T p + t; or a view with R^T and the camera's position
        {"translation-not-inverted", 2, Step::Matrices,
         [](Program &p, int variant) {
             const Turn r = turnOf(p.view);
             const dvec3 t(p.view[3]);
             p.view = variant == 0 ? glm::inverse(poseOf(transposed(r), t)) : poseOf(r, p.scene.eye);
         }},
        // COLMAP's w x y z of OpenCV's view read as x y z w, and the reverse; the same of a camera's pose
        // in OpenGL's axes
        {"quaternion-order", 4, Step::Matrices,
         [](Program &p, int variant) {
             const bool isView = variant < 2;
             Turn r = turnOf(p.view);
             if (isView) {
                 for (int i = 0; i < 3; ++i) {
                     r[1][i] = -r[1][i];
                     r[2][i] = -r[2][i];
                 }
             } else {
                 r = transposed(r);
             }
             const std::array<double, 4> q = quaternionOf(r); // w x y z
             const bool isScalarFirst = variant % 2 == 0;
             Turn wrong = isScalarFirst ? turnBy(q[3], q[0], q[1], q[2]) : turnBy(q[1], q[2], q[3], q[0]);
             if (!isView)
                 return setCamera(p, transposed(wrong));
             for (int i = 0; i < 3; ++i) {
                 wrong[1][i] = -wrong[1][i];
                 wrong[2][i] = -wrong[2][i];
             }
             p.view = poseOf(wrong, dvec3(p.view[3]));
         }},
        // Angles of Rx Ry Rz multiplied as Rz Ry Rx; of Rz Ry Rx as Rx Ry Rz; of Ry Rx Rz as Rz Ry Rx
        {"euler-order", 3, Step::Matrices,
         [](Program &p, int variant) {
             const Turn r = transposed(turnOf(p.view));
             if (variant == 0) {
                 const dvec3 a = anglesOfXyz(r);
                 setCamera(p, transposed(about(2, a.z) * about(1, a.y) * about(0, a.x)));
             } else if (variant == 1) {
                 const dvec3 a = anglesOfZyx(r);
                 setCamera(p, transposed(about(0, a.x) * about(1, a.y) * about(2, a.z)));
             } else {
                 const dvec3 a = anglesOfYxz(r);
                 setCamera(p, transposed(about(2, a.z) * about(1, a.y) * about(0, a.x)));
             }
         }},
        {"euler-degrees", 2, Step::Matrices,
         [](Program &p, int variant) {
             const double factor = variant == 0 ? 180.0 / std::numbers::pi : std::numbers::pi / 180.0;
             const dvec3 a = factor * anglesOfZyx(transposed(turnOf(p.view)));
             setCamera(p, transposed(about(2, a.z) * about(1, a.y) * about(0, a.x)));
         }},
        // x = (u - cx) / fx z, with u from the picture's left edge: cx and cy exchanged
        {"centre-swapped", 1, Step::Unproject,
         [](Program &p, int) {
             const double w = p.viewport.z, h = p.viewport.w, focal = h / 2.0 / p.halfHeight, z = p.distance();
             const double u = p.window.x - p.viewport.x, v = p.viewport.y + h - p.window.y;
             p.fromEye({(u - h / 2.0) / focal * z, -(v - w / 2.0) / focal * z, -z});
             inPerspective(p);
         }},
        // K of half and of twice the size of the viewport's picture
        {"intrinsics-of-another-size", 2, Step::Unproject,
         [](Program &p, int variant) {
             const double s = variant == 0 ? 0.5 : 2.0, w = p.viewport.z, h = p.viewport.w;
             const double focal = s * h / 2.0 / p.halfHeight, z = p.distance();
             const double u = p.window.x - p.viewport.x, v = p.viewport.y + h - p.window.y;
             p.fromEye({(u - s * w / 2.0) / focal * z, -(v - s * h / 2.0) / focal * z, -z});
             inPerspective(p);
         }},
        // The half added to a position that has it; to the row that counts from the bottom
        {"half-pixel-twice", 2, Step::Window,
         [](Program &p, int variant) {
             p.window.x += 0.5;
             p.window.y += variant == 0 ? -0.5 : 0.5;
         }},
        // The point
        {"axes-differ", 4, Step::Point,
         [](Program &p, int variant) {
             const dvec3 w = p.world;
             p.world = variant == 0   ? dvec3(w.x, -w.z, w.y)
                       : variant == 1 ? dvec3(w.x, w.z, -w.y)
                       : variant == 2 ? dvec3(-w.y, w.z, w.x)
                                      : dvec3(w.x, w.y, -w.z);
         }},
        {"model-left-in", 1, Step::Point,
         [](Program &p, int) { p.world = dvec3(glm::inverse(p.scene.worldFromObject) * dvec4(p.world, 1.0)); }},
        {"model-left-out", 1, Step::Point,
         [](Program &p, int) { p.world = dvec3(p.scene.worldFromObject * dvec4(p.world, 1.0)); }},
        {"eye-added", 1, Step::Point, [](Program &p, int) { p.world += p.scene.eye; }},
    };
    return all;
}

const Wrong *wrongOf(std::string_view id)
{
    const auto found = std::find_if(wrongs().begin(), wrongs().end(), [&](const Wrong &w) { return w.id == id; });
    return found == wrongs().end() ? nullptr : &*found;
}

} // namespace

const std::vector<Mistake> &mistakes()
{
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> result;
        for (const Wrong &wrong : wrongs())
            result.push_back({wrong.id, wrong.variants});
        return result;
    }();
    return all;
}

Click clickOn(const Scene &scene, const dvec3 &world)
{
    Program program(scene, {});
    program.measureLens();
    program.makeMatrices();
    const dvec4 clip = program.projection * program.view * dvec4(world, 1.0);
    const dvec3 ndc = dvec3(clip) / clip.w;
    const dvec4 &v = scene.viewport;
    return {v.x + (ndc.x + 1.0) * v.z / 2.0, scene.framebufferHeight - (v.y + (ndc.y + 1.0) * v.w / 2.0),
            (ndc.z + 1.0) / 2.0};
}

std::optional<dvec3> printed(const Scene &scene, const Click &click, const std::vector<Made> &made)
{
    Program program(scene, click);
    const auto mistakesAt = [&](Step step) {
        bool any = false;
        for (const Made &m : made) {
            const Wrong *wrong = wrongOf(m.id);
            if (wrong == nullptr || wrong->step != step)
                continue;
            wrong->make(program, m.variant);
            any = true;
        }
        return any;
    };
    mistakesAt(Step::Mouse);
    program.flip();
    mistakesAt(Step::Window);
    mistakesAt(Step::Lens);
    program.measureLens();
    mistakesAt(Step::Size);
    program.makeMatrices();
    mistakesAt(Step::Matrices);
    program.toNdc();
    mistakesAt(Step::Ndc);
    if (!mistakesAt(Step::Unproject))
        program.unproject();
    mistakesAt(Step::Point);
    const dvec3 &p = program.world;
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return std::nullopt;
    return p;
}

} // namespace wrong_programs
