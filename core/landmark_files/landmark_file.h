#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/text/csv.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::landmark_files {

/// The files that landmarks are exchanged by.
enum class Format {
    Csv,             ///< our own, `name,x,y,z,object,face,u,v,w,note`; the one that keeps most, curves too
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
/// Whether a format can be written; each can be read.
constexpr bool isWritten(Format format)
{
    return format != Format::LandmarkAscii && format != Format::Landmarker;
}

/// The suffix of a format, and the word for it: "csv", "pp", "mrk.json", …
const char *suffixOf(Format format);
/// The format of that suffix, in whatever case; nothing where there is none. "dta" is NTSYS's too.
std::optional<Format> formatOfSuffix(std::string_view suffix);
/// The format that a file's name ends in. "x.json" is one of 3D Slicer's too.
std::optional<Format> formatOf(const std::filesystem::path &file);
/// The same of a file that is to be read: "x.txt" and "x.tsv" are tables.
std::optional<Format> readFormatOf(const std::filesystem::path &file);
/// "csv, pp, mrk.json", as choices.
std::string readWords();
std::string writtenWords();

/// What of landmarks did not pass through a file as it was.
struct LandmarkNote {
    enum class Kind {
        // Writing: what the format has no place for. count: how many landmarks (or specimens) have it.
        NamesLeftOut,
        PositionsLeftOut,
        ObjectsLeftOut,
        HoldsLeftOut, ///< the triangle, vertex or edge
        UncertaintiesLeftOut,
        NotesLeftOut,
        ColorsLeftOut,
        HiddenLeftOut,
        KeysLeftOut,         ///< detail: their names
        SpecimenKeysLeftOut, ///< detail: their names
        SpecimenNameLeftOut, ///< detail: the name
        MeshLeftOut,         ///< detail: the file's name
        UnitLeftOut,         ///< detail: the unit
        // Writing: what is written otherwise.
        NameChanged,          ///< detail: both names in quotes
        NoteChanged,          ///< detail: whose
        EmptySpecimenLeftOut, ///< detail: its name; it has no landmarks, and a table no row for it
        LooksMissing,         ///< detail: whose; a coordinate of it is the format's word for "missing"
        MissingAtOrigin,      ///< count: older readers take them to be at 0, 0, 0
        CurvesAsPoints,       ///< count: semilandmarks
        CurvesUnnamed,        ///< count: curves, of which only the semilandmarks are kept
        UnitUnknown,          ///< detail: which file's, beside one that has a unit
        CurveUnknown,         ///< detail: its name; nobody has worked out where it goes
        // Reading: what is not kept as it was.
        AxesTurned,         ///< the file is in RAS
        FlatPoints,         ///< count: of two coordinates, z is 0
        Scaled,             ///< detail: the factor that coordinates were multiplied by
        CurvesLeftOut,      ///< count: points of curves that have fewer than two
        CurveCellsLeftOut,  ///< count: rows of semilandmarks that say more than where they are
        MissingHadPosition, ///< count: points that are not placed and have coordinates all the same
        BlanksLeftOut,      ///< count: names and other texts that have blanks around them and no quotes
        CommentsLeftOut,    ///< count: lines
        HeaderMissing,      ///< detail: what the columns of the table are taken for
        DecimalCommas,      ///< the table's numbers have a decimal comma
        EmptyRowsLeftOut,   ///< count: rows of a table behind its last point that have nothing but separators
        RowNamesLeftOut,    ///< count: row names of R that are no numbers, beside a column of names
        ApostrophesLeftOut, ///< count: texts of a table of others that have one before what looks like a formula
        NegativeIsMissing,  ///< count: points whose coordinates are all -1, as tpsDig writes missing ones
        LinksLeftOut,       ///< count: pairs of points that a file joins by lines
    };
    Kind kind;
    std::size_t count = 0;
    std::string detail; ///< UTF-8
    friend bool operator==(const LandmarkNote &, const LandmarkNote &) = default;
};

/// A note as a sentence for people, without a full stop. English.
std::string noteText(const LandmarkNote &note);

/// A note and the file that it is about.
struct FileNote {
    std::string file; ///< UTF-8
    LandmarkNote note;
};
/// Notes as lines "FILE: what". More than three of one kind are one line: with their sum where they say the same, else
/// with the first and how many are like it. Changed names are all listed.
std::vector<std::string> noteLines(const std::vector<FileNote> &notes);

/// Why landmarks could not be read or written.
struct LandmarkFileError {
    enum class Code {
        NotFound,
        IsDirectory,
        NotReadable,
        NotWritable,   ///< detail: files::fileErrorText
        UnknownFormat, ///< the suffix is none of ours
        NotWritten,    ///< the suffix is of no format that is written
        TooLarge,
        Malformed,  ///< line, detail: what is wrong there and what to do
        CannotHold, ///< detail: what the format cannot have at all, and what to do
    };
    Code code = Code::Malformed;
    std::string file;     ///< UTF-8, as it was given
    std::size_t line = 0; ///< counted from 1; 0: no line
    std::string detail;   ///< UTF-8, English
};

/// "points.csv:3: …", one sentence.
std::string errorText(const LandmarkFileError &error);

struct ReadLandmarks {
    std::vector<landmarks::LandmarkSet> sets; ///< one a specimen, at least one
    std::vector<LandmarkNote> notes;
};
struct WrittenLandmarks {
    std::string text;
    std::vector<LandmarkNote> notes;
};

/// No file of landmarks is larger, neither one that is read nor one that is written.
constexpr std::size_t kMostLandmarkBytes = std::size_t{64} << 20;

/// Reads the text of a file of landmarks. Every number is read to the nearest double, whatever the system's language.
/// @param text  UTF-8, with or without a byte order mark
/// @param name  of the file, for the error
/// @return TooLarge, Malformed
geometry::Result<ReadLandmarks, LandmarkFileError> parseLandmarks(std::string_view text, Format format,
                                                                  const std::string &name);

/// The text of a file of landmarks. Every coordinate is written in the fewest digits that read back to the same double; what
/// the format has no place for is said in the notes. Semilandmarks of curves are written with the landmarks: in CSV with all that
/// the curve is, in TPS as CURVES and POINTS, in the others as further points, "NAME:01".
/// @param sets   one a specimen
/// @param texts  of tables, which are read back as they were in either case
/// @return CannotHold: several specimens where the format has one, or specimens of different numbers of points where it
///         has a table; a name that is not UTF-8 in JSON; more than kMostLandmarkBytes
geometry::Result<WrittenLandmarks, LandmarkFileError> landmarksText(std::span<const landmarks::LandmarkSet> sets,
                                                                    Format format,
                                                                    text::CellTexts texts = text::CellTexts::AsTheyAre);

/// A table with one row a specimen: specimen,A_x,A_y,A_z,B_x,… The columns are the landmarks of all specimens by name, in
/// the order in which they first appear; what a specimen lacks stays empty. Names are those of
/// landmarks::distinctNames. Semilandmarks are further points, "CURVE:01".
WrittenLandmarks wideTable(std::span<const landmarks::LandmarkSet> specimens,
                           text::CellTexts texts = text::CellTexts::AsTheyAre);

/// Takes the last points out that are named as the semilandmarks of curves are where a format knows no curves, "NAME:01",
/// "NAME:02" and so on without a gap, and makes them curves of which only the semilandmarks are known. Points there must be besides.
/// @return how many curves were put behind those of the set
std::size_t takeSemilandmarks(landmarks::LandmarkSet &set);

/// Reads a file by its suffix.
/// @return UnknownFormat, NotFound, IsDirectory, NotReadable, and the errors of parseLandmarks
geometry::Result<ReadLandmarks, LandmarkFileError> readLandmarkFile(const std::filesystem::path &file);

/// Writes a file by its suffix, by way of a new file beside it.
/// @return what was lost; NotWritten, NotWritable, and the errors of landmarksText
geometry::Result<std::vector<LandmarkNote>, LandmarkFileError>
writeLandmarkFile(const std::filesystem::path &file, std::span<const landmarks::LandmarkSet> sets);

} // namespace unprojector::landmark_files
