#include "core/landmark_files/lines.h"

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::marked;
using base::quoted;
using base::tr;

void fail(std::size_t line, std::string text)
{
    throw base::Error{.text = std::move(text), .line = static_cast<int>(line)};
}

bool Lines::next()
{
    m_scanner.skipBlankLines();
    if (m_scanner.isAtEnd())
        return false;
    m_number = m_scanner.line();
    m_line = m_scanner.restOfLine();
    return true;
}

std::string upperCase(std::string_view text)
{
    std::string upper(text);
    for (char &c : upper)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return upper;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    base::TextScanner scanner(line);
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord())
        words.push_back(word);
    return words;
}

double numberOf(std::string_view word, std::size_t line, std::string_view what)
{
    const std::optional<double> value = base::doubleFromWord(trimmed(word));
    if (!value || !std::isfinite(*value))
        fail(line, tr(word.find(',') == word.npos ? "%1 is %2; write a number"
                                                  : "%1 is %2; write a number with a decimal point",
                      tr(what), quoted(word)));
    return *value;
}

std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what)
{
    const std::optional<long long> value = base::integerFromWord(trimmed(word));
    if (!value || *value < 0 || *value > std::numeric_limits<std::uint32_t>::max())
        fail(line, tr("%1 is %2; write a whole number, 0 or more", tr(what), quoted(word)));
    return static_cast<std::uint32_t>(*value);
}

bool isMissingWord(std::string_view word)
{
    constexpr std::array<std::string_view, 6> kWords{"na", "nan", "n/a", "#n/a", "null", "none"};
    return std::find(kWords.begin(), kWords.end(), lowerCase(word)) != kWords.end();
}

void Coordinates::add(std::string_view word, std::size_t line, bool isMissing)
{
    if (isMissing)
        ++m_missing;
    else
        m_position[static_cast<int>(m_count)] = numberOf(word, line, kAxes[m_count]);
    ++m_count;
    m_line = line;
}

Landmark Coordinates::landmark() const
{
    Landmark landmark;
    if (m_missing == m_count)
        return landmark;
    if (m_missing > 0)
        fail(m_line, tr("some coordinates of a point are missing and some are not; a point is missing as a whole"));
    landmark.world = WorldPoint(m_position);
    return landmark;
}

Landmark landmarkAt(std::span<const std::string_view> words, std::size_t line,
                    const std::function<bool(std::string_view)> &isMissing)
{
    Coordinates coordinates;
    for (const std::string_view word : words)
        coordinates.add(word, line, isMissing(word));
    return coordinates.landmark();
}

std::string numbersText(const glm::dvec3 &v, char separator)
{
    std::string text;
    for (int i = 0; i < 3; ++i) {
        if (i > 0)
            text += separator;
        base::appendNumber(text, v[i]);
    }
    return text;
}

WorldPoint turned(const WorldPoint &point, Axes axes)
{
    return axes == Axes::Ras ? WorldPoint(0.0 - point.x, 0.0 - point.y, point.z) : point; // no -0
}

base::Json takenFrom(base::JsonValue &object, const char *key)
{
    base::Json value;
    if (object.json().contains(key)) {
        base::Json &json = object.edit();
        value = std::move(json[key]);
        json.erase(key);
        if (json.empty())
            json = nullptr;
    }
    return value;
}

