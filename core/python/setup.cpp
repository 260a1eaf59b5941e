#include "core/python/arrays.h"
#include "core/python/bindings.h"

#include "unprojector/cameras.h"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::python {
namespace {

using Size = std::pair<int, int>;
using OptionalViewport = std::optional<std::array<double, 4>>;
using Ends = std::pair<double, double>;

/// An argument as a float64 array of the given shape, by rows.
py::array_t<double> argumentOf(const char *name, const py::object &argument, const Shape &shape)
{
    const py::array array = numbersOf(name, argument).array;
    if (shapeOf(array) != shape)
        refuseShape(name, array, shapeText(shape));
    return py::array_t<double, py::array::c_style | py::array::forcecast>(array);
}

glm::dvec3 vectorOf(const char *name, const py::object &argument)
{
    const auto array = argumentOf(name, argument, {3});
    return {array.at(0), array.at(1), array.at(2)};
}

void requireFinite(double number, const std::string &name)
{
    if (!std::isfinite(number))
        throw py::value_error(name + " is " + std::string(py::str(py::float_(number))) + "; give a finite number");
}

/// A matrix that acts on column vectors, rows by columns as NumPy has it.
template <class Matrix>
Matrix matrixOf(const char *name, const py::object &argument)
{
    constexpr auto kSize = static_cast<py::ssize_t>(Matrix::length());
    const auto array = argumentOf(name, argument, {kSize, kSize});
    Matrix matrix;
    for (py::ssize_t row = 0; row < kSize; ++row) {
        for (py::ssize_t column = 0; column < kSize; ++column) {
            const double entry = array.at(row, column);
            requireFinite(entry, std::string(name) + '[' + std::to_string(row) + ", " + std::to_string(column) + ']');
            matrix[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)] = entry;
        }
    }
    return matrix;
}

/// The rotation matrix of an argument: 3x3, or the vector of cv2.Rodrigues.
glm::dmat3 rotationOf(const py::object &argument)
{
    const py::array array = numbersOf("R", argument).array;
    const Shape shape = shapeOf(array);
    if (shape == Shape{3, 3})
        return matrixOf<glm::dmat3>("R", argument);
    if (shape != Shape{3} && shape != Shape{3, 1})
        refuseShape("R", array, "(3, 3), or the vector of cv2.Rodrigues, (3,)");
    const glm::dvec3 axis = vectorOf("R", py::module_::import("numpy").attr("ravel")(argument));
    for (int k = 0; k < 3; ++k)
        requireFinite(axis[k], "R[" + std::to_string(k) + ']');
    return rotationFromAxis(axis);
}

Window windowOf(const Size &size, const OptionalViewport &viewport, const Ends &depthRange)
{
    Window window;
    window.width = size.first;
    window.height = size.second;
    if (viewport)
        window.viewport = Viewport{(*viewport)[0], (*viewport)[1], (*viewport)[2], (*viewport)[3]};
    window.depthRange = {depthRange.first, depthRange.second};
    return window;
}

constexpr const char *kClassHelp = R"(All that maps the world to pixels: projection, camera, viewport and depth range.

A setup is valid and does not change. Setups can be compared, hashed, copied and pickled.

    Setup.perspective    gluPerspective and gluLookAt
    Setup.frustum        glFrustum and gluLookAt
    Setup.ortho          glOrtho and gluLookAt
    Setup.oblique        a sheared glOrtho and gluLookAt
    Setup.from_matrices  projection and view of another program
    Setup.from_opencv    K, R and t
    Setup.from_camera    a camera file of another program
    Setup.from_scene     the text of a scene file)";

/// The help that all constructors by parameters share.
const std::string kWindowHelp = R"(
near, far : float
    Distances of the near and the far plane from the eye.
eye, center, up : array_like of shape (3,)
    The arguments of gluLookAt, world space.
size : (int, int)
    Width and height of the window, device pixels.
viewport : (x, y, width, height), optional
    The arguments of glViewport: device pixels, from the bottom-left corner. None: the
    whole window.
depth_range : (float, float)
    The arguments of glDepthRange: the window depths of the near and the far plane.)";

/// Defines a constructor by parameters.
/// @param projectionOf  of the distances of near and far, and of its own arguments
/// @param own           these arguments
template <class... Own, class... Arguments>
void defConstructor(SetupClass &setup, const char *name, Projection (*projectionOf)(double, double, Own...),
                    const std::string &help, const Arguments &...own)
{
    setup.def_static(
        name,
        [projectionOf](Own... given, double nearDistance, double farDistance, const py::object &eye,
                       const py::object &center, const py::object &up, const Size &size,
                       const OptionalViewport &viewport, const Ends &depthRange) {
            return valueOrRaise(Setup::of(projectionOf(nearDistance, farDistance, given...),
                                          {vectorOf("eye", eye), vectorOf("center", center), vectorOf("up", up)},
                                          windowOf(size, viewport, depthRange)));
        },
        py::kw_only(), own..., py::arg("near"), py::arg("far"), py::arg("eye"), py::arg("center"),
        py::arg("up") = py::make_tuple(0.0, 1.0, 0.0), py::arg("size"), py::arg("viewport") = py::none(),
        py::arg("depth_range") = py::make_tuple(0.0, 1.0), (help + kWindowHelp).c_str());
}

