#include "core/landmark_files/landmark_folder.h"

#include "core/base/csv.h"
#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/system_error.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"
#include "core/landmark_files/measures_file.h"
#include "core/landmark_files/sliders.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace unprojector::landmark_files {
using namespace landmarks;
using namespace base;
namespace {

/// True if a name without its last suffix ends in ".mrk", in any case.
bool isMarkup(const std::filesystem::path &stem)
{
    return lowerCase(utf8FromPath(stem.extension())) == ".mrk";
}

/// The number of ".points-2"; 1 for ".points", empty for another suffix.
std::optional<int> placingOfSuffix(const std::string &suffix)
{
    constexpr std::string_view kWord = ".points";
    if (suffix == kWord)
        return 1;
    int number = 0;
    const char *end = suffix.data() + suffix.size();
    const bool isNumber = suffix.starts_with(kWord) && suffix.size() > kWord.size() + 1 && suffix[kWord.size()] == '-'
                          && std::from_chars(suffix.data() + kWord.size() + 1, end, number).ptr == end;
    return isNumber && number >= 1 && number <= kMostPlacings ? std::optional(number) : std::nullopt;
}

/// True for a table that this program made of other files: repeats, errors, or a row a specimen.
bool isResultTable(const std::filesystem::path &file)
{
    if (formatOf(file) != Format::Csv)
        return false;
    std::ifstream opened(file, std::ios::binary);
    std::string line;
    std::getline(opened, line);
    if (line.starts_with("\xef\xbb\xbf"))
        line.erase(0, 3);
    base::CsvReader reader(line, base::csvSeparatorOf(line));
    if (!reader.next())
        return false;
    const auto cell = [&reader](std::size_t i) { return lowerCase(reader.row().text(i)); };
    const std::size_t first = cell(1) == "placing" ? 2 : 1;
    return (cell(0) == "specimen" && cell(2) == "placings" && cell(7) == "farthest")
           || (cell(0) == "landmark" && cell(2) == "placings" && cell(4) == "icc1")
           || (cell(0) == "specimen" && cell(first).ends_with("_x") && cell(first + 1).ends_with("_y")
               && cell(first + 2).ends_with("_z"));
}

/// What a file's landmarks are of: its scan, else the file itself.
std::filesystem::path sourceOf(const std::filesystem::path &file)
{
    std::filesystem::path scan = scanOf(file);
    return scan.empty() ? file : scan;
}

/// The landmark files of a folder, sorted, placings of a scan by number.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path &folder, std::error_code &error)
{
    std::vector<std::filesystem::path> found;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        const std::filesystem::path &file = it->path();
        const std::optional<Format> format = formatOf(file);
        // Other JSON contains no landmarks, and neither do measures, sliders and a series' template.
        const bool isOther = (format == Format::SlicerJson && !isMarkup(file.stem())) || isMeasuresFile(file)
                             || isSlidersFile(file) || file.filename() == seriesTemplate({});
        // A link to nothing is reported as a file that cannot be read.
        const bool isLost = it->is_symlink(ignored) && !it->exists(ignored);
        if (format && !isOther && (it->is_regular_file(ignored) || isLost))
            found.push_back(file);
    }
    // "face.ply.points-2.csv" would come before "face.ply.points.csv". Of two names of one placing, the shorter
    // one is first, in any order of the folder.
    const auto key = [](const std::filesystem::path &file) {
        return std::tuple(sourceOf(file), placingOf(file), file.native().size(), file);
    };
    std::sort(found.begin(), found.end(),
              [&key](const std::filesystem::path &a, const std::filesystem::path &b) { return key(a) < key(b); });
    return found;
}

/// A name in the form of a table format without blanks in names.
std::string withoutBlanks(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c >= 0 && c <= ' '; }, '_');
    return name;
}

/// True if a file is more than an earlier table of the folder: it lies beside a scan, or it has
/// a specimen that the other files lack, or one with the name of the file.
bool holdsMore(const std::filesystem::path &table, const std::vector<LandmarkSet> &others)
{
    if (!scanOf(table).empty())
        return true;
    const auto read = readLandmarkFile(table);
    return read && std::any_of(read->sets.begin(), read->sets.end(), [&](const LandmarkSet &set) {
               return set.name.empty() || set.name == specimenOf(table)
                      || std::none_of(others.begin(), others.end(), [&set](const LandmarkSet &other) {
                             return other.name == set.name || withoutBlanks(other.name) == set.name;
                         });
           });
}

