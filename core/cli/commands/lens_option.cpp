#include "core/cli/commands/lens_option.h"

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/camera_texts.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/error_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace unprojector::cli {
using namespace cameras;
using namespace geometry;
using namespace base;
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

std::optional<SceneLens> sceneLens(const std::string &option, const Setup &setup, const std::string &scene)
{
    const std::optional<Intrinsics> pinhole = pinholeOf(setup);
    if (!pinhole) {
        complain(scene + ": " + tr("the projection is no perspective and has no K; --distortion needs one"));
        return std::nullopt;
    }
    if (const auto numbers = numbersIn(option)) {
        const Result<Distortion, std::string> lens = distortionOf(*numbers);
        if (lens)
            return SceneLens{*lens, *pinhole};
        complain("--distortion " + option + ": " + lens.error());
        return std::nullopt;
    }
    const std::optional<GivenTexts> given = givenTexts({option}, "--distortion");
    if (!given)
        return std::nullopt;
    const auto read = given->files.empty() ? std::nullopt : readCamera(given->texts, {});
    if (!read) {
        complain("--distortion " + option + ": "
                 + tr("this is neither a file of a camera nor a list k1,k2,p1,p2,k3 of numbers"));
        return std::nullopt;
    }
    if (!*read) {
        complain(cameraErrorText(read->error(), given->name));
        return std::nullopt;
    }
    const ForeignCamera &camera = **read;
    if (!camera.distortion) {
        complain(given->name + ": " + tr("there are no distortion coefficients; leave --distortion out"));
        return std::nullopt;
    }
    if (camera.intrinsics && !isSame(*camera.intrinsics, *pinhole))
        complain(given->name + ": "
                 + tr("its K (%1) differs from the scene's (%2), which counts: make the scene from this file, or check "
                      "which image the pixels belong to",
                      pinholeText(*camera.intrinsics), pinholeText(*pinhole)));
    return SceneLens{*camera.distortion, *pinhole};
}

} // namespace unprojector::cli