namespace {

constexpr NoteText kNameTwice{marked("%1 has several landmarks named \"%2\"; the table numbers them")},
    kSpellingsKept{marked("%1 has both \"%2\" and \"%3\", so they are two landmarks in all specimens; rename one if "
                          "they are the same")};
constexpr NoteText kKeysLeftOut{marked("the other values of %1 landmark are left out: %2"),
                                marked("the other values of %1 landmarks are left out: %2")},
    kSpecimenKeysLeftOut{marked("other values of %1 specimen are left out: %2"),
                         marked("other values of %1 specimens are left out: %2")},
    kMeshLeftOut{marked("the name of the mesh, \"%1\", is left out")};

/// A property of landmarks that a format may lack.
struct Loss {
    unsigned held;
    NoteText text;
    bool (*has)(const Landmark &);
    bool isOfEveryTable = true;
};
constexpr std::array kLosses{
    Loss{HeldNames,
         {marked("the names of %1 landmark are left out; only their order is kept"),
          marked("the names of %1 landmarks are left out; only their order is kept")},
         [](const Landmark &l) { return !l.name.empty(); },
         false},
    Loss{
        HeldPositions,
        {marked("the coordinates of %1 landmark are left out"), marked("the coordinates of %1 landmarks are left out")},
        [](const Landmark &l) { return l.isPlaced(); },
        false},
    Loss{HeldObjects,
         {marked("the objects of %1 landmark are left out"), marked("the objects of %1 landmarks are left out")},
         [](const Landmark &l) { return !l.object.empty(); }},
    Loss{HeldAnchors,
         {marked("the anchor of %1 landmark (triangle, vertex or edge) is left out"),
          marked("the anchors of %1 landmarks (triangles, vertices or edges) are left out")},
         [](const Landmark &l) { return !std::holds_alternative<Free>(l.anchor); }},
    Loss{HeldUncertainties,
         {marked("the uncertainties of %1 landmark are left out"),
          marked("the uncertainties of %1 landmarks are left out")},
         [](const Landmark &l) { return l.uncertainty.has_value(); }},
    Loss{HeldNotes,
         {marked("the notes of %1 landmark are left out"), marked("the notes of %1 landmarks are left out")},
         [](const Landmark &l) { return !l.note.empty(); }},
    Loss{HeldColors,
         {marked("the colours of %1 landmark are left out"), marked("the colours of %1 landmarks are left out")},
         [](const Landmark &l) { return l.color.has_value(); }},
    Loss{HeldHidden,
         {marked("%1 hidden landmark is written as any other"), marked("%1 hidden landmarks are written as any other")},
         [](const Landmark &l) { return l.isHidden; }},
};

/// The keys of several objects, each once, and the number of objects.
class Keys {
public:
    /// @param held  keys that are not lost
    void add(const base::Json &extra, std::span<const std::string_view> held = {})
    {
        bool isAny = false;
        for (const auto &[key, value] : extra.items()) {
            // The program's own: the edge that a placed landmark's pixel touches is a part of its anchor.
            if (key == "pixelEdge" || std::find(held.begin(), held.end(), key) != held.end())
                continue;
            isAny = true;
            if (m_known.insert(key).second)
                list += (list.empty() ? "" : ", ") + key;
        }
        count += isAny ? 1 : 0;
    }

    std::string list;
    std::size_t count = 0;

private:
    std::set<std::string> m_known;
};

/// Adds a note where landmarks have no position for different reasons, which then look alike.
void noteAbsences(Notes &notes, std::span<const LandmarkSet> sets)
{
    std::array<std::size_t, 3> counts{};
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks) {
            if (!landmark.isPlaced())
                ++counts[static_cast<std::size_t>(landmark.absence)];
        }
    }
    if (std::count(counts.begin(), counts.end(), std::size_t{0}) < 2)
        notes.add({marked("%1 points have no position, for different reasons (not placed: %2, skipped: %3, missing: "
                          "%4); the reasons are left out")},
                  1,
                  {std::to_string(counts[0] + counts[1] + counts[2]), std::to_string(counts[0]),
                   std::to_string(counts[1]), std::to_string(counts[2])});
}

} // namespace

void Notes::add(const NoteText &text, std::size_t count, std::vector<std::string> values)
{
    if (count == 0)
        return;
    const auto [known, isNew] = m_indices.try_emplace({text.one, values}, m_notes.size());
    if (isNew)
        m_notes.push_back({text.one, std::move(values), text.many, count});
    else
        m_notes[known->second].count += count;
}

void Notes::addKeys(const std::string &names, std::size_t count)
{
    add(kKeysLeftOut, count, {names});
}

void Notes::addSpecimenKeys(const std::string &names, std::size_t count)
{
    add(kSpecimenKeysLeftOut, count, {names});
}

bool isOfEveryTable(const base::Note &note)
{
    return note.one == kKeysLeftOut.one || note.one == kSpecimenKeysLeftOut.one || note.one == kMeshLeftOut.one
           || std::any_of(kLosses.begin(), kLosses.end(),
                          [&](const Loss &loss) { return loss.isOfEveryTable && loss.text.one == note.one; });
}

void addLosses(Notes &notes, std::span<const LandmarkSet> sets, unsigned held,
               std::span<const std::string_view> ownKeys)
{
    for (const Loss &loss : kLosses) {
        for (const LandmarkSet &set : sets) {
            if (!(held & loss.held))
                notes.add(loss.text, static_cast<std::size_t>(
                                         std::count_if(set.landmarks.begin(), set.landmarks.end(), loss.has)));
        }
    }
    if (!(held & HeldAbsences))
        noteAbsences(notes, sets);
    Keys keys, specimenKeys;
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks) {
            if (!(held & HeldKeys))
                keys.add(landmark.extra.json(), ownKeys);
        }
        if (!(held & HeldSpecimenKeys))
            specimenKeys.add(set.extra.json());
        if (!(held & HeldSpecimenName) && !set.name.empty())
            notes.add({marked("the name of the specimen, \"%1\", is left out")}, 1, {set.name});
        if (!(held & HeldPlacings) && set.placing > 1)
            notes.add({marked("the placing of %1 specimen, which is not its first, is left out"),
                       marked("the placings of %1 specimens, which are not their first, are left out")});
        notes.add(kMeasuresLeftOut, set.measures.size()); // they have a file of their own
        if (!(held & HeldMesh) && !set.mesh.empty())
            notes.add(kMeshLeftOut, 1, {set.mesh});
        if (!(held & HeldUnit) && !set.unit.empty())
            notes.add({marked("the unit, %1, is left out")}, 1, {set.unit});
    }
    notes.addKeys(keys.list, keys.count);
    notes.addSpecimenKeys(specimenKeys.list, specimenKeys.count);
}

