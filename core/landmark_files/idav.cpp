// .pts of IDAV Landmark: "Version 1.0", the number of points, then one point per line.

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <algorithm>

namespace unprojector::landmark_files {
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

constexpr double kMissing = 9999.0;

bool isVersion(std::string_view line)
{
    const std::vector<std::string_view> words = wordsOf(line);
    return words.size() == 2 && lowerCase(words[0]) == "version" && base::doubleFromWord(words[1]) == 1.0;
}

/// True if a word means "no number". This program writes a coordinate of exactly 9999 with an
/// exponent.
bool isMissing(std::string_view word)
{
    return isMissingWord(word) || (base::doubleFromWord(word) == kMissing && word.find_first_of("eE") == word.npos);
}

/// Parses a row "name x y z".
Landmark landmarkOf(std::string_view row, std::size_t line)
{
    const std::vector<std::string_view> words = wordsOf(row);
    if (words.size() < 4)
        fail(line, tr("%1 is not a point; write its name, x, y and z", base::quoted(row)));
    // A name may contain blanks: the coordinates are the last three words.
    const std::string_view lastOfName = words[words.size() - 4];
    if (words.size() > 4 && base::doubleFromWord(lastOfName))
        fail(line, tr("%1 has more than three numbers behind its name; write name, x, y and z, and _ for a blank in a "
                      "name that ends in a number",
                      base::quoted(row)));
    Landmark landmark = landmarkAt(std::span(words).last(3), line, isMissing);
    landmark.name = row.substr(0, static_cast<std::size_t>(lastOfName.data() + lastOfName.size() - row.data()));
    return landmark;
}

} // namespace

ReadLandmarks readIdav(std::string_view text)
{
    Lines lines(text);
    if (!lines.next())
        fail(1, tr("the file is empty; IDAV Landmark begins it with \"Version 1.0\""));
    const std::string first = lowerCase(lines.text());
    if (first.starts_with("version:"))
        lines.fail(tr("this is a .pts of dlib, points in an image; only those of IDAV Landmark, which begin with "
                      "\"Version 1.0\", are points in space"));
    if (!first.starts_with("version"))
        lines.fail(tr("this .pts begins with %1, not with \"Version 1.0\" as those of IDAV Landmark do; a point cloud "
                      "of a scanner is not read: save it as .ply, and open that as a model",
                      base::quoted(lines.text())));
    if (!isVersion(lines.text()))
        lines.fail(tr("this .pts begins with %1, and only \"Version 1.0\" is known; write that there if its rows are "
                      "name, x, y and z",
                      base::quoted(lines.text())));
    if (!lines.next())
        lines.fail(tr("the number of points is missing; it follows \"Version 1.0\""));
    const std::size_t countLine = lines.number();
    const std::uint32_t count = countOf(lines.text(), countLine, marked("the number of points"));
    ReadLandmarks read;
    LandmarkSet &set = read.sets.emplace_back();
    while (lines.next()) {
        if (set.landmarks.size() == count)
            lines.fail(
                tr("line %1 says %2 points, and here is one more; write the right number there", countLine, count));
        set.landmarks.push_back(landmarkOf(lines.text(), lines.number()));
    }
    if (set.landmarks.size() < count)
        lines.fail(tr("the file ends after %1 of %2 points; is it cut off?", set.landmarks.size(), count));
    return read;
}

std::string idavText(std::span<const LandmarkSet> sets, Notes &notes)
{
    const LandmarkSet &set = sets.front();
    std::string text = "Version 1.0\n" + std::to_string(set.landmarks.size()) + '\n';
    // Readers in R take '#' for a comment and quotes as quotes, and need unique names.
    PlainNames names(" #\"'\\", true, notes);
    for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
        const Landmark &landmark = set.landmarks[i];
        text += names.of(landmark.name, 'S' + std::to_string(i));
        const glm::dvec3 v = landmark.world ? landmark.world->coordinates() : glm::dvec3(kMissing);
        if (landmark.world && (v.x == kMissing || v.y == kMissing || v.z == kMissing))
            notes.add({marked("\"%1\" has a coordinate of 9999, which readers take for a missing point")}, 1,
                      {landmark.name});
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            if (landmark.world && v[axis] == kMissing)
                text += "9.999e3"; // "9999" would mean missing
            else
                base::appendNumber(text, v[axis]);
        }
        text += '\n';
    }
    return text + '\n'; // one reader drops the last line
}

} // namespace unprojector::landmark_files
