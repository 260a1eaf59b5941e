#pragma once

#include "core/matrices/pasted_matrix.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// A number of a pasted text, and what its surroundings say of the matrix it belongs to.
struct PastedNumber {
    double value = 0.0;
    std::size_t at = 0;               ///< its first byte
    std::size_t line = 0;             ///< from 0
    std::size_t bracket = 0;          ///< which pair of brackets it stands in, counted as they open; 0: in none
    bool isBehindSemicolon = false;   ///< a semicolon stands between it and the number before it
    std::vector<int> subscripts{};    ///< m[3] = 1: {3}; m(0,1) = 1 and m01 = 1: {0, 1}
    std::vector<std::string> words{}; ///< between it and the number before, in small letters
    std::optional<PastedPart> part{}; ///< whose name was the last
    bool isInverse = false;           ///< that name is of the part's inverse
};

/// @return NotFinite's word, line and column
geometry::Result<std::vector<PastedNumber>, PasteError> pastedNumbers(std::string_view text);

} // namespace unprojector::matrices
