#pragma once

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/base/note.h"
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

/// The format of a file to write by its suffix.
/// @return an error without a file for another suffix
base::Expected<Format, base::Error> writtenFormatOf(const std::filesystem::path &file);

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

/// A note and its file.
struct FileNote {
    std::string file; ///< UTF-8
    base::Note note;
};
/// Notes as lines "FILE: what". More than three of one kind become one line: with their sum if they
/// are equal, else with the first and the number of similar ones. Changed names are all listed.
std::vector<std::string> noteLines(const std::vector<FileNote> &notes);

/// The note about repeated placings that a format would have as more specimens.
base::Note repeatsLeftOut(std::size_t count);

struct ReadLandmarks {
    std::vector<landmarks::LandmarkSet> sets; ///< one per specimen, at least one
    std::vector<base::Note> notes;
};
struct WrittenLandmarks {
    std::string text;
    std::vector<base::Note> notes;
};

/// The largest size of a landmark file, for reading and writing.
constexpr std::size_t kMostLandmarkBytes = std::size_t{64} << 20;

/// Parses the text of a landmark file. Every number is read to the nearest double, in any system
/// language.
/// @param text  UTF-8, with or without a byte order mark
/// @param name  of the file, for the error
base::Expected<ReadLandmarks, base::Error> parseLandmarks(std::string_view text, Format format,
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
/// @return an error without a file: several specimens where the format has one, or specimens with different
///         numbers of points where it has a table; a name that is not UTF-8 in JSON; more than
///         kMostLandmarkBytes
base::Expected<WrittenLandmarks, base::Error> landmarksText(std::span<const landmarks::LandmarkSet> sets, Format format,
                                                            base::CellTexts texts = base::CellTexts::ReadBack);

/// Converts trailing points "NAME:01", "NAME:02" and so on without a gap to curves with
/// semilandmarks only. Formats without curves name semilandmarks so. The first one may be
/// "NAME:02": an end that is a landmark is not written again. At least one other point must remain.
/// @return number of curves appended to the set
std::size_t takeSemilandmarks(landmarks::LandmarkSet &set);

/// Reads a file by its suffix.
base::Expected<ReadLandmarks, base::Error> readLandmarkFile(const std::filesystem::path &file);

/// Writes a file by its suffix, through a new file beside it.
/// @return the losses
base::Expected<std::vector<base::Note>, base::Error> writeLandmarkFile(const std::filesystem::path &file,
                                                                       std::span<const landmarks::LandmarkSet> sets);

} // namespace unprojector::landmark_files