void bindParameters(SetupClass &setup)
{
    defConstructor(
        setup, "perspective",
        +[](double nearDistance, double farDistance, double fovy, std::optional<double> aspect) -> Projection {
            return Perspective{fovy, aspect, nearDistance, farDistance};
        },
        R"(The setup of gluPerspective and gluLookAt.

perspective(*, fovy, near, far, eye, center, up=(0, 1, 0), size, aspect=None,
            viewport=None, depth_range=(0, 1))

fovy : float
    The vertical field of view, degrees.
aspect : float, optional
    Width / height. None: the viewport's.)",
        py::arg("fovy"), py::arg("aspect") = py::none());
    defConstructor(
        setup, "frustum",
        +[](double nearDistance, double farDistance, double left, double right, double bottom, double top,
            double skew) -> Projection { return Frustum{left, right, bottom, top, nearDistance, farDistance, skew}; },
        R"(The setup of glFrustum and gluLookAt.

frustum(*, left, right, bottom, top, near, far, eye, center, up=(0, 1, 0), size,
        skew=0.0, viewport=None, depth_range=(0, 1))

left, right, bottom, top : float
    The window on the near plane, eye units.
skew : float
    Replaces x by x + skew y in eye space before glFrustum.)",
        py::arg("left"), py::arg("right"), py::arg("bottom"), py::arg("top"), py::arg("skew") = 0.0);
    defConstructor(
        setup, "ortho",
        +[](double nearDistance, double farDistance, double left, double right, double bottom,
            double top) -> Projection { return Ortho{left, right, bottom, top, nearDistance, farDistance}; },
        R"(The setup of glOrtho and gluLookAt.

ortho(*, left, right, bottom, top, near, far, eye, center, up=(0, 1, 0), size,
      viewport=None, depth_range=(0, 1))

left, right, bottom, top : float
    The edges of the box, eye units.)",
        py::arg("left"), py::arg("right"), py::arg("bottom"), py::arg("top"));
    defConstructor(
        setup, "oblique",
        +[](double nearDistance, double farDistance, double left, double right, double bottom, double top, double theta,
            double phi) -> Projection {
            return Oblique{{left, right, bottom, top, nearDistance, farDistance}, theta, phi};
        },
        R"(The setup of a sheared glOrtho and gluLookAt: x += cot(theta) z_eye, y += cot(phi) z_eye.

oblique(*, left, right, bottom, top, theta, phi, near, far, eye, center, up=(0, 1, 0),
        size, viewport=None, depth_range=(0, 1))

left, right, bottom, top : float
    The edges of the box, eye units.
theta, phi : float
    The shear angles of x and y, degrees. 90 leaves an axis unsheared.)",
        py::arg("left"), py::arg("right"), py::arg("bottom"), py::arg("top"), py::arg("theta"), py::arg("phi"));
}

