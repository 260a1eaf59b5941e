#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// A call in the source text of a program in C, C++, C#, JavaScript or Python.
struct CallText {
    std::string written;                ///< "glm::perspective", "camera.position.set"
    std::string object;                 ///< the names before the last one: "glm", "camera.position", or nothing
    std::string name;                   ///< "perspective", "set"
    std::string variable;               ///< the variable that receives the result: "camera" in "const camera = new …"
    std::vector<std::string> arguments; ///< without comments
    std::size_t at = 0, end = 0;        ///< its bytes in the text
};

/// The text with its comments replaced by blanks: // and # up to the end of the line, and /* … */.
std::string withoutComments(std::string_view text);

/// All calls, nested ones included, in the order in which they begin.
/// @param text  without comments
std::vector<CallText> callTexts(std::string_view text);

/// An assignment to a variable: "camera.position.z = 5".
struct AssignmentText {
    std::string name, value;
    std::size_t at = 0, end = 0; ///< its bytes in the text
};
/// @param text  without comments
std::vector<AssignmentText> assignmentTexts(std::string_view text);

} // namespace unprojector::cameras
