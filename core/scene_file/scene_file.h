#pragma once

#include "core/base/file_stamp.h"
#include "core/base/json.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "core/unproject/unprojector.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace unprojector::scene_file {

/// An object of a scene file, without its model.
struct SceneFileObject {
    std::string name;           ///< UTF-8; may be empty
    std::filesystem::path file; ///< as written: relative to the scene file, or absolute; empty for a bundled model
    std::string bundled;        ///< name of a bundled model, UTF-8; empty if there is a file
    std::vector<geometry::TransformStep> transform;
    base::JsonValue extra; ///< unknown keys; null or an object
    bool isHidden = false; ///< "hidden": the window does not show it. Written only if true
};

/// The settings of a scene that only the window uses: "ui". Missing keys have no value here.
struct SceneFileUi {
    std::optional<scene::ViewportRule> viewportRule;
    std::optional<bool> projectionFollowsViewport;
    std::optional<bool> clipDistancesFitObjects;
    std::optional<geometry::LookAt> home;
    std::vector<scene::ClipPlaneOff> clipPlanesOff;
};

/// The contents of a scene file without models: the numbers of the setup and the transforms of the
/// objects.
///
/// JSON. scene_fields.h defines each key.
///
/// - Angles are in degrees, as in gluPerspective and glRotate. If no number of degrees gives an
///   angle's radians, "fovyRadians", "thetaRadians" or "phiRadians" gives them too.
/// - `window` is in logical pixels, `viewport` in device pixels from the bottom-left corner.
/// - "generator" names the program that wrote the file; every write sets it to this program.
/// - Optional: "viewport", "depthRange", "objects", "clipPlanes", "landmarks", "point", "ui", the
///   window's "devicePixelRatio" and "fixed", and a perspective's "aspect".
/// - Unknown keys are kept and written after the known ones, numbers with all their digits. Unknown
///   keys of a transform's steps are lost.
/// - "landmarks" are {"points": [{"name", "position": [x, y, z] or null, "absence", "object",
///   "held", …}], …}, in world space; "object" is the name of the object that the landmark lies on.
///   "absence" is "skipped" or "missing" for a landmark without a position that is so.
/// - A projection of type "matrix" has "matrix", 16 numbers column by column, and optionally
///   "ndcDepth", [-1, 1] or [0, 1]. A view may be {"matrix": [...]} too. Any finite invertible
///   matrix is accepted.
/// - "conventions" names the API of the matrices, "vulkan" or another key of ApiConventions. It
///   sets their axes, and the NDC depth if that API has only one, which "ndcDepth" must not
///   contradict. For row vectors, the 16 numbers are row by row. The window shows matrices and
///   points in that convention. Everything else in the file is in OpenGL's, with a right-handed
///   world.
struct SceneFile {
    int windowWidth = 800; ///< logical pixels
    int windowHeight = 600;
    double devicePixelRatio = 1.0;
    bool isWindowFixed = false; ///< "fixed": the user has chosen the window's size. Written only if true
    std::optional<geometry::Viewport> viewport; ///< none: the whole window
    geometry::DepthRange depthRange;
    /// "conventions": the API of the file's matrices; none: OpenGL. In this struct they are always
    /// OpenGL's, see oursFromApi.
    std::optional<geometry::Api> conventions;
    std::variant<geometry::Projection, geometry::MatrixProjection> projection;
    bool aspectFromViewport = false; ///< a perspective without "aspect"; `projection` already has the viewport's
    std::variant<geometry::LookAt, glm::dmat4> view; ///< or eyeFromWorld
    std::vector<SceneFileObject> objects;
    std::vector<glm::dvec4> clipPlanes;
    landmarks::LandmarkSet landmarks;          ///< written unless empty
    std::optional<geometry::GivenPoint> point; ///< "point": {"space": "eye", "coordinates": [x, y, z]}
    SceneFileUi ui;

    /// Unknown keys, each at its position: {"author": "A", "window": {"title": "T"}}; null or an
    /// object. Objects and planes that do not cut have their own.
    base::JsonValue extra;
};

using SceneOrError = base::Expected<SceneFile, base::Error>;

/// The maximum number of bytes of a scene file. This allows more than a
/// million landmarks, and every file of landmarks that can be imported. A file or a pipe without end is
/// refused. In memory, a scene takes up to 40 times the size of its text.
constexpr std::size_t kMostSceneBytes = std::size_t{256} << 20;
/// The maximum size of the window, in logical pixels and in device pixels.
constexpr int kMostWindowPixels = 65536;

