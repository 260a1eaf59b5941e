#pragma once

#include "core/files/file_stamp.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "core/scene_file/scene_file_error.h"
#include "core/text/json_value.h"
#include "core/unproject/unprojector.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::scene_file {

/// An object of a scene file, its model not loaded.
struct SceneFileObject {
    std::string name;           ///< UTF-8; may be empty
    std::filesystem::path file; ///< as written: relative to the scene file, or absolute; empty for a bundled model
    std::string bundled;        ///< name of a model that the program brings along, UTF-8; empty where there is a file
    std::vector<geometry::TransformStep> transform;
    text::JsonValue extra; ///< keys that this version does not know; null or an object
    bool isHidden = false; ///< "hidden": the window does not show it. Written only where it is so
};

/// What only the window uses of a scene: "ui". Whatever is left out has no value here.
struct SceneFileUi {
    std::optional<scene::ViewportRule> viewportRule;
    std::optional<bool> projectionFollowsViewport;
    std::optional<bool> clipDistancesFitObjects;
    std::optional<geometry::LookAt> home;
    std::vector<scene::ClipPlaneOff> clipPlanesOff;
};

/// What a scene file says, independent of any loaded model: the picture's numbers and where its objects are.
///
/// JSON; angles in degrees as in gluPerspective and glRotate, `window` in logical pixels, `viewport` in device pixels
/// from the bottom-left corner. "generator" says which program wrote it, and is ours as soon as we write it. "viewport", "depthRange", "objects", "clipPlanes", "landmarks", "point", "ui", the window's
/// "devicePixelRatio" and "fixed", and a perspective's "aspect" may be left out. Keys that this version does not know are kept and
/// written again after those it knows, numbers with all their digits. Those of a transform's steps are not.
/// "landmarks" are {"points": [{"name", "position": [x, y, z] or null where it is missing, "object", "held", …}], …}, in world
/// space; what each of them lies on is said by the object's name.
/// Where no number of degrees makes an angle's radians, "fovyRadians", "thetaRadians" or "phiRadians" say them as well.
/// What each key is, is said in scene_fields.h.
///
/// A projection of type "matrix" has "matrix", 16 numbers column by column, and may have "ndcDepth", [-1, 1] or [0, 1]; a
/// view may be {"matrix": [...]} too. Any finite matrix that has an inverse is read, whatever its form. "conventions" says
/// whose they are, "vulkan" or another key of ApiConventions: their axes, and the NDC depth where that API has but one, which
/// "ndcDepth" must not contradict. Where vectors are rows, the 16 numbers are row by row. The window shows matrices and points
/// so; everything else in the file is OpenGL's all the same, the world right-handed.
struct SceneFile {
    int windowWidth = 800; ///< logical pixels
    int windowHeight = 600;
    double devicePixelRatio = 1.0;
    bool isWindowFixed = false; ///< "fixed": the user has chosen the window's size. Written only where it is so
    std::optional<geometry::Viewport> viewport; ///< none: the whole window
    geometry::DepthRange depthRange;
    /// "conventions": whose matrices the file has; none: OpenGL's. Here they are OpenGL's always, see oursFromApi.
    std::optional<geometry::Api> conventions;
    std::variant<geometry::Projection, geometry::MatrixProjection> projection;
    bool aspectFromViewport = false; ///< a perspective without "aspect"; `projection` already has the viewport's
    std::variant<geometry::LookAt, glm::dmat4> view; ///< or eyeFromWorld
    std::vector<SceneFileObject> objects;
    std::vector<glm::dvec4> clipPlanes;
    landmarks::LandmarkSet landmarks;          ///< written where there is anything in it
    std::optional<geometry::GivenPoint> point; ///< "point": {"space": "eye", "coordinates": [x, y, z]}
    SceneFileUi ui;

    /// Unknown keys, each where it stood: {"author": "A", "window": {"title": "T"}}; null or an object. Objects and planes
    /// that do not cut have their own.
    text::JsonValue extra;
};

/// A scene file may have this many bytes, and brackets nested this deep: enough for tens of thousands of objects, and
/// little enough that no file, however made, can exhaust memory or stack.
constexpr std::size_t kMostSceneBytes = std::size_t{8} << 20;
constexpr std::size_t kMostSceneLevels = 64;
/// Of the window, logical pixels and device pixels.
constexpr int kMostWindowPixels = 65536;

