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

/// APIs and programs that each have axes, depths and pixels of their own.
enum class Api { OpenGl, Vulkan, Direct3d, Metal, WebGpu, ThreeJs, Unity, OpenCv, OpenCascade };
inline constexpr std::array kApis{Api::OpenGl,  Api::Vulkan, Api::Direct3d, Api::Metal,      Api::WebGpu,
                                  Api::ThreeJs, Api::Unity,  Api::OpenCv,   Api::OpenCascade};

/// What one of them does otherwise than OpenGL, whose conventions are the values that stand here. An API that leaves a choice
/// has the usual one:
///
///   Vulkan       GLM's perspectiveRH_ZO with its second row turned round
///   Direct3d     10 and later; XMMatrixPerspectiveFovLH; the world as given, so that the view turns z round, as the SDK's notes on porting
///                from right-handed worlds have it
///   Metal        the right-handed functions of Apple's samples
///   WebGpu       wgpu-matrix
///   ThreeJs      Camera.matrixWorldInverse and projectionMatrix; the pointer's clientX and clientY
///   Unity        Camera.worldToCameraMatrix and projectionMatrix, which are OpenGL's; Camera.WorldToScreenPoint; the depth
///                buffer where SystemInfo.usesReversedZBuffer, so everywhere but on OpenGL
///   OpenCv       calib3d, without distortion: x_eye = R x + t, u = fx x / z + cx, v = fy y / z + cy
///   OpenCascade  opencascade-transforms: v M
struct ApiConventions {
    const char *key = "";         ///< in scene files and of the command: "direct3d"
    const char *name = "";        ///< "Direct3D"
    bool isWorldMirrored = false; ///< world space is left-handed: z is that of the scene, negated
    bool looksAlongPlusZ = false; ///< eye space has z forward
    bool isEyeYDown = false;
    bool isNdcYDown = false;
    NdcDepth ndcDepth = NdcDepth::MinusOneToOne;
    bool hasOnlyThatDepth = false; ///< no setting of the API makes it another one, as glClipControl does
    bool areVectorsRows = false;   ///< v M. Matrices are stored row by row then, which is the same sixteen numbers
    bool isOriginTop = false;      ///< pixels count from the top-left corner, y down
    bool areLogicalPixels = false; ///< CSS pixels: device pixels over the pixel ratio
    double pixelCentre = 0.5;      ///< what is added to a pixel's whole numbers to have its centre
    bool isDepthReversed = false;  ///< the depth buffer has its greater value at the near plane
};

const ApiConventions &conventionsOf(Api api);
/// @param key  as in scene files
std::optional<Api> apiOf(std::string_view key);

/// From one convention to another: x' = scale x + shift w on each axis, w as it is.
struct AxisChange {
    glm::dvec3 scale{1.0}, shift{0.0};

    glm::dmat4 matrix() const;
    AxisChange inverse() const;
    glm::dvec4 operator*(const glm::dvec4 &p) const { return {scale * glm::dvec3(p) + shift * p.w, p.w}; }
    glm::dvec3 operator*(const glm::dvec3 &p) const { return scale * p + shift; }
};

/// What takes points of this program's spaces to those of an API: apiFromOurs, space by space.
struct ApiSpaces {
    AxisChange world, eye;
    AxisChange clip;   ///< and NDC
    AxisChange window; ///< the position of a pixel and what the depth buffer holds there
};

/// @param setup  its eye space may look along +z, its NDC depth be [0, 1]: then these are changed as well
ApiSpaces apiSpaces(const Setup &setup, Api api);

/// A picture's matrices as an API has them, acting on column vectors; where vectors are rows, they are to be transposed. What
/// they show is the same picture.
struct ApiCamera {
    glm::dmat4 eyeFromWorld{1.0}; ///< OpenCV's [R t; 0 1]
    glm::dmat4 clipFromEye{1.0};  ///< OpenCV has none: OpenGL's clip from OpenCV's eye
    glm::dmat4 windowFromNdc{1.0};
    /// OpenCV's camera matrix K of the same picture in pixels whose centres are whole numbers, [fx s cx; 0 fy cy; 0 0 1]. Nothing
    /// for boxes, and for an API that has none.
    std::optional<glm::dmat3> intrinsics;
};

/// @return the errors of clipFromEye and eyeFromWorld
Result<ApiCamera> apiCamera(const Setup &setup, Api api);

/// A click in an API's own terms.
struct ApiClick {
    glm::dvec2 position{0.0};       ///< in pixels, see ApiConventions
    double depth = 0.0;             ///< what the depth buffer holds; of OpenCv, as in its depth images, z of the camera
    glm::dvec3 ndc{0.0};            ///< of OpenCv (x / z, y / z, 1)
    std::optional<glm::dvec4> clip; ///< OpenCv has none
    glm::dvec3 eye{0.0}, world{0.0};
};

/// @param window      of this program: device pixels, origin bottom-left
/// @param eye, world  the point that the click unprojects to
/// @return the errors of apiCamera
Result<ApiClick> apiClick(const Setup &setup, Api api, const WindowPoint &window, const EyePoint &eye,
                          const WorldPoint &world);

/// A projection and a view as an API writes them, for those that a scene has, and back: signs and no more, except that a depth
/// of [-1, 1] becomes [0, 1] where the API has only that.
MatrixProjection apiFromOurs(const MatrixProjection &projection, Api api);
MatrixProjection oursFromApi(const MatrixProjection &projection, Api api);
glm::dmat4 viewFromOurs(const glm::dmat4 &eyeFromWorld, Api api);
glm::dmat4 oursFromView(const glm::dmat4 &eyeFromWorld, Api api);

} // namespace unprojector::geometry
