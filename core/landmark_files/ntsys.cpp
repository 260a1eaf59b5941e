// .nts and .dta of NTSYS: a matrix with one row per specimen, or without labels one row per
// landmark of one specimen.

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

/// The parameter line "1 12L 63L 1 9999 DIM=3": kind of matrix, rows, columns, whether values are
/// missing and the number that marks them.
struct Parameters {
    std::uint32_t rows = 0, columns = 0, dimensions = 3;
    char rowLabels = 0; ///< 'L': all before the numbers; 'B', 'E': at the beginning or end of each row; 0: none
    bool hasColumnLabels = false;
    std::optional<double> missing;
    bool isMissingUnknown = false; ///< values are missing, and the number that marks them is not given

    std::size_t axes() const { return dimensions; }
};

std::string upperCase(std::string_view text)
{
    std::string upper(text);
    for (char &c : upper)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return upper;
}

/// Removes the letter of a count and returns it, if there is one.
char takeLetter(std::string_view &word, std::string_view letters)
{
    if (word.empty() || letters.find(word.back()) == letters.npos)
        return 0;
    const char letter = word.back();
    word.remove_suffix(1);
    return letter;
}

Parameters parametersOf(std::string_view line, std::size_t number)
{
    const std::string upper = upperCase(line);
    const std::size_t key = upper.find("DIM");
    const std::size_t equals = key == upper.npos ? key : upper.find('=', key);
    if (equals == upper.npos)
        throw Failure{number, tr("%1 has no DIM=3; this is not a matrix of landmarks", base::quoted(line))};
    const std::string_view behind = trimmed(std::string_view(upper).substr(equals + 1));
    const std::size_t end = std::min(behind.find_first_of(" \t"), behind.size());
    Parameters parameters;
    parameters.dimensions = countOf(behind.substr(0, end), number, "DIM");
    if (parameters.dimensions != 2 && parameters.dimensions != 3)
        throw Failure{number, tr("DIM is %1; it must be 2 or 3", parameters.dimensions)};
    const std::string rest = upper.substr(0, key) + ' ' + std::string(behind.substr(end));
    std::vector<std::string_view> words = wordsOf(rest);
    if (words.size() < 3 || words.front() != "1")
        throw Failure{number, tr("%1 is not a line of parameters; a matrix of landmarks begins with one like %2",
                                 base::quoted(line), "1 12L 63 1 9999 DIM=3")};
    parameters.rowLabels = takeLetter(words[1], "LBE");
    parameters.hasColumnLabels = takeLetter(words[2], "LBE") != 0;
    parameters.rows = countOf(words[1], number, marked("the number of rows"));
    parameters.columns = countOf(words[2], number, marked("the number of columns"));
    if (words.size() > 4 && words[3] != "0")
        parameters.missing = numberOf(words[4], number, marked("the number for missing values"));
    parameters.isMissingUnknown = words.size() == 4 && words[3] != "0";
    if (parameters.columns == 0 || parameters.columns % parameters.dimensions != 0)
        throw Failure{number, tr("%1 columns are not a whole number of points of %2 coordinates", parameters.columns,
                                 parameters.dimensions)};
    return parameters;
}

/// The words after the parameters, with their lines.
class Words {
public:
    Words(Lines &lines, Notes &notes) : m_lines(lines), m_notes(notes) {}

    /// The next word; empty at the end.
    std::optional<std::string_view> next()
    {
        while (m_at == m_words.size()) {
            if (!m_lines.nextFilled())
                return std::nullopt;
            m_at = 0;
            m_words.clear();
            if (isComment(m_lines.text()))
                m_notes.add(LandmarkNote::Kind::CommentsLeftOut);
            else
                m_words = wordsOf(m_lines.text());
        }
        return m_words[m_at++];
    }
    std::string_view need()
    {
        const std::optional<std::string_view> word = next();
        if (!word)
            throw Failure{line(), tr("the file ends within the matrix that the parameters announce; is it cut off?")};
        return *word;
    }
    std::size_t line() const { return m_lines.number(); }

