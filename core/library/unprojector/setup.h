#pragma once

#include "unprojector/export.h"
#include "unprojector/result.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector {

/// The arguments of gluPerspective. The angle is in degrees. 0 < near < far.
struct Perspective {
    double verticalFovDegrees = 45.0;
    std::optional<double> aspect = std::nullopt; ///< width / height; empty: the viewport's
    double nearDistance = 1.0, farDistance = 100.0;
};

/// The arguments of glFrustum, eye units: the window [left, right] x [bottom, top] on the near
/// plane. 0 < near < far. A skew replaces x_eye by x_eye + skew y_eye before glFrustum.
struct Frustum {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    double skew = 0.0;
};

/// The arguments of glOrtho, eye units. near and far are distances in front of the eye.
struct Ortho {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
};

/// A sheared glOrtho box: x += cot(theta) z_eye, y += cot(phi) z_eye. 90 degrees leave an axis
/// unsheared.
struct Oblique {
    Ortho box = {};
    double thetaDegrees = 90.0, phiDegrees = 90.0;
};

using Projection = std::variant<Perspective, Frustum, Ortho, Oblique>;

/// The arguments of gluLookAt, world space.
struct Camera {
    glm::dvec3 eye{0.0, 0.0, 5.0}, center{0.0}, up{0.0, 1.0, 0.0};
};

/// The arguments of glViewport: device pixels, origin at the bottom-left corner.
struct Viewport {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

/// The arguments of glDepthRange: the window depths of the near and the far plane.
struct DepthRange {
    double atNear = 0.0, atFar = 1.0;
};

/// The pixels that a setup maps to.
struct Window {
    int width = 800, height = 600;                   ///< device pixels
    std::optional<Viewport> viewport = std::nullopt; ///< empty: the whole window
    DepthRange depthRange = {};
};

/// A setup's matrices in the conventions of an API. They act on column vectors; where the API's
/// vectors are rows, transpose them.
struct ApiMatrices {
    glm::dmat4 clipFromEye{1.0};
    glm::dmat4 eyeFromWorld{1.0}; ///< OpenCV's [R t; 0 1]
    glm::dmat4 windowFromNdc{1.0};
    /// OpenCV's K, [fx s cx; 0 fy cy; 0 0 1]; empty for a box and other APIs.
    std::optional<glm::dmat3> intrinsics = std::nullopt;
};

/// The keys of the conventions: "opengl", "vulkan", "direct3d", "metal", "webgpu", "threejs",
/// "unity", "opencv", "opencascade".
UNPROJECTOR_PUBLIC std::vector<std::string> conventionKeys();
/// True if the matrices of an API act on row vectors, v M.
/// @pre a key
UNPROJECTOR_PUBLIC bool areVectorsRows(std::string_view conventions);

/// A rotation by |axis| radians about the axis, as cv2.Rodrigues makes it.
UNPROJECTOR_PUBLIC glm::dmat3 rotationFromAxis(const glm::dvec3 &axis);

/// All that maps the world to pixels: projection, camera, viewport and depth range. A setup is valid
/// and does not change; copies share its data. Any thread may use it.
class UNPROJECTOR_PUBLIC Setup {
public:
    /// Builds a setup by parameters.
    /// @return Value: the first parameter that is out of range
    static Result<Setup> of(const Projection &projection, const Camera &camera, const Window &window);

    /// Builds a setup from another program's matrices. Any matrix that has an inverse is accepted;
    /// `findings` reports what is odd about it.
    /// @param clipFromEye, eyeFromWorld  column vectors; the projection and the view
    /// @param conventions  a key, see conventionKeys: the axes and the depths of the matrices
    /// @return Value: an entry that is not finite, a matrix without an inverse, an unknown key
    static Result<Setup> fromMatrices(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld,
                                      const Window &window, std::string_view conventions = "opengl");

    /// Builds a setup from a camera of OpenCV without distortion: x_eye = R x + t,
    /// u = fx x / z + cx, v = fy y / z + cy. The centre of its first pixel is (0, 0).
    /// @param cameraMatrix, rotation, translation  K, R and t
    /// @param window  its size is the image's
    /// @param nearDistance, farDistance  > 0, the planes between which window depths count
    /// @return Value: K is no camera matrix, R no rotation, near and far
    static Result<Setup> fromOpenCv(const glm::dmat3 &cameraMatrix, const glm::dmat3 &rotation,
                                    const glm::dvec3 &translation, const Window &window, double nearDistance,
                                    double farDistance);

    /// Reads the setup of a scene file's text.
    /// @param name  of the file, for messages
    /// @return Value: the key and the line that are wrong
    static Result<Setup> fromSceneText(std::string_view text, const std::string &name = "scene");
    /// The setup as the text of a scene file without objects. Every number has all its digits:
    /// fromSceneText gives an equal setup.
    std::string sceneText() const;

    int width() const;  ///< device pixels
    int height() const; ///< device pixels
    Viewport viewport() const;
    DepthRange depthRange() const;

    /// OpenGL's matrices: eye space looks down -z, clip space is OpenGL's.
    glm::dmat4 clipFromEye() const;
    glm::dmat4 eyeFromWorld() const;
    /// @param conventions  a key, see conventionKeys
    /// @return Value: an unknown key
    Result<ApiMatrices> matrices(std::string_view conventions) const;

    /// The parameters; empty where the setup was given by a matrix. Of a camera by K, the frustum with
    /// rounded edges; sceneText() keeps K.
    std::optional<Projection> projection() const;
    std::optional<Camera> camera() const;

    /// Sentences about what is odd in the given matrices: transposed, mirrored, a far plane at
    /// infinity, reversed depths, axes that are not perpendicular. It may be intended.
    const std::vector<std::string> &findings() const;
    /// The same setup with these findings.
    Setup withFindings(std::vector<std::string> findings) const;

    /// A line that describes the setup: "perspective fovy 45 near 0.1 far 100, eye (3, 2, 5), 800x600".
    std::string description() const;

    bool operator==(const Setup &other) const;

private:
    friend struct SetupAccess;
    struct Data;
    explicit Setup(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
