#include "core/cli/commands/landmarks_command.h"

#include "core/cli/commands/opened_scene.h"
#include "core/cli/rows/byte_stream.h"
#include "core/curves/curve_line.h"
#include "core/curves/surface_mesh.h"
#include "core/files/path_text.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/repeats_table.h"
#include "core/landmark_files/sliders.h"
#include "core/mesh/import/import_error_text.h"
#include "core/mesh/import/mesh_import.h"
#include "core/ray/tie_landmark.h"
#include "core/text/system_error.h"
#include "core/text/translation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace landmarks;
using namespace mesh;
using namespace landmark_files;
using namespace files;
using geometry::Result;
using text::tr;
namespace {

text::CellTexts textsOf(const LandmarksOptions &options)
{
    return options.isSpreadsheetSafe ? text::CellTexts::SpreadsheetSafe : text::CellTexts::AsTheyAre;
}

void tell(const std::string &name, const std::vector<LandmarkNote> &notes)
{
    std::vector<FileNote> ofFile;
    ofFile.reserve(notes.size());
    for (const LandmarkNote &note : notes)
        ofFile.push_back({name, note});
    for (const std::string &line : noteLines(ofFile))
        complain(line);
}

/// Reads a landmark file. Prints errors on stderr.
std::optional<ReadLandmarks> readFile(const std::string &file, Format format)
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    std::string text;
    std::array<char, 65536> block;
    std::size_t size = 0;
    do {
        size = source.read(block.data(), block.size());
        text.append(block.data(), size);
    } while (size > 0 && text.size() <= kMostLandmarkBytes);
    if (source.hasFailed()) {
        complain(tr("%1: the file cannot be read to its end", source.name()));
        return std::nullopt;
    }
    Result<ReadLandmarks, LandmarkFileError> read = parseLandmarks(text, format, source.name());
    if (!read) {
        complain(errorText(read.error()));
        return std::nullopt;
    }
    tell(source.name(), read->notes);
    const auto isEmpty = [](const LandmarkSet &set) { return set.landmarks.empty() && set.curves.empty(); };
    if (std::all_of(read->sets.begin(), read->sets.end(), isEmpty))
        complain(tr("%1: there are no points in the file", source.name()));
    return std::move(read).value();
}

/// @param inputs  inputs of the run: none of them is overwritten
ExitCode write(const std::string &file, const Result<WrittenLandmarks, LandmarkFileError> &text,
               const InputFiles &inputs)
{
    const std::string name = file == "-" ? "stdout" : file;
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = name;
        complain(errorText(error));
        return ExitCode::UnusableInput;
    }
    ByteSink sink(file, inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(text->text);
    const ExitCode written = sink.finish();
    if (written == ExitCode::Done)
        tell(name, text->notes);
    return written;
}

/// Writes the sliders of points that were written. Reports on stderr what it wrote, or why it
/// wrote nothing.
/// @param written  exit code of the points
ExitCode writeSliders(const std::string &file, const Result<Sliders, LandmarkFileError> &sliders,
                      const InputFiles &inputs, ExitCode written)
{
    if (file.empty() || written == ExitCode::UnusableInput)
        return written;
    if (!sliders || sliders->count == 0) {
        complain(
            file + ": "
            + (sliders ? tr("it is not written, because no curve has semilandmarks") : errorText(sliders.error())));
        return ExitCode::SomeRowsBad;
    }
    ByteSink sink(file, inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(sliders->text);
    if (const ExitCode finished = sink.finish(); finished != ExitCode::Done)
        return finished;
    complain(file + ": "
             + tr(sliders->count == 1 ? "%1 slider, for geomorph's gpagen(curves=)"
                                      : "%1 sliders, for geomorph's gpagen(curves=)",
                  sliders->count));
    return written;
}

/// The given format of a file, else the one of its suffix. An unknown format is reported on stderr.
std::optional<Format> formatOf(const std::string &file, const std::optional<Format> &given, const char *option)
{
    if (given)
        return given;
    const bool isRead = option == std::string_view("--from");
    const std::optional<Format> format = file == "-" ? std::nullopt
                                         : isRead    ? readFormatOf(pathFromUtf8(file))
                                                     : landmark_files::formatOf(pathFromUtf8(file));
    if (!format) {
        complain(tr("%1: the name does not tell the format; give %2, one of %3",
                    file != "-"                       ? file
                    : option == std::string("--from") ? "stdin"
                                                      : "stdout",
                    option, isRead ? readWords() : writtenWords()));
    }
    return format;
}

/// "0.0123": three digits suffice for a distance.
std::string shortText(double value)
{
    std::array<char, 32> digits;
    const auto written =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 3);
    return {digits.data(), written.ptr};
}

