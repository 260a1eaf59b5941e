#pragma once

#include "core/scene_file/scene_file.h"

#include <string>

namespace unprojector::scene_code {

/// Whether the viewport takes the whole window.
bool isWholeWindow(const geometry::Setup &setup);
/// Whether a perspective's aspect is the viewport's width by its height.
bool hasViewportsAspect(const geometry::Setup &setup);
/// Whether NDC depths go from 0 to 1.
bool isDepthZeroToOne(const geometry::Setup &setup);
/// Whether the near plane has the greater depth, which turns the depth test round.
bool isNearGreater(const geometry::Setup &setup);
/// The depth to clear with: an end of [0, 1], which every depth buffer holds exactly, whatever the depth range.
double clearDepth(const geometry::Setup &setup);

/// An object for a comment: "face", models/face.obj
std::string whatIs(const scene_file::SceneFileObject &object);

/// The code of one object.
/// @param id  ends a function's name, as "face" does; no two objects have the same
using ObjectCode = std::string(const scene_file::SceneFileObject &object, const std::string &id);
/// The code of all objects, in the scene's order.
std::string ofEachObject(const scene_file::SceneFile &scene, ObjectCode &code);

/// glRotate's axis. One that a library takes for zero, or whose square leaves single precision, has the length 1.
glm::dvec3 axisForCode(const glm::dvec3 &axis);

/// The matrix that glOrtho's is multiplied by: x += cot(theta) z_eye, y += cot(phi) z_eye.
glm::dmat4 shearOf(const geometry::Oblique &oblique);

} // namespace unprojector::scene_code