std::string nameOf(const Curve &curve, std::size_t index)
{
    return curve.name.empty() ? "curve " + std::to_string(index + 1) : curve.name;
}

std::string semilandmarkName(const std::string &curve, std::size_t index, std::size_t count)
{
    const std::string number = std::to_string(index + 1);
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
    return curve + ':' + std::string(digits - number.size(), '0') + number;
}

std::optional<std::size_t> placedIndexOf(const std::string &name, const LandmarkSet &set)
{
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
        if (set.landmarks[i].name != name)
            continue;
        if (found || !set.landmarks[i].isPlaced())
            return std::nullopt;
        found = i;
    }
    return found;
}

CurvePart partOf(const Curve &curve, const LandmarkSet &set)
{
    // The curve starts on the surface, where the landmark lies to rounding.
    constexpr double kRounding = 1e-6;
    const std::vector<WorldPoint> &places = curve.semilandmarks;
    CurvePart part{0, places.size(), {}, {}};
    if (places.size() < 2 || curve.points.empty())
        return part;
    double length = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i)
        length += glm::distance(places[i - 1].coordinates(), places[i].coordinates());
    if (!std::isfinite(length))
        return part;
    const auto landmarkAt = [&](const std::string &name, const WorldPoint &place) {
        std::optional<std::size_t> index = placedIndexOf(name, set);
        if (index
            && !(glm::distance(set.landmarks[*index].world->coordinates(), place.coordinates()) <= kRounding * length))
            index.reset();
        return index;
    };
    part.before = landmarkAt(curve.points.front(), places.front());
    part.behind = landmarkAt(curve.points.back(), places.back());
    part.begin += part.before ? 1u : 0u;
    part.end -= part.behind ? 1u : 0u;
    return part;
}

std::vector<LandmarkSet> withCurvesAsPoints(std::span<const LandmarkSet> sets, Notes &notes)
{
    std::vector<LandmarkSet> plain(sets.begin(), sets.end());
    for (LandmarkSet &set : plain) {
        std::vector<Landmark> semilandmarks;
        for (std::size_t i = 0; i < set.curves.size(); ++i) {
            const Curve &curve = set.curves[i];
            const std::string name = nameOf(curve, i);
            const CurvePart part = partOf(curve, set);
            if (curve.semilandmarks.empty())
                notes.add(kCurveUnknown, 1, {name});
            notes.add({marked("%1 semilandmark is written as points behind the others, named by their curve; what the "
                              "curves go through is left out"),
                       marked("%1 semilandmarks are written as points behind the others, named by their curve; what "
                              "the curves go through is left out")},
                      part.size());
            notes.add(kCurveEndsShared, part.sharedCount());
            for (std::size_t k = part.begin; k < part.end; ++k) {
                Landmark &landmark = semilandmarks.emplace_back();
                landmark.name = semilandmarkName(name, k, curve.semilandmarks.size());
                landmark.world = curve.semilandmarks[k];
            }
        }
        set.landmarks.insert(set.landmarks.end(), std::make_move_iterator(semilandmarks.begin()),
                             std::make_move_iterator(semilandmarks.end()));
        set.curves.clear();
    }
    return plain;
}