std::string nameOf(const Landmark &landmark, std::size_t index)
{
    return landmark.name.empty() ? tr("point %1", index + 1) : tr("\"%1\"", landmark.name);
}

/// Moves every landmark to the closest point of the mesh, and reports the distance.
class Tying {
public:
    /// Opens the mesh. Prints errors on stderr.
    static std::optional<Tying> to(const std::string &mesh)
    {
        const std::filesystem::path file = pathFromUtf8(mesh);
        const auto model = mesh::importModel(file, {});
        if (!model) {
            complain(importErrorText(model.error()));
            return std::nullopt;
        }
        return Tying(mesh, utf8FromPath(file.filename()), ray::ClosestPlaces::build(*model, {}));
    }

    void tie(LandmarkSet &set)
    {
        set.mesh = m_target.name;
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            Landmark &landmark = set.landmarks[i];
            const std::optional<ray::Tied> tied = ray::tieToMesh(landmark, {&m_target, 1});
            if (!tied) {
                if (landmark.world)
                    complain(tr("%1: %2 is not moved: its distance from the mesh is not a finite number", m_mesh,
                                nameOf(landmark, i)));
                continue;
            }
            ++m_count;
            if (m_count == 1 || tied->distance > m_farthest) {
                m_farthest = tied->distance;
                m_farthestName = nameOf(landmark, i);
            }
            const double share = m_size > 0.0 ? tied->distance / m_size : tied->distance > 0.0 ? 1.0 : 0.0;
            if (share > ray::kFarFromMesh)
                complain(tr("%1: %2 was %3 from the mesh, %4 % of its size; do the points belong to another mesh, or "
                            "use other axes?",
                            m_mesh, nameOf(landmark, i), shortText(tied->distance), shortText(100.0 * share)));
        }
    }

    /// Recomputes the curves of a moved set through its landmarks.
    void lead(LandmarkSet &set)
    {
        for (Curve &curve : set.curves) {
            const std::string name = tr("the curve \"%1\"", curve.name);
            if (curve.points.empty()) {
                complain(tr("%1: %2 is not moved: its points are unknown", m_mesh, name));
                continue;
            }
            std::vector<const Landmark *> points;
            for (const std::string &point : curve.points) {
                const auto found = std::find_if(set.landmarks.begin(), set.landmarks.end(),
                                                [&point](const Landmark &landmark) { return landmark.name == point; });
                if (found != set.landmarks.end())
                    points.push_back(&*found);
            }
            curve.semilandmarks.clear(); // the old ones describe the former position
            if (points.size() < curve.points.size()) {
                complain(tr("%1: %2 has no semilandmarks: some of its landmarks are missing", m_mesh, name));
                continue;
            }
            if (!m_surface)
                m_surface = curves::SurfaceMesh::build(m_target.places->model(), {});
            const auto line = curves::lineThrough(*m_surface, points, curve.kind, m_target.worldFromObject, {});
            if (line)
                curve.semilandmarks = curves::resampled(line->path, curve.count);
            else
                complain(tr("%1: %2 has no semilandmarks: no path on the mesh leads to its point \"%3\"", m_mesh, name,
                            points[line.error().point]->name));
        }
    }

    /// The mesh's file, and the files that it names.
    InputFiles files() const { return filesOf(pathFromUtf8(m_mesh), m_target.places->model()); }

    void tellFarthest() const
    {
        if (m_count > 0)
            complain(m_mesh + ": "
                     + tr(m_count == 1 ? "%1 point moved onto the mesh, by at most %2 (%3)"
                                       : "%1 points moved onto the mesh, by at most %2 (%3)",
                          m_count, shortText(m_farthest), m_farthestName));
    }

