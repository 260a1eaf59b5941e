#pragma once

#include "core/unproject/unprojector.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>

namespace unprojector::unproject {

/// Programs that turn a click into a point, as of their sources in 2026. The correct computation:
/// the depth of framebuffer row H - 1 - j, unprojected at (i + 1/2, H - j - 1/2).
enum class OtherProgram {
    Paper,        ///< Weng et al. 2008, (7) and (8) taken literally: (i, rect.bottom - j)
    Screen2World, ///< the tutorial's screen2world: flipped with the viewport's height, the depth of the row above
    MeshLab,      ///< vcglib, wrap/gl/picking.h: (i, H - j), the depth of the row above
    Polyscope,    ///< src/pick.cpp: the same position, the depth of the row above
    CloudCompare, ///< ccGLWindowInterface.cpp, getClick3DPos: (i, H - 1 - j)
    Open3D,       ///< FilamentCamera.cpp: (i, H - j)
    Vtk           ///< vtkViewport.cxx: the pixel's index is divided by the viewport's size minus one
};
inline constexpr std::array kOtherPrograms{OtherProgram::Paper,     OtherProgram::Screen2World, OtherProgram::MeshLab,
                                           OtherProgram::Polyscope, OtherProgram::CloudCompare, OtherProgram::Open3D,
                                           OtherProgram::Vtk};

/// The name of a program in the command and in files: "paper", "screen2world", "meshlab", …
std::string_view keyOf(OtherProgram program);
std::optional<OtherProgram> otherProgramOf(std::string_view key);

/// The position and depth that a program takes for a click on a pixel.
struct OtherClick {
    geometry::DevicePoint position; ///< the position that it unprojects: continuous device pixels, origin top-left
    geometry::DevicePixel
        depthFrom; ///< the pixel whose depth it reads; may lie outside the window, where OpenGL's result is undefined
};

OtherClick clickOf(OtherProgram program, const geometry::Setup &setup, const geometry::DevicePixel &pixel);

/// A program's answer to a click. It uses the inverted matrix in double, so that only the click
/// differs. Every program gets this setup, viewport included, even if it could not draw it.
struct OtherAnswer {
    OtherProgram program = OtherProgram::Paper;
    OtherClick click;
    /// Nothing if the depth that it reads is undefined or unknown.
    std::optional<geometry::WorldPoint> point;
};

using OtherAnswers = std::array<OtherAnswer, kOtherPrograms.size()>; ///< in the order of kOtherPrograms

/// Every program's answer to a click on a pixel.
/// @param depthAt  the contents of the depth buffer at a pixel, the far plane's depth on the
///         background; nothing outside the window, and if unknown
/// Source: the programs' sources as named above; the tutorial's and the paper's text.
OtherAnswers otherAnswers(const Unprojector &unprojector, const geometry::DevicePixel &pixel,
                          const std::function<std::optional<double>(const geometry::DevicePixel &)> &depthAt);

} // namespace unprojector::unproject