std::size_t takeSemilandmarks(LandmarkSet &set)
{
    std::vector<Curve> taken;
    std::vector<Landmark> landmarks = set.landmarks;
    while (!landmarks.empty()) {
        const std::string &last = landmarks.back().name;
        const std::size_t colon = last.rfind(':');
        if (colon == last.npos || colon == 0)
            break;
        const std::string name = last.substr(0, colon);
        const std::string_view digits = std::string_view(last).substr(colon + 1);
        std::size_t number = 0; // of the last one
        for (const char c : digits)
            number = c >= '0' && c <= '9' && number <= kMostSemilandmarks ? 10 * number + std::size_t(c - '0')
                                                                          : kMostSemilandmarks + std::size_t{1};
        if (number < 2 || number > kMostSemilandmarks)
            break;
        // The number of digits follows from the count, which is one more if the end is left out.
        const std::size_t count = digits.size() > semilandmarkName({}, 0, number).size() - 1 ? number + 1 : number;
        std::size_t first = landmarks.size();
        for (std::size_t k = number; k > 0 && first > 0; --k, --first) {
            const Landmark &landmark = landmarks[first - 1];
            if (!landmark.world || landmark.name != semilandmarkName(name, k - 1, count))
                break;
        }
        const std::size_t size = landmarks.size() - first;
        if (first == 0 || size < 2 || size + 1 < number)
            break;
        Curve curve;
        curve.name = name;
        curve.count = static_cast<std::uint32_t>(size);
        for (std::size_t i = first; i < landmarks.size(); ++i)
            curve.semilandmarks.push_back(*landmarks[i].world);
        landmarks.resize(first);
        taken.insert(taken.begin(), std::move(curve));
    }
    if (taken.empty())
        return 0;
    set.landmarks = std::move(landmarks);
    const std::size_t count = taken.size();
    set.curves.insert(set.curves.end(), std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
    return count;
}

std::string PlainNames::of(const std::string &name, const std::string &instead)
{
    std::string plain = name.empty() ? instead : name;
    for (char &c : plain) {
        const bool isControl = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
        if ((isControl && m_good.find(c) == m_good.npos) || m_bad.find(c) != m_bad.npos)
            c = '_';
    }
    if (m_isUnique) {
        const std::string stem = plain;
        for (std::size_t &number = m_next.try_emplace(stem, 2).first->second; !m_given.insert(plain).second; ++number)
            plain = stem + '_' + std::to_string(number);
    }
    if (plain != name)
        m_notes.add(kNameChanged, 1, {name, plain});
    return plain;
}

void checkUnits(std::span<const LandmarkSet> sets, std::span<const std::string> names, Notes &notes)
{
    std::optional<std::size_t> with, without;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::string &unit = sets[i].unit;
        std::optional<std::size_t> &first = unit.empty() ? without : with;
        first = first.value_or(i);
        if (!unit.empty() && lowerCase(trimmed(unit)) != lowerCase(trimmed(sets[*with].unit)))
            fail(0, tr("%1 is in %2 and %3 in %4; write both in the same unit first", names[*with], sets[*with].unit,
                       names[i], unit));
    }
    if (with && without)
        notes.add({marked("%1 is in %2, and %3 does not say its unit; its coordinates are read in that unit")}, 1,
                  {names[*with], sets[*with].unit, names[*without]});
}

void addNameNotes(Notes &notes, const DistinctNames &distinct, std::span<const LandmarkSet> sets,
                  std::span<const std::string> names)
{
    for (const auto &[name, other] : distinct.respelled)
        notes.add(kNameChanged, 1, {name, other});
    for (const KeptSpellings &kept : distinct.kept) {
        if (!names[kept.set].empty())
            notes.add(kSpellingsKept, 1, {names[kept.set], kept.first, kept.second});
    }
    for (std::size_t i = 0; i < sets.size(); ++i) {
        std::map<std::string, int> counts;
        for (const Landmark &landmark : sets[i].landmarks) {
            if (!names[i].empty() && !landmark.name.empty() && ++counts[landmark.name] == 2)
                notes.add(kNameTwice, 1, {names[i], landmark.name});
        }
    }
}

std::vector<std::string> noteLines(const std::vector<FileNote> &notes)
{
    constexpr std::size_t kMostLines = 3;
    const auto isListed = [](std::string_view text) { // each names another landmark
        return text == kNameChanged.one || text == kNameTwice.one || text == kSpellingsKept.one;
    };
    std::vector<std::vector<FileNote>> groups; ///< of one text
    std::map<std::string_view, std::size_t> indices;
    for (const FileNote &note : notes) {
        const auto [known, isNew] = indices.try_emplace(note.note.one, groups.size());
        if (isNew)
            groups.emplace_back();
        groups[known->second].push_back(note);
    }
    std::vector<std::string> lines;
    for (const std::vector<FileNote> &group : groups) {
        const auto &[file, first] = group.front();
        base::Note sum = first;
        sum.count = 0;
        bool areEqual = true;
        for (const FileNote &each : group) {
            sum.count += each.note.count;
            areEqual = areEqual && each.note.values == sum.values;
        }
        if (group.size() <= kMostLines || isListed(first.one)) {
            for (const FileNote &each : group)
                lines.push_back(each.file + ": " + each.note.text());
        } else if (areEqual) {
            lines.push_back(tr("%1 files: %2", group.size(), sum.text()));
        } else {
            lines.push_back(tr("%1: %2 (and %3 more notes like this one)", file, first.text(), group.size() - 1));
        }
    }
    return lines;
}

} // namespace unprojector::landmark_files
