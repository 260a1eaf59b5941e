#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unprojector::lessons {

/// A number as a text says it.
struct StatedNumber {
    double value = 0.0;
    double tolerance = 0.0; ///< half of its last decimal; of whole numbers and fractions such as 4/9 but a rounding
    bool isOfSize = false;  ///< ±0.5: only the size is said
};

/// What stands in braces: {(3, 4) = world.x, world.y}.
struct Statement {
    std::string shown;                 ///< "(3, 4)"
    std::vector<StatedNumber> numbers; ///< 3 and 4
    std::vector<std::string> sources;  ///< "world.x" and "world.y"
    bool isQuoted = false;             ///< "quoted": the numbers are those of the source
};

/// A text with its statements.
struct StatedText {
    std::string shown; ///< without braces and sources
    std::vector<Statement> statements;
    std::vector<std::string> faults; ///< in words: braces that do not fit, numbers outside of statements
};

/// Takes a text apart. Numbers that belong to a name are none: m[14], w9, glTranslate3f; nor are those in tags, and a formula's
/// own, "(9)", in the words of a link to the formulas.
/// @param text  UTF-8 with a little HTML
StatedText statedText(std::string_view text);

} // namespace unprojector::lessons
