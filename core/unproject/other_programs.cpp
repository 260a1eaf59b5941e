#include "core/unproject/other_programs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace unprojector::unproject {
using namespace geometry;

std::string_view keyOf(OtherProgram program)
{
    constexpr std::string_view kKeys[] = {"paper",        "screen2world", "meshlab", "polyscope",
                                          "cloudcompare", "open3d",       "vtk"};
    static_assert(std::size(kKeys) == kOtherPrograms.size());
    static_assert(kOtherPrograms.size() == static_cast<std::size_t>(OtherProgram::Vtk) + 1);
    return kKeys[static_cast<std::size_t>(program)];
}

std::optional<OtherProgram> otherProgramOf(std::string_view key)
{
    const auto found = std::find_if(kOtherPrograms.begin(), kOtherPrograms.end(),
                                    [key](OtherProgram program) { return keyOf(program) == key; });
    return found != kOtherPrograms.end() ? std::optional(*found) : std::nullopt;
}

OtherClick clickOf(OtherProgram program, const Setup &setup, const DevicePixel &pixel)
{
    const DevicePoint topLeft(pixel.i, pixel.j);
    const DevicePixel above{pixel.i, pixel.j - 1};
    switch (program) {
    case OtherProgram::Paper:
    case OtherProgram::Open3D: break;
    case OtherProgram::MeshLab:
    case OtherProgram::Polyscope: return {topLeft, above};
    case OtherProgram::CloudCompare: return {DevicePoint(topLeft.x, topLeft.y + 1.0), pixel};
    case OtherProgram::Screen2World: {
        // y_w = h - j with the viewport's height, and the depth of the pixel whose lower edge is
        // there.
        const double yInWindow = setup.viewport.height - pixel.j;
        const DevicePoint position = deviceFromWindow(setup.surface, WindowPoint(pixel.i, yInWindow, 0.0));
        const int row = static_cast<int>(std::floor(yInWindow));
        return {position, {pixel.i, framebufferRow(setup.surface, {pixel.i, row})}}; // the flip is its own inverse
    }
    case OtherProgram::Vtk: {
        // A viewport of one pixel would divide by 0; its pixel stays unchanged.
        const Viewport &v = setup.viewport;
        const auto stretched = [](double edge, double start, double size) {
            return size > 1.0 ? start + (edge - start) * size / (size - 1.0) : edge;
        };
        const WindowPoint lowerLeft = windowFromDevice(setup.surface, DevicePoint(topLeft.x, topLeft.y + 1.0), 0.0);
        return {deviceFromWindow(setup.surface, WindowPoint(stretched(lowerLeft.x, v.x, v.width),
                                                            stretched(lowerLeft.y, v.y, v.height), 0.0)),
                pixel};
    }
    }
    return {topLeft, pixel};
}

OtherAnswers otherAnswers(const Unprojector &unprojector, const DevicePixel &pixel,
                          const std::function<std::optional<double>(const DevicePixel &)> &depthAt)
{
    const Setup &setup = unprojector.setup();
    OtherAnswers answers;
    for (std::size_t k = 0; k < answers.size(); ++k) {
        OtherAnswer &answer = answers[k];
        answer.program = kOtherPrograms[k];
        answer.click = clickOf(answer.program, setup, pixel);
        const std::optional<double> depth = depthAt(answer.click.depthFrom);
        if (!depth)
            continue;
        const WindowPoint window = windowFromDevice(setup.surface, answer.click.position, *depth);
        if (const Result<WorldPoint> point = unprojector.worldAt(Method::Matrix, window))
            answer.point = *point;
    }
    return answers;
}

} // namespace unprojector::unproject