    static bool isComment(std::string_view line) { return line.front() == '"' || line.front() == '\''; }

private:
    Lines &m_lines;
    Notes &m_notes;
    std::vector<std::string_view> m_words;
    std::size_t m_at = 0;
};

Landmark landmarkOf(Words &words, const Parameters &parameters)
{
    constexpr std::array kAxes{"x", "y", "z"};
    glm::dvec3 v(0.0);
    std::size_t missing = 0;
    for (std::size_t axis = 0; axis < parameters.axes(); ++axis) {
        const std::string_view word = words.need();
        double &value = v[static_cast<int>(axis)];
        if (!isMissingWord(word))
            value = numberOf(word, words.line(), kAxes[axis]);
        missing += isMissingWord(word) || value == parameters.missing ? 1u : 0u;
    }
    if (missing > 0 && missing < parameters.axes())
        throw Failure{words.line(),
                      tr("some coordinates of a point are missing and some are not; a point is missing as "
                         "a whole")};
    Landmark landmark;
    if (missing == 0)
        landmark.world = WorldPoint(v);
    return landmark;
}

/// The labels of the rows: one a line if the file has no more words than the labels' lines and the
/// numbers, as IDAV Landmark writes names with blanks; otherwise one a word.
std::vector<std::string> labelsOf(Words &words, const Lines &after, const Parameters &parameters)
{
    std::vector<std::string> labels;
    Lines lines = after;
    std::size_t labelWords = 0, otherWords = 0;
    while (lines.nextFilled()) {
        if (Words::isComment(lines.text()))
            continue;
        const bool isLabel = labels.size() < parameters.rows;
        (isLabel ? labelWords : otherWords) += wordsOf(lines.text()).size();
        if (isLabel)
            labels.emplace_back(lines.text());
    }
    const std::size_t columnLabels = parameters.hasColumnLabels ? parameters.columns : 0;
    const bool isOneALine = labels.size() == parameters.rows
                            && otherWords == columnLabels + std::size_t{parameters.rows} * parameters.columns;
    std::vector<std::string> byWord;
    for (std::size_t i = 0; i < (isOneALine ? labelWords : std::size_t{parameters.rows}); ++i)
        byWord.emplace_back(words.need());
    return isOneALine ? labels : byWord;
}

/// The common part of the labels of a point's columns: "Nasion" for "Nasion_x", "Nasion_y" and
/// "Nasion_z".
std::string nameOf(const std::vector<std::string> &labels, std::size_t first, std::size_t axes)
{
    constexpr std::string_view kAxes = "xyz";
    std::string stem;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        std::string_view label = labels[first + axis];
        if (label.empty() || lowerCase(label.substr(label.size() - 1)) != kAxes.substr(axis, 1))
            return {};
        label.remove_suffix(1);
        if (!label.empty() && (label.back() == '_' || label.back() == '.' || label.back() == '-'))
            label.remove_suffix(1);
        if (axis > 0 && label != stem)
            return {};
        stem = label;
    }
    return stem;
}

} // namespace

