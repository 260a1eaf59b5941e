#pragma once

#include "core/scene_file/scene_file.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::scene_code {
using namespace scene_file;

struct CodeObject {
    std::string id;   ///< to end a function's name with: "face"
    std::string what; ///< for a comment: "face", models/face.obj
    std::vector<TransformStep> transform;
    bool isHidden = false;
};

/// What all dialects say of a scene, each in its own words.
struct CodeScene {
    Picture picture;
    bool isWholeWindow = false;      ///< the viewport is the window
    bool hasViewportsAspect = false; ///< a perspective's aspect is the viewport's width by its height
    bool isDepthZeroToOne = false;   ///< NDC depths go from 0 to 1
    bool isNearGreater = false;      ///< near has the greater depth: the depth test is turned round
    std::vector<CodeObject> objects;
    std::vector<glm::dvec4> clipPlanes;

    /// Where depths are cleared to: an end of [0, 1], which every depth buffer holds exactly, whatever the depth range.
    double clearDepth() const { return isNearGreater ? 0.0 : 1.0; }
};

CodeScene codeScene(const SceneFile &scene);

/// glRotate's axis. One that a library takes for zero, or whose square leaves single precision, has the length 1.
glm::dvec3 axisForCode(const glm::dvec3 &axis);

/// The matrix that glOrtho's is multiplied by: x += cot(theta) z_eye, y += cot(phi) z_eye.
glm::dmat4 shearOf(const Oblique &oblique);

} // namespace unprojector::scene_code
