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
namespace {

struct FormatRow {
    const char *suffix;
    ReadLandmarks (*read)(std::string_view);
    std::string (*write)(std::span<const LandmarkSet>, Notes &); ///< null for csvText
    bool holdsSpecimens, holdsCurves;
    unsigned held;
    std::vector<std::string_view> ownKeys = {};
};

const FormatRow &rowOf(Format format)
{
    static const std::array<FormatRow, kFormats.size()> kRows{{
        {"csv", readCsv, nullptr, true, true, ~HeldSpecimenKeys},
        {"pp", readMeshLab, meshLabText, false, false, HeldNames | HeldPositions | HeldSpecimenKeys | HeldMesh},
        {"pptpl", readMeshLabTemplate, meshLabTemplateText, false, false, HeldNames | HeldAbsences},
        {"mrk.json", readSlicerJson, slicerJsonText, true, true,
         HeldNames | HeldPositions | HeldNotes | HeldHidden | HeldKeys | HeldAbsences | HeldSpecimenKeys
             | HeldSpecimenName | HeldUnit},
        {"fcsv",
         readSlicerCsv,
         slicerCsvText,
         false,
         false,
         HeldNames | HeldPositions | HeldNotes | HeldHidden | HeldAbsences,
         {"id", "ow", "ox", "oy", "oz", "selected", "locked", "associatedNodeID", "autoCreated"}},
        {"pts", readIdav, idavText, false, false, HeldNames | HeldPositions},
        {"tps", readTps, tpsText, true, true,
         HeldPositions | HeldSpecimenKeys | HeldSpecimenName | HeldPlacings | HeldMesh},
        {"nts", readNts, ntsText, true, false, HeldPositions | HeldSpecimenName},
        {"landmarkAscii", readAmira, nullptr, false, false, 0},
        {"ljson", readLandmarker, nullptr, false, false, 0},
    }};
    return kRows[static_cast<std::size_t>(format)];
}

std::string wordsWhere(bool (*is)(Format))
{
    std::string words;
    for (const Format format : kFormats) {
        if (is(format))
            words += (words.empty() ? "" : ", ") + std::string(suffixOf(format));
    }
    return words;
}

/// The error for another suffix than those of formats: ".csv, .pp or .tps".
Error wrongSuffix(bool (*is)(Format))
{
    std::string list, last;
    for (const Format format : kFormats) {
        if (!is(format))
            continue;
        if (!last.empty())
            list += (list.empty() ? "" : ", ") + last;
        last = '.' + std::string(suffixOf(format));
    }
    return {tr("the name must end in %1", tr("%1 or %2", list, last))};
}

bool isRead(Format)
{
    return true;
}

} // namespace