/// Reads the text of a scene file. Everything is checked: a returned scene has a valid setup.
/// @param text  UTF-8, with or without a byte order mark
/// @param name  of the file, for the error
/// @param mostBytes  the maximum size of the text; a text that this program wrote needs none
SceneOrError parseScene(std::string_view text, const std::string &name, std::size_t mostBytes = kMostSceneBytes);

/// Applies a JSON merge patch to a scene file.
/// @param change  the changed keys in objects as in the file; null removes a key (RFC 7396)
/// @param name    of the change, for the error
/// @return as parseScene
SceneOrError changed(const SceneFile &scene, const base::JsonValue &change, const std::string &name);

/// The error of a file that cannot be read.
/// @param reason  the system's, as errno; 0: unknown
base::Error notReadable(const std::string &name, int reason = 0);
/// The error of a scene with more bytes than a limit.
std::string tooLargeText(std::size_t mostBytes);

/// The bytes of a scene file. Of a file that is too large, only enough to show that it is.
/// @return an error of kind NoFile or File
base::Expected<std::string, base::Error> readSceneText(const std::filesystem::path &file);

/// @return the errors of readSceneText and parseScene
SceneOrError readSceneFile(const std::filesystem::path &file);

/// Returns whether a file is meant as a scene: a JSON object with the key "unprojector", under any
/// file name. It may still be invalid; readSceneFile returns the error. A glTF file is JSON too,
/// but has no such key.
bool isSceneFile(const std::filesystem::path &file);
bool isSceneText(std::string_view text);

/// The text of a scene file. Numbers have all their digits, so parseScene restores them exactly.
/// It may have more bytes than a scene file.
/// @return an error with the path of a text that is not UTF-8
base::Expected<std::string, base::Error> sceneText(const SceneFile &scene);

/// Writes a scene file atomically: to a new file beside it, which then replaces the old one. Does
/// not overwrite a model that the scene shows.
/// @param onlyIf  the expected state of the file, so that no other program's changes are
///         overwritten unseen
/// @return the stamp of the new contents; the errors of sceneText and replaceFile; an error if it could
///         not be read again, or would overwrite such a model
base::Expected<base::FileStamp, base::Error>
writeSceneFile(const std::filesystem::path &file, const SceneFile &scene,
               const std::optional<base::FileStamp> &onlyIf = std::nullopt);

/// The setup of a scene file, in a window of its own size. To show it, take it byParameters.
geometry::Setup setupOf(const SceneFile &scene);

/// The path of an object's file.
/// @param sceneFile  the file that the scene was read from
std::filesystem::path objectFile(const SceneFileObject &object, const std::filesystem::path &sceneFile);

/// The reason why a window cannot draw a scene file, with the first key to change. The command
/// computes with all such files.
/// @param name  of the file, for the error
/// @return the errors of checkViewportNumber and checkDepthRangeEnd; of a depth range whose ends are
///         equal in single precision; of byParameters(Setup), for matrices that no camera of the
///         window makes
std::optional<base::Error> whyNotShown(const SceneFile &scene, const std::string &name);

/// The scene to show for a file.
///
/// Without "ui" the file's numbers are used unchanged: near and far are not fitted, and the
/// projection follows the viewport only if the file leaves its aspect to it. A viewport that covers
/// the whole window keeps doing so.
/// @param objects  of the scene, with their models: see opening::objectsOf
/// @return whyNotShown; the error of reachable for an object, with its index
base::Expected<scene::Scene, base::Error> sceneFromFile(const SceneFile &scene, const std::filesystem::path &sceneFile,
                                                        std::vector<scene::SceneObject> objects);

/// An object as a scene file describes it.
/// @param sceneFile  the file that will have it: the model's path is relative to its folder
SceneFileObject sceneFileObject(const scene::SceneObject &object, const std::filesystem::path &sceneFile);

/// The scene file to write for a scene: the numbers of its setup, and the window's settings for
/// them under "ui". Only the depth range is the scene's, with all digits as typed. The setup's
/// range is rounded to single precision, and a depth read at an end of it may lie just outside the
/// scene's range. For such depths a click keeps the range of its setup, see clickOf. An imported
/// matrix of the projection or the camera is written to the last digit, see Importable. Unknown
/// keys of the file, of objects and of planes that are off are written as read.
/// @param setup      of the scene, in the window that shows it
/// @param sceneFile  to be written; the objects' files are given relative to its folder
SceneFile sceneFileFrom(const scene::Scene &scene, const geometry::Setup &setup,
                        const std::filesystem::path &sceneFile);

} // namespace unprojector::scene_file
