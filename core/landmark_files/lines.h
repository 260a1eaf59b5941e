#pragma once

#include "core/base/csv.h"
#include "core/base/text_scanner.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/distinct_names.h"
#include "core/landmarks/landmark.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::landmark_files {

// Shared parts of the readers and writers of all formats.

/// Thrown by a reader where it cannot continue.
struct Failure {
    std::size_t line; ///< counted from 1; 0: no line
    std::string text; ///< the error and its remedy
    LandmarkFileError::Code code = LandmarkFileError::Code::Malformed;

    LandmarkFileError in(const std::string &file) const { return {code, file, line, text}; }
};

/// The lines of a text, ended by LF, CRLF or CR.
class Lines {
public:
    explicit Lines(std::string_view text) : m_rest(text) {}

    /// Moves to the next line.
    /// @return false at the end of the text
    bool next();
    /// Moves to the next line that is not blank.
    bool nextFilled();
    /// The line without blanks around it.
    std::string_view text() const { return m_line; }
    std::size_t number() const { return m_number; }

private:
    std::string_view m_rest, m_line;
    std::size_t m_number = 0;
};

using base::lowerCase;
using base::trimmed;
/// The words of a line.
std::vector<std::string_view> wordsOf(std::string_view line);

/// Parses a finite number. Throws Failure.
/// @param what  name of the number, for the message
double numberOf(std::string_view word, std::size_t line, std::string_view what);
/// Parses a whole number from 0 to 4294967295. Throws Failure.
std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what);

/// Appends numbers, each after a separator.
void appendNumbers(std::string &text, const glm::dvec3 &v, char separator);

/// Converts to or from the axes of the file: in RAS x and y have the opposite sign.
geometry::WorldPoint turned(const geometry::WorldPoint &point, landmarks::Axes axes);

/// Collects notes: each kind and detail once, with the sum of its counts.
class Notes {
public:
    void add(LandmarkNote::Kind kind, std::size_t count = 1, const std::string &detail = {});
    std::vector<LandmarkNote> take() { return std::move(m_notes); }

private:
    std::vector<LandmarkNote> m_notes;
    std::map<std::pair<LandmarkNote::Kind, std::string>, std::size_t> m_places;
};

/// The properties that a format can hold.
struct FormatCapabilities {
    bool names = false, positions = true, objects = false, anchors = false, uncertainties = false, notes = false,
         colors = false, hidden = false, keys = false;
    bool absences = false; ///< the reasons why landmarks have no position
    bool specimenKeys = false, specimenName = false, placings = false, mesh = false, unit = false;
};
/// Adds notes about properties of the sets that the format cannot hold.
void addLosses(Notes &notes, std::span<const landmarks::LandmarkSet> sets, const FormatCapabilities &format);

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
    /// @param bad  characters replaced by '_', as are all below the blank
    PlainNames(std::string_view bad, bool isUnique, Notes &notes) : m_bad(bad), m_isUnique(isUnique), m_notes(notes) {}

    /// @param instead  replaces an empty name
    std::string of(const std::string &name, const std::string &instead = {});

private:
    std::string_view m_bad;
    bool m_isUnique;
    Notes &m_notes;
    std::set<std::string> m_given;
    std::map<std::string, std::size_t> m_next; ///< next number for a name that was used before
};

/// True if a word means "no number": NA, NaN, N/A, #N/A, null or none, in any case.
bool isMissingWord(std::string_view word);

/// Reads a file, at most a byte more than kMostLandmarkBytes and a block.
/// @return NotFound, IsDirectory, NotReadable
geometry::Result<std::string, LandmarkFileError> readText(const std::filesystem::path &file);
/// Throws Failure if a file of that size could not be read again.
void checkSize(std::size_t bytes);

/// Checks that sets have one unit, because numbers of several units can be neither averaged nor
/// compared. Throws Failure. Sets without a unit beside others get a note.
/// @param names  of the sets, for messages
void checkUnits(std::span<const landmarks::LandmarkSet> sets, std::span<const std::string> names, Notes &notes);

/// Adds notes about spellings that count as one name, spellings that do not, and names that a set has
/// several times.
/// @param names  of the sets, for messages; empty: its spellings and numbers are meant so
void addNameNotes(Notes &notes, const landmarks::DistinctNames &distinct, std::span<const landmarks::LandmarkSet> sets,
                  std::span<const std::string> names);

/// The failure for an error of a JSON document: its position is the key, or line and column.
Failure failureOf(const base::Error &error);

// One pair per format. Readers throw Failure.
ReadLandmarks readCsv(std::string_view text);
ReadLandmarks readMeshLab(std::string_view text, bool isTemplate);
ReadLandmarks readSlicerJson(std::string_view text);
ReadLandmarks readSlicerCsv(std::string_view text);
ReadLandmarks readIdav(std::string_view text);
ReadLandmarks readTps(std::string_view text);
ReadLandmarks readNts(std::string_view text);
ReadLandmarks readAmira(std::string_view text);
ReadLandmarks readLandmarker(std::string_view text);

/// Returns whether a set is a second or later placing.
bool hasSeveralPlacings(std::span<const landmarks::LandmarkSet> sets);
/// @param absent  stands for each coordinate of a landmark without a position
std::string csvText(std::span<const landmarks::LandmarkSet> sets, base::CellTexts texts, Notes &notes,
                    const std::string &absent = {});
std::string meshLabText(const landmarks::LandmarkSet &set, Notes &notes);
std::string meshLabTemplateText(const landmarks::LandmarkSet &set, Notes &notes);
std::string slicerJsonText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string slicerCsvText(const landmarks::LandmarkSet &set, Notes &notes);
std::string idavText(const landmarks::LandmarkSet &set, Notes &notes);
std::string tpsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string ntsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);

} // namespace unprojector::landmark_files
