#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <QString>

#include <filesystem>
#include <vector>

namespace unprojector::gui {

struct Scan;

/// The export formats for the landmarks of all scans of a series.
enum class SeriesTable {
    Long, ///< a row a landmark
    Wide, ///< a row a scan
    Tps,
    Nts,
    Repeats ///< a row a landmark of each scan, over all placings: mean and scatter
};

/// The messages about an exported table.
struct WrittenSeries {
    QString warning; ///< what was left out, may be empty
    QString notice;
};

/// Writes the landmarks of all scans into one file.
/// @param names  of the landmarks, in order; other names in the scans follow
/// @return why it was not written: no landmark, the name of a file of the series, a file that
/// cannot be written
geometry::Result<WrittenSeries, QString> writeSeries(const std::filesystem::path &file, SeriesTable table,
                                                     const std::vector<Scan> &scans,
                                                     const std::vector<landmarks::Landmark> &names);

} // namespace unprojector::gui
