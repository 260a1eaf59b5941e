#include "core/scene_code/code_text.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <vector>

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;
using namespace base;

std::string literal(double value, NumberStyle style)
{
    std::string digits = shortestText(value);
    if (style == NumberStyle::JavaScript)
        return digits;
    if (digits.find_first_of(".e") == std::string::npos)
        digits += ".0";
    return style == NumberStyle::Float ? digits + 'f' : digits;
}

std::string beyondFloat(const std::string &code)
{
    constexpr const char *kOfNumbers = "0123456789.e+-";
    std::vector<std::string> tooLarge, tooSmall;
    for (std::size_t at = 0; (at = code.find_first_of("0123456789", at)) != code.npos;) {
        const std::size_t end = std::min(code.find_first_not_of(kOfNumbers, at), code.size());
        const std::string digits = code.substr(at, end - at);
        at = end;
        double value = 0.0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (end == code.size() || code[end] != 'f' || read.ptr != digits.data() + digits.size())
            continue;
        auto *kept = value > double(std::numeric_limits<float>::max())                                 ? &tooLarge
                     : value != 0.0 && value <= 0.5 * double(std::numeric_limits<float>::denorm_min()) ? &tooSmall
                                                                                                       : nullptr;
        if (kept && std::find(kept->begin(), kept->end(), digits) == kept->end())
            kept->push_back(digits);
    }
    const auto said = [](const std::vector<std::string> &numbers, const std::string &become) {
        std::string text;
        for (const std::string &number : numbers)
            text += (text.empty() ? "" : ", ") + number;
        return numbers.empty() ? text : " No float holds " + text + ": here that is " + become + '.';
    };
    const std::string text = said(tooLarge, "infinite") + said(tooSmall, "0");
    return text.empty() ? text : text + " What is computed with it is wrong.";
}

std::string list(std::initializer_list<double> values, NumberStyle style)
{
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : ", ") + literal(value, style);
    return text;
}

std::string list(const glm::dvec3 &v, NumberStyle style)
{
    return list({v.x, v.y, v.z}, style);
}

std::string list(const ProjectionWindow &w, NumberStyle style)
{
    return list({w.left, w.right, w.bottom, w.top, w.nearDistance, w.farDistance}, style);
}

std::string list(const glm::dmat4 &matrix, MatrixOrder order, NumberStyle style, const std::string &indent)
{
    const glm::dmat4 lines = order == MatrixOrder::ByColumns ? matrix : glm::transpose(matrix);
    std::string text;
    for (int line = 0; line < 4; ++line)
        text += (line == 0 ? "" : ",\n" + indent)
                + list({lines[line].x, lines[line].y, lines[line].z, lines[line].w}, style);
    return text;
}

std::string windowText(const Surface &surface)
{
    return std::to_string(surface.widthPixels) + " x " + std::to_string(surface.heightPixels) + " device pixels";
}

std::string headerComment(const SceneFile &scene, const std::string &what, const std::string &mark)
{
    const Setup setup = setupOf(scene);
    const Surface &surface = setup.surface;
    std::string text = mark + ' ' + what + ". Written by Unprojector.\n" + mark + '\n';
    text += mark + " Its window has " + windowText(surface);
    if (surface.devicePixelRatio != 1.0)
        text += ", " + shortestText(surface.devicePixelRatio) + " to a logical one: positions of the mouse times that";
    text += ".\n";
    if (isWholeWindow(setup) && !hasViewportsAspect(setup))
        text +=
            mark + " In a window of another shape, the projection's width has to follow, or circles become ellipses.\n";
    if (!scene.objects.empty())
        text += mark + " Models are not in it, only their files' names.\n";
    return text;
}

} // namespace unprojector::scene_code
