#pragma once

#include "core/landmarks/landmark.h"
#include "gui/landmarks/scan.h"
#include "gui/landmarks/series_names.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The scan that was shown before a lesson.
struct SuspendedScan {
    std::size_t inView = 0;
    bool isShown = false; ///< its landmarks are saved
    int placing = 1;
};

/// The scans of a series, and which of them is shown.
struct SeriesState {
    std::filesystem::path folder;
    std::vector<Scan> scans;
    SeriesNames names;                    ///< given to every scan
    std::vector<landmarks::Curve> curves; ///< the same, by the names of their landmarks
    /// The scan that is shown, or that could not be shown; nothing while another scene is shown.
    std::optional<std::size_t> current;
    std::optional<std::size_t> inView; ///< the scan in the view
    /// the same, but nothing if its landmark file is damaged: then they are not saved
    std::optional<std::size_t> shown;
    std::optional<SuspendedScan> aside; ///< the scan before the present lesson
    int placing = 1;

    /// The index that next and previous start from; in a lesson the suspended scan's.
    std::optional<std::size_t> index() const { return current || !aside ? current : aside->inView; }
    /// The scan whose landmarks are shown; null: none.
    const Scan *shownScan() const { return shown ? &scans[*shown] : nullptr; }
    Scan *shownScan() { return shown ? &scans[*shown] : nullptr; }
    /// The scan that was shown last and is saved: the shown one, or the suspended one; null: none.
    const Scan *lastShown() const;
    std::optional<std::size_t> indexOf(const std::filesystem::path &scan) const;
    /// The first scan from this index on that lacks a landmark; else the first one that can be read.
    std::size_t firstIncomplete(std::size_t from) const;
    /// Reads the saved landmarks of a scan, without names to place that the series has no more.
    void read(Scan &scan) const;
    /// Removes names to place that were removed from the shown scan from the other scans too.
    /// @pre shown
    void dropRemoved(const std::vector<landmarks::Landmark> &before);
};

} // namespace unprojector::gui
