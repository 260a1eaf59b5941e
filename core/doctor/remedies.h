#pragma once

#include <span>
#include <string_view>

namespace unprojector::doctor {

/// A line of code as it stands where the mistake is made, and as it should.
struct CodeChange {
    std::string_view library; ///< GLU, GLM, Qt, three.js, NumPy
    std::string_view wrong, right;
};

/// What to say of a mistake and to do about it. In the code x, y are the pixel in device pixels from the top-left corner, i, j
/// its whole column and row, W, H the framebuffer's size, d the depth, (vx, vy, w, h) the viewport.
struct Remedy {
    std::string_view id;
    const char *name;     ///< of the mistake, in a few words, marked for text::tr
    const char *sentence; ///< what the program does, with its full stop; marked too
    std::span<const CodeChange> code;
};

/// @param id  one of mistakeIds()
const Remedy &remedyOf(std::string_view id);

} // namespace unprojector::doctor
