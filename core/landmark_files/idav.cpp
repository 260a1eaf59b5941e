// .pts of IDAV Landmark: "Version 1.0", the number of points, then one a line.

#include "core/landmark_files/lines.h"
#include "core/mesh_import/text_scanner.h"
#include "core/text/translation.h"

#include <algorithm>
#include <cmath>

namespace unprojector::landmark_files {
using text::marked;
using text::tr;
namespace {

constexpr double kMissing = 9999.0;

} // namespace

ReadLandmarks readIdav(std::string_view text)
{
    Lines lines(text);
    if (!lines.nextFilled())
        throw Failure{1, tr("the file is empty; IDAV Landmark begins it with \"Version 1.0\"")};
    const std::string first = lowerCase(lines.text());
    if (first.starts_with("version:"))
        throw Failure{lines.number(), tr("this is a .pts of dlib, points in a picture; only those of IDAV Landmark, "
                                         "which begin with \"Version 1.0\", are points in space")};
    if (!first.starts_with("version"))
        throw Failure{lines.number(),
                      tr("this .pts begins with %1, not with \"Version 1.0\" as those of IDAV Landmark "
                         "do; a point cloud of a scanner is not read: save it as .ply, and open that as a "
                         "model",
                         mesh_import::quoted(lines.text()))};
    if (!lines.nextFilled())
        throw Failure{lines.number(), tr("the number of points is missing; it stands behind \"Version 1.0\"")};
    const std::size_t countLine = lines.number();
    const std::uint32_t count = countOf(lines.text(), countLine, marked("the number of points"));
    ReadLandmarks read;
    LandmarkSet &set = read.sets.emplace_back();
    while (lines.nextFilled()) {
        if (set.landmarks.size() == count)
            throw Failure{
                lines.number(),
                tr("line %1 says %2 points, and here is one more; write the right number there", countLine, count)};
        const std::vector<std::string_view> words = wordsOf(lines.text());
        if (words.size() < 4)
            throw Failure{lines.number(),
                          tr("%1 is no point; write its name, x, y and z", mesh_import::quoted(lines.text()))};
        Landmark landmark;
        // A name with blanks in it is one all the same: the coordinates are the last three.
        const std::string_view lastOfName = words[words.size() - 4];
        landmark.name = lines.text().substr(
            0, static_cast<std::size_t>(lastOfName.data() + lastOfName.size() - lines.text().data()));
        glm::dvec3 v(kMissing);
        const bool isMissing = std::all_of(words.end() - 3, words.end(), isMissingWord);
        for (int i = 0; i < 3 && !isMissing; ++i)
            v[i] = numberOf(words[words.size() - 3 + std::size_t(i)], lines.number(),
                            i == 0   ? "x"
                            : i == 1 ? "y"
                                     : "z");
        if (v != glm::dvec3(kMissing))
            landmark.world = WorldPoint(v);
        set.landmarks.push_back(std::move(landmark));
    }
    if (set.landmarks.size() < count)
        throw Failure{lines.number(),
                      tr("the file ends after %1 of %2 points; is it cut off?", set.landmarks.size(), count)};
    return read;
}

std::string idavText(const LandmarkSet &set, Notes &notes)
{
    addLosses(notes, {&set, 1}, {.names = true});
    std::string text = "Version 1.0\n" + std::to_string(set.landmarks.size()) + '\n';
    // What reads these files in R takes '#' for a comment, quotes for quotes, and wants each name once.
    PlainNames names(" #\"'\\", true, notes);
    for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
        const Landmark &landmark = set.landmarks[i];
        text += names.of(landmark.name, 'S' + std::to_string(i));
        const glm::dvec3 v = landmark.world ? landmark.world->coordinates() : glm::dvec3(kMissing);
        if (landmark.world && (v.x == kMissing || v.y == kMissing || v.z == kMissing))
            notes.add(LandmarkNote::Kind::LooksMissing, 1, landmark.name);
        appendNumbers(text, v, ' ');
        text += '\n';
    }
    return text + '\n'; // one reader drops the last line
}

} // namespace unprojector::landmark_files
