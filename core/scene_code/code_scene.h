#pragma once

#include "core/scene_file/scene_file.h"

#include <string>

namespace unprojector::scene_code {

/// Returns whether the viewport covers the whole window.
bool isWholeWindow(const geometry::Setup &setup);
/// Returns whether a perspective's aspect is the viewport's width / height.
bool hasViewportsAspect(const geometry::Setup &setup);
/// Returns whether NDC depths go from 0 to 1.
bool isDepthZeroToOne(const geometry::Setup &setup);
/// Returns whether the near plane has the greater depth, which reverses the depth test.
bool isNearGreater(const geometry::Setup &setup);
/// The depth to clear with: an end of [0, 1], which every depth buffer holds exactly, for any depth
/// range.
double clearDepth(const geometry::Setup &setup);

/// A description of an object for a comment: "face", models/face.obj
std::string whatIs(const scene_file::SceneFileObject &object);

/// Generates the code of one object.
/// @param id  ends a function's name, as "face" does; unique per object
using ObjectCode = std::string(const scene_file::SceneFileObject &object, const std::string &id);
/// The code of all objects, in the scene's order.
std::string ofEachObject(const scene_file::SceneFile &scene, ObjectCode &code);

/// glRotate's axis, scaled to length 1 if a library takes it for zero or its square leaves single
/// precision.
glm::dvec3 axisForCode(const glm::dvec3 &axis);

/// The matrix by which glOrtho's is multiplied: x += cot(theta) z_eye, y += cot(phi) z_eye.
glm::dmat4 shearOf(const geometry::Oblique &oblique);
/// The matrix by which glFrustum's is multiplied: x += skew y_eye.
glm::dmat4 shearOf(const geometry::Frustum &frustum);

} // namespace unprojector::scene_code
