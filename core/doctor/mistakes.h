#pragma once

#include "core/doctor/diagnosis.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

/// A line of code with the mistake, and the corrected line. In the code x, y are the pixel in
/// device pixels from the top-left corner; i, j its integer column and row; W, H the framebuffer's
/// size; d the depth; (vx, vy, w, h) the viewport; K, R, t, dist are OpenCV's, and C is the
/// camera's position.
struct CodeChange {
    std::string library; ///< GLU, GLM, Qt, three.js, NumPy
    std::string wrong, right;
    bool operator==(const CodeChange &) const = default;
};

/// A record of resources/doctor/mistakes.json.
struct Mistake {
    std::string id;
    std::string name, sentence; ///< keys of base::tr(): a short name, and the program's behaviour with a full stop
    int reports = 0;            ///< public threads found about this kind; ranks equal candidates
    bool isOnlySolved = false;  ///< it has free values only, see addSolvedMistakes
    std::vector<CodeChange> code;
    /// Other code, for a mistake that has a value of one of these names, or one of these words: a
    /// scale about the eye has other lines than one about the origin.
    std::vector<std::string> with{};
    std::vector<CodeChange> codeWith{};
};

/// All known mistakes, in the order of the stages from a click to a point. The id of two mistakes
/// follows this order.
const std::vector<Mistake> &mistakes();

/// @param id  of one of mistakes()
const Mistake &mistakeOf(std::string_view id);

/// The code changes of a mistake with these values. The name of a value in a line of mistakes() is
/// "other" and its own name: 50 for otherFar, 60 for otherFovy. Without its value, otherRatio
/// becomes ratio.
/// @param id  of one of mistakes()
std::vector<CodeChange> codeOf(std::string_view id, std::span<const SolvedValue> values);

} // namespace unprojector::doctor
