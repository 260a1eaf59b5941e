#pragma once

#include "core/base/file_stamp.h"
#include "core/landmarks/landmark.h"
#include "gui/landmarks/scan.h"

#include <QString>

#include <filesystem>
#include <vector>

namespace unprojector::gui {

/// The measures that a series keeps, in the file "series.measures.csv" of its folder. A file that
/// cannot be read, or that another program has changed since it was read, is never overwritten.
class SeriesProtocol {
public:
    /// Reads the protocol of a folder. Without a file, the series starts with the scene's measures;
    /// they are written when the first scan is kept.
    /// @return why the file cannot be read; empty: no error
    QString open(const std::filesystem::path &folder, const std::vector<landmarks::KeptMeasure> &ofScene);
    void close();
    const std::vector<landmarks::KeptMeasure> &measures() const { return m_measures; }
    /// Takes measures. Writes them at once if they have changed.
    /// @return why they are not written; empty: no error
    QString take(std::vector<landmarks::KeptMeasure> measures);
    /// Writes measures that a failure left unwritten, and those of the scene that the series began
    /// with.
    /// @param areLandmarksWritten  of a scan: then the series is kept in this folder
    /// @return as take
    QString keep(bool areLandmarksWritten);

private:
    QString write();

    std::filesystem::path m_file; ///< empty: no series is open
    std::vector<landmarks::KeptMeasure> m_measures;
    base::FileStamp m_stamp;
    bool m_isDamaged = false;
    bool m_isNew = false;     ///< the scene's measures, not written yet
    bool m_isUnsaved = false; ///< after a failure
};

/// A message if measures follow a renamed landmark while other scans still have the former name;
/// else empty.
/// @param renamedOn  index of the scan on which it was renamed
QString leftBehindText(const std::vector<landmarks::KeptMeasure> &before,
                       const std::vector<landmarks::KeptMeasure> &after, const std::vector<Scan> &scans,
                       std::size_t renamedOn);

} // namespace unprojector::gui
