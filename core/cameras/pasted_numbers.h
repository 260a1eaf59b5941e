#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/cameras/scan.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// A number of a pasted text with its context, which tells the matrix it belongs to.
struct PastedNumber : ScannedNumber {
    std::vector<std::string> words{}; ///< names between it and the previous number, in lower case
    std::optional<PastedPart> part{}; ///< the part whose name occurred last
    std::string partName{};           ///< that name
    bool isInverse = false;           ///< it is of the part's inverse
};

struct PastedNumbers {
    std::vector<PastedNumber> numbers;
    std::vector<std::string> aside; ///< names whose numbers belong to no matrix: "near", "Mouse"
};

/// The numbers of matrices and viewports. A width and a height are the viewport 0 0 width height,
/// if the text names no other.
/// @return the line and column of a number that is not finite, or of one name too many
geometry::Result<PastedNumbers, PasteError> pastedNumbers(std::string_view text);

} // namespace unprojector::cameras