void bindMatrices(SetupClass &setup)
{
    setup.def_static(
        "from_matrices",
        [](const py::object &projection, const py::object &view, const Size &size, const std::string &conventions,
           const OptionalViewport &viewport, const Ends &depthRange) {
            auto clipFromEye = matrixOf<glm::dmat4>("projection", projection);
            auto eyeFromWorld = matrixOf<glm::dmat4>("view", view);
            if (areVectorsRows(conventions)) {
                clipFromEye = glm::transpose(clipFromEye);
                eyeFromWorld = glm::transpose(eyeFromWorld);
            }
            return valueOrRaise(
                Setup::fromMatrices(clipFromEye, eyeFromWorld, windowOf(size, viewport, depthRange), conventions));
        },
        py::arg("projection"), py::arg("view"), py::kw_only(), py::arg("size"), py::arg("conventions") = "opengl",
        py::arg("viewport") = py::none(), py::arg("depth_range") = py::make_tuple(0.0, 1.0),
        R"(The setup of another program's matrices.

from_matrices(projection, view, *, size, conventions="opengl", viewport=None,
              depth_range=(0, 1))

projection : array_like of shape (4, 4)
    Clip space from eye space.
view : array_like of shape (4, 4)
    Eye space from world space.
size : (int, int)
    Width and height of the window, device pixels.
conventions : str
    The API of the matrices: its axes and its depths. One of unprojector.conventions().
viewport, depth_range
    See Setup.perspective.

The matrices act on column vectors, M @ v. In conventions with row vectors ("direct3d",
"opencascade") they act on rows, v @ M, as that API writes them. Any matrix that has an
inverse is accepted; `findings` reports what is odd about it.)");
    setup.def_static(
        "from_opencv",
        [](const py::object &cameraMatrix, const py::object &rotation, const py::object &translation, const Size &size,
           double nearDistance, double farDistance, const Ends &depthRange) {
            const py::object flat = py::module_::import("numpy").attr("ravel")(translation);
            return valueOrRaise(Setup::fromOpenCv(matrixOf<glm::dmat3>("K", cameraMatrix), rotationOf(rotation),
                                                  vectorOf("t", flat), windowOf(size, std::nullopt, depthRange),
                                                  nearDistance, farDistance));
        },
        py::arg("K"), py::arg("R"), py::arg("t"), py::kw_only(), py::arg("size"), py::arg("near"), py::arg("far"),
        py::arg("depth_range") = py::make_tuple(0.0, 1.0),
        R"(The setup of a camera of OpenCV without distortion.

from_opencv(K, R, t, *, size, near, far, depth_range=(0, 1))

K : array_like of shape (3, 3)
    The camera matrix [fx s cx; 0 fy cy; 0 0 1], pixels. OpenCV counts the centre of its
    first pixel as (0, 0); in this module it is (0.5, 0.5).
R : array_like of shape (3, 3) or (3,)
    The rotation from world to camera axes, or its vector as cv2.Rodrigues takes it.
t : array_like of shape (3,)
    The translation: x_camera = R x_world + t.
size : (int, int)
    Width and height of the image, pixels.
near, far : float
    The planes that window depths count between. For `cloud` with depth_is="z", they
    limit the distances.)");
    setup.def_static(
        "from_camera",
        [](const py::args &files, const py::object &text, const std::variant<int, std::string> &image,
           const std::optional<Size> &size, std::optional<double> nearDistance, std::optional<double> farDistance,
           const std::string &axes, const std::string &pose, const std::string &pixelCenters, bool isUndistorted) {
            const std::string imageName = std::holds_alternative<int>(image) ? std::to_string(std::get<int>(image))
                                                                             : std::get<std::string>(image);
            CameraChoices choices{imageName, 0, 0, nearDistance, farDistance, axes, pose, pixelCenters, isUndistorted};
            if (size)
                std::tie(choices.width, choices.height) = *size;
            if (size && (choices.width < 1 || choices.height < 1))
                throw py::value_error("size is (" + std::to_string(choices.width) + ", "
                                      + std::to_string(choices.height)
                                      + "); width and height must be at least 1 pixel");
            if (!text.is_none() && !py::isinstance<py::str>(text))
                throw py::type_error("text is not a str");
            if (!text.is_none() && !files.empty())
                throw py::type_error("from_camera needs files or text=, not both");
            if (!text.is_none())
                return valueOrRaise(readCamera(std::vector<CameraText>{{"text", text.cast<std::string>()}}, choices))
                    .setup;
            std::vector<std::filesystem::path> paths;
            for (const py::handle file : files) {
                if (!py::isinstance<py::str>(file) && !py::hasattr(file, "__fspath__"))
                    throw py::type_error("a file is no path; give texts by text=");
                paths.push_back(file.cast<std::filesystem::path>());
            }
            if (paths.empty())
                throw py::type_error("from_camera needs files, or text=");
            return valueOrRaise(readCamera(paths, choices)).setup;
        },
        py::kw_only(), py::arg("text") = py::none(), py::arg("image") = "", py::arg("size") = py::none(),
        py::arg("near") = py::none(), py::arg("far") = py::none(), py::arg("axes") = "", py::arg("pose") = "",
        py::arg("pixel_centers") = "", py::arg("undistorted") = false,
        R"(The setup of another program's camera.

from_camera(*files, text=None, image="", size=None, near=None, far=None, axes="",
            pose="", pixel_centers="", undistorted=False)

files : paths
    The files of one camera: OpenCV (YAML, XML, JSON), ROS camera_info, COLMAP
    (cameras.txt with images.txt), NeRF transforms.json, Open3D, glTF, or the printed
    values of MuJoCo, PyBullet, Blender, Unity, Unreal, pyrender, 3D Gaussian splatting,
    SAPIEN.
text : str, optional
    The text itself, instead of files.
image : str or int
    The name or the index of an image or frame. Empty: the first.
size, near, far : optional
    Instead of the file's.
axes : "opengl", "opencv", "direct3d", "unreal", "ros"
    The axes of the camera. Empty: the program's.
pose : "world-to-camera", "camera-to-world"
    The direction of the pose. Empty: the program's.
pixel_centers : "integer", "half"
    The coordinates of the first pixel's centre, 0 or 1/2. Empty: the program's.
undistorted : bool
    Whether the pixels are those of the undistorted image. Without it, a camera with
    distortion is an error.

`findings` reports what was assumed.)");
    setup.def_static(
        "from_scene", [](const std::string &text) { return valueOrRaise(Setup::fromSceneText(text)); }, py::arg("text"),
        R"(The setup in the text of a scene file. Scene.load reads a file with its models.

from_scene(text))");
}

