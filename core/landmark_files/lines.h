#pragma once

#include "core/base/csv.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/distinct_names.h"
#include "core/landmarks/landmark.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::landmark_files {

// Shared parts of the readers and writers of all formats. They throw a base::Error where they cannot
// continue.

/// @param line  counted from 1; 0: no line
[[noreturn]] void fail(std::size_t line, std::string text);

/// The lines of a text that are not blank.
class Lines {
public:
    explicit Lines(std::string_view text) : m_scanner(text) {}

    /// Moves to the next line.
    /// @return false at the end of the text
    bool next();
    /// The line without blanks around it.
    std::string_view text() const { return m_line; }
    std::size_t number() const { return m_number; }
    [[noreturn]] void fail(std::string text) const { landmark_files::fail(m_number, std::move(text)); }

private:
    base::TextScanner m_scanner;
    std::string_view m_line;
    std::size_t m_number = 0;
};

using base::lowerCase;
using base::trimmed;
std::string upperCase(std::string_view text);
/// The words of a line.
std::vector<std::string_view> wordsOf(std::string_view line);

inline constexpr std::array kAxes{"x", "y", "z"};

/// Parses a finite number.
/// @param what  name of the number, for the message
double numberOf(std::string_view word, std::size_t line, std::string_view what);
/// Parses a whole number from 0 to 4294967295.
std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what);
/// True if a word means "no number": NA, NaN, N/A, #N/A, null or none, in any case.
bool isMissingWord(std::string_view word);
/// A landmark from its coordinates, one after another, which may stand on several lines.
class Coordinates {
public:
    void add(std::string_view word, std::size_t line, bool isMissing);
    /// The landmark; without a position if all coordinates are missing.
    landmarks::Landmark landmark() const;

private:
    glm::dvec3 m_position{0.0};
    std::size_t m_count = 0, m_missing = 0;
    std::size_t m_line = 0; ///< of the last one
};
/// Parses two or three coordinates: a landmark without a position if all are missing.
landmarks::Landmark landmarkAt(std::span<const std::string_view> words, std::size_t line,
                               const std::function<bool(std::string_view)> &isMissing = isMissingWord);

/// Three numbers, each after the separator but the first.
std::string numbersText(const glm::dvec3 &v, char separator = ' ');

/// Converts to or from the axes of the file: in RAS x and y have the opposite sign.
geometry::WorldPoint turned(const geometry::WorldPoint &point, landmarks::Axes axes);

/// Removes a value from an object; null if it is missing.
base::Json takenFrom(base::JsonValue &object, const char *key);

/// The texts of a base::Note.
struct NoteText {
    std::string_view one, many = {};
};

/// Collects notes: each text with its values once, with the sum of its counts.
class Notes {
public:
    void add(const NoteText &text, std::size_t count = 1, std::vector<std::string> values = {});
    void addKeys(const std::string &names, std::size_t count = 1);         ///< of landmarks
    void addSpecimenKeys(const std::string &names, std::size_t count = 1); ///< of specimens
    std::vector<base::Note> take() { return std::move(m_notes); }

private:
    std::vector<base::Note> m_notes;
    std::map<std::pair<std::string_view, std::vector<std::string>>, std::size_t> m_indices;
};

// Notes of several formats.
inline constexpr NoteText kNameChanged{base::marked("the name \"%1\" as \"%2\"")},
    kCurveUnknown{base::marked("the curve \"%1\" has no semilandmarks and is left out: its path is computed when its "
                               "mesh is open")},
    kDecimalCommas{base::marked("the numbers have a decimal comma: 1,5 is one and a half")},
    kAxesFlipped{
        base::marked("the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads "
                     "one (LPS)")},
    kBlanksLeftOut{base::marked("the blanks around %1 cell text are removed; put the text in quotes to keep them"),
                   base::marked("the blanks around %1 cell texts are removed; put the texts in quotes to keep them")},
    kCommentsLeftOut{base::marked("%1 comment is left out"), base::marked("%1 comments are left out")},
    kCurveCellsLeftOut{base::marked("%1 semilandmark has more than a name and a position, which is left out"),
                       base::marked("%1 semilandmarks have more than a name and a position, which is left out")},
    kCurveEndsShared{base::marked("%1 end of a curve is a landmark and is not written again"),
                     base::marked("%1 ends of curves are landmarks and are not written again")},
    kFlatPoints{base::marked("%1 point has two coordinates; z is 0"),
                base::marked("%1 points have two coordinates; z is 0")},
    kHadPosition{base::marked("%1 point is marked as not placed and had coordinates, which are left out"),
                 base::marked("%1 points are marked as not placed and had coordinates, which are left out")},
    kMeasuresLeftOut{base::marked("%1 measure of the protocol is left out; save the protocol in a file of its own"),
                     base::marked("%1 measures of the protocol are left out; save the protocol in a file of its own")},
    kPreviewsLeftOut{
        base::marked("%1 point is a preview, which was not placed in 3D Slicer; it has no position here"),
        base::marked("%1 points are previews, which were not placed in 3D Slicer; they have no position here")},
    kSkippedLeftOut{base::marked("%1 skipped point is written as not placed"),
                    base::marked("%1 skipped points are written as not placed")};
/// Returns whether the note is about a property that tables of coordinates never have.
bool isOfEveryTable(const base::Note &note);

