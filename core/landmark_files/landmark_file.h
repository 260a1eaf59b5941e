#pragma once

#include "core/base/csv.h"
#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::landmark_files {

/// The file formats for the exchange of landmarks.
enum class Format {
    Csv,             ///< this program's own, `name,x,y,z,object,face,u,v,w,note`; keeps the most, including curves
    MeshLab,         ///< .pp, picked points
    MeshLabTemplate, ///< .pptpl, names only
    SlicerJson,      ///< .mrk.json of 3D Slicer
    SlicerCsv,       ///< .fcsv of 3D Slicer
    Idav,            ///< .pts of IDAV Landmark
    Tps,             ///< .tps of tpsDig and geomorph; many specimens
    Nts,             ///< .nts and .dta of NTSYS; many specimens
    LandmarkAscii,   ///< .landmarkAscii of Amira and Avizo; read only
    Landmarker,      ///< .ljson of landmarker.io and menpo; read only
};
inline constexpr std::array kFormats{
    Format::Csv, Format::MeshLab, Format::MeshLabTemplate, Format::SlicerJson, Format::SlicerCsv, Format::Idav,
    Format::Tps, Format::Nts,     Format::LandmarkAscii,   Format::Landmarker};
/// True if a format can be written; all can be read.
constexpr bool isWritten(Format format)
{
    return format != Format::LandmarkAscii && format != Format::Landmarker;
}

/// The suffix of a format, which is also its name in options: "csv", "pp", "mrk.json", …
const char *suffixOf(Format format);
/// The format of a suffix, in any case; empty if unknown. "dta" is NTSYS's too.
std::optional<Format> formatOfSuffix(std::string_view suffix);
/// The format of a file by the end of its name. "x.json" is one of 3D Slicer's too.
std::optional<Format> formatOf(const std::filesystem::path &file);
/// The format of a file to read: "x.txt" and "x.tsv" are tables.
std::optional<Format> readFormatOf(const std::filesystem::path &file);
/// The formats that can be read, as choices: "csv, pp, mrk.json".
std::string readWords();
std::string writtenWords();

/// A property of landmarks that a file changed or dropped.
struct LandmarkNote {
    enum class Kind {
        // Writing: the format cannot hold it. count: number of landmarks (or specimens) with it.
        NamesLeftOut,
        PositionsLeftOut,
        ObjectsLeftOut,
        HoldsLeftOut, ///< the anchor: triangle, vertex or edge
        UncertaintiesLeftOut,
        NotesLeftOut,
        ColorsLeftOut,
        HiddenLeftOut,
        KeysLeftOut,         ///< detail: their names
        SpecimenKeysLeftOut, ///< detail: their names
        SpecimenNameLeftOut, ///< detail: the name
        MeshLeftOut,         ///< detail: the file's name
        UnitLeftOut,         ///< detail: the unit
        PlacingsLeftOut,     ///< count: specimens whose placing is not the first
        MeasuresLeftOut,     ///< count: measures of the protocol
        RepeatsLeftOut,      ///< count: further placings of a specimen, where each would be one more specimen
        // Writing: the file has it in another form.
        NameChanged,          ///< detail: both names in quotes
        NameTwice,            ///< detail: which specimen has which name several times
        SpellingsKept,        ///< detail: which specimen has both spellings of a name
        NoteChanged,          ///< detail: the landmark
        AbsencesLeftOut,      ///< count: landmarks without a position; detail: the reasons and their counts
        SkippedLeftOut,       ///< count: skipped landmarks, written as not placed
        UnitOfOthers,         ///< detail: the unit; 3D Slicer takes every length for mm
        EmptySpecimenLeftOut, ///< detail: its name; it has no landmarks, so a table has no row for it
        LooksMissing,         ///< detail: the landmark; one of its coordinates is the format's word for "missing"
        MissingAtOrigin,      ///< count: older readers put them at 0, 0, 0
        CurvesAsPoints,       ///< count: semilandmarks
        CurveEndsShared,      ///< count: ends of curves that are landmarks, and are not written again
        CurvesUnnamed,        ///< count: curves of which only the semilandmarks are kept
        UnitUnknown,          ///< detail: the file, beside one that has a unit
        CurveUnknown,         ///< detail: its name; its path has not been computed
        CurveCountsDiffer,    ///< detail: which curve has how many semilandmarks on which specimens
        // Reading: the value was changed or dropped.
        AxesTurned,         ///< the file is in RAS
        FlatPoints,         ///< count: with two coordinates, z becomes 0
        Scaled,             ///< detail: the factor applied to coordinates
        CurvesLeftOut,      ///< count: points of curves with fewer than two points
        CurveCellsLeftOut,  ///< count: rows of semilandmarks with more data than a position
        MissingHadPosition, ///< count: points marked as missing that have coordinates nevertheless
        BlanksLeftOut,      ///< count: names and other texts with blanks around them and no quotes
        CommentsLeftOut,    ///< count: lines
        HeaderMissing,      ///< detail: the assumed columns of the table
        DecimalCommas,      ///< the table's numbers have a decimal comma
        EmptyRowsLeftOut,   ///< count: rows of separators only, after the table's last point
        RowNamesLeftOut,    ///< count: row names of R that are no numbers, beside a column of names
        ApostrophesLeftOut, ///< count: texts of another program's table with an apostrophe before an apparent formula
        NegativeIsMissing,  ///< count: points whose coordinates are all -1, tpsDig's form of missing ones
        CodeIsMissing,      ///< coordinates that are all 9999 or all -9999
        MissingCodeUnknown, ///< the file says that values are missing, and not by which number
        PreviewsLeftOut,    ///< count: points under 3D Slicer's mouse that were not placed yet
        LinksLeftOut,       ///< count: pairs of points that a file connects by lines
    };
    Kind kind;
    std::size_t count = 0;
    std::string detail; ///< UTF-8
    friend bool operator==(const LandmarkNote &, const LandmarkNote &) = default;
};

