#pragma once

#include "core/cameras/pasted_matrix.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// A number of a pasted text with its context, which tells the matrix it belongs to.
struct PastedNumber {
    double value = 0.0;
    std::size_t at = 0;               ///< its first byte
    std::size_t line = 0;             ///< from 0
    std::size_t bracket = 0;          ///< the number of its innermost bracket pair, counted as they open; 0: none
    bool isBehindSemicolon = false;   ///< a semicolon stands between it and the number before it
    std::vector<int> subscripts{};    ///< m[3] = 1: {3}; m(0,1) = 1 and m01 = 1: {0, 1}
    std::vector<std::string> words{}; ///< between it and the previous number, in lower case
    std::optional<PastedPart> part{}; ///< the part whose name occurred last
    bool isInverse = false;           ///< that name is of the part's inverse
};

struct PastedNumbers {
    std::vector<PastedNumber> numbers;
    std::vector<std::string> aside; ///< names whose numbers belong to no matrix: "near", "Mouse"
};

/// The numbers of matrices and viewports. A width and a height are the viewport 0 0 width height,
/// if the text names no other.
/// @return the line and column of a number that is not finite
geometry::Result<PastedNumbers, PasteError> pastedNumbers(std::string_view text);

} // namespace unprojector::cameras
