#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::base {

/// A mistake in the syntax of a JSON text.
struct JsonMistake {
    std::size_t at = 0; ///< bytes before it
    std::string text;   ///< `"b" stands where "," or "}" is expected`, in the current language
};

/// Describes the position at which the JSON library's parser stops. The parser's own message only
/// names the kind of mistake.
/// @param text       the text being parsed
/// @param position, lastToken, parserMessage  as the parser passes them to parse_error()
JsonMistake jsonMistake(std::string_view text, std::size_t position, std::string_view lastToken,
                        std::string_view parserMessage);

} // namespace unprojector::base
