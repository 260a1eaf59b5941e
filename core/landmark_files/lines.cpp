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
using base::quoted;
using base::tr;

bool Lines::next()
{
    if (m_rest.empty())
        return false;
    const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
    m_line = trimmed(m_rest.substr(0, end));
    const bool isCrLf = end + 1 < m_rest.size() && m_rest[end] == '\r' && m_rest[end + 1] == '\n';
    m_rest.remove_prefix(std::min(end + (isCrLf ? 2 : 1), m_rest.size()));
    ++m_number;
    return true;
}

bool Lines::nextFilled()
{
    while (next()) {
        if (!m_line.empty())
            return true;
    }
    return false;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(" \t\v\f"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

double numberOf(std::string_view word, std::size_t line, std::string_view what)
{
    const std::optional<double> value = base::doubleFromWord(trimmed(word));
    if (value && std::isfinite(*value))
        return *value;
    throw Failure{line, tr(word.find(',') == word.npos ? "%1 is %2; write a number"
                                                       : "%1 is %2; write a number with a decimal point",
                           tr(what), quoted(word))};
}

std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what)
{
    const std::optional<long long> value = base::integerFromWord(trimmed(word));
    if (value && *value >= 0 && *value <= std::numeric_limits<std::uint32_t>::max())
        return static_cast<std::uint32_t>(*value);
    throw Failure{line, tr("%1 is %2; write a whole number, 0 or more", tr(what), quoted(word))};
}

void appendNumbers(std::string &text, const glm::dvec3 &v, char separator)
{
    for (int i = 0; i < 3; ++i) {
        text += separator;
        base::appendNumber(text, v[i]);
    }
}

WorldPoint turned(const WorldPoint &point, Axes axes)
{
    return axes == Axes::Ras ? WorldPoint(0.0 - point.x, 0.0 - point.y, point.z) : point; // no -0
}

void Notes::add(LandmarkNote::Kind kind, std::size_t count, const std::string &detail)
{
    const auto [place, isNew] = m_places.try_emplace({kind, detail}, m_notes.size());
    if (isNew)
        m_notes.push_back({kind, count, detail});
    else
        m_notes[place->second].count += count;
}

namespace {

/// Collects the keys of several objects, each once.
class Keys {
    // The program's own: the edge that a placed landmark's pixel touches is a part of its anchor.
    static constexpr const char *kEdgeKey = "pixelEdge";

public:
    void add(const nlohmann::ordered_json &extra)
    {
        if (!extra.is_object() || extra.empty() || (extra.size() == 1 && extra.contains(kEdgeKey)))
            return;
        ++m_count;
        for (auto it = extra.begin(); it != extra.end(); ++it) {
            if (it.key() != kEdgeKey && std::find(m_names.begin(), m_names.end(), it.key()) == m_names.end())
                m_names.push_back(it.key());
        }
    }
    void tell(Notes &notes, LandmarkNote::Kind kind) const
    {
        std::string list;
        for (const std::string &name : m_names)
            list += (list.empty() ? "" : ", ") + name;
        if (m_count > 0)
            notes.add(kind, m_count, list);
    }

private:
    std::size_t m_count = 0;
    std::vector<std::string> m_names;
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
    if (std::count(counts.begin(), counts.end(), std::size_t{0}) > 1)
        return;
    notes.add(LandmarkNote::Kind::AbsencesLeftOut, counts[0] + counts[1] + counts[2],
              tr("not placed: %1, skipped: %2, missing: %3", counts[0], counts[1], counts[2]));
}

} // namespace

void addLosses(Notes &notes, std::span<const LandmarkSet> sets, const FormatCapabilities &format)
{
    using Kind = LandmarkNote::Kind;
    const auto count = [&](bool isHeld, Kind kind, const auto &has) {
        std::size_t sum = 0;
        for (const LandmarkSet &set : sets)
            sum +=
                isHeld ? 0 : static_cast<std::size_t>(std::count_if(set.landmarks.begin(), set.landmarks.end(), has));
        if (sum > 0)
            notes.add(kind, sum);
    };
    count(format.names, Kind::NamesLeftOut, [](const Landmark &l) { return !l.name.empty(); });
    count(format.positions, Kind::PositionsLeftOut, [](const Landmark &l) { return l.isPlaced(); });
    count(format.objects, Kind::ObjectsLeftOut, [](const Landmark &l) { return !l.object.empty(); });
    count(format.anchors, Kind::HoldsLeftOut,
          [](const Landmark &l) { return !std::holds_alternative<Free>(l.anchor); });
    count(format.uncertainties, Kind::UncertaintiesLeftOut,
          [](const Landmark &l) { return l.uncertainty.has_value(); });
    count(format.notes, Kind::NotesLeftOut, [](const Landmark &l) { return !l.note.empty(); });
    count(format.colors, Kind::ColorsLeftOut, [](const Landmark &l) { return l.color.has_value(); });
    count(format.hidden, Kind::HiddenLeftOut, [](const Landmark &l) { return l.isHidden; });
    if (!format.absences)
        noteAbsences(notes, sets);
    Keys keys, specimenKeys;
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks) {
            if (!format.keys)
                keys.add(landmark.extra.json());
        }
        if (!format.specimenKeys)
            specimenKeys.add(set.extra.json());
        if (!format.specimenName && !set.name.empty())
            notes.add(Kind::SpecimenNameLeftOut, 1, set.name);
        if (!format.placings && set.placing > 1)
            notes.add(Kind::PlacingsLeftOut);
        if (!set.measures.empty()) // they have a file of their own
            notes.add(Kind::MeasuresLeftOut, set.measures.size());
        if (!format.mesh && !set.mesh.empty())
            notes.add(Kind::MeshLeftOut, 1, set.mesh);
        if (!format.unit && !set.unit.empty())
            notes.add(Kind::UnitLeftOut, 1, set.unit);
    }
    keys.tell(notes, Kind::KeysLeftOut);
    specimenKeys.tell(notes, Kind::SpecimenKeysLeftOut);
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
                notes.add(LandmarkNote::Kind::CurveUnknown, 1, name);
            else if (part.size() > 0)
                notes.add(LandmarkNote::Kind::CurvesAsPoints, part.size());
            if (part.sharedCount() > 0)
                notes.add(LandmarkNote::Kind::CurveEndsShared, part.sharedCount());
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
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f' || m_bad.find(c) != m_bad.npos)
            c = '_';
    }
    if (m_isUnique) {
        const std::string stem = plain;
        for (std::size_t &number = m_next.try_emplace(stem, 2).first->second; !m_given.insert(plain).second; ++number)
            plain = stem + '_' + std::to_string(number);
    }
    if (plain != name)
        m_notes.add(LandmarkNote::Kind::NameChanged, 1, tr("\"%1\" as \"%2\"", name, plain));
    return plain;
}