private:
    Tying(std::string mesh, std::string fileName, std::shared_ptr<const ray::ClosestPlaces> places)
        : m_mesh(std::move(mesh)), m_target{std::move(fileName), std::move(places)},
          m_size(m_target.places->model().bounds.diagonal())
    {
    }

    std::string m_mesh, m_farthestName;
    ray::TyingTarget m_target;
    std::shared_ptr<const curves::SurfaceMesh> m_surface; ///< built for the first curve
    double m_size = 0.0, m_farthest = 0.0;
    std::size_t m_count = 0;
};

ExitCode convert(const LandmarksOptions &options)
{
    const std::optional<Format> from = formatOf(options.input, options.from, "--from");
    const std::optional<Format> to = formatOf(options.output, options.to, "--to");
    InputFiles inputs{options.input};
    if (!options.mesh.empty())
        inputs.push_back(options.mesh);
    if (!from || !to || isOverInput(options.output, inputs) || isOverInput(options.sliders, inputs))
        return ExitCode::UnusableInput;
    if (!options.sliders.empty() && (to == Format::SlicerJson || to == Format::MeshLabTemplate)) {
        complain(
            tr("%1: .%2 has no numbers for semilandmarks; write .csv, .tps or .nts", options.sliders, suffixOf(*to)));
        return ExitCode::UnusableInput;
    }
    std::optional<ReadLandmarks> read = readFile(options.input, *from);
    if (!read)
        return ExitCode::UnusableInput;
    if (!options.mesh.empty()) {
        std::optional<Tying> tying = Tying::to(options.mesh);
        if (!tying)
            return ExitCode::UnusableInput;
        for (std::string &file : tying->files())
            inputs.push_back(std::move(file));
        if (isOverInput(options.output, inputs))
            return ExitCode::UnusableInput;
        for (LandmarkSet &set : read->sets) {
            tying->tie(set);
            tying->lead(set);
        }
        tying->tellFarthest();
    }
    // NTSYS rows are specimens by name. Where the input has no name, the file's name is used.
    if (*to == Format::Nts && options.input != "-") {
        for (std::size_t i = 0; i < read->sets.size(); ++i) {
            if (read->sets[i].name.empty())
                read->sets[i].name = specimenOf(pathFromUtf8(options.input))
                                     + (read->sets.size() > 1 ? '_' + std::to_string(i + 1) : "");
        }
    }
    const ExitCode written = write(options.output, landmarksText(read->sets, *to, textsOf(options)), inputs);
    inputs.push_back(options.output);
    return writeSliders(options.sliders, slidersOf(read->sets), inputs, written);
}

Result<WrittenLandmarks, LandmarkFileError> tableOf(const std::vector<LandmarkSet> &sets, LandmarkTable table,
                                                    text::CellTexts texts)
{
    switch (table) {
    case LandmarkTable::Long: return landmarksText(sets, Format::Csv, texts);
    case LandmarkTable::Wide: return wideTable(sets, texts);
    case LandmarkTable::Tps: return landmarksText(sets, Format::Tps);
    case LandmarkTable::Nts: return landmarksText(sets, Format::Nts);
    }
    return wideTable(sets, texts);
}

