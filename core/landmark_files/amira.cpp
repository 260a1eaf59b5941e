// .landmarkAscii of Amira and Avizo: "# Avizo 3D ASCII 2.0", declarations, then sections of
// numbers, "@1" and so on.

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <algorithm>
#include <map>

namespace unprojector::landmark_files {
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

/// A declaration: "Markers { float[3] Coordinates } @1".
struct Declaration {
    std::string type, name, section;
};

std::optional<Declaration> declarationOf(std::string_view line)
{
    std::string spaced;
    for (const char c : line)
        spaced += c == '{' || c == '}' ? std::string{' ', c, ' '} : std::string{c == '=' ? ' ' : c}; // older: "} = @1"
    const std::vector<std::string_view> words = wordsOf(spaced);
    if (words.size() != 6 || words[0] != "Markers" || words[1] != "{" || words[4] != "}" || !words[5].starts_with('@'))
        return std::nullopt;
    return Declaration{std::string(words[2]), std::string(words[3]), std::string(words[5])};
}

} // namespace

ReadLandmarks readAmira(std::string_view text)
{
    const std::string_view line = trimmed(text.substr(0, text.find_first_of("\r\n")));
    const std::string first = lowerCase(line);
    // HyperMesh is the oldest name of the format.
    const bool isAmira = first.starts_with('#')
                         && (first.find("amira") != first.npos || first.find("avizo") != first.npos
                             || first.find("hypermesh") != first.npos);
    if (!isAmira)
        fail(1, tr("the first line is %1; Amira and Avizo begin the file with \"# Avizo 3D ASCII 2.0\"",
                   base::quoted(line)));
    if (first.find("ascii") == first.npos)
        fail(1, tr("this file is binary; save it as \"LandmarkSet Ascii\" in Amira or Avizo"));
    Lines lines(text);
    ReadLandmarks read;
    Notes notes;
    std::optional<std::uint32_t> count;
    std::map<std::string, std::string, std::less<>> sections; ///< coordinates that are not read yet, by section
    bool isOther = false;                                     ///< the numbers belong to a section without coordinates
    while (lines.next()) {
        const std::vector<std::string_view> words = wordsOf(lines.text());
        if (words.size() >= 3 && words[0] == "define" && words[1] == "Markers") {
            count = countOf(words[2], lines.number(), marked("the number of points"));
        } else if (const auto declaration = declarationOf(lines.text())) {
            const bool isPosition = declaration->type == "float[3]" || declaration->type == "double[3]";
            if (isPosition && declaration->name.starts_with("Coordinates"))
                sections.emplace(declaration->section, declaration->name);
            else
                notes.addSpecimenKeys(declaration->name);
        } else if (const auto section = sections.find(words.front()); section != sections.end()) {
            if (!count)
                lines.fail(
                    tr("the number of points is missing; write a line %1 before the points", "define Markers 10"));
            sections.erase(section);
            isOther = false;
            LandmarkSet &set = read.sets.emplace_back();
            for (std::uint32_t i = 0; i < *count; ++i) {
                if (!lines.next() || lines.text().starts_with('@'))
                    lines.fail(tr("here are %1 of the %2 points that \"define Markers\" announces; is the file cut "
                                  "off?",
                                  i, *count));
                const std::vector<std::string_view> point = wordsOf(lines.text());
                if (point.size() != kAxes.size())
                    lines.fail(tr("%1 is not a point; write x, y and z", base::quoted(lines.text())));
                set.landmarks.push_back(landmarkAt(point, lines.number()));
            }
        } else if (lines.text().starts_with('@')) {
            isOther = true;
        } else if (!read.sets.empty() && !isOther && !lines.text().starts_with('#')) {
            lines.fail(tr("%1 follows the points; write the right number behind \"define Markers\"",
                          base::quoted(lines.text())));
        }
    }
    if (read.sets.empty() || !sections.empty())
        lines.fail(tr("there is no section of points, which begins with a line \"@1\"; is the file cut off?"));
    read.notes = notes.take();
    return read;
}

} // namespace unprojector::landmark_files
