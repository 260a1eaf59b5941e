#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// A call in the text of a program, in C, C++, C#, JavaScript or Python.
struct CallText {
    std::string written;                ///< "glm::perspective", "camera.position.set"
    std::string object;                 ///< what stands before the last name: "glm", "camera.position", or nothing
    std::string name;                   ///< "perspective", "set"
    std::string variable;               ///< that the result is given to: "camera" of "const camera = new …"
    std::vector<std::string> arguments; ///< without comments
    std::size_t at = 0, end = 0;        ///< its bytes in the text
};

/// The text with blanks in the place of its comments: // and # up to the line's end, and /* … */.
std::string withoutComments(std::string_view text);

/// All calls, those inside of others too, in the order in which they begin.
/// @param text  without comments
std::vector<CallText> callTexts(std::string_view text);

/// A variable that gets a value: "camera.position.z = 5".
struct AssignmentText {
    std::string name, value;
    std::size_t at = 0, end = 0; ///< its bytes in the text
};
/// @param text  without comments
std::vector<AssignmentText> assignmentTexts(std::string_view text);

} // namespace unprojector::matrices
