#include "core/cli/commands/camera_texts.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace unprojector::cli {
using namespace base;
namespace {

bool isFile(const std::string &word)
{
    std::error_code ignored;
    return word == "-" || std::filesystem::exists(pathFromUtf8(word), ignored);
}

/// @return nothing if the file cannot be read, with a message on stderr
std::optional<cameras::NamedText> textOf(const std::string &file)
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    cameras::NamedText text{source.name(), {}};
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    for (std::size_t read = kPiece; read == kPiece && text.text.size() <= cameras::kMostCameraBytes;) {
        const std::size_t begin = text.text.size();
        text.text.resize(begin + kPiece);
        read = source.read(text.text.data() + begin, kPiece);
        text.text.resize(begin + read);
    }
    if (text.text.size() > cameras::kMostCameraBytes || source.hasFailed()) {
        complain(source.hasFailed() ? tr("%1: cannot be read", source.name())
                                    : tr("%1: longer than 256 MiB; give the file of one camera", source.name()));
        return std::nullopt;
    }
    text.text = base::utf8FromFile(std::move(text.text));
    return text;
}

} // namespace

std::optional<GivenTexts> givenTexts(const std::vector<std::string> &words, const std::string &option)
{
    GivenTexts given;
    if (std::none_of(words.begin(), words.end(), isFile)) {
        std::string text;
        for (const std::string &word : words)
            text += word + ' ';
        return GivenTexts{{{option, text}}, {}, option};
    }
    for (const std::string &word : words) {
        if (!isFile(word)) {
            complain(word + ": " + tr("there is no such file"));
            return std::nullopt;
        }
        std::optional<cameras::NamedText> text = textOf(word);
        if (!text)
            return std::nullopt;
        given.name += (given.name.empty() ? "" : ", ") + text->name;
        given.texts.push_back(std::move(*text));
        given.files.push_back(word);
    }
    return given;
}

std::string cameraErrorText(const cameras::CameraError &error, const std::string &name)
{
    const std::string file = error.file.empty() ? name : error.file;
    return file + (error.line > 0 ? ':' + std::to_string(error.line) : std::string()) + ": " + error.reason;
}

} // namespace unprojector::cli
