// .nts and .dta of NTSYS: a matrix with one row per specimen, or without labels one row per
// landmark of one specimen.

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <algorithm>
#include <optional>
#include <set>

namespace unprojector::landmark_files {
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
};

/// Removes the letter of a count and returns it, if there is one.
char takeLetter(std::string_view &word)
{
    constexpr std::string_view kLetters = "LBE";
    if (kLetters.find(word.back()) == kLetters.npos)
        return 0;
    const char letter = word.back();
    word.remove_suffix(1);
    return letter;
}

Parameters parametersOf(const Lines &lines)
{
    const std::string upper = upperCase(lines.text());
    const std::size_t key = upper.find("DIM");
    const std::size_t equals = key == upper.npos ? key : upper.find('=', key);
    if (equals == upper.npos)
        lines.fail(tr("%1 has no DIM=3; this is not a matrix of landmarks", base::quoted(lines.text())));
    const std::string_view behind = trimmed(std::string_view(upper).substr(equals + 1));
    const std::size_t end = std::min(behind.find_first_of(" \t"), behind.size());
    Parameters parameters;
    parameters.dimensions = countOf(behind.substr(0, end), lines.number(), "DIM");
    if (parameters.dimensions != 2 && parameters.dimensions != 3)
        lines.fail(tr("DIM is %1; it must be 2 or 3", parameters.dimensions));
    const std::string rest = upper.substr(0, key) + ' ' + std::string(behind.substr(end));
    std::vector<std::string_view> words = wordsOf(rest);
    if (words.size() < 3 || words.front() != "1")
        lines.fail(tr("%1 is not a line of parameters; a matrix of landmarks begins with one like %2",
                      base::quoted(lines.text()), "1 12L 63 1 9999 DIM=3"));
    parameters.rowLabels = takeLetter(words[1]);
    parameters.hasColumnLabels = takeLetter(words[2]) != 0;
    parameters.rows = countOf(words[1], lines.number(), marked("the number of rows"));
    parameters.columns = countOf(words[2], lines.number(), marked("the number of columns"));
    if (words.size() > 4 && words[3] != "0")
        parameters.missing = numberOf(words[4], lines.number(), marked("the number for missing values"));
    parameters.isMissingUnknown = words.size() == 4 && words[3] != "0";
    if (parameters.columns == 0 || parameters.columns % parameters.dimensions != 0)
        lines.fail(tr("%1 columns are not a whole number of points of %2 coordinates", parameters.columns,
                      parameters.dimensions));
    return parameters;
}

bool isComment(std::string_view line)
{
    return line.front() == '"' || line.front() == '\'';
}

/// The words after the parameters, with their lines.
class Words {
public:
    Words(Lines &lines, Notes &notes) : m_lines(lines), m_notes(notes) {}

    /// The next word; empty at the end.
    std::string_view next()
    {
        while (m_at == m_words.size()) {
            if (!m_lines.next())
                return {};
            m_at = 0;
            m_words.clear();
            if (isComment(m_lines.text()))
                m_notes.add(kCommentsLeftOut);
            else
                m_words = wordsOf(m_lines.text());
        }
        return m_words[m_at++];
    }
    std::string_view need()
    {
        const std::string_view word = next();
        if (word.empty())
            m_lines.fail(tr("the file ends within the matrix that the parameters announce; is it cut off?"));
        return word;
    }

private:
    Lines &m_lines;
    Notes &m_notes;
    std::vector<std::string_view> m_words;
    std::size_t m_at = 0;
};

/// The labels of the rows: one a line if the file has no more words than the labels' lines and the
/// numbers, as IDAV Landmark writes names with blanks; otherwise one a word.
std::vector<std::string> labelsOf(Words &words, const Lines &after, const Parameters &parameters)
{
    std::vector<std::string> labels;
    Lines lines = after;
    std::size_t labelWords = 0, otherWords = 0;
    while (lines.next()) {
        if (isComment(lines.text()))
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
    std::string stem;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        std::string_view label = labels[first + axis];
        if (label.empty() || lowerCase(label.substr(label.size() - 1)) != kAxes[axis])
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
    bool isThere = lines.next();
    for (; isThere && isComment(lines.text()); isThere = lines.next()) {
        if (comments++ > 0)
            continue;
        title = trimmed(lines.text().substr(1));
        while (!title.empty() && (title.back() == '"' || title.back() == '\''))
            title.pop_back();
    }
    if (!isThere)
        fail(1, tr("there are no points; in NTSYS they follow a line like %1", "1 12L 63 1 9999 DIM=3"));
    const Parameters parameters = parametersOf(lines);
    const std::size_t axes = parameters.dimensions;
    const auto isMissing = [&parameters](std::string_view word) {
        return isMissingWord(word) || (parameters.missing && base::doubleFromWord(word) == parameters.missing);
    };
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
    notes.add(kCommentsLeftOut, comments);
    for (std::uint32_t row = 0; row < parameters.rows; ++row) {
        if (read.sets.empty() || !isOneSpecimen)
            read.sets.emplace_back();
        LandmarkSet &set = read.sets.back();
        if (parameters.rowLabels == 'L')
            set.name = rowLabels[row];
        else if (parameters.rowLabels == 'B')
            set.name = words.need();
        for (std::size_t column = 0; column < parameters.columns; column += axes) {
            Coordinates coordinates;
            for (std::size_t axis = 0; axis < axes; ++axis) {
                const std::string_view word = words.need();
                coordinates.add(word, lines.number(), isMissing(word));
            }
            Landmark landmark = coordinates.landmark();
            if (!columnLabels.empty() && !isOneSpecimen)
                landmark.name = nameOf(columnLabels, column, axes);
            set.landmarks.push_back(std::move(landmark));
        }
        if (parameters.rowLabels == 'E')
            set.name = words.need();
    }
    if (const std::string_view word = words.next(); !word.empty())
        lines.fail(tr("%1 follows the matrix; write the right numbers of rows and columns into the parameters",
                      base::quoted(word)));
    if (parameters.isMissingUnknown)
        notes.add({marked("the parameters say that values are missing, and not by which number; every number is read "
                          "as a coordinate")});
    if (axes == 2)
        notes.add(kFlatPoints, std::size_t{parameters.rows} * (parameters.columns / 2));
    if (read.sets.empty())
        read.sets.emplace_back();
    read.notes = notes.take();
    return read;
}

std::string ntsText(std::span<const LandmarkSet> sets, Notes &notes)
{
    if (sets.empty() || sets.front().landmarks.empty())
        fail(0, tr(".nts is a table, and there are no points; place some first"));
    const std::size_t points = sets.front().landmarks.size();
    bool hasMissing = false;
    std::set<double> coordinates;
    for (const LandmarkSet &set : sets) {
        if (set.landmarks.size() != points)
            fail(0, tr(".nts is a table, in which all specimens have the same points: \"%1\" has %2, \"%3\" has %4; "
                       "take .tps, or leave one of them out",
                       set.name, set.landmarks.size(), sets.front().name, points));
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
        for (const Landmark &landmark : set.landmarks)
            text += numbersText(landmark.world ? landmark.world->coordinates() : glm::dvec3(missing)) + ' ';
        text.back() = '\n';
    }
    return text;
}

} // namespace unprojector::landmark_files
