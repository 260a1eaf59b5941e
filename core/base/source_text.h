#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The names, brackets, calls and assignments in the source text of a program in C, C++, C#,
/// JavaScript, Python or Rust. Their meaning is the reader's.
namespace unprojector::base {

std::size_t behindBlanks(std::string_view text, std::size_t at);
/// The names that begin at `at`, joined by dots, arrows or double colons: "camera->position.set".
std::string_view namesAt(std::string_view text, std::size_t at);
/// The end of the template's angle brackets, <float>, that begin at `at`; `at` itself if there are
/// none.
std::size_t behindTemplate(std::string_view text, std::size_t at);
/// The last name of a chain: "set" of "camera.position.set".
std::string_view lastName(std::string_view names);
/// The names before the last one: "camera.position" of "camera.position.set".
std::string_view namesBefore(std::string_view names);
/// The last name of a chain in lower case, without underscores: "DirectX::XM_PIDIV4" is "xmpidiv4".
std::string plainName(std::string_view names);
/// Returns whether a list, with blanks between its words, has a word.
bool isListed(std::string_view list, std::string_view word);

/// The position of the bracket that closes the one at `at`; npos if there is none, or brackets are
/// nested deeper than in real programs.
std::size_t closingBracket(std::string_view text, std::size_t at);
/// The parts between the commas outside inner brackets; empty for a blank text.
std::vector<std::string_view> commaSeparated(std::string_view text);

/// The text with its comments replaced by blanks: // and # up to the end of the line, and /* … */.
std::string withoutComments(std::string_view text);

/// A call; or an assignment, which has its value as the only argument: "camera.position.z = 5".
struct SourceCall {
    std::string_view written;    ///< "glm::perspective", "camera.position.set"
    std::string_view object{};   ///< the names before the last one: "glm", "camera.position", or nothing
    std::string_view name{};     ///< "perspective", "set"
    std::string_view variable{}; ///< that a call's result is assigned to: "camera" in "const camera = new …"
    std::vector<std::string_view> arguments{};
    std::size_t at = 0, end = 0; ///< its bytes in the text
    bool isAssignment = false;
};

/// All calls, nested ones included, and assignments, in the order in which they begin.
/// @param text  without comments; the result refers to it
std::vector<SourceCall> sourceCalls(std::string_view text);

} // namespace unprojector::base
