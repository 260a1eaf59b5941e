#pragma once

#include "core/landmarks/landmark.h"
#include "core/landmarks/procrustes.h"
#include "core/landmarks/symmetry.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

/// The landmarks of several scans in one order, as Procrustes methods need them.
struct SeriesShapes {
    QStringList names; ///< as first written
    std::vector<landmarks::Configuration> scans;
    /// The index in `names` of each landmark of each scan.
    std::vector<std::vector<std::size_t>> places;

    /// The pairs of left and right landmarks.
    std::vector<landmarks::Pair> pairs() const;
};

/// Finds equal landmarks by name, see landmarks::distinctNames.
SeriesShapes shapesOf(const std::vector<const std::vector<landmarks::Landmark> *> &scans);

} // namespace unprojector::gui
