#include "core/cli/scene_command.h"

#include "core/cli/byte_stream.h"
#include "core/cli/size_text.h"
#include "core/files/path_text.h"
#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

namespace unprojector::cli {
using namespace scene_file;
using namespace files;
namespace {

/// The three things that are asked for, in the order in which they come where nothing is said.
struct Part {
    const char *name;
    std::size_t wanted;
    std::vector<double> numbers{};
};
using Parts = std::array<Part, 3>;

bool isWordCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
}

std::string lowerCase(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return result;
}

/// A number, with the f of a C float behind it or not.
std::optional<double> numberOf(std::string_view word)
{
    if (word.size() > 1 && word.front() == '+')
        word.remove_prefix(1);
    if (word.size() > 1 && (word.back() == 'f' || word.back() == 'F') && word.find_first_of("0123456789") != word.npos)
        word.remove_suffix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// Sorts the numbers of a text into the parts: those behind a part's name are that part's; those behind none go to the
/// first part that is not yet full. Brackets, commas and other words are passed over.
/// @param name  of the text, for the message
/// @return what is wrong, or nothing
std::string sortNumbers(const std::string &text, const std::string &name, Parts &parts)
{
    Part *named = nullptr;
    for (std::size_t at = 0; at < text.size();) {
        if (!isWordCharacter(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && isWordCharacter(text[end]))
            ++end;
        const std::string word = text.substr(at, end - at);
        at = end;
        const std::optional<double> value = numberOf(word);
        if (!value) {
            const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part &p) {
                return lowerCase(word).find(p.name) != std::string::npos;
            });
            if (part != parts.end())
                named = &*part;
            continue;
        }
        if (!std::isfinite(*value)) {
            const std::string_view before = std::string_view(text).substr(0, end - word.size());
            const std::string line = std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
            const std::string column = std::to_string(before.size() - (before.rfind('\n') + 1) + 1);
            return name + ':' + line + ':' + column + ": \"" + word + "\" is not a finite number";
        }
        Part *target = named;
        if (target == nullptr) {
            const auto open =
                std::find_if(parts.begin(), parts.end(), [](const Part &p) { return p.numbers.size() < p.wanted; });
            target = open == parts.end() ? &parts.back() : &*open;
        }
        target->numbers.push_back(*value);
    }
    for (const Part &part : parts) {
        if (part.numbers.size() != part.wanted)
            return name + ": " + part.name + ": " + std::to_string(part.numbers.size()) + " numbers found, "
                   + std::to_string(part.wanted) + " are needed";
    }
    return {};
}

glm::dmat4 matrixOf(const std::vector<double> &numbers, bool isRowByRow)
{
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) {
        const int outer = i / 4, inner = i % 4;
        (isRowByRow ? m[inner][outer] : m[outer][inner]) = numbers[static_cast<std::size_t>(i)];
    }
    return m;
}

struct Pasted {
    std::string text, name;
    bool isFile = false; ///< or stdin
};

/// What was pasted: the words themselves, or a file's text. What is wrong is said on stderr.
std::optional<Pasted> pasted(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += word + ' ';
    std::error_code ignored;
    const bool isFile =
        words.size() == 1 && (words[0] == "-" || std::filesystem::exists(pathFromUtf8(words[0]), ignored));
    if (!isFile)
        return Pasted{text, "--from-matrices"};
    ByteSource source(words[0]);
    if (!source.isOpen())
        return std::nullopt;
    constexpr std::size_t kMost = 1 << 20;
    text.resize(kMost);
    text.resize(source.read(text.data(), kMost));
    if (text.size() == kMost || source.hasFailed()) {
        complain(source.name()
                 + (source.hasFailed() ? ": cannot be read" : ": too long for two matrices and a viewport"));
        return std::nullopt;
    }
    return Pasted{text, source.name(), true};
}

/// The window's size: asked for, or up to where the viewport reaches.
bool setWindow(const SceneOptions &options, const Viewport &viewport, SceneFile &scene)
{
    if (options.window.empty()) {
        const double width = std::ceil(viewport.x + viewport.width), height = std::ceil(viewport.y + viewport.height);
        if (!(width >= 1.0 && height >= 1.0 && width <= kMostWindowPixels && height <= kMostWindowPixels)) {
            complain("viewport: it reaches beyond any window; give four numbers, x y width height, in pixels");
            return false;
        }
        scene.windowWidth = static_cast<int>(width);
        scene.windowHeight = static_cast<int>(height);
        return true;
    }
    const std::optional<SizeGiven> size = sizeGiven("--window", options.window);
    if (!size)
        return false;
    scene.windowWidth = size->width;
    scene.windowHeight = size->height;
    return true;
}

} // namespace

ExitCode runScene(const SceneOptions &options)
{
    const std::optional<Pasted> given = pasted(options.fromMatrices);
    if (!given)
        return ExitCode::UnusableInput;
    Parts parts{{{"modelview", 16}, {"projection", 16}, {"viewport", 4}}};
    if (const std::string problem = sortNumbers(given->text, given->name, parts); !problem.empty()) {
        const bool hasNumbers =
            std::any_of(parts.begin(), parts.end(), [](const Part &p) { return !p.numbers.empty(); });
        const bool isFileMeant = !hasNumbers && given->name == "--from-matrices" && options.fromMatrices.size() == 1;
        complain(isFileMeant ? options.fromMatrices[0] + ": there is no such file" : problem);
        return ExitCode::UnusableInput;
    }

    SceneFile scene;
    const std::vector<double> &v = parts[2].numbers;
    scene.viewport = Viewport{v[0], v[1], v[2], v[3]};
    if (!setWindow(options, *scene.viewport, scene))
        return ExitCode::UnusableInput;
    scene.view = matrixOf(parts[0].numbers, options.isRowByRow);
    scene.projection = MatrixProjection{matrixOf(parts[1].numbers, options.isRowByRow), std::nullopt};

    // What is written must be read again: the reader says what a scene may not be.
    const auto written = sceneText(scene);
    const std::string name = options.output == "-" ? "scene" : options.output;
    if (!written) {
        complain(sceneErrorText(written.error()));
        return ExitCode::UnusableInput;
    }
    if (const auto readAgain = parseScene(*written, name); !readAgain) {
        complain(sceneErrorText(readAgain.error()));
        return ExitCode::UnusableInput;
    }
    if (given->isFile && isOverInput(options.output, {options.fromMatrices[0]}))
        return ExitCode::UnusableInput;
    ByteSink sink(options.output);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(*written);
    return sink.finish();
}

} // namespace unprojector::cli