/// The properties that a format can hold, as bits.
enum Held : unsigned {
    HeldNames = 1,
    HeldPositions = 2,
    HeldObjects = 4,
    HeldAnchors = 8,
    HeldUncertainties = 0x10,
    HeldNotes = 0x20,
    HeldColors = 0x40,
    HeldHidden = 0x80,
    HeldKeys = 0x100,
    HeldAbsences = 0x200, ///< the reasons why landmarks have no position
    HeldSpecimenKeys = 0x400,
    HeldSpecimenName = 0x800,
    HeldPlacings = 0x1000,
    HeldMesh = 0x2000,
    HeldUnit = 0x4000
};
/// Adds notes about properties of the sets that the format cannot hold.
/// @param held     bits of Held
/// @param ownKeys  keys of landmarks that have a place of their own
void addLosses(Notes &notes, std::span<const landmarks::LandmarkSet> sets, unsigned held,
               std::span<const std::string_view> ownKeys = {});

/// The semilandmarks of a curve that a file has beside the landmarks: all without an end that is
/// one of them, by its name and by its position.
struct CurvePart {
    std::size_t begin = 0, end = 0;            ///< indices of the semilandmarks; `end` is behind the last one
    std::optional<std::size_t> before, behind; ///< indices of the landmarks at the ends, where they are left out

    std::size_t size() const { return end - begin; }
    /// The number of ends that are left out.
    std::size_t sharedCount() const { return (before ? 1u : 0u) + (behind ? 1u : 0u); }
};
CurvePart partOf(const landmarks::Curve &curve, const landmarks::LandmarkSet &set);
/// The index of the placed landmark of a name; empty if there is none, or more than one.
std::optional<std::size_t> placedIndexOf(const std::string &name, const landmarks::LandmarkSet &set);

/// The sets in the form of a format without curves: semilandmarks are further points, "NAME:02".
std::vector<landmarks::LandmarkSet> withCurvesAsPoints(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
/// The name of a curve; "curve 1" for the first one without a name.
std::string nameOf(const landmarks::Curve &curve, std::size_t index);
/// The name of a semilandmark: "NAME:03" for the third of at most 99. @param index  from 0
std::string semilandmarkName(const std::string &curve, std::size_t index, std::size_t count);

/// Converts names to a format's limits: without certain characters, and unique if requested.
class PlainNames {
public:
    /// @param bad   characters replaced by '_', as are control characters
    /// @param good  those that are not
    PlainNames(std::string_view bad, bool isUnique, Notes &notes, std::string_view good = {})
        : m_bad(bad), m_good(good), m_isUnique(isUnique), m_notes(notes)
    {
    }

    /// @param instead  replaces an empty name
    std::string of(const std::string &name, const std::string &instead = {});

private:
    std::string_view m_bad, m_good;
    bool m_isUnique;
    Notes &m_notes;
    std::set<std::string> m_given;
    std::map<std::string, std::size_t> m_next; ///< next number for a name that was used before
};

/// Reads a file, at most a byte more than kMostLandmarkBytes and a block.
/// @return errors of kinds NoFile and File
base::Expected<std::string, base::Error> readText(const std::filesystem::path &file);
/// Fails for a text that is too large or not UTF-8. Removes a byte order mark.
void checkText(std::string_view &text);
/// Fails if a file of that size could not be read again.
void checkSize(std::size_t bytes);

/// Checks that sets have one unit, because numbers of several units can be neither averaged nor
/// compared. Sets without a unit beside others get a note.
/// @param names  of the sets, for messages
void checkUnits(std::span<const landmarks::LandmarkSet> sets, std::span<const std::string> names, Notes &notes);

/// Adds notes about spellings that count as one name, spellings that do not, and names that a set has
/// several times.
/// @param names  of the sets, for messages; empty: its spellings and numbers are meant so
void addNameNotes(Notes &notes, const landmarks::DistinctNames &distinct, std::span<const landmarks::LandmarkSet> sets,
                  std::span<const std::string> names);

/// The result of a function that throws errors.
template <class Make>
auto caught(const Make &make, const std::string &file = {}) -> base::Expected<decltype(make()), base::Error>
{
    try {
        return make();
    } catch (base::Error &error) {
        error.file = file;
        return error;
    }
}

ReadLandmarks readCsv(std::string_view text);
ReadLandmarks readMeshLab(std::string_view text);
ReadLandmarks readMeshLabTemplate(std::string_view text);
ReadLandmarks readSlicerJson(std::string_view text);
ReadLandmarks readSlicerCsv(std::string_view text);
ReadLandmarks readIdav(std::string_view text);
ReadLandmarks readTps(std::string_view text);
ReadLandmarks readNts(std::string_view text);
ReadLandmarks readAmira(std::string_view text);
ReadLandmarks readLandmarker(std::string_view text);

/// Returns whether a set is a second or later placing.
bool hasSeveralPlacings(std::span<const landmarks::LandmarkSet> sets);
/// The text of a file, with notes about what the format cannot hold.
/// @param absent  stands in .csv for each coordinate of a landmark without a position
std::string textOf(std::span<const landmarks::LandmarkSet> sets, Format format, base::CellTexts texts, Notes &notes,
                   const std::string &absent = {});
// The writers of textOf.
std::string csvText(std::span<const landmarks::LandmarkSet> sets, base::CellTexts texts, Notes &notes,
                    const std::string &absent);
std::string meshLabText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string meshLabTemplateText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string slicerJsonText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string slicerCsvText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string idavText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string tpsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string ntsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);

} // namespace unprojector::landmark_files