/// Reads the text of a scene file. Everything is checked: a scene that is returned has a valid picture.
/// @param text  UTF-8, with or without a byte order mark
/// @param name  of the file, for the error
geometry::Result<SceneFile, SceneFileError> parseScene(std::string_view text, const std::string &name);

/// A scene file with other values.
/// @param change  their keys in objects as in the file; null removes a key (RFC 7396)
/// @param name    of the change, for the error
/// @return as parseScene
geometry::Result<SceneFile, SceneFileError> changed(const SceneFile &scene, const text::JsonValue &change,
                                                    const std::string &name);

/// The bytes of a scene file, no more of them than show that it is too large.
/// @return NotFound, IsDirectory, NotAFile, NotReadable
geometry::Result<std::string, SceneFileError> readSceneText(const std::filesystem::path &file);

/// @return the errors of readSceneText and parseScene
geometry::Result<SceneFile, SceneFileError> readSceneFile(const std::filesystem::path &file);

/// Whether a file is meant as a scene, whatever its name: a JSON object with the key "unprojector". It may still be one
/// that cannot be read; readSceneFile says why. A glTF file is JSON too, and has no such key.
bool isSceneFile(const std::filesystem::path &file);
bool isSceneText(std::string_view text);

/// The text of a scene file. Numbers have all their digits: parseScene gives the same ones back.
/// @return NotUtf8; TooLarge
geometry::Result<std::string, SceneFileError> sceneText(const SceneFile &scene);

/// Writes a scene file by way of a new file beside it, so that what was there is whole or replaced, never half. A model
/// that the scene shows is not written over.
/// @param onlyIf  what the file must still be like, so that nobody else's work is overwritten unseen
/// @return the stamp of what the file holds now; the errors of sceneText; IsDirectory, IsOwnModel, ChangedMeanwhile,
///         NotWritable
geometry::Result<files::FileStamp, SceneFileError>
writeSceneFile(const std::filesystem::path &file, const SceneFile &scene,
               const std::optional<files::FileStamp> &onlyIf = std::nullopt);

/// The picture that a scene file describes, in a window of its own size. To show it, take it byParameters.
geometry::Setup setupOf(const SceneFile &scene);

/// Where an object's file is.
/// @param sceneFile  the file that the scene was read from
std::filesystem::path objectFile(const SceneFileObject &object, const std::filesystem::path &sceneFile);

/// Why a window cannot draw what a file says, with the first key to change. The command computes with all of it.
/// @param name  of the file, for the error
/// @return InvalidValue: the errors of checkViewportNumber and checkDepthRangeEnd; EmptyDepthRange of two ends that are one
///         in single precision; those of byParameters(Setup), of matrices that no camera of the window's makes
std::optional<SceneFileError> whyNotShown(const SceneFile &scene, const std::string &name);

/// The scene to show for a file.
///
/// Without "ui" the file's numbers hold as they stand: near and far are not fitted, and the projection follows the
/// viewport only where the file leaves its aspect to it. A viewport that takes the whole window keeps doing so.
/// @param objects  of the scene, with their models: see opening::objectsOf
/// @return InvalidValue: whyNotShown; what reachable says of an object, with its place
geometry::Result<scene::Scene, SceneFileError>
sceneFromFile(const SceneFile &scene, const std::filesystem::path &sceneFile, std::vector<scene::SceneObject> objects);

/// What to write for a scene: the numbers of the picture as it is shown, and under "ui" how the window makes them. Only
/// the depth range is the scene's, with all the digits that were typed: OpenGL has it in single precision, and a depth
/// that was read at an end of that range may lie just outside this one. For such depths a click has the range of its
/// picture, see clickOf.
/// @param setup      of the scene, in the window that shows it
/// @param sceneFile  to be written; the objects' files are given relative to its folder
/// The matrix that a scene's projection or camera came as is written to the last digit, see Importable. Unknown keys of the file,
/// of objects and of planes that are off are written as they were read.
SceneFile sceneFileFrom(const scene::Scene &scene, const geometry::Setup &setup,
                        const std::filesystem::path &sceneFile);

} // namespace unprojector::scene_file