bool isMissingWord(std::string_view word)
{
    constexpr std::array<std::string_view, 6> kWords{"na", "nan", "n/a", "#n/a", "null", "none"};
    return std::find(kWords.begin(), kWords.end(), lowerCase(word)) != kWords.end();
}

void checkUnits(std::span<const LandmarkSet> sets, std::span<const std::string> names, Notes &notes)
{
    std::optional<std::size_t> with, without;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::string &unit = sets[i].unit;
        std::optional<std::size_t> &first = unit.empty() ? without : with;
        first = first.value_or(i);
        if (!unit.empty() && lowerCase(trimmed(unit)) != lowerCase(trimmed(sets[*with].unit)))
            throw Failure{0,
                          tr("%1 is in %2 and %3 in %4; write both in the same unit first", names[*with],
                             sets[*with].unit, names[i], unit),
                          LandmarkFileError::Code::CannotHold};
    }
    if (with && without)
        notes.add(LandmarkNote::Kind::UnitUnknown, 1,
                  tr("%1 is in %2, and %3 does not say its unit", names[*with], sets[*with].unit, names[*without]));
}

void addNameNotes(Notes &notes, const DistinctNames &distinct, std::span<const LandmarkSet> sets,
                  std::span<const std::string> names)
{
    for (const auto &[name, other] : distinct.respelled)
        notes.add(LandmarkNote::Kind::NameChanged, 1, tr("\"%1\" as \"%2\"", name, other));
    for (const KeptSpellings &kept : distinct.kept) {
        if (!names[kept.set].empty())
            notes.add(LandmarkNote::Kind::SpellingsKept, 1,
                      tr("%1 has both \"%2\" and \"%3\"", names[kept.set], kept.first, kept.second));
    }
    for (std::size_t i = 0; i < sets.size(); ++i) {
        std::map<std::string, int> counts;
        for (const Landmark &landmark : sets[i].landmarks) {
            if (!names[i].empty() && !landmark.name.empty() && ++counts[landmark.name] == 2)
                notes.add(LandmarkNote::Kind::NameTwice, 1,
                          tr("%1 has several landmarks named \"%2\"", names[i], landmark.name));
        }
    }
}

} // namespace unprojector::landmark_files
