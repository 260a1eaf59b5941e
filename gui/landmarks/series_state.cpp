#include "gui/landmarks/series_state.h"

#include <algorithm>

namespace unprojector::gui {
using namespace landmarks;

const Scan *SeriesState::lastShown() const
{
    if (!shown && aside && aside->isShown)
        return &scans[aside->inView];
    return shownScan();
}

std::optional<std::size_t> SeriesState::indexOf(const std::filesystem::path &scan) const
{
    const auto found =
        std::find_if(scans.begin(), scans.end(), [&scan](const Scan &each) { return each.file == scan; });
    return found != scans.end() ? std::optional(static_cast<std::size_t>(found - scans.begin())) : std::nullopt;
}

std::size_t SeriesState::firstIncomplete(std::size_t from) const
{
    for (std::size_t i = from; i < scans.size(); ++i) {
        const Scan &scan = scans[i];
        if (scan.problem.isEmpty() && (!scan.isKept || !scan.isComplete(names.all())))
            return i;
    }
    const auto readable =
        std::find_if(scans.begin(), scans.end(), [](const Scan &scan) { return scan.problem.isEmpty(); });
    return readable != scans.end() ? static_cast<std::size_t>(readable - scans.begin()) : 0;
}

void SeriesState::read(Scan &scan) const
{
    const QString unreadable = scan.isDamaged ? QString() : scan.problem; // the scan itself
    readKept(scan, placing);
    if (scan.problem.isEmpty())
        scan.problem = unreadable;
    withoutUnwanted(scan.points.landmarks, names.all());
}

void SeriesState::dropRemoved(const std::vector<Landmark> &before)
{
    std::vector<Landmark> removed = before;
    std::erase_if(removed, [this](const Landmark &landmark) {
        return !landmark.isToPlace() || has(scans[*shown].points.landmarks, landmark.name);
    });
    if (removed.empty())
        return;
    names.remove(removed);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (i != *shown)
            std::erase_if(scans[i].points.landmarks, [&removed](const Landmark &landmark) {
                return landmark.isToPlace() && has(removed, landmark.name);
            });
    }
}

} // namespace unprojector::gui
