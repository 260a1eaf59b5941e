#pragma once

#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {
using namespace unproject;

struct PlacedObject {
    std::string name;
    glm::dmat4 worldFromObject{1.0};
};

/// What the command needs of a scene file: models are not loaded.
struct SceneInput {
    Picture geometry;
    std::vector<PlacedObject> objects;
};

/// Reads a scene file; what is wrong with it is said on stderr.
/// @param file  UTF-8
std::optional<SceneInput> sceneInput(const std::string &file);

/// The first object of a name; where there is none, stderr says which there are.
const PlacedObject *objectNamed(const SceneInput &scene, const std::string &name);

/// What --space says: eye, world or object:NAME. What is wrong with it is said on stderr.
std::optional<BatchSpace> batchSpace(const std::string &space, const SceneInput &scene);

} // namespace unprojector::cli
