#pragma once

#include "core/geometry/spaces.h"
#include "core/landmarks/expected_places.h"
#include "core/ray/closest_place.h"
#include "gui/landmarks/series_shapes.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

class ScanSeries;
class SceneDocument;

/// The expected place of a landmark of the present scan.
struct ExpectedLandmark {
    std::size_t index = 0; ///< in SceneDocument::landmarks()
    geometry::WorldPoint world;
    std::optional<double> spread; ///< see landmarks::ExpectedPlace; world units
    bool isNext = false;          ///< it is the next to place
};

/// The expected places of the landmarks that the present scan of a series lacks, from those of the
/// other scans. They are suggestions for the view: they change neither the scene nor a file.
class ExpectedLandmarks : public QObject {
    Q_OBJECT
public:
    /// @param document, series  outlive it
    ExpectedLandmarks(SceneDocument &document, const ScanSeries &series, QObject *parent = nullptr);

    /// Returns whether they are shown in the view.
    bool isShown() const { return m_isShown; }
    void setShown(bool isShown);

    /// The expected places of the landmarks to place; none while they are not known.
    const std::vector<ExpectedLandmark> &all();
    /// Turns the camera to face the surface at the expected place of the next landmark: one step of
    /// undo, as each change of the view.
    /// @return why it could not; empty: it did
    QString faceNext();

signals:
    void changed();

private:
    void update();
    /// The reason why the next landmark has no expected place.
    QString reasonText() const;

    SceneDocument &m_document;
    const ScanSeries &m_series;
    bool m_isShown = true;
    bool m_isKnown = false; ///< the members below belong to the present landmarks
    std::vector<ExpectedLandmark> m_all;
    std::optional<landmarks::NoExpectedPlaces> m_reason;
    std::vector<landmarks::Configuration> m_others; ///< that m_expectation comes from
    landmarks::PlaceExpectation m_expectation;
    /// The prepared model that was asked last: preparing a large one takes a second.
    std::shared_ptr<const ray::ClosestPlaces> m_places;
};

} // namespace unprojector::gui
