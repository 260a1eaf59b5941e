#include "core/landmark_files/lines.h"

#include "core/text/number_text.h"
#include "core/text/text_scanner.h"
#include "core/text/translation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using text::quoted;
using text::tr;

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

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n\v\f");
    return first == text.npos ? std::string_view()
                              : text.substr(first, text.find_last_not_of(" \t\r\n\v\f") - first + 1);
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    for (char &c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
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
    const std::optional<double> value = text::doubleFromWord(trimmed(word));
    if (value && std::isfinite(*value))
        return *value;
    throw Failure{line, tr(word.find(',') == word.npos ? "%1 is %2; write a number"
                                                       : "%1 is %2; write a number with a decimal point",
                           tr(what), quoted(word))};
}

std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what)
{
    const std::optional<long long> value = text::integerFromWord(trimmed(word));
    if (value && *value >= 0 && *value <= std::numeric_limits<std::uint32_t>::max())
        return static_cast<std::uint32_t>(*value);
    throw Failure{line, tr("%1 is %2; write a whole number, 0 or more", tr(what), quoted(word))};
}

void appendNumbers(std::string &text, const glm::dvec3 &v, char separator)
{
    for (int i = 0; i < 3; ++i) {
        text += separator;
        text::appendNumber(text, v[i]);
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
public:
    void add(const nlohmann::ordered_json &extra)
    {
        if (!extra.is_object() || extra.empty())
            return;
        ++m_count;
        for (auto it = extra.begin(); it != extra.end(); ++it) {
            if (std::find(m_names.begin(), m_names.end(), it.key()) == m_names.end())
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

std::vector<LandmarkSet> withCurvesAsPoints(std::span<const LandmarkSet> sets, Notes &notes)
{
    std::vector<LandmarkSet> plain(sets.begin(), sets.end());
    for (LandmarkSet &set : plain) {
        for (std::size_t i = 0; i < set.curves.size(); ++i) {
            const Curve &curve = set.curves[i];
            const std::string name = nameOf(curve, i);
            if (curve.semilandmarks.empty())
                notes.add(LandmarkNote::Kind::CurveUnknown, 1, name);
            else
                notes.add(LandmarkNote::Kind::CurvesAsPoints, curve.semilandmarks.size());
            for (std::size_t k = 0; k < curve.semilandmarks.size(); ++k) {
                Landmark &landmark = set.landmarks.emplace_back();
                landmark.name = semilandmarkName(name, k, curve.semilandmarks.size());
                landmark.world = curve.semilandmarks[k];
            }
        }
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
        // The number of the last one is the count.
        std::size_t count = 0;
        for (const char c : std::string_view(last).substr(colon + 1))
            count = c >= '0' && c <= '9' && count <= kMostSemilandmarks ? 10 * count + std::size_t(c - '0')
                                                                        : kMostSemilandmarks + std::size_t{1};
        if (count < 2 || count > kMostSemilandmarks || count >= landmarks.size())
            break;
        Curve curve;
        curve.name = name;
        curve.count = static_cast<std::uint32_t>(count);
        const std::size_t first = landmarks.size() - count;
        for (std::size_t k = 0; k < count; ++k) {
            const Landmark &landmark = landmarks[first + k];
            if (landmark.world && landmark.name == semilandmarkName(name, k, count))
                curve.semilandmarks.push_back(*landmark.world);
        }
        if (curve.semilandmarks.size() < count)
            break;
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

void appendCell(std::string &text, std::string_view cell)
{
    const bool isPlain = cell.find_first_of(",\"\r\n") == cell.npos && trimmed(cell).size() == cell.size()
                         && cell != "NA" && cell != "#N/A";
    if (isPlain) {
        text += cell;
        return;
    }
    text += '"';
    for (const char c : cell)
        text.append(c == '"' ? 2 : 1, c);
    text += '"';
}

void appendCell(std::string &text, const std::string &cell, text::CellTexts texts)
{
    const bool isQuoted =
        text::isQuotedFormula(cell) || (texts == text::CellTexts::SpreadsheetSafe && text::isFormula(cell));
    appendCell(text, isQuoted ? '\'' + cell : cell);
}

} // namespace unprojector::landmark_files