const char *suffixOf(Format format)
{
    return rowOf(format).suffix;
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

Expected<Format, Error> writtenFormatOf(const std::filesystem::path &file)
{
    const std::optional<Format> format = formatOf(file);
    if (format && isWritten(*format))
        return *format;
    return wrongSuffix(isWritten);
}

std::string readWords()
{
    return wordsWhere(isRead);
}

std::string writtenWords()
{
    return wordsWhere(isWritten);
}

void checkText(std::string_view &text)
{
    if (text.size() > kMostLandmarkBytes)
        fail(0, tr("a file of landmarks may have at most %1 MiB", kMostLandmarkBytes >> 20));
    if (text.find('\0') != text.npos || text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        fail(0, tr("this is not a text in UTF-8; save it as UTF-8"));
    // A name in Latin-1, if written unchanged, would make an XML or JSON file that other
    // programs reject.
    if (const std::size_t end = firstNotUtf8(text); end != text.npos)
        fail(static_cast<std::size_t>(std::count(text.begin(), text.begin() + end, '\n')) + 1,
             tr("this is not UTF-8; save the file as UTF-8"));
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
}

Expected<ReadLandmarks, Error> parseLandmarks(std::string_view text, Format format, const std::string &name)
{
    const auto parse = [&] {
        checkText(text);
        return rowOf(format).read(text);
    };
    return caught(parse, name);
}

std::string textOf(std::span<const LandmarkSet> sets, Format format, CellTexts texts, Notes &notes,
                   const std::string &absent)
{
    const FormatRow &row = rowOf(format);
    if (!isWritten(format))
        throw wrongSuffix(isWritten);
    if (sets.size() != 1 && !row.holdsSpecimens)
        fail(0, tr(".%1 holds one specimen, and there are %2; take .csv, .tps, .nts or .mrk.json", row.suffix,
                   sets.size()));
    addLosses(notes, sets, row.held, row.ownKeys);
    return row.write ? row.write(sets, notes) : csvText(sets, texts, notes, absent);
}

void checkSize(std::size_t bytes)
{
    if (bytes > kMostLandmarkBytes)
        fail(0, tr("the file would have %1 MiB or more, and a file of landmarks may have at most %2 MiB; write "
                   "fewer points, or a format that takes less",
                   (bytes >> 20) + 1, kMostLandmarkBytes >> 20));
}

Expected<WrittenLandmarks, Error> landmarksText(std::span<const LandmarkSet> sets, Format format, CellTexts texts)
{
    return caught([&] {
        Notes notes;
        const std::vector<LandmarkSet> plain =
            rowOf(format).holdsCurves ? std::vector<LandmarkSet>() : withCurvesAsPoints(sets, notes);
        WrittenLandmarks written{textOf(rowOf(format).holdsCurves ? sets : std::span(plain), format, texts, notes), {}};
        checkSize(written.text.size());
        written.notes = notes.take();
        return written;
    });
}

Expected<std::string, Error> readText(const std::filesystem::path &file)
{
    const auto failed = [&file](Error::Kind kind, std::string text) {
        return Error{.text = std::move(text), .file = utf8FromPath(file), .kind = kind};
    };
    const auto notReadable = [&] {
        return failed(Error::Kind::File, tr("the file cannot be read; check its permissions"));
    };
    std::error_code system;
    const std::filesystem::file_status status = std::filesystem::status(file, system);
    if (status.type() == std::filesystem::file_type::not_found)
        return failed(Error::Kind::NoFile, tr("there is no such file"));
    if (std::filesystem::is_directory(status))
        return failed(Error::Kind::File, tr("this is a folder, not a file of landmarks"));
    std::ifstream stream;
    if (std::filesystem::is_regular_file(status)) // opening a named pipe may block forever
        stream.open(file, std::ios::binary);
    if (!stream.is_open())
        return notReadable();
    std::string text;
    std::array<char, 65536> block;
    do {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream && text.size() <= kMostLandmarkBytes);
    if (stream.bad())
        return notReadable();
    return text;
}

Expected<ReadLandmarks, Error> readLandmarkFile(const std::filesystem::path &file)
{
    const std::optional<Format> format = readFormatOf(file);
    if (!format) {
        Error error = wrongSuffix(isRead);
        error.file = utf8FromPath(file);
        return error;
    }
    const Expected<std::string, Error> text = readText(file);
    if (!text)
        return text.error();
    return parseLandmarks(*text, *format, utf8FromPath(file));
}

Expected<std::vector<Note>, Error> writeLandmarkFile(const std::filesystem::path &file,
                                                     std::span<const LandmarkSet> sets)
{
    const auto write = [&] {
        const Expected<Format, Error> format = writtenFormatOf(file);
        if (!format)
            throw format.error();
        const Expected<WrittenLandmarks, Error> text = landmarksText(sets, *format);
        if (!text)
            throw text.error();
        if (const Done written = replaceFile(file, text->text); !written)
            throw written.error();
        return text->notes;
    };
    return caught(write, utf8FromPath(file));
}

} // namespace unprojector::landmark_files