ExitCode makeTable(const LandmarksOptions &options)
{
    std::error_code error;
    const LandmarkFolder folder =
        readLandmarkFolder(pathFromUtf8(options.folder),
                           options.output == "-" ? std::filesystem::path() : pathFromUtf8(options.output), error);
    if (error) {
        complain(folderErrorText(pathFromUtf8(options.folder), error));
        return ExitCode::UnusableInput;
    }
    for (const std::string &report : folder.reports)
        complain(report);
    if (folder.sets.empty()) {
        complain(folder.fileCount == 0 ? tr("%1: there are no files of landmarks (%2)", options.folder, readWords())
                                       : tr("%1: none of its files of landmarks could be read", options.folder));
        return ExitCode::UnusableInput;
    }
    const InputFiles inputs = folder.isTableInput ? InputFiles{options.output} : InputFiles();
    const ExitCode table = write(options.output, tableOf(folder.sets, options.table, textsOf(options)), inputs);
    const Result<Sliders, LandmarkFileError> sliders = options.table == LandmarkTable::Wide
                                                           ? slidersOf(folder.sets, wideTableNames(folder.sets))
                                                           : slidersOf(folder.sets);
    const ExitCode written = writeSliders(options.sliders, sliders, {options.output}, table);
    return written == ExitCode::Done && !folder.badFiles.empty() ? ExitCode::SomeRowsBad : written;
}

/// Groups the sets of several files by specimen. If each file has one set, all are the same
/// specimen, under any name. Otherwise sets of the same name belong together, or, without names,
/// sets at the same index.
/// @param names  of the files
std::vector<RepeatedSpecimen> specimensOf(const std::vector<std::vector<LandmarkSet>> &files,
                                          const std::vector<std::string> &names)
{
    const std::string firstName = specimenOf(pathFromUtf8(names.front()));
    const bool isOne = std::all_of(files.begin(), files.end(), [](const auto &sets) { return sets.size() == 1; });
    std::vector<RepeatedSpecimen> specimens;
    for (std::size_t file = 0; file < files.size(); ++file) {
        const std::vector<LandmarkSet> &sets = files[file];
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const std::string name = !sets[i].name.empty() ? sets[i].name : isOne ? firstName : std::to_string(i + 1);
            auto known = std::find_if(specimens.begin(), specimens.end(),
                                      [&](const RepeatedSpecimen &specimen) { return isOne || specimen.name == name; });
            if (known == specimens.end())
                known = specimens.insert(known, RepeatedSpecimen{name, {}, {}});
            known->placings.push_back(sets[i]);
            known->files.push_back(names[file]);
        }
    }
    return specimens;
}

/// Warns about a file given twice, because a set compared with itself has no scatter.
void tellSameFiles(const std::vector<std::string> &files)
{
    std::map<std::filesystem::path, std::string> known;
    for (const std::string &file : files) {
        std::error_code error;
        const auto [first, isNew] = known.emplace(std::filesystem::weakly_canonical(pathFromUtf8(file), error), file);
        if (!isNew && !error)
            complain(
                tr("%1: this is %2 again; the placing counts twice, so the scatter is too small", file, first->second));
    }
}

ExitCode makeRepeats(const LandmarksOptions &options)
{
    std::vector<std::vector<LandmarkSet>> files;
    if (isOverInput(options.output, options.repeats))
        return ExitCode::UnusableInput;
    for (const std::string &file : options.repeats) {
        const std::optional<Format> format = formatOf(file, options.from, "--from");
        std::optional<ReadLandmarks> read = format ? readFile(file, *format) : std::nullopt;
        if (!read)
            return ExitCode::UnusableInput;
        files.push_back(std::move(read->sets));
    }
    tellSameFiles(options.repeats);
    const std::vector<RepeatedSpecimen> specimens = specimensOf(files, options.repeats);
    for (const RepeatedSpecimen &specimen : specimens) {
        if (specimen.placings.size() < 2)
            complain(tr("the specimen \"%1\" is in one file only: there is nothing to compare it with", specimen.name));
    }
    return write(options.output, repeatsTable(specimens, textsOf(options)), options.repeats);
}

} // namespace

ExitCode runLandmarks(const LandmarksOptions &options)
{
    if (!options.repeats.empty())
        return makeRepeats(options);
    return options.folder.empty() ? convert(options) : makeTable(options);
}

} // namespace unprojector::cli
