#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What calls are made of in C, C++, C#, JavaScript and Python.
namespace unprojector::matrices::syntax {

/// Underscores are letters.
bool isLetter(char c);
bool isDigit(char c);
bool isBlank(char c);
std::size_t behindBlanks(std::string_view text, std::size_t at);
std::string_view trimmed(std::string_view text);
/// Behind the names that begin at a place, joined by points, arrows or double colons: "camera->position.set".
std::size_t behindNames(std::string_view text, std::size_t at);
/// Behind the angle brackets of a template, <float>, or `at` where there are none.
std::size_t behindTemplate(std::string_view text, std::size_t at);
/// The bracket that closes the one at a place, or npos.
std::size_t closing(std::string_view text, std::size_t at);
/// What commas outside of inner brackets separate; nothing of a blank text.
std::vector<std::string> separated(std::string_view text);
/// "set" of "camera.position.set".
std::string lastName(std::string_view names);

} // namespace unprojector::matrices::syntax
