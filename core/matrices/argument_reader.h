#pragma once

#include "core/matrices/call_text.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// A number that an argument stands for.
struct ArgumentNumber {
    double value = 0.0;
    /// A quotient of whole numbers that leaves a rest, as written: C, C++ and C# drop it.
    std::string wholeQuotient{};
};

/// Reads arguments: numbers with or without a suffix, + - * / and parentheses, casts, pi under its usual names, conversions
/// between degrees and radians, and variables that the same text gives one value.
class ArgumentReader {
public:
    /// @param text  of the program, without comments
    explicit ArgumentReader(std::string_view text);

    /// Nothing where it is no number.
    std::optional<ArgumentNumber> number(std::string_view argument) const;
    /// Three numbers: "glm::vec3(0, 0, 5)", "{0, 0, 5}", "Vector3.UnitY". Nothing where it is no such.
    std::optional<glm::dvec3> vector(std::string_view argument) const;

private:
    std::vector<AssignmentText> m_assignments;
};

} // namespace unprojector::matrices