/// A note as a sentence for users, without a full stop. English.
std::string noteText(const LandmarkNote &note);

/// A note and its file.
struct FileNote {
    std::string file; ///< UTF-8
    LandmarkNote note;
};
/// Notes as lines "FILE: what". More than three of one kind become one line: with their sum if they
/// are equal, else with the first and the number of similar ones. Changed names are all listed.
std::vector<std::string> noteLines(const std::vector<FileNote> &notes);

/// The reason why landmarks could not be read or written.
struct LandmarkFileError {
    enum class Code {
        NotFound,
        IsDirectory,
        NotReadable,
        NotWritable,   ///< detail: the reason
        UnknownFormat, ///< the suffix belongs to no known format
        NotWritten,    ///< the suffix belongs to no writable format
        TooLarge,
        Malformed,  ///< line, detail: the error there and its remedy
        CannotHold, ///< detail: the property that the format cannot hold at all, and the remedy
    };
    Code code = Code::Malformed;
    std::string file;     ///< UTF-8, as given
    std::size_t line = 0; ///< counted from 1; 0: no line
    std::string detail;   ///< UTF-8, English
};

/// "points.csv:3: …", one sentence.
std::string errorText(const LandmarkFileError &error);

struct ReadLandmarks {
    std::vector<landmarks::LandmarkSet> sets; ///< one per specimen, at least one
    std::vector<LandmarkNote> notes;
};
struct WrittenLandmarks {
    std::string text;
    std::vector<LandmarkNote> notes;
};

/// The largest size of a landmark file, for reading and writing.
constexpr std::size_t kMostLandmarkBytes = std::size_t{64} << 20;

/// Parses the text of a landmark file. Every number is read to the nearest double, in any system
/// language.
/// @param text  UTF-8, with or without a byte order mark
/// @param name  of the file, for the error
/// @return TooLarge, Malformed
geometry::Result<ReadLandmarks, LandmarkFileError> parseLandmarks(std::string_view text, Format format,
                                                                  const std::string &name);

/// The text of a landmark file. Every coordinate has the fewest digits that read back to the same
/// double. The notes list what the format cannot hold.
///
/// Semilandmarks of curves are written with the landmarks: in CSV with all data of the curve, in
/// .mrk.json as markups of type Curve, in TPS as CURVES and POINTS, in the other formats as further
/// points, "NAME:02". An end of a curve that is a landmark is not written again, except in
/// .mrk.json.
/// @param sets   one per specimen
/// @param texts  for tables, which read back unchanged in either case
/// @return CannotHold: several specimens where the format has one, or specimens with different
///         numbers of points where it has a table; a name that is not UTF-8 in JSON; more than
///         kMostLandmarkBytes
geometry::Result<WrittenLandmarks, LandmarkFileError> landmarksText(std::span<const landmarks::LandmarkSet> sets,
                                                                    Format format,
                                                                    base::CellTexts texts = base::CellTexts::ReadBack);

/// Converts trailing points "NAME:01", "NAME:02" and so on without a gap to curves with
/// semilandmarks only. Formats without curves name semilandmarks so. The first one may be
/// "NAME:02": an end that is a landmark is not written again. At least one other point must remain.
/// @return number of curves appended to the set
std::size_t takeSemilandmarks(landmarks::LandmarkSet &set);

/// Reads a file by its suffix.
/// @return UnknownFormat, NotFound, IsDirectory, NotReadable, and the errors of parseLandmarks
geometry::Result<ReadLandmarks, LandmarkFileError> readLandmarkFile(const std::filesystem::path &file);

/// Writes a file by its suffix, through a new file beside it.
/// @return the losses; NotWritten, NotWritable, and the errors of landmarksText
geometry::Result<std::vector<LandmarkNote>, LandmarkFileError>
writeLandmarkFile(const std::filesystem::path &file, std::span<const landmarks::LandmarkSet> sets);

} // namespace unprojector::landmark_files