/// Equal setups have equal matrices; -0.0 and 0.0 have one hash.
std::size_t hashOf(const Setup &setup)
{
    auto hash = static_cast<std::size_t>(setup.width()) * 65537 + static_cast<std::size_t>(setup.height());
    const std::array matrices{setup.clipFromEye(), setup.eyeFromWorld()};
    for (const glm::dmat4 &matrix : matrices) {
        for (glm::length_t column = 0; column < 4; ++column) {
            for (glm::length_t row = 0; row < 4; ++row)
                hash = hash * 31 + std::hash<double>()(matrix[column][row]);
        }
    }
    return hash;
}

void bindProperties(SetupClass &setup)
{
    setup.def_property_readonly(
        "size", [](const Setup &s) { return std::pair(s.width(), s.height()); },
        "Width and height of the window, device pixels.");
    setup.def_property_readonly(
        "viewport",
        [](const Setup &s) {
            const Viewport v = s.viewport();
            return py::make_tuple(v.x, v.y, v.width, v.height);
        },
        "x, y, width, height of the viewport: device pixels, from the bottom-left corner.");
    setup.def_property_readonly(
        "depth_range", [](const Setup &s) { return std::pair(s.depthRange().atNear, s.depthRange().atFar); },
        "The window depths of the near and the far plane.");
    setup.def_property_readonly(
        "projection", [](const Setup &s) { return arrayOf(s.clipFromEye()); },
        "OpenGL's clip space from eye space, float64 of shape (4, 4), for column vectors.");
    setup.def_property_readonly(
        "view", [](const Setup &s) { return arrayOf(s.eyeFromWorld()); },
        "OpenGL's eye space from world space, float64 of shape (4, 4), for column vectors.");
    setup.def_property_readonly(
        "camera",
        [](const Setup &s) -> py::object {
            const std::optional<Camera> camera = s.camera();
            if (!camera)
                return py::none();
            return py::make_tuple(arrayOf(camera->eye), arrayOf(camera->center), arrayOf(camera->up));
        },
        "Eye, center and up, float64 of shape (3,) each; None where the view was given as a matrix.");
    setup.def_property_readonly(
        "findings", [](const Setup &s) { return s.findings(); },
        "What is odd about the given matrices, or was assumed of a camera: a list of sentences. It may be intended.");
    setup.def(
        "matrices",
        [](const Setup &s, const std::string &conventions) {
            const ApiMatrices m = valueOrRaise(s.matrices(conventions));
            const bool areRows = areVectorsRows(conventions);
            py::dict result;
            result["projection"] = arrayOf(m.clipFromEye, areRows);
            result["view"] = arrayOf(m.eyeFromWorld, areRows);
            result["window"] = arrayOf(m.windowFromNdc, areRows);
            if (m.intrinsics)
                result["K"] = arrayOf(*m.intrinsics, areRows);
            return result;
        },
        py::arg("conventions") = "opengl",
        R"(The matrices as an API has them.

matrices(conventions="opengl")

Returns a dict of float64 arrays: "projection", "view" and "window" (window from NDC), of
shape (4, 4); "K" of shape (3, 3) for "opencv". They act on column vectors, M @ v; in
conventions with row vectors on rows, v @ M.)");
    setup.def("to_scene", &Setup::sceneText,
              "The setup as the text of a scene file, with all digits: from_scene gives an equal setup.\n\nto_scene()");
    setup.def("__repr__", [](const Setup &s) { return "<Setup: " + s.description() + '>'; });
    setup.def("__eq__", [](const Setup &a, const py::object &b) -> py::object {
        if (!py::isinstance<Setup>(b))
            return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        return py::bool_(a == b.cast<Setup>());
    });
    setup.def("__hash__", &hashOf);
    setup.def("__copy__", [](const Setup &s) { return s; });
    setup.def("__deepcopy__", [](const Setup &s, const py::dict &) { return s; });
    setup.def(py::pickle([](const Setup &s) { return py::make_tuple(s.sceneText(), s.findings()); },
                         [](const py::tuple &state) {
                             return valueOrRaise(Setup::fromSceneText(state[0].cast<std::string>()))
                                 .withFindings(state[1].cast<std::vector<std::string>>());
                         }));
}

} // namespace

SetupClass bindSetup(py::module_ &module)
{
    SetupClass setup(module, "Setup", kClassHelp);
    bindParameters(setup);
    bindMatrices(setup);
    bindProperties(setup);
    return setup;
}

} // namespace unprojector::python
