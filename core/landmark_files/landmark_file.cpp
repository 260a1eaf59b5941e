#include "core/landmark_files/landmark_file.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"
#include "core/landmark_files/lines.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::landmark_files {
using namespace landmarks;
using namespace base;
using geometry::Result;

const char *suffixOf(Format format)
{
    switch (format) {
    case Format::Csv: return "csv";
    case Format::MeshLab: return "pp";
    case Format::MeshLabTemplate: return "pptpl";
    case Format::SlicerJson: return "mrk.json";
    case Format::SlicerCsv: return "fcsv";
    case Format::Idav: return "pts";
    case Format::Tps: return "tps";
    case Format::Nts: return "nts";
    case Format::LandmarkAscii: return "landmarkAscii";
    case Format::Landmarker: return "ljson";
    }
    return "";
}

std::optional<Format> formatOfSuffix(std::string_view suffix)
{
    const std::string lower = lowerCase(suffix);
    for (const Format format : kFormats) {
        if (lower == lowerCase(suffixOf(format)))
            return format;
    }
    return lower == "dta" ? std::optional(Format::Nts) : std::nullopt;
}

std::optional<Format> formatOf(const std::filesystem::path &file)
{
    const std::string suffix = utf8FromPath(file.extension());
    if (lowerCase(suffix) == ".json")
        return Format::SlicerJson;
    return suffix.empty() ? std::nullopt : formatOfSuffix(std::string_view(suffix).substr(1));
}

std::optional<Format> readFormatOf(const std::filesystem::path &file)
{
    const std::string suffix = lowerCase(utf8FromPath(file.extension()));
    return suffix == ".txt" || suffix == ".tsv" ? std::optional(Format::Csv) : formatOf(file);
}

namespace {

template <class Is>
std::string wordsWhere(const Is &is)
{
    std::string words;
    for (const Format format : kFormats) {
        if (is(format))
            words += (words.empty() ? "" : ", ") + std::string(suffixOf(format));
    }
    return words;
}

} // namespace

std::string readWords()
{
    return wordsWhere([](Format) { return true; });
}

std::string writtenWords()
{
    return wordsWhere(isWritten);
}

