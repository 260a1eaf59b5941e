#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Programs with typical mistakes in clicking into a 3-D view. They share no code with core, whose
/// doctor is tested on their output.
namespace wrong_programs {

/// The arguments of gluPerspective with the viewport's own aspect, or of glOrtho with the given
/// height and the width that the viewport needs.
struct Lens {
    bool isPerspective = true;
    double fovyRadians = 0.0;
    double height = 0.0; ///< of the box, world units
    double aspect = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
};

struct Scene {
    glm::dvec3 eye{0.0}, target{0.0}, up{0.0, 1.0, 0.0};
    Lens lens;
    glm::dvec4 viewport{0.0}; ///< x, y, width, height in device pixels, origin bottom-left
    double framebufferWidth = 0.0, framebufferHeight = 0.0;
    double pixelRatio = 1.0; ///< device pixels per logical pixel
    glm::dmat4 worldFromObject{1.0};
};

/// Device pixels from the top-left corner, continuous; depth in [0, 1].
struct Click {
    double px = 0.0, py = 0.0, depth = 0.0;
};

/// The click that shows a point.
Click clickOn(const Scene &scene, const glm::dvec3 &world);

struct Mistake {
    std::string_view id;
    int variants; ///< number of ways to make it
};

const std::vector<Mistake> &mistakes();

/// A mistake in a program, in one of its variants, counted from 0.
struct Made {
    std::string_view id;
    int variant = 0;
};
/// The answer of a program with these mistakes to the click; without mistakes, the right point.
/// @return nothing if it prints no numbers (inf, NaN), or if the mistake cannot be made in this
///         scene
std::optional<glm::dvec3> printed(const Scene &scene, const Click &click, const std::vector<Made> &made);

} // namespace wrong_programs
