#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::base {

/// What a reader or writer of a file changed or left out, in one line without a capital and a full
/// stop. It is worded when it is shown: JSON is English in every language.
struct Note {
    std::string_view one;                 ///< the text of tr(), marked
    std::vector<std::string> values = {}; ///< of the text's placeholders
    /// The text for another count than 1; empty: the note counts nothing.
    std::string_view many = {};
    std::size_t count = 0; ///< %1; the values begin at %2 then

    /// In the language of tr(). Control characters of the values are escaped.
    std::string text() const;
    friend bool operator==(const Note &, const Note &) = default;
};

/// Adds a note about `count` things, unless it is 0. A note with the same words and values counts
/// them too instead.
void addNote(std::vector<Note> &notes, std::size_t count, std::string_view one, std::string_view many,
             std::vector<std::string> values = {});

} // namespace unprojector::base
