#include "core/cli/commands/landmarks_command.h"

#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/system_file.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/cli/terminal/refusal.h"
#include "core/curves/curve_line.h"
#include "core/curves/surface_mesh.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/sliders.h"
#include "core/landmark_files/specimen_table.h"
#include "core/mesh/import/mesh_import.h"
#include "core/ray/tie_landmark.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace landmarks;
using namespace mesh;
using namespace landmark_files;
using namespace base;
using geometry::Result;
namespace {

std::string nameOf(const Landmark &landmark, std::size_t index)
{
    return landmark.name.empty() ? tr("point %1", index + 1) : tr("\"%1\"", landmark.name);
}

/// Moves every landmark to the closest point of the mesh, and reports the distance.
class Tying {
public:
    explicit Tying(const std::string &mesh) : m_mesh(mesh)
    {
        const std::filesystem::path file = pathFromUtf8(mesh);
        const auto model = mesh::importModel(file, {});
        if (!model)
            refuse(model.error().message());
        m_target = {utf8FromPath(file.filename()), ray::ClosestPlaces::build(*model, {})};
        m_size = m_target.places->model().bounds.diagonal();
    }

    /// @param progress  counts landmarks
    void tie(LandmarkSet &set, ProgressBar &progress)
    {
        set.mesh = m_target.name;
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            progress.advance(1);
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
                            m_mesh, nameOf(landmark, i), significantText(tied->distance, 3),
                            significantText(100.0 * share, 3)));
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
                          m_count, significantText(m_farthest, 3), m_farthestName));
    }

private:
    std::string m_mesh, m_farthestName;
    ray::TyingTarget m_target;
    std::shared_ptr<const curves::SurfaceMesh> m_surface; ///< built for the first curve
    double m_size = 0.0, m_farthest = 0.0;
    std::size_t m_count = 0;
};

ExitCode convert(const LandmarksOptions &options)
{
    const Format from = formatOf(options.input, options.from, "--from");
    const Format to = formatOf(options.output, options.to, "--to");
    InputFiles inputs{options.input};
    if (!options.mesh.empty())
        inputs.push_back(options.mesh);
    checkNotInput(options.output, inputs);
    checkNotInput(options.sliders, inputs);
    if (!options.sliders.empty() && (to == Format::SlicerJson || to == Format::MeshLabTemplate))
        refuse(tr("%1: .%2 has no numbers for semilandmarks; write .csv, .tps or .nts", options.sliders, suffixOf(to)));
    ReadLandmarks read = readFile(options.input, from);
    if (!options.mesh.empty()) {
        Tying tying(options.mesh);
        for (std::string &file : tying.files())
            inputs.push_back(std::move(file));
        checkNotInput(options.output, inputs);
        std::size_t count = 0;
        for (const LandmarkSet &set : read.sets)
            count += set.landmarks.size();
        ProgressBar progress(count, ProgressBar::Unit::Points);
        for (LandmarkSet &set : read.sets) {
            tying.tie(set, progress);
            tying.lead(set);
        }
        tying.tellFarthest();
    }
    const auto table =
        convertedText(std::move(read.sets), to,
                      options.input == "-" ? std::string() : specimenOf(pathFromUtf8(options.input)), options.texts());
    if (!table)
        return write(options.output, table.error(), inputs);
    const ExitCode written = write(options.output, WrittenLandmarks{table->text, table->notes}, inputs);
    inputs.push_back(options.output);
    return writeSliders(options.sliders, table->sliders, inputs, written);
}

/// Checks that two results do not go to the same file, or both to stdout.
/// @param b  empty: there is no such result, as for a
void checkDistinct(const std::string &a, const std::string &b)
{
    const auto whole = [](const std::string &file) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(pathFromUtf8(file), ignored), ignored);
    };
    if (a.empty() || b.empty() || isStream(pathFromUtf8(a)))
        return;
    if (a != b && (a == "-" || b == "-" || (whole(a) != whole(b) && !isSameFile(pathFromUtf8(a), pathFromUtf8(b)))))
        return;
    refuse(tr("%1: two results cannot go to one file; give another name for one of them", outputName(a)));
}

ExitCode runLandmarks(const LandmarksOptions &options)
{
    checkDistinct(options.output, options.errors);
    checkDistinct(options.output, options.sliders);
    if (!options.repeats.empty())
        return makeRepeats(options);
    return options.folder.empty() ? convert(options) : makeTable(options);
}

CLI::Option *addFormat(const Command &command, const char *name, std::optional<Format> &target, bool isWritten)
{
    return command.word(
        name, isWritten ? writtenWords() : readWords(),
        [&target](const std::string &given) { target = formatOfSuffix(given); },
        [isWritten](const std::string &given) {
            const auto format = formatOfSuffix(given);
            return format && (!isWritten || landmark_files::isWritten(*format));
        });
}

} // namespace

void addLandmarks(const Command &command)
{
    const auto options = std::make_shared<LandmarksOptions>();
    CLI::Option *input = command.file("IN", options->input), *output = command.file("OUT", options->output);
    CLI::Option *from = addFormat(command, "--from", options->from, false),
                *to = addFormat(command, "--to", options->to, true);
    CLI::Option *mesh = command.file("--mesh", options->mesh);
    CLI::Option *folder = command.file("--table", options->folder)->excludes(from);
    CLI::Option *repeats = command.add("--repeats", options->repeats)
                               ->excludes(folder)
                               ->expected(1, CLI::detail::expected_max_vector_size);
    for (CLI::Option *option : {input, output, to, mesh}) {
        folder->excludes(option);
        repeats->excludes(option);
    }
    command.file("--errors", options->errors)->needs(repeats);
    command.file("--measures", options->measures)->needs(folder);
    command.file("-o,--output", options->output);
    command.file("--sliders", options->sliders)->excludes(repeats);
    command.choice(
        "--format", options->table,
        {{"long", TableForm::Long}, {"wide", TableForm::Wide}, {"tps", TableForm::Tps}, {"nts", TableForm::Nts}});
    command.flag("--spreadsheet-safe", options->isSpreadsheetSafe);
    command.runs(options, [command](const LandmarksOptions &given) {
        if (!command.has("--table") && !command.has("--repeats")) {
            if (command.has("-o"))
                throw CLI::RequiredError(tr("--table or --repeats (with -o)"));
            for (const char *name : {"IN", "OUT"}) {
                if (!command.has(name))
                    throw CLI::RequiredError(tr("%1 (or --table)", name));
            }
        } else if (!command.has("-o") && !command.has("--errors")) {
            throw CLI::RequiredError("-o,--output");
        }
        return runLandmarks(given);
    });
}

} // namespace unprojector::cli