ReadLandmarks readNts(std::string_view text)
{
    ReadLandmarks read;
    Notes notes;
    Lines lines(text);
    std::string title; // the first comment
    std::size_t comments = 0;
    bool isThere = lines.nextFilled();
    for (; isThere && Words::isComment(lines.text()); isThere = lines.nextFilled()) {
        if (comments++ > 0)
            continue;
        title = trimmed(lines.text().substr(1));
        while (!title.empty() && (title.back() == '"' || title.back() == '\''))
            title.pop_back();
    }
    if (!isThere)
        throw Failure{1, tr("there are no points; in NTSYS they follow a line like %1", "1 12L 63 1 9999 DIM=3")};
    const Parameters parameters = parametersOf(lines.text(), lines.number());
    const std::size_t axes = parameters.axes();
    Words words(lines, notes);
    std::vector<std::string> rowLabels, columnLabels;
    if (parameters.rowLabels == 'L')
        rowLabels = labelsOf(words, lines, parameters);
    for (std::uint32_t i = 0; parameters.hasColumnLabels && i < parameters.columns; ++i)
        columnLabels.emplace_back(words.need());
    // geomorph's digit.fixed: the rows are the landmarks of one specimen; the first comment is its
    // name. buildtemplate and digitsurface write another comment.
    const bool isOneSpecimen = parameters.rowLabels == 0 && parameters.columns == parameters.dimensions;
    if (isOneSpecimen && comments > 0) {
        read.sets.emplace_back().name = title;
        --comments;
    }
    if (comments > 0)
        notes.add(LandmarkNote::Kind::CommentsLeftOut, comments);
    for (std::uint32_t row = 0; row < parameters.rows; ++row) {
        if (read.sets.empty() || !isOneSpecimen)
            read.sets.emplace_back();
        LandmarkSet &set = read.sets.back();
        if (parameters.rowLabels == 'L')
            set.name = rowLabels[row];
        else if (parameters.rowLabels == 'B')
            set.name = words.need();
        for (std::size_t column = 0; column < parameters.columns; column += axes) {
            Landmark landmark = landmarkOf(words, parameters);
            if (!columnLabels.empty() && !isOneSpecimen)
                landmark.name = nameOf(columnLabels, column, axes);
            set.landmarks.push_back(std::move(landmark));
        }
        if (parameters.rowLabels == 'E')
            set.name = words.need();
    }
    if (const auto word = words.next())
        throw Failure{words.line(),
                      tr("%1 follows the matrix; write the right numbers of rows and columns into the parameters",
                         base::quoted(*word))};
    if (parameters.isMissingUnknown)
        notes.add(LandmarkNote::Kind::MissingCodeUnknown);
    if (axes == 2)
        notes.add(LandmarkNote::Kind::FlatPoints, std::size_t{parameters.rows} * (parameters.columns / 2));
    if (read.sets.empty())
        read.sets.emplace_back();
    read.notes = notes.take();
    return read;
}

std::string ntsText(std::span<const LandmarkSet> sets, Notes &notes)
{
    addLosses(notes, sets, {.specimenName = true});
    if (sets.empty() || sets.front().landmarks.empty())
        throw Failure{0, tr(".nts is a table, and there are no points; place some first"),
                      LandmarkFileError::Code::CannotHold};
    const std::size_t points = sets.front().landmarks.size();
    bool hasMissing = false;
    std::set<double> coordinates;
    for (const LandmarkSet &set : sets) {
        if (set.landmarks.size() != points)
            throw Failure{0,
                          tr(".nts is a table, in which all specimens have the same points: \"%1\" has %2, \"%3\" has "
                             "%4; take .tps, or leave one of them out",
                             set.name, set.landmarks.size(), sets.front().name, points),
                          LandmarkFileError::Code::CannotHold};
        for (const Landmark &landmark : set.landmarks) {
            hasMissing = hasMissing || !landmark.isPlaced();
            for (int axis = 0; axis < 3 && landmark.world; ++axis)
                coordinates.insert((*landmark.world)[axis]);
        }
    }
    double missing = 9999.0; // the usual mark of a missing value
    while (hasMissing && coordinates.contains(missing))
        missing += 10000.0;
    std::string text = "1 " + std::to_string(sets.size()) + "L " + std::to_string(3 * points);
    text += hasMissing ? " 1 " : " 0";
    if (hasMissing)
        base::appendNumber(text, missing);
    text += " DIM=3\n";
    PlainNames names(" \"'", true, notes);
    for (std::size_t i = 0; i < sets.size(); ++i)
        text += names.of(sets[i].name, std::to_string(i + 1)) + '\n';
    for (const LandmarkSet &set : sets) {
        std::string row;
        for (const Landmark &landmark : set.landmarks) {
            appendNumbers(row, landmark.world ? landmark.world->coordinates() : glm::dvec3(missing), ' ');
        }
        text += row.substr(1) + '\n';
    }
    return text;
}

} // namespace unprojector::landmark_files
