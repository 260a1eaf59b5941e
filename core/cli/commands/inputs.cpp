#include "core/cli/commands/inputs.h"

#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"
#include "core/cameras/lens.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/refusal.h"
#include "core/geometry/api_conventions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace unprojector::cli {
using namespace cameras;
using namespace geometry;
using namespace base;

std::optional<double> finiteNumberIn(std::string_view given)
{
    const std::optional<double> number = numberIn<double>(given);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

ImageSize sizeGiven(const std::string &option, const std::string &text)
{
    const std::size_t cross = std::min(text.find('x'), text.size());
    const auto width = numberIn<int>(text.substr(0, cross)),
               height = numberIn<int>(text.substr(std::min(cross + 1, text.size())));
    if (!width || !height)
        refuse(tr("%1: give width and height in pixels, as in 800x600", option + ' ' + text));
    return {*width, *height};
}

Surface surfaceGiven(const std::string &option, const std::string &text)
{
    const ImageSize size = sizeGiven(option, text);
    const Surface surface{size.width, size.height, 1.0};
    if (const Check valid = check(surface); !valid)
        refuse(option + ' ' + text + ": " + errorText(valid.error()));
    return surface;
}

bool isMeantAsScene(const std::string &file)
{
    return file == "-" || opening::isMeantAsScene(pathFromUtf8(file));
}

OpenedScene openScene(const std::string &file)
{
    if (!isMeantAsScene(file))
        return needed(opening::open(pathFromUtf8(file)));
    scene_file::SceneFile scene = readScene(file);
    return needed(opening::withModels(std::move(scene), file == "-" ? "" : pathFromUtf8(file), inputName(file)));
}

void checkReach(const OpenedScene &opened)
{
    if (const std::optional<base::Error> error = opening::unreachable(opened))
        refuse(error->message());
}

std::uint64_t pixelsOf(const Setup &setup)
{
    return static_cast<std::uint64_t>(setup.surface.widthPixels)
           * static_cast<std::uint64_t>(setup.surface.heightPixels);
}

Setup setupOf(const OpenedScene &opened, const std::string &size)
{
    return needed(opening::setupOf(opened, size.empty() ? std::nullopt : std::optional(surfaceGiven("--size", size))));
}

namespace {

bool isFile(const std::string &word)
{
    std::error_code ignored;
    return word == "-" || std::filesystem::exists(pathFromUtf8(word), ignored);
}

} // namespace

GivenTexts givenTexts(const std::vector<std::string> &words, const std::string &option)
{
    GivenTexts given;
    if (std::none_of(words.begin(), words.end(), isFile)) {
        std::string text;
        for (const std::string &word : words)
            text += word + ' ';
        return GivenTexts{{{option, text}}, {}, option};
    }
    for (const std::string &word : words) {
        if (!isFile(word))
            refuse(word + ": " + tr("there is no such file"));
        ByteSource source(word);
        std::string text = source.readAll(kMostCameraBytes);
        if (text.size() > kMostCameraBytes)
            refuse(tr("%1: longer than 256 MiB; give the file of one camera", source.name()));
        given.name += (given.name.empty() ? "" : ", ") + source.name();
        given.texts.push_back({source.name(), utf8FromFile(std::move(text))});
        given.files.push_back(word);
    }
    return given;
}

void refuseCamera(base::Error error, const GivenTexts &given)
{
    if (error.file.empty())
        error.file = given.name;
    refuse(error.message());
}

namespace {

/// The numbers between commas; nothing if something else is there.
std::optional<std::vector<double>> numbersIn(std::string_view list)
{
    std::vector<double> numbers;
    while (true) {
        const std::size_t comma = std::min(list.find(','), list.size());
        const std::optional<double> number = doubleFromWord(list.substr(0, comma));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        if (comma == list.size())
            return numbers;
        list.remove_prefix(comma + 1);
    }
}

/// The scene's K, with pixel centres at whole numbers.
std::optional<Intrinsics> pinholeOf(const Setup &setup)
{
    const Result<ApiCamera> camera = apiCamera(setup, Api::OpenCv);
    if (!camera || !camera->intrinsics)
        return std::nullopt;
    const glm::dmat3 &k = *camera->intrinsics;
    return Intrinsics{k[0][0], k[1][1], k[2][0], k[2][1], k[1][0], PixelCentres::AtIntegers};
}

std::string pinholeText(const Intrinsics &k)
{
    return "fx " + significantText(k.fx, 9) + ", fy " + significantText(k.fy, 9) + ", cx " + significantText(k.cx, 9)
           + ", cy " + significantText(k.cy, 9);
}

bool isSame(const Intrinsics &a, const Intrinsics &b)
{
    constexpr double kPixels = 1e-3;
    const double shift = cornerToCentre(b.centres) - cornerToCentre(a.centres);
    return std::abs(a.fx - b.fx) <= kPixels && std::abs(a.fy - b.fy) <= kPixels
           && std::abs(a.cx - b.cx - shift) <= kPixels && std::abs(a.cy - b.cy - shift) <= kPixels;
}

} // namespace

SceneLens sceneLens(const std::string &option, const Setup &setup, const std::string &scene)
{
    const std::optional<Intrinsics> pinhole = pinholeOf(setup);
    if (!pinhole)
        refuse(scene + ": " + tr("the projection is no perspective and has no K; --distortion needs one"));
    if (const auto numbers = numbersIn(option)) {
        const Result<Distortion, std::string> lens = distortionOf(*numbers);
        if (!lens)
            refuse("--distortion " + option + ": " + lens.error());
        return {*lens, *pinhole};
    }
    const GivenTexts given = givenTexts({option}, "--distortion");
    const auto read = given.files.empty() ? std::nullopt : readCamera(given.texts, {});
    if (!read)
        refuse("--distortion " + option + ": "
               + tr("this is neither a file of a camera nor a list k1,k2,p1,p2,k3 of numbers"));
    if (!*read)
        refuseCamera(read->error(), given);
    const ForeignCamera &camera = **read;
    if (!camera.distortion)
        refuse(given.name + ": " + tr("there are no distortion coefficients; leave --distortion out"));
    if (camera.intrinsics && !isSame(*camera.intrinsics, *pinhole))
        complain(given.name + ": "
                 + tr("its K (%1) differs from the scene's (%2), which counts: make the scene from this file, or check "
                      "which image the pixels belong to",
                      pinholeText(*camera.intrinsics), pinholeText(*pinhole)));
    return {*camera.distortion, *pinhole};
}

} // namespace unprojector::cli
