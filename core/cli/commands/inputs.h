#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cli/rows/byte_stream.h"
#include "core/geometry/setup.h"
#include "core/opening/opened_scene.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// The inputs of commands, from the words of their options. Where one is unusable, the run ends with the
// reason on stderr.

namespace unprojector::cli {

using opening::filesOf;
using opening::OpenedScene;
using opening::raysOf;

/// A number in full that is finite.
std::optional<double> finiteNumberIn(std::string_view given);

/// Parses an option such as 800x600, without checking whether a view can have that size.
cameras::ImageSize sizeGiven(const std::string &option, const std::string &text);
/// The same for the size of a view.
geometry::Surface surfaceGiven(const std::string &option, const std::string &text);

/// True if a file is meant as a scene, see opening::isMeantAsScene.
/// @param file  UTF-8; "-" is a scene
bool isMeantAsScene(const std::string &file);

/// Opens a model file, a scene file, or clicks on one scene. Reads each model file once.
/// @param file  UTF-8; "-" is a scene from standard input
OpenedScene openScene(const std::string &file);

/// Checks that all objects lie within the range of computation.
void checkReach(const OpenedScene &opened);

/// The number of pixels of a view.
std::uint64_t pixelsOf(const geometry::Setup &setup);

/// The setup of an opened scene, see opening::setupOf.
/// @param size  device pixels; "800x600", or empty
geometry::Setup setupOf(const OpenedScene &opened, const std::string &size);

/// Texts that were given as files, as "-" or in the words of an option.
struct GivenTexts {
    std::vector<cameras::NamedText> texts;
    InputFiles files; ///< empty where the words are the text
    std::string name; ///< of all, for messages
};

/// Reads the files that the words name. Where no word names a file, the words are the text.
/// @param option  the name of a text of words
GivenTexts givenTexts(const std::vector<std::string> &words, const std::string &option);

/// Refuses texts of a camera: "camera.yml:3: K: it has 8 numbers".
[[noreturn]] void refuseCamera(base::Error error, const GivenTexts &given);

/// A lens that distorts the image of a scene's pinhole.
struct SceneLens {
    cameras::Distortion distortion;
    cameras::Intrinsics pinhole; ///< K of the scene
};

/// The lens of --distortion: coefficients "k1,k2,p1,p2,k3", or a file of a camera that has them. A K
/// that differs from the scene's is reported on stderr.
/// @param scene  its name, for messages
SceneLens sceneLens(const std::string &option, const geometry::Setup &setup, const std::string &scene);

} // namespace unprojector::cli