/// Reports two files for one placing of a scan: ".points-2.csv" and ".points-02.csv".
void tellSamePlacing(LandmarkFolder &folder, const std::filesystem::path &file)
{
    const std::filesystem::path scan = scanOf(file);
    for (std::size_t i = 0; i < folder.files.size() && !scan.empty(); ++i) {
        const std::filesystem::path &other = folder.files[i];
        if (scanOf(other) != scan || placingOf(other) != placingOf(file))
            continue;
        folder.reports.push_back(base::tr("%1: this is placing %2 of %3, as %4 is; it counts as another specimen",
                                          utf8FromPath(file), placingOf(file), utf8FromPath(scan.filename()),
                                          utf8FromPath(other.filename())));
        return;
    }
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
    const std::filesystem::path scan = scanOf(file).filename();
    if (scan.empty())
        return utf8FromPath(stem);
    return utf8FromPath(isModelName(scan) ? scan.stem() : scan);
}

bool isModelName(const std::filesystem::path &file)
{
    constexpr std::array<std::string_view, 6> kSuffixes{".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};
    return std::find(kSuffixes.begin(), kSuffixes.end(), lowerCase(utf8FromPath(file.extension()))) != kSuffixes.end();
}

int placingOf(const std::filesystem::path &file)
{
    return placingOfSuffix(utf8FromPath(file.stem().extension())).value_or(1);
}

std::filesystem::path scanOf(const std::filesystem::path &file)
{
    const std::filesystem::path stem = file.stem();
    return placingOfSuffix(utf8FromPath(stem.extension())) ? file.parent_path() / stem.stem() : std::filesystem::path();
}

LandmarkFolder readLandmarkFolder(const std::filesystem::path &folder, std::span<const std::filesystem::path> tables,
                                  std::error_code &error)
{
    LandmarkFolder read;
    std::vector<std::filesystem::path> earlier;
    std::vector<FileNote> notes;
    const std::vector<std::filesystem::path> files = filesIn(folder, error);
    const bool hasScans = std::any_of(files.begin(), files.end(),
                                      [](const std::filesystem::path &file) { return !scanOf(file).empty(); });
    for (const std::filesystem::path &file : files) {
        if (std::any_of(tables.begin(), tables.end(), [&file](const std::filesystem::path &table) {
                return !table.empty() && isSameFile(file, table);
            })) {
            earlier.push_back(file);
            continue;
        }
        const std::string name = utf8FromPath(file);
        ++read.fileCount;
        if (formatOf(file) == Format::MeshLabTemplate) {
            read.reports.push_back(name + ": " + base::tr("a template has names and no points; it is left out"));
            continue;
        }
        if (isResultTable(file)) {
            read.reports.push_back(name + ": "
                                   + base::tr("this is a table that this program made of other files; it is left out"));
            continue;
        }
        auto result = readLandmarkFile(file);
        if (!result) {
            read.reports.push_back(result.error().message());
            read.badFiles.push_back(name);
            continue;
        }
        ReadLandmarks landmarks = std::move(result).value();
        if (hasScans && scanOf(file).empty() && landmarks.sets.size() > 1) {
            read.reports.push_back(
                name + ": "
                + base::tr("it has several specimens, and other files lie beside their scans; it is left out"));
            continue;
        }
        tellSamePlacing(read, file);
        for (const Note &note : landmarks.notes)
            notes.push_back({name, note});
        for (std::size_t i = 0; i < landmarks.sets.size(); ++i) {
            LandmarkSet &set = landmarks.sets[i];
            if (set.name.empty())
                set.name = specimenOf(file) + (landmarks.sets.size() > 1 ? '_' + std::to_string(i + 1) : "");
            if (const int placing = placingOf(file); placing > 1)
                set.placing = placing;
            // a.pp beside a.pts: each is a specimen of its own. Placings of one scan are not.
            const std::filesystem::path source = sourceOf(file);
            const auto isTaken = [&](const std::string &wanted) {
                for (std::size_t k = 0; k < read.sets.size(); ++k) {
                    if (read.sets[k].name == wanted
                        && (sourceOf(read.files[k]) != source || read.sets[k].placing == set.placing))
                        return true;
                }
                return false;
            };
            const std::string plain = set.name + " (" + utf8FromPath(source.filename()) + ')';
            if (isTaken(set.name))
                set.name = plain;
            for (int number = 2; isTaken(set.name); ++number)
                set.name = plain + ' ' + std::to_string(number);
            read.sets.push_back(std::move(set));
            read.files.push_back(file);
        }
    }
    std::vector<std::string> lines = noteLines(notes);
    read.reports.insert(read.reports.end(), std::make_move_iterator(lines.begin()),
                        std::make_move_iterator(lines.end()));
    std::copy_if(earlier.begin(), earlier.end(), std::back_inserter(read.tableInputs),
                 [&read](const std::filesystem::path &file) { return holdsMore(file, read.sets); });
    return read;
}

std::string folderErrorText(const std::filesystem::path &folder, const std::error_code &error)
{
    return base::tr("%1: the folder cannot be read: %2", utf8FromPath(folder), base::systemErrorText(error));
}

} // namespace unprojector::landmark_files
