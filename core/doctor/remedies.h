#pragma once

#include "core/doctor/diagnosis.h"

#include <span>
#include <string>
#include <string_view>

namespace unprojector::doctor {

/// A line of code with the mistake, and the corrected line.
struct CodeChange {
    std::string_view library; ///< GLU, GLM, Qt, three.js, NumPy
    std::string_view wrong, right;
};

/// The description and the remedy of a mistake. In the code x, y are the pixel in device pixels
/// from the top-left corner; i, j its integer column and row; W, H the framebuffer's size; d the
/// depth; (vx, vy, w, h) the viewport.
struct Remedy {
    std::string_view id;
    const char *name;     ///< short name of the mistake, marked for base::tr
    const char *sentence; ///< the program's behaviour, with a full stop; marked too
    std::span<const CodeChange> code;
};

/// @param id  one of mistakeIds()
const Remedy &remedyOf(std::string_view id);

/// The code changes of a mistake with these values. They can differ from its Remedy's: a scale
/// about the eye has other lines than one about the origin.
/// @param id  one of mistakeIds()
std::span<const CodeChange> codeOf(std::string_view id, std::span<const SolvedValue> values);

/// A line of code with values. The name of a value in a line is "other" and its own name: 50 for
/// otherFar, 60 for otherFovy. Without its value, otherRatio becomes ratio.
std::string lineWithValues(std::string_view line, std::span<const SolvedValue> values);

} // namespace unprojector::doctor
