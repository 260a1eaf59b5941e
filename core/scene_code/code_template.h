#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace unprojector::scene_code {

struct Values;
/// The values of a repeated part, made one by one: a scene may have 100,000 objects.
struct Rows {
    std::size_t count = 0;
    std::function<Values(std::size_t index)> at;
};
/// The values of a template's names.
struct Values : std::map<std::string, std::variant<std::string, bool, Rows>, std::less<>> {
    using map::map;
};

/// A mistake of the program: the first tag of a template that cannot be filled. It has an unknown name, or no
/// end, or ends nothing.
struct TemplateError {
    std::size_t line; ///< from 1
    std::string tag;
};

/// Fills a template. Its tags are:
///
///   <<name>>                                             a text
///   <<if a>> … <<else if not b>> … <<else>> … <<end>>    the first part whose name holds: true, a text, rows
///   <<for rows>> … <<between>> … <<end>>                 the first part for each row, where the row's names come
///                                                        before those outside; the second between two rows
///
/// A line with an if, else, for, between or end alone leaves no line behind. Texts are not read for
/// tags; the template has no other <<. Throws a TemplateError.
std::string filled(std::string_view source, const Values &values);

} // namespace unprojector::scene_code
