#include "unprojector/cameras.h"

#include "core/base/letters.h"
#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"
#include "core/cameras/foreign_camera.h"
#include "core/cameras/lens.h"
#include "core/library/internal.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <utility>

namespace unprojector {
namespace {

/// A sentence with the names of the choices instead of the command's options: pixel_centers of --pixel-centers.
std::string withChoices(const std::string &sentence)
{
    std::string text;
    for (std::size_t at = 0; at < sentence.size();) {
        if (sentence.compare(at, 2, "--") != 0) {
            text += sentence[at++];
            continue;
        }
        constexpr std::string_view kValue = "--image NAME"; // "image reads another"
        if (sentence.compare(at, kValue.size(), kValue) == 0) {
            text += "image";
            at += kValue.size();
            continue;
        }
        for (at += 2; at < sentence.size() && (sentence[at] == '-' || base::isLetter(sentence[at])); ++at)
            text += sentence[at] == '-' ? '_' : sentence[at];
    }
    return text;
}

std::string nameOf(const std::vector<CameraText> &texts)
{
    std::string names;
    for (const CameraText &text : texts)
        names += (names.empty() ? "" : ", ") + text.name;
    return names;
}

/// The value of a word, or the error that lists the words.
template <class Value, std::size_t Count>
Result<std::optional<Value>> valueOf(const char *choice, const std::string &word,
                                     const std::array<Value, Count> &values)
{
    if (word.empty())
        return std::optional<Value>();
    std::string known;
    for (const Value value : values) {
        if (word == cameras::keyOf(value))
            return std::optional(value);
        known += (known.empty() ? "" : ", ") + std::string(cameras::keyOf(value));
    }
    return valueError(base::tr("there are no %1 \"%2\"; known: %3", choice, word, known));
}

Result<cameras::CameraChoices> internalChoices(const CameraChoices &choices)
{
    cameras::CameraChoices result;
    result.image = choices.image;
    if (choices.width != 0 || choices.height != 0) {
        if (choices.width < 1 || choices.height < 1)
            return valueError(base::tr("the image has %1x%2 pixels; width and height must be at least 1 pixel",
                                       choices.width, choices.height));
        result.size = cameras::ImageSize{choices.width, choices.height};
    }
    result.nearDistance = choices.nearDistance;
    result.farDistance = choices.farDistance;
    result.isUndistorted = choices.isUndistorted;
    const auto axes = valueOf("axes", choices.axes, cameras::kEyeAxes);
    if (!axes)
        return axes.error();
    constexpr std::array kDirections{cameras::PoseDirection::WorldToCamera, cameras::PoseDirection::CameraToWorld};
    const auto direction = valueOf("pose directions", choices.pose, kDirections);
    if (!direction)
        return direction.error();
    result.axes = *axes;
    result.direction = *direction;
    constexpr std::array kCentres{cameras::PixelCentres::AtIntegers, cameras::PixelCentres::AtHalves};
    const auto centres = valueOf("pixel centers", choices.pixelCenters, kCentres);
    if (!centres)
        return centres.error();
    result.centres = *centres;
    return result;
}

} // namespace

Result<CameraRead> readCamera(const std::vector<CameraText> &texts, const CameraChoices &choices)
{
    const Result<cameras::CameraChoices> internal = internalChoices(choices);
    if (!internal)
        return internal.error();
    std::vector<cameras::NamedText> named;
    named.reserve(texts.size());
    for (const CameraText &text : texts)
        named.push_back({text.name, base::utf8FromFile(text.text)});
    const std::string name = nameOf(texts);
    const auto errorOf = [&name](base::Error error) {
        if (error.file.empty())
            error.file = name;
        error.text = withChoices(error.text);
        return valueError(error.message());
    };
    const auto read = cameras::readCamera(named, *internal);
    if (!read)
        return valueError(name + ": " + base::tr("has no camera in the form of a known program"));
    if (!*read)
        return errorOf(read->error());
    const cameras::ForeignCamera &camera = **read;
    const auto converted = cameras::sceneCamera(camera, *internal, std::nullopt);
    if (!converted)
        return errorOf(converted.error());
    if (converted->distortion)
        return valueError(name + ": "
                          + base::tr("the lens distorts the image (%1), and a setup has no lens; if the pixels are "
                                     "those of the undistorted image, say so (undistorted)",
                                     cameras::coefficientsText(*converted->distortion)));
    geometry::Setup setup;
    setup.surface = {converted->size.width, converted->size.height, 1.0};
    setup.viewport = geometry::wholeSurface(setup.surface);
    setup.lens = converted->projection;
    setup.pose = converted->eyeFromWorld;
    std::vector<std::string> assumed;
    std::ranges::transform(converted->assumed, std::back_inserter(assumed), withChoices);
    const Result<Setup> made = SetupAccess::make(setup, assumed);
    if (!made)
        return valueError(name + ": " + made.error().message);
    return CameraRead{*made, camera.program, camera.images, assumed};
}

Result<CameraRead> readCamera(const std::vector<std::filesystem::path> &files, const CameraChoices &choices)
{
    std::vector<CameraText> texts;
    for (const std::filesystem::path &file : files) {
        const std::string name = base::utf8FromPath(file);
        std::error_code code;
        if (!std::filesystem::exists(file, code))
            return Error{Error::Kind::MissingFile, name + ": " + base::tr("there is no such file")};
        if (std::filesystem::is_directory(file, code))
            return Error{Error::Kind::File, name + ": " + base::tr("this is a folder; give the name of a file")};
        const std::uintmax_t bytes = std::filesystem::file_size(file, code);
        if (!code && bytes > cameras::kMostCameraBytes)
            return valueError(name + ": " + base::tr("longer than 256 MiB; give the file of one camera"));
        std::ifstream stream(file, std::ios::binary);
        std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        if (code || !stream)
            return Error{Error::Kind::File, name + ": " + base::tr("cannot be read")};
        texts.push_back({name, base::utf8FromFile(std::move(text))});
    }
    return readCamera(texts, choices);
}

} // namespace unprojector
