// .tps of tpsDig and geomorph, many specimens per file.

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

constexpr std::string_view kPlacingWord = "placing ";

/// A line "KEY=value", the key in capitals; empty for another line.
struct KeyValue {
    std::string key;
    std::string_view value;
};

std::optional<KeyValue> keyValueOf(std::string_view line)
{
    const std::size_t equals = line.find('=');
    if (equals == line.npos)
        return std::nullopt;
    return KeyValue{upperCase(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1))};
}

/// True for tpsDig's "-1 -1", a missing point. This program writes a point that really is there
/// with an exponent.
bool isMinusOnes(const std::vector<std::string_view> &words)
{
    return std::all_of(words.begin(), words.end(), [](std::string_view word) {
        return base::doubleFromWord(word) == -1.0 && word.find_first_of("eE") == word.npos;
    });
}

/// Marks points of -1 as missing if no other coordinate of the specimen is negative, because tpsDig
/// counts pixels.
/// @param minusOnes  indices of the points
void takeMinusOnesAsMissing(LandmarkSet &set, const std::vector<std::size_t> &minusOnes, Notes &notes)
{
    std::vector<Landmark> others = set.landmarks;
    for (const std::size_t index : minusOnes)
        others[index].world.reset();
    const bool isInPixels = std::all_of(others.begin(), others.end(), [](const Landmark &landmark) {
        return !landmark.world || (landmark.world->x >= 0.0 && landmark.world->y >= 0.0 && landmark.world->z >= 0.0);
    });
    if (minusOnes.empty() || !isInPixels)
        return;
    notes.add({marked("%1 point has only coordinates of -1, as tpsDig writes a missing point; it has no position here"),
               marked("%1 points have only coordinates of -1, as tpsDig writes missing points; they have no position "
                      "here")},
              minusOnes.size());
    set.landmarks = std::move(others);
}

/// The words of the next row, which must have `size` numbers.
std::vector<std::string_view> rowOf(Lines &lines, std::size_t size, const std::string &announced)
{
    if (!lines.next())
        lines.fail(tr("the file ends within the points that %1 announces; is it cut off?", announced));
    std::vector<std::string_view> words = wordsOf(lines.text());
    if (words.size() != size || keyValueOf(lines.text()))
        lines.fail(tr("%1 is not a row of %2 numbers, which %3 announces; write the right number of points there",
                      base::quoted(lines.text()), size, announced));
    return words;
}

/// The placing in this program's "COMMENT=placing 2"; other programs skip comments.
std::optional<int> placingOf(std::string_view key, std::string_view value)
{
    if (key != "COMMENT" || !value.starts_with(kPlacingWord))
        return std::nullopt;
    const std::optional<long long> number = base::integerFromWord(value.substr(kPlacingWord.size()));
    return number && *number >= 1 && *number <= kMostPlacings ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

} // namespace

ReadLandmarks readTps(std::string_view text)
{
    ReadLandmarks read;
    Notes notes;
    Lines lines(text);
    std::set<std::string> keys; ///< keys of the specimen
    double scaleOfSet = 1.0;
    while (lines.next()) {
        const std::optional<KeyValue> entry = keyValueOf(lines.text());
        if (!entry)
            lines.fail(tr("%1 belongs to nothing; LM3= or LM= and a number come first, then as many rows of numbers",
                          base::quoted(lines.text())));
        const std::string announced = tr("line %1", lines.number());
        const auto &[key, value] = *entry;
        if (key == "LM3" || key == "LM") {
            const std::uint32_t count = countOf(value, lines.number(), key);
            LandmarkSet &set = read.sets.emplace_back();
            keys.clear();
            scaleOfSet = 1.0;
            std::vector<std::size_t> minusOnes;
            for (std::uint32_t i = 0; i < count; ++i) {
                const std::vector<std::string_view> words = rowOf(lines, key == "LM3" ? 3 : 2, announced);
                set.landmarks.push_back(landmarkAt(words, lines.number()));
                if (isMinusOnes(words))
                    minusOnes.push_back(i);
            }
            takeMinusOnesAsMissing(set, minusOnes, notes);
            notes.add(kFlatPoints, key == "LM" ? count : 0);
            continue;
        }
        if (read.sets.empty())
            lines.fail(tr("before %1 there must be points: LM3= and their number", base::quoted(lines.text())));
        LandmarkSet &set = read.sets.back();
        const bool isRepeated = key.starts_with("POINTS") || key.starts_with("CURVES");
        if (!isRepeated && !keys.insert(key).second)
            lines.fail(tr("%1 is here for the second time in a specimen; remove one of them", key));
        if (key == "ID") {
            set.name = value;
        } else if (const auto placing = placingOf(key, value)) {
            set.placing = *placing;
        } else if (key == "IMAGE") {
            set.mesh = value;
        } else if (key == "SCALE") {
            scaleOfSet = numberOf(value, lines.number(), "SCALE");
            if (!(scaleOfSet > 0.0))
                lines.fail(tr("SCALE is %1; it must be greater than 0", value));
            // Captured by name, because Clang 14 cannot capture a structured binding otherwise.
            const auto enlarge = [&lines, scaleOfSet, given = value](WorldPoint &point) {
                point = WorldPoint(point.coordinates() * scaleOfSet);
                if (!isFinite(point))
                    lines.fail(tr("SCALE is %1, which makes coordinates too large; write a smaller one", given));
            };
            for (Landmark &landmark : set.landmarks) {
                if (landmark.world)
                    enlarge(*landmark.world);
            }
            for (Curve &curve : set.curves)
                std::for_each(curve.semilandmarks.begin(), curve.semilandmarks.end(), enlarge);
            if (scaleOfSet != 1.0)
                notes.add({marked("coordinates are multiplied by the SCALE of the file, %1")}, 1, {std::string(value)});
        } else if (key.starts_with("POINTS")) {
            const std::uint32_t count = countOf(value, lines.number(), key);
            Curve curve;
            for (std::uint32_t i = 0; i < count; ++i) {
                if (!lines.next() || keyValueOf(lines.text()))
                    lines.fail(tr("there are fewer rows than the %1 that %2 announces; write the right number there",
                                  count, announced));
                const std::vector<std::string_view> words = wordsOf(lines.text());
                if (words.size() != 2 && words.size() != 3)
                    lines.fail(
                        tr("%1 is not a point of a curve; write two or three numbers", base::quoted(lines.text())));
                const Landmark place = landmarkAt(words, lines.number());
                if (!place.isPlaced() || (words.size() == 2 && isMinusOnes(words)))
                    lines.fail(tr("a point of a curve is %1, which means a missing one; a curve has all its points",
                                  lines.text()));
                curve.semilandmarks.push_back(WorldPoint(place.world->coordinates() * scaleOfSet));
                if (!isFinite(curve.semilandmarks.back()))
                    lines.fail(tr("SCALE makes this point's coordinates too large; write a smaller one"));
            }
            if (count < 2) {
                notes.add({marked("%1 point of curves are left out: a curve needs at least two"),
                           marked("%1 points of curves are left out: a curve needs at least two")},
                          count);
                continue;
            }
            curve.name = nameOf(curve, set.curves.size());
            curve.count = std::min(count, std::uint32_t{kMostSemilandmarks});
            set.curves.push_back(std::move(curve));
        } else if (!key.starts_with("CURVES")) {
            set.extra.edit()[key] = value;
        }
    }
    if (read.sets.empty())
        fail(1, tr("there are no points; in TPS they follow LM3= and their number"));
    read.notes = notes.take();
    return read;
}

