#include "core/mesh/import/file_contents.h"

#include "core/base/translation.h"

#include <algorithm>

namespace unprojector::mesh::reader {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view firstWord(std::string_view text)
{
    return text.substr(0, text.find_first_of(kBlanks));
}

/// The suffix of the format that the first bytes look like; empty if unknown.
std::string_view suffixByContents(std::string_view start)
{
    if (start.starts_with("glTF"))
        return "glb";
    start.remove_prefix(start.starts_with("\xef\xbb\xbf") ? 3 : 0);
    start.remove_prefix(std::min(start.size(), start.find_first_not_of(kBlanks)));
    const std::string_view word = firstWord(start);
    if (word == "ply")
        return "ply";
    if (word.ends_with("OFF") && word.size() <= 7)
        return "off";
    if (word == "solid" && start.find("facet") != start.npos)
        return "stl";
    if (start.starts_with('{') && start.find("\"asset\"") != start.npos)
        return "gltf";
    if ((word == "v" || word.starts_with('#')) && (word == "v" || start.find("\nv ") != start.npos))
        return "obj";
    return {};
}

} // namespace

std::string adviceByContents(std::string_view start, std::string_view suffix)
{
    if (start.starts_with("\x1f\x8b") || start.starts_with("PK\x03\x04") || start.starts_with("7z\xbc\xaf"))
        return base::tr("its contents are compressed: unpack it first");
    const std::string_view known = suffixByContents(start);
    if (known.empty() || known == suffix)
        return {};
    return base::tr("its contents look like %1: give it the suffix .%1", known);
}

} // namespace unprojector::mesh::reader
