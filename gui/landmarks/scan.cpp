#include "gui/landmarks/scan.h"

#include "core/base/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmarks/name_key.h"
#include "core/landmarks/point_template.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace scene;

namespace {

using namespace landmark_files;

bool isScan(const std::filesystem::path &file)
{
    // "Models (*.obj … *.glb)"
    const QString pattern = u'*' + pathText(file.extension()).toLower(), all = modelFileFilter();
    return file.has_extension() && (all.contains(pattern + u' ') || all.contains(pattern + u')'));
}

} // namespace

std::size_t placedCount(const LandmarkSet &set)
{
    return static_cast<std::size_t>(std::count_if(set.landmarks.begin(), set.landmarks.end(),
                                                  [](const Landmark &landmark) { return landmark.isPlaced(); }));
}

std::size_t Scan::placedCount() const
{
    return gui::placedCount(points);
}

std::size_t Scan::missingCount() const
{
    return static_cast<std::size_t>(std::count_if(points.landmarks.begin(), points.landmarks.end(),
                                                  [](const Landmark &landmark) { return landmark.isMissing(); }));
}

bool Scan::isComplete(const std::vector<Landmark> &names) const
{
    const std::vector<Landmark> all = withTemplate(points.landmarks, names);
    return std::none_of(all.begin(), all.end(), [](const Landmark &landmark) { return landmark.isToPlace(); });
}

geometry::Result<std::vector<Scan>, QString> scansIn(const std::filesystem::path &folder)
{
    std::vector<Scan> scans;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (isScan(it->path()) && it->is_regular_file(ignored))
            scans.push_back({it->path(), {}, {}});
    }
    if (error)
        return QString::fromStdString(folderErrorText(folder, error));
    if (scans.empty())
        return ScanSeries::tr("%1: this folder has no model file. Supported: %2.")
            .arg(pathText(folder), modelFileFilter());
    std::sort(scans.begin(), scans.end(), [](const Scan &a, const Scan &b) { return a.file < b.file; });
    return scans;
}

void readKept(Scan &scan, int placing)
{
    const std::filesystem::path file = landmarksBeside(scan.file, placing);
    scan.points = {};
    scan.problem.clear();
    scan.isDamaged = false;
    std::error_code error;
    scan.isKept = std::filesystem::exists(file, error);
    if (!scan.isKept)
        return;
    auto read = readLandmarkFile(file);
    if (!read)
        scan.problem = QString::fromStdString(read.error().message());
    else if (read->sets.size() > 1)
        scan.problem =
            ScanSeries::tr(
                "%1: this file has the landmarks of %2 specimens. A scan is one specimen: put each into its own file.")
                .arg(pathText(file))
                .arg(read->sets.size());
    else
        scan.points = std::move(std::move(read).value().sets.front());
    scan.isDamaged = !scan.problem.isEmpty();
}

SceneObject asInItsFile(const std::filesystem::path &file, const SceneObject &shown)
{
    return {base::utf8FromPath(file.filename()), file, shown.model, {}};
}

bool isStill(const Landmark &now, const Landmark &was)
{
    constexpr double kRounding = 1e-12;
    if (!now.world || !was.world || now.anchor != was.anchor)
        return false;
    const auto &[a, b] = std::pair(now.world->coordinates(), was.world->coordinates());
    const double size = std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return std::abs(a.x - b.x) <= kRounding * size && std::abs(a.y - b.y) <= kRounding * size
           && std::abs(a.z - b.z) <= kRounding * size;
}

void takeExact(std::vector<Landmark> &landmarks, const std::vector<Landmark> &were)
{
    for (std::size_t i = 0; i < std::min(landmarks.size(), were.size()); ++i) {
        if (!isStill(landmarks[i], were[i]))
            continue;
        landmarks[i].world = were[i].world;
        landmarks[i].uncertainty = were[i].uncertainty;
    }
}

NamedLandmark namedLandmark(const std::vector<Landmark> &landmarks, std::size_t index)
{
    const std::string &name = landmarks[index].name;
    const auto before = std::count_if(landmarks.begin(), landmarks.begin() + static_cast<std::ptrdiff_t>(index),
                                      [&name](const Landmark &landmark) { return landmark.name == name; });
    return {name, static_cast<std::size_t>(before)};
}

std::optional<std::size_t> indexOf(const std::vector<Landmark> &landmarks, const NamedLandmark &landmark)
{
    std::size_t before = 0;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (landmarks[i].name == landmark.name && before++ == landmark.before)
            return i;
    }
    return std::nullopt;
}

bool has(const std::vector<Landmark> &landmarks, const std::string &name)
{
    return indexOfName(landmarks, name).has_value();
}

void withoutUnwanted(std::vector<Landmark> &landmarks, const std::vector<Landmark> &wanted)
{
    std::erase_if(landmarks, [&wanted](const Landmark &landmark) {
        return landmark.isToPlace() && !landmark.name.empty() && !has(wanted, landmark.name);
    });
}

void addCurves(std::vector<Curve> &curves, const std::vector<Curve> &others)
{
    for (const Curve &curve : others) {
        const auto hasName = [&curve](const Curve &other) { return other.name == curve.name; };
        if (!curve.points.empty() && std::none_of(curves.begin(), curves.end(), hasName))
            curves.push_back(curve);
    }
}

bool holds(const std::vector<Landmark> &all, const std::vector<Landmark> &others)
{
    return std::all_of(others.begin(), others.end(), [&all](const Landmark &other) {
        if (!other.isPlaced() && !other.isMissing())
            return true;
        return std::any_of(all.begin(), all.end(), [&other](const Landmark &each) {
            return each.name == other.name && (other.isPlaced() ? isStill(each, other) : each.isMissing());
        });
    });
}

} // namespace unprojector::gui
