#pragma once

#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/landmark.h"
#include "core/scene_file/scene_file_error.h"
#include "core/text/csv.h"

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::landmark_files {

// What the readers and the writers of all formats share.

/// Thrown by a reader at a place that it cannot go on from.
struct Failure {
    std::size_t line; ///< counted from 1; 0: no line
    std::string text; ///< what is wrong and what to do
    LandmarkFileError::Code code = LandmarkFileError::Code::Malformed;
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
    /// Without blanks around it.
    std::string_view text() const { return m_line; }
    std::size_t number() const { return m_number; }

private:
    std::string_view m_rest, m_line;
    std::size_t m_number = 0;
};

std::string_view trimmed(std::string_view text);
std::string lowerCase(std::string_view text);
/// The words of a line.
std::vector<std::string_view> wordsOf(std::string_view line);

/// A finite number.
/// @param what  it is, for the message
/// Throws Failure.
double numberOf(std::string_view word, std::size_t line, std::string_view what);
/// A whole number from 0 to 4294967295. Throws Failure.
std::uint32_t countOf(std::string_view word, std::size_t line, std::string_view what);

/// Appends numbers, each after a separator.
void appendNumbers(std::string &text, const glm::dvec3 &v, char separator);

/// To and from the axes of the file: in RAS x and y have the other sign.
geometry::WorldPoint turned(const geometry::WorldPoint &point, landmarks::Axes axes);

/// Notes, each kind with each detail once, its counts added.
class Notes {
public:
    void add(LandmarkNote::Kind kind, std::size_t count = 1, const std::string &detail = {});
    std::vector<LandmarkNote> take() { return std::move(m_notes); }

private:
    std::vector<LandmarkNote> m_notes;
    std::map<std::pair<LandmarkNote::Kind, std::string>, std::size_t> m_places;
};

/// What a format has a place for.
struct FormatCapabilities {
    bool names = false, positions = true, objects = false, anchors = false, uncertainties = false, notes = false,
         colors = false, hidden = false, keys = false;
    bool specimenKeys = false, specimenName = false, mesh = false, unit = false;
};
/// Notes what sets have that the format has no place for.
void addLosses(Notes &notes, std::span<const landmarks::LandmarkSet> sets, const FormatCapabilities &format);

/// Sets as a format has them that knows no curves: semilandmarks are further points, "NAME:01".
std::vector<landmarks::LandmarkSet> withCurvesAsPoints(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
/// The name of a curve, "curve 1" of the first without one.
std::string nameOf(const landmarks::Curve &curve, std::size_t index);
/// "NAME:03" of the third of at most 99 semilandmarks. @param index  from 0
std::string semilandmarkName(const std::string &curve, std::size_t index, std::size_t count);

/// Names as a format can have them: without some characters, and each once where that is asked for.
class PlainNames {
public:
    /// @param bad  characters that are replaced by '_', as all below the blank are
    PlainNames(std::string_view bad, bool isUnique, Notes &notes) : m_bad(bad), m_isUnique(isUnique), m_notes(notes) {}

    /// @param instead  of an empty name
    std::string of(const std::string &name, const std::string &instead = {});

private:
    std::string_view m_bad;
    bool m_isUnique;
    Notes &m_notes;
    std::set<std::string> m_given;
    std::map<std::string, std::size_t> m_next; ///< number behind a name that was given before
};

/// Whether a word stands for "no number": NA, NaN, N/A, #N/A, null or none, in whatever case.
bool isMissingWord(std::string_view word);

/// A cell, in quotes where it needs them: without them NA is nothing.
void appendCell(std::string &text, std::string_view cell);
/// The same of a table of ours, whose reader takes an apostrophe before a formula off: one that is a name's own is doubled.
void appendCell(std::string &text, const std::string &cell, text::CellTexts texts);

/// An error of a JSON document: its place is the key, or line and column.
Failure failureOf(scene_file::SceneFileError error);

// One pair a format. Readers throw Failure.
ReadLandmarks readCsv(std::string_view text);
ReadLandmarks readMeshLab(std::string_view text, bool isTemplate);
ReadLandmarks readSlicerJson(std::string_view text);
ReadLandmarks readSlicerCsv(std::string_view text);
ReadLandmarks readIdav(std::string_view text);
ReadLandmarks readTps(std::string_view text);
ReadLandmarks readNts(std::string_view text);
ReadLandmarks readAmira(std::string_view text);
ReadLandmarks readLandmarker(std::string_view text);

std::string csvText(std::span<const landmarks::LandmarkSet> sets, text::CellTexts texts, Notes &notes);
std::string meshLabText(const landmarks::LandmarkSet &set, Notes &notes);
std::string meshLabTemplateText(const landmarks::LandmarkSet &set, Notes &notes);
std::string slicerJsonText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string slicerCsvText(const landmarks::LandmarkSet &set, Notes &notes);
std::string idavText(const landmarks::LandmarkSet &set, Notes &notes);
std::string tpsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);
std::string ntsText(std::span<const landmarks::LandmarkSet> sets, Notes &notes);

} // namespace unprojector::landmark_files
