#pragma once

#include "core/geometry/result.h"
#include "core/landmark_files/repeats_table.h"
#include "core/landmarks/landmark.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace unprojector::gui {

struct Scan;

/// The export formats for the landmarks of all scans of a series.
enum class SeriesTable {
    Long, ///< a row a landmark, all placings
    Wide, ///< a row a scan and placing
    Tps,  ///< the shown placing, as in NTSYS
    Nts,
    Repeats, ///< a row a landmark of each scan, over all placings: mean and scatter
    Errors,  ///< a row a landmark, over all scans and placings: the error of measurement
};

/// The content of a table.
struct SeriesContent {
    const std::vector<Scan> &scans;                      ///< with the landmarks of the shown placing
    const std::vector<landmarks::Landmark> &names;       ///< in order; other names in the scans follow
    const std::vector<landmarks::KeptMeasure> &measures; ///< columns of the tables with rows
    int placing = 1;                                     ///< the shown one
    /// Reports how many scans are measured along their surface; returns false to cancel. May be empty.
    std::function<bool(std::size_t done, std::size_t count)> goesOn;
};

/// The messages about an exported table.
struct WrittenSeries {
    QString warning; ///< what was left out, may be empty
    QString notice;
};

/// Writes the landmarks of all scans into one file.
/// @return why it was not written: no landmark, the name of a file of the series, a file that
/// cannot be written, cancelled
geometry::Result<WrittenSeries, QString> writeSeries(const std::filesystem::path &file, SeriesTable table,
                                                     const SeriesContent &content);

/// The scans with the landmarks of every placing, as saved.
struct SeriesRepeats {
    std::vector<landmark_files::RepeatedSpecimen> specimens;
    QStringList problems; ///< read errors
    QString summary;      ///< how many scans were placed more than once
};
SeriesRepeats repeatsIn(const std::vector<Scan> &scans);

} // namespace unprojector::gui
