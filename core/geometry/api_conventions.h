#pragma once

#include "core/geometry/setup.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace unprojector::geometry {

/// APIs and programs, each with its own axes, depths and pixels.
enum class Api { OpenGl, Vulkan, Direct3d, Metal, WebGpu, ThreeJs, Unity, OpenCv, OpenCascade };
inline constexpr std::array kApis{Api::OpenGl,  Api::Vulkan, Api::Direct3d, Api::Metal,      Api::WebGpu,
                                  Api::ThreeJs, Api::Unity,  Api::OpenCv,   Api::OpenCascade};

/// The differences between an API's conventions and OpenGL's. The default values are OpenGL's.
/// Where an API leaves a choice, the usual one is taken:
///
///   Vulkan       GLM's perspectiveRH_ZO with its second row negated
///   Direct3d     10 and later; XMMatrixPerspectiveFovLH. The world stays, the view negates z: see
///                the SDK's notes on porting from right-handed worlds
///   Metal        the right-handed functions of Apple's samples
///   WebGpu       wgpu-matrix
///   ThreeJs      Camera.matrixWorldInverse and projectionMatrix; the pointer's clientX and clientY
///   Unity        Camera.worldToCameraMatrix and projectionMatrix, which are OpenGL's;
///                Camera.WorldToScreenPoint; the depth buffer where SystemInfo.usesReversedZBuffer,
///                so everywhere but on OpenGL
///   OpenCv       calib3d, no distortion: x_eye = R x + t, u = fx x / z + cx, v = fy y / z + cy
///   OpenCascade  the article opencascade-transforms: row vectors, v M
struct ApiConventions {
    const char *key = "";         ///< name in scene files and on the command line: "direct3d"
    const char *name = "";        ///< "Direct3D"
    bool isWorldMirrored = false; ///< world space is left-handed: z is the scene's z, negated
    bool looksAlongPlusZ = false; ///< eye space has z forward
    bool isEyeYDown = false;
    bool isNdcYDown = false;
    NdcDepth ndcDepth = NdcDepth::MinusOneToOne;
    bool hasOnlyThatDepth = false; ///< no setting of the API changes ndcDepth, as glClipControl does in OpenGL
    bool areVectorsRows = false;   ///< v M. Matrices are then stored row by row: the same sixteen numbers
    bool isOriginTop = false;      ///< pixels count from the top-left corner, y down
    bool areLogicalPixels = false; ///< CSS pixels: device pixels over the pixel ratio
    double pixelCentre = 0.5;      ///< offset from a pixel's whole numbers to its centre
    bool isDepthReversed = false;  ///< the depth buffer has its greater value at the near plane
};

const ApiConventions &conventionsOf(Api api);
/// @param key  as in scene files
std::optional<Api> apiOf(std::string_view key);

/// A change from one convention to another: x' = scale x + shift w on each axis, w unchanged.
struct AxisChange {
    glm::dvec3 scale{1.0}, shift{0.0};

    glm::dmat4 matrix() const;
    AxisChange inverse() const;
    glm::dvec4 operator*(const glm::dvec4 &p) const { return {scale * glm::dvec3(p) + shift * p.w, p.w}; }
    glm::dvec3 operator*(const glm::dvec3 &p) const { return scale * p + shift; }
};

/// The changes from this program's spaces to an API's spaces: apiFromOurs, space by space.
struct ApiSpaces {
    AxisChange world, eye;
    AxisChange clip;   ///< and NDC
    AxisChange window; ///< the position of a pixel and its value in the depth buffer
};

/// @param setup  if its eye space looks along +z or its NDC depth is [0, 1], these are changed too
ApiSpaces apiSpaces(const Setup &setup, Api api);

/// A setup's matrices in an API's conventions, acting on column vectors. Where the API's vectors
/// are rows, transpose the matrices. They show the same view.
struct ApiCamera {
    glm::dmat4 eyeFromWorld{1.0}; ///< OpenCV's [R t; 0 1]
    glm::dmat4 clipFromEye{1.0};  ///< OpenCV has none: OpenGL's clip from OpenCV's eye
    glm::dmat4 windowFromNdc{1.0};
    /// OpenCV's camera matrix K of the same view, [fx s cx; 0 fy cy; 0 0 1]. The centres of its
    /// pixels are whole numbers. Empty for a box and for an API without K.
    std::optional<glm::dmat3> intrinsics;
};

/// @return the errors of clipFromEye and eyeFromWorld
Result<ApiCamera> apiCamera(const Setup &setup, Api api);

/// A click in an API's own terms.
struct ApiClick {
    glm::dvec2 position{0.0};       ///< in pixels, see ApiConventions
    double depth = 0.0;             ///< value in the depth buffer; for OpenCv the camera's z, as in its depth images
    glm::dvec3 ndc{0.0};            ///< for OpenCv (x / z, y / z, 1)
    std::optional<glm::dvec4> clip; ///< OpenCv has none
    glm::dvec3 eye{0.0}, world{0.0};
};

/// @param window      of this program: device pixels, origin bottom-left
/// @param eye, world  the point that the click unprojects to
/// @return the errors of apiCamera
Result<ApiClick> apiClick(const Setup &setup, Api api, const WindowPoint &window, const EyePoint &eye,
                          const WorldPoint &world);

/// Converts a scene's projection and view to an API's form, and back. Only signs change. If the API
/// has only NDC depths from 0 to 1, depths from -1 to 1 are converted too.
MatrixProjection apiFromOurs(const MatrixProjection &projection, Api api);
MatrixProjection oursFromApi(const MatrixProjection &projection, Api api);
glm::dmat4 viewFromOurs(const glm::dmat4 &eyeFromWorld, Api api);
glm::dmat4 oursFromView(const glm::dmat4 &eyeFromWorld, Api api);

} // namespace unprojector::geometry
