#include "core/cli/commands/landmarks_command.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/landmark_streams.h"
#include "core/cli/commands/landmark_tables.h"
#include "core/cli/commands/opened_scene.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/curves/curve_line.h"
#include "core/curves/surface_mesh.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/sliders.h"
#include "core/landmark_files/specimen_table.h"
#include "core/mesh/import/import_error_text.h"
#include "core/mesh/import/mesh_import.h"
#include "core/ray/tie_landmark.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace landmarks;
using namespace mesh;
using namespace landmark_files;
using namespace base;
using geometry::Result;
namespace {

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
        std::size_t count = 0;
        for (const LandmarkSet &set : read->sets)
            count += set.landmarks.size();
        ProgressBar progress(count, ProgressBar::Unit::Points);
        for (LandmarkSet &set : read->sets) {
            tying->tie(set, progress);
            tying->lead(set);
        }
        tying->tellFarthest();
    }
    const auto table =
        convertedText(std::move(read->sets), *to,
                      options.input == "-" ? std::string() : specimenOf(pathFromUtf8(options.input)), textsOf(options));
    if (!table)
        return write(options.output, table.error(), inputs);
    const ExitCode written = write(options.output, WrittenLandmarks{table->text, table->notes}, inputs);
    inputs.push_back(options.output);
    return writeSliders(options.sliders, table->sliders, inputs, written);
}

} // namespace

ExitCode runLandmarks(const LandmarksOptions &options)
{
    if (isSameOutput(options.output, options.errors) || isSameOutput(options.output, options.sliders))
        return ExitCode::UnusableInput;
    if (!options.repeats.empty())
        return makeRepeats(options);
    return options.folder.empty() ? convert(options) : makeTable(options);
}

} // namespace unprojector::cli
