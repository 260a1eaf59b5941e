#include "core/base/note.h"

#include "core/base/printable.h"
#include "core/base/translation.h"

#include <algorithm>
#include <utility>

namespace unprojector::base {

std::string Note::text() const
{
    std::vector<std::string> filling;
    if (!many.empty())
        filling.push_back(std::to_string(count));
    for (const std::string &value : values)
        filling.push_back(printableLine(value));
    return filled(translated(many.empty() || count == 1 ? one : many), filling);
}

void addNote(std::vector<Note> &notes, std::size_t count, std::string_view one, std::string_view many,
             std::vector<std::string> values)
{
    if (count == 0)
        return;
    const auto known = std::find_if(notes.begin(), notes.end(),
                                    [&](const Note &note) { return note.one == one && note.values == values; });
    if (known != notes.end())
        known->count += count;
    else
        notes.push_back({one, std::move(values), many, count});
}

} // namespace unprojector::base
