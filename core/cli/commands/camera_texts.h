#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cli/rows/byte_stream.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// Texts that were given as files, as "-" or in the words of an option.
struct GivenTexts {
    std::vector<cameras::NamedText> texts;
    InputFiles files; ///< empty where the words are the text
    std::string name; ///< of all, for messages
};

/// Reads the files that the words name. Where no word names a file, the words are the text. Errors
/// are printed on stderr.
/// @param option  the name of a text of words
std::optional<GivenTexts> givenTexts(const std::vector<std::string> &words, const std::string &option);

/// "camera.yml:3: K: it has 8 numbers".
std::string cameraErrorText(const cameras::CameraError &error, const std::string &name);

} // namespace unprojector::cli
