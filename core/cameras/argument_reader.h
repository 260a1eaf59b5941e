#pragma once

#include "core/cameras/call_text.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// The number that an argument evaluates to.
struct ArgumentNumber {
    double value = 0.0;
    /// The source text of a division of whole numbers with a remainder; C, C++ and C# drop the
    /// remainder.
    std::string wholeQuotient{};
};

/// Evaluates arguments: numbers with or without a suffix, + - * / and parentheses, casts, pi under
/// its usual names. Converts between degrees and radians, and resolves variables to which the text
/// assigns exactly one value.
class ArgumentReader {
public:
    /// @param text  of the program, without comments
    explicit ArgumentReader(std::string_view text);

    /// The argument's value; nothing if it is not a number.
    std::optional<ArgumentNumber> number(std::string_view argument) const;
    /// A vector of three numbers: "glm::vec3(0, 0, 5)", "{0, 0, 5}", "Vector3.UnitY". Nothing for
    /// any other argument.
    std::optional<glm::dvec3> vector(std::string_view argument) const;

private:
    std::vector<AssignmentText> m_assignments;
};

} // namespace unprojector::cameras
