#pragma once

#include "core/unproject/unprojector.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>

namespace unprojector::unproject {

/// Programs that turn a click into a point, as their sources stood in 2026. Beside them stands what is right: the depth of
/// framebuffer row H - 1 - j, unprojected at (i + 1/2, H - j - 1/2).
enum class OtherProgram {
    Paper,        ///< Weng et al. 2008, (7) and (8) taken literally: (i, rect.bottom - j)
    Screen2World, ///< the tutorial's screen2world: flipped with the viewport's height, the depth of the row above
    MeshLab,      ///< vcglib, wrap/gl/picking.h: (i, H - j), the depth of the row above
    Polyscope,    ///< src/pick.cpp: the same place, the depth of the row above
    CloudCompare, ///< ccGLWindowInterface.cpp, getClick3DPos: (i, H - 1 - j)
    Open3D,       ///< FilamentCamera.cpp: (i, H - j)
    Vtk           ///< vtkViewport.cxx: a pixel's number is divided by the viewport's size less one
};
inline constexpr std::array kOtherPrograms{OtherProgram::Paper,     OtherProgram::Screen2World, OtherProgram::MeshLab,
                                           OtherProgram::Polyscope, OtherProgram::CloudCompare, OtherProgram::Open3D,
                                           OtherProgram::Vtk};

/// The name that the command and files call a program by: "paper", "screen2world", "meshlab", …
std::string_view keyOf(OtherProgram program);
std::optional<OtherProgram> otherProgramOf(std::string_view key);

/// What a program makes of a click on a pixel, before it unprojects.
struct OtherClick {
    geometry::DevicePoint position; ///< what it unprojects: continuous device pixels, origin top-left
    geometry::DevicePixel
        depthFrom; ///< whose depth it reads; may lie outside the window, where OpenGL leaves it undefined
};

OtherClick clickOf(OtherProgram program, const geometry::Setup &setup, const geometry::DevicePixel &pixel);

/// What a program answers to a click: the inverted matrix in double, so that nothing but the click differs. All of them are
/// asked with this picture, viewport included, whatever else they could not draw of it.
struct OtherAnswer {
    OtherProgram program = OtherProgram::Paper;
    OtherClick click;
    /// Nothing where the depth that it reads is undefined or not known.
    std::optional<geometry::WorldPoint> point;
};

using OtherAnswers = std::array<OtherAnswer, kOtherPrograms.size()>; ///< in the order of kOtherPrograms

/// Every program's answer to a click on a pixel.
/// @param depthAt  what the depth buffer holds at a pixel, on the background the far plane's; nothing outside the window, and
///                 where it is not known
/// Source: the programs' sources as named above; the tutorial's and the paper's text.
OtherAnswers otherAnswers(const Unprojector &unprojector, const geometry::DevicePixel &pixel,
                          const std::function<std::optional<double>(const geometry::DevicePixel &)> &depthAt);

} // namespace unprojector::unproject
