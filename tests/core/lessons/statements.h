#pragma once

#include "core/lessons/step_numbers.h"

#include <string>
#include <string_view>
#include <vector>

namespace lessontexts {

/// A number in a text.
struct StatedNumber {
    double value = 0.0;
    double tolerance = 0.0; ///< half a unit of its last decimal; for whole numbers and fractions (4/9) only rounding
    bool isOfSize = false;  ///< ±0.5: only the absolute value is given
};

/// A statement in braces: {(3, 4) = world.x, world.y}.
struct Statement {
    std::string shown;                 ///< "(3, 4)"
    std::vector<StatedNumber> numbers; ///< 3 and 4
    std::vector<std::string> sources;  ///< "world.x" and "world.y"
    bool isQuoted = false;             ///< "quoted": the numbers come from the source
};

/// A text with its statements.
struct StatedText {
    std::vector<Statement> statements;
    std::vector<std::string> faults; ///< descriptions of errors: mismatched braces, numbers outside of statements
};

/// Parses a text with statements. Numbers in names do not count: m[14], w9, glTranslate3f. Numbers
/// in tags do not count either, nor a formula's own number, "(9)", in a link to the formulas.
/// @param text  UTF-8 with a little HTML
StatedText statedText(std::string_view text);

/// The errors in the statements of a step, including its question's. Each names the step, the
/// stated and the computed number.
std::vector<std::string> faultsOf(const unprojector::lessons::LessonNumbers &numbers,
                                  const unprojector::lessons::Step &step);

} // namespace lessontexts
