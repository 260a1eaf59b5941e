#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::text {

/// A mistake in the syntax of a JSON text.
struct JsonMistake {
    std::size_t at = 0; ///< bytes before it
    std::string text;   ///< `"b" stands where "," or "}" is expected`, in the language that is set
};

/// What the JSON library's parser stops at. Its own sentence only tells which kind of mistake it is.
/// @param text       what the parser reads
/// @param position, lastToken, parserMessage  as the parser hands them to parse_error()
JsonMistake jsonMistake(std::string_view text, std::size_t position, std::string_view lastToken,
                        std::string_view parserMessage);

} // namespace unprojector::text
