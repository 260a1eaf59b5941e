#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <QString>

#include <filesystem>
#include <vector>

namespace unprojector::gui {

struct Scan;

/// What the points of all scans of a series are written as.
enum class SeriesTable {
    Long, ///< a row a point
    Wide, ///< a row a scan
    Tps,
    Nts,
    Repeats ///< a row a point of each scan, of all placings: their mean and how far they scatter
};

/// What there is to say of a table that was written.
struct WrittenSeries {
    QString warning; ///< what is left out of it, may be empty
    QString notice;
};

/// Writes the points of all scans into one file.
/// @param names  of the points, in their order; those of the scans follow
/// @return why it was not written: no point, a name that a file of the series has, a file that cannot be written
geometry::Result<WrittenSeries, QString> writeSeries(const std::filesystem::path &file, SeriesTable table,
                                                     const std::vector<Scan> &scans,
                                                     const std::vector<landmarks::Landmark> &names);

} // namespace unprojector::gui
