#include "core/landmark_files/landmark_folder.h"

#include "core/files/path_text.h"
#include "core/files/replace_file.h"
#include "core/landmark_files/lines.h"
#include "core/landmark_files/sliders.h"
#include "core/text/system_error.h"
#include "core/text/translation.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

namespace unprojector::landmark_files {
using namespace landmarks;
using namespace files;
namespace {

/// True if a name without its last suffix ends in ".mrk", in any case.
bool isMarkup(const std::filesystem::path &stem)
{
    return lowerCase(utf8FromPath(stem.extension())) == ".mrk";
}

/// True for ".points" and ".points-2".
bool isPlacing(const std::string &suffix)
{
    constexpr std::string_view kWord = ".points";
    if (!suffix.starts_with(kWord))
        return false;
    const std::string_view number = std::string_view(suffix).substr(kWord.size());
    return number.empty()
           || (number.size() > 1 && number.front() == '-'
               && number.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

bool isModel(const std::string &suffix)
{
    constexpr std::array<std::string_view, 6> kSuffixes{".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};
    return std::find(kSuffixes.begin(), kSuffixes.end(), lowerCase(suffix)) != kSuffixes.end();
}

/// The landmark files of a folder, sorted.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path &folder, std::error_code &error)
{
    std::vector<std::filesystem::path> found;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        const std::filesystem::path &file = it->path();
        const std::optional<Format> format = formatOf(file);
        // Other JSON contains no landmarks, and neither do sliders and a series' template.
        const bool isOther = (format == Format::SlicerJson && !isMarkup(file.stem())) || isSlidersFile(file)
                             || file.filename() == seriesTemplate({});
        if (format && !isOther && it->is_regular_file(ignored))
            found.push_back(file);
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// A name in the form of a table format without blanks in names.
std::string withoutBlanks(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c >= 0 && c <= ' '; }, '_');
    return name;
}

/// True if a file is more than an earlier table of the folder: it has a specimen that the other
/// files lack, or one with the name of the file.
bool holdsMore(const std::filesystem::path &table, const std::vector<LandmarkSet> &others)
{
    const auto read = readLandmarkFile(table);
    return read && std::any_of(read->sets.begin(), read->sets.end(), [&](const LandmarkSet &set) {
               return set.name.empty() || set.name == specimenOf(table)
                      || std::none_of(others.begin(), others.end(), [&set](const LandmarkSet &other) {
                             return other.name == set.name || withoutBlanks(other.name) == set.name;
                         });
           });
}

} // namespace

std::filesystem::path landmarksBeside(const std::filesystem::path &scan, int placing)
{
    std::filesystem::path file = scan;
    file += placing > 1 ? ".points-" + std::to_string(placing) + ".csv" : std::string(".points.csv");
    return file;
}

std::filesystem::path seriesTemplate(const std::filesystem::path &folder)
{
    return folder / "series-template.csv";
}

std::string specimenOf(const std::filesystem::path &file)
{
    const std::filesystem::path stem = file.stem();
    if (isMarkup(stem))
        return utf8FromPath(stem.stem());
    if (!isPlacing(utf8FromPath(stem.extension())))
        return utf8FromPath(stem);
    const std::filesystem::path scan = stem.stem();
    return utf8FromPath(isModel(utf8FromPath(scan.extension())) ? scan.stem() : scan);
}

LandmarkFolder readLandmarkFolder(const std::filesystem::path &folder, const std::filesystem::path &table,
                                  std::error_code &error)
{
    LandmarkFolder read;
    std::filesystem::path earlier;
    std::vector<FileNote> notes;
    for (const std::filesystem::path &file : filesIn(folder, error)) {
        if (!table.empty() && isSameFile(file, table)) {
            earlier = file;
            continue;
        }
        const std::string name = utf8FromPath(file);
        ++read.fileCount;
        if (formatOf(file) == Format::MeshLabTemplate) {
            read.reports.push_back(name + ": " + text::tr("a template has names and no points; it is left out"));
            continue;
        }
        auto result = readLandmarkFile(file);
        if (!result) {
            read.reports.push_back(errorText(result.error()));
            read.badFiles.push_back(name);
            continue;
        }
        ReadLandmarks landmarks = std::move(result).value();
        for (const LandmarkNote &note : landmarks.notes)
            notes.push_back({name, note});
        for (std::size_t i = 0; i < landmarks.sets.size(); ++i) {
            LandmarkSet &set = landmarks.sets[i];
            if (set.name.empty())
                set.name = specimenOf(file) + (landmarks.sets.size() > 1 ? '_' + std::to_string(i + 1) : "");
            // a.pp beside a.pts: each is a specimen of its own.
            if (std::any_of(read.sets.begin(), read.sets.end(),
                            [&set](const LandmarkSet &other) { return other.name == set.name; }))
                set.name += " (" + utf8FromPath(file.filename()) + ')';
            read.sets.push_back(std::move(set));
        }
    }
    std::vector<std::string> lines = noteLines(notes);
    read.reports.insert(read.reports.end(), std::make_move_iterator(lines.begin()),
                        std::make_move_iterator(lines.end()));
    read.isTableInput = !earlier.empty() && holdsMore(earlier, read.sets);
    return read;
}

std::string folderErrorText(const std::filesystem::path &folder, const std::error_code &error)
{
    return text::tr("%1: the folder cannot be read: %2", utf8FromPath(folder), text::systemErrorText(error));
}

} // namespace unprojector::landmark_files
