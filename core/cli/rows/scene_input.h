#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/scene_file/clicks.h"
#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {
using namespace unproject;
using namespace scene_file;

struct PlacedObject {
    std::string name;
    glm::dmat4 worldFromObject{1.0};
};

/// What the command needs of a scene file: models are not loaded.
struct SceneInput {
    Picture geometry;
    std::vector<PlacedObject> objects;
    Api conventions = Api::OpenGl; ///< to write matrices in
    InputFiles files;              ///< see filesOf
};

/// Reads a scene file, or the clicks that the window prints; prints errors on stderr.
/// @param file  UTF-8; "-" for stdin
std::optional<SceneOrClicks> sceneOrClicks(const std::string &file);

/// The file itself, and those of the models that its scenes name, whether they are read or not.
/// @param file  as above
InputFiles filesOf(const SceneFile &scene, const std::string &file);
InputFiles filesOf(const SceneOrClicks &given, const std::string &file);

SceneInput sceneInput(const SceneFile &scene);
/// The scene of a file, or the one that all its clicks show. Errors are printed on stderr.
std::optional<SceneInput> sceneInput(const SceneOrClicks &given, const std::string &file);
std::optional<SceneInput> sceneInput(const std::string &file);

/// The same as the scene file that it is.
std::optional<SceneFile> sceneFile(const std::string &file);

/// The object of a name; where there is none, stderr says which there are, and where there are several, which those are.
const PlacedObject *objectNamed(const SceneInput &scene, const std::string &name);

/// What --space says: eye, world or object:NAME. Errors are printed on stderr.
std::optional<BatchSpace> batchSpace(const std::string &space, const SceneInput &scene);

} // namespace unprojector::cli