namespace {

bool isTpsEntry(const std::string &key, const nlohmann::ordered_json &value)
{
    const bool isKey = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    });
    constexpr std::array kOurs{"LM", "LM3", "ID", "IMAGE", "SCALE"};
    const bool isOurs = std::find(kOurs.begin(), kOurs.end(), key) != kOurs.end() || key.starts_with("POINTS")
                        || key.starts_with("CURVES");
    return isKey && !isOurs && value.is_string()
           && value.get_ref<const std::string &>().find_first_of("\r\n") == std::string::npos;
}

/// Appends the curves. Their points have no names, and their origin is not kept.
void appendCurves(std::string &text, const LandmarkSet &set, Notes &notes)
{
    std::size_t count = 0;
    std::string rows;
    for (std::size_t i = 0; i < set.curves.size(); ++i) {
        const Curve &curve = set.curves[i];
        if (curve.semilandmarks.empty()) {
            notes.add(kCurveUnknown, 1, {nameOf(curve, i)});
            continue;
        }
        const CurvePart part = partOf(curve, set);
        notes.add(kCurveEndsShared, part.sharedCount());
        if (part.size() == 0)
            continue;
        ++count;
        rows += "POINTS=" + std::to_string(part.size()) + '\n';
        for (std::size_t k = part.begin; k < part.end; ++k)
            rows += numbersText(curve.semilandmarks[k].coordinates()) + '\n';
    }
    if (count == 0)
        return;
    notes.add({marked("the names of %1 curve and what they go through are left out"),
               marked("the names of %1 curves and what they go through are left out")},
              count);
    text += "CURVES=" + std::to_string(count) + '\n' + rows;
}

} // namespace

std::string tpsText(std::span<const LandmarkSet> sets, Notes &notes)
{
    std::string text;
    PlainNames names("", false, notes);
    for (const LandmarkSet &set : sets) {
        text += "LM3=" + std::to_string(set.landmarks.size()) + '\n';
        for (const Landmark &landmark : set.landmarks) {
            if (landmark.world == WorldPoint(-1.0, -1.0, -1.0))
                text += "-1e0 -1e0 -1e0\n"; // "-1 -1 -1" would mean missing
            else
                text += (landmark.world ? numbersText(landmark.world->coordinates()) : "NA NA NA") + '\n';
        }
        appendCurves(text, set, notes);
        if (!set.mesh.empty())
            text += "IMAGE=" + names.of(set.mesh) + '\n';
        for (auto it = set.extra.json().begin(); it != set.extra.json().end(); ++it) {
            if (isTpsEntry(it.key(), *it) && (set.placing == 1 || it.key() != "COMMENT"))
                text += it.key() + '=' + it->get<std::string>() + '\n';
            else
                notes.addSpecimenKeys(it.key());
        }
        if (set.placing > 1)
            text += "COMMENT=" + std::string(kPlacingWord) + std::to_string(set.placing) + '\n';
        if (!set.name.empty())
            text += "ID=" + names.of(set.name) + '\n';
        text += '\n';
    }
    return text;
}

} // namespace unprojector::landmark_files