Result<ReadLandmarks, LandmarkFileError> parseLandmarks(std::string_view text, Format format, const std::string &name)
{
    try {
        if (text.size() > kMostLandmarkBytes)
            throw Failure{0, {}, LandmarkFileError::Code::TooLarge};
        if (text.find('\0') != text.npos || text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
            throw Failure{0, tr("this is not a text in UTF-8; save it as UTF-8")};
        // A name in Latin-1, if written unchanged, would make an XML or JSON file that other
        // programs reject.
        if (const std::size_t end = base::firstNotUtf8(text); end != text.npos)
            throw Failure{static_cast<std::size_t>(std::count(text.begin(), text.begin() + end, '\n')) + 1,
                          tr("this is not UTF-8; save the file as UTF-8")};
        if (text.starts_with("\xef\xbb\xbf"))
            text.remove_prefix(3);
        switch (format) {
        case Format::Csv: return readCsv(text);
        case Format::MeshLab: return readMeshLab(text, false);
        case Format::MeshLabTemplate: return readMeshLab(text, true);
        case Format::SlicerJson: return readSlicerJson(text);
        case Format::SlicerCsv: return readSlicerCsv(text);
        case Format::Idav: return readIdav(text);
        case Format::Tps: return readTps(text);
        case Format::Nts: return readNts(text);
        case Format::LandmarkAscii: return readAmira(text);
        case Format::Landmarker: return readLandmarker(text);
        }
        return LandmarkFileError{LandmarkFileError::Code::UnknownFormat, name, 0, {}};
    } catch (const Failure &failure) {
        return failure.in(name);
    }
}

namespace {

/// The only set; throws Failure if there are several.
const LandmarkSet &onlyOf(std::span<const LandmarkSet> sets, Format format)
{
    if (sets.size() == 1)
        return sets.front();
    throw Failure{0,
                  tr(".%1 holds one specimen, and there are %2; take .csv, .tps, .nts or .mrk.json", suffixOf(format),
                     sets.size()),
                  LandmarkFileError::Code::CannotHold};
}

std::string textOf(std::span<const LandmarkSet> sets, Format format, base::CellTexts texts, Notes &notes)
{
    switch (format) {
    case Format::Csv: return csvText(sets, texts, notes);
    case Format::MeshLab: return meshLabText(onlyOf(sets, format), notes);
    case Format::MeshLabTemplate: return meshLabTemplateText(onlyOf(sets, format), notes);
    case Format::SlicerJson: return slicerJsonText(sets, notes);
    case Format::SlicerCsv: return slicerCsvText(onlyOf(sets, format), notes);
    case Format::Idav: return idavText(onlyOf(sets, format), notes);
    case Format::Tps: return tpsText(sets, notes);
    case Format::Nts: return ntsText(sets, notes);
    case Format::LandmarkAscii:
    case Format::Landmarker: throw Failure{0, {}, LandmarkFileError::Code::NotWritten};
    }
    return {};
}

/// The least number of bytes of a point in .mrk.json.
constexpr std::size_t kLeastJsonBytes = 200;

} // namespace

void checkSize(std::size_t bytes)
{
    if (bytes > kMostLandmarkBytes)
        throw Failure{0,
                      tr("the file would have %1 MiB or more, and a file of landmarks may have at most %2 MiB; write "
                         "fewer points, or a format that takes less",
                         (bytes >> 20) + 1, kMostLandmarkBytes >> 20),
                      LandmarkFileError::Code::CannotHold};
}

Result<WrittenLandmarks, LandmarkFileError> landmarksText(std::span<const LandmarkSet> sets, Format format,
                                                          base::CellTexts texts)
{
    Notes notes;
    try {
        const bool hasCurves =
            std::any_of(sets.begin(), sets.end(), [](const LandmarkSet &set) { return !set.curves.empty(); });
        std::vector<LandmarkSet> plain;
        const bool holdsCurves = format == Format::Csv || format == Format::Tps || format == Format::SlicerJson;
        if (hasCurves && !holdsCurves) {
            plain = withCurvesAsPoints(sets, notes);
            sets = plain;
        }
        if (format == Format::SlicerJson) { // check before gigabytes are built
            std::size_t points = 0;
            for (const LandmarkSet &set : sets) {
                points += set.landmarks.size();
                for (const Curve &curve : set.curves)
                    points += curve.semilandmarks.size();
            }
            checkSize(points * kLeastJsonBytes);
        }
        std::string text = textOf(sets, format, texts, notes);
        checkSize(text.size());
        return WrittenLandmarks{std::move(text), notes.take()};
    } catch (const Failure &failure) {
        return failure.in({});
    }
}

Result<std::string, LandmarkFileError> readText(const std::filesystem::path &file)
{
    const auto failed = [&file](LandmarkFileError::Code code) {
        return LandmarkFileError{code, utf8FromPath(file), 0, {}};
    };
    std::error_code system;
    const std::filesystem::file_status status = std::filesystem::status(file, system);
    if (status.type() == std::filesystem::file_type::not_found)
        return failed(LandmarkFileError::Code::NotFound);
    if (std::filesystem::is_directory(status))
        return failed(LandmarkFileError::Code::IsDirectory);
    std::ifstream stream;
    if (std::filesystem::is_regular_file(status)) // opening a named pipe may block forever
        stream.open(file, std::ios::binary);
    if (!stream.is_open())
        return failed(LandmarkFileError::Code::NotReadable);
    std::string text;
    std::array<char, 65536> block;
    do {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream && text.size() <= kMostLandmarkBytes);
    if (stream.bad())
        return failed(LandmarkFileError::Code::NotReadable);
    return text;
}

Result<ReadLandmarks, LandmarkFileError> readLandmarkFile(const std::filesystem::path &file)
{
    const std::string name = utf8FromPath(file);
    const std::optional<Format> format = readFormatOf(file);
    if (!format)
        return LandmarkFileError{LandmarkFileError::Code::UnknownFormat, name, 0, {}};
    const Result<std::string, LandmarkFileError> text = readText(file);
    if (!text)
        return text.error();
    return parseLandmarks(*text, *format, name);
}

Result<std::vector<LandmarkNote>, LandmarkFileError> writeLandmarkFile(const std::filesystem::path &file,
                                                                       std::span<const LandmarkSet> sets)
{
    const std::string name = utf8FromPath(file);
    const std::optional<Format> format = formatOf(file);
    if (!format)
        return LandmarkFileError{LandmarkFileError::Code::NotWritten, name, 0, {}};
    const Result<WrittenLandmarks, LandmarkFileError> text = landmarksText(sets, *format);
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = name;
        return error;
    }
    if (const Done written = replaceFile(file, text->text); !written)
        return LandmarkFileError{LandmarkFileError::Code::NotWritable, name, 0, written.error().text};
    return text->notes;
}

} // namespace unprojector::landmark_files
