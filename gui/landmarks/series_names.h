#pragma once

#include "core/landmarks/landmark.h"
#include "gui/landmarks/scan.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

/// The names of the landmarks that a series places on each scan, in their order: its template, and
/// what the user adds on a scan. A name that the user has removed does not come back with a scan
/// where its landmark is placed.
class SeriesNames {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::ScanSeries)
public:
    const std::vector<landmarks::Landmark> &all() const { return m_all; }
    /// Appends the names of landmarks that are absent.
    void add(const std::vector<landmarks::Landmark> &landmarks);
    void remove(const std::vector<landmarks::Landmark> &landmarks);
    /// Notes the landmarks of a scan that is shown now: names that it has later were added there.
    void begin(const Scan &shown) { m_atFirst = shown.points.landmarks; }
    /// All names, with those that were added on the shown scan.
    /// @param shown  null: none
    std::vector<landmarks::Landmark> with(const Scan *shown) const;

    /// The names of all landmarks of these scans, in the order of first appearance.
    QStringList namesOn(const std::vector<Scan> &scans) const;
    /// The number of landmarks that a scan has or that are to be placed on it.
    std::size_t wantedCount(const Scan &scan, const Scan *shown) const;
    /// "9 of 10, 1 missing"
    QString progressText(const Scan &scan, const Scan *shown) const;

private:
    std::vector<landmarks::Landmark> m_all;
    std::vector<landmarks::Landmark> m_atFirst; ///< of the shown scan, without those removed since
};

} // namespace unprojector::gui
