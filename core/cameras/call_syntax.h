#pragma once

#include "core/base/letters.h"
#include "core/base/text_scanner.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Lexical helpers for calls in C, C++, C#, JavaScript and Python.
namespace unprojector::cameras::syntax {

using base::isDigit;
using base::isLetter;
using base::trimmed;

std::size_t behindBlanks(std::string_view text, std::size_t at);
/// The end of the names that begin at `at`, joined by dots, arrows or double colons:
/// "camera->position.set".
std::size_t behindNames(std::string_view text, std::size_t at);
/// The end of the template's angle brackets, <float>, that begin at `at`; `at` itself if there are
/// none.
std::size_t behindTemplate(std::string_view text, std::size_t at);
/// The position of the bracket that closes the one at `at`, or npos.
std::size_t closing(std::string_view text, std::size_t at);
/// The parts between the commas outside inner brackets; empty for a blank text.
std::vector<std::string> separated(std::string_view text);
/// The last name of a chain: "set" of "camera.position.set".
std::string lastName(std::string_view names);
/// The name in lower case, without underscores: "XM_PIDIV4" is "xmpidiv4".
std::string plain(std::string_view name);

} // namespace unprojector::cameras::syntax
