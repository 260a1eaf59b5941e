#include "gui/landmarks/expected_landmarks.h"

#include "gui/document/landmark_views.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/scan_series.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace landmarks;
using namespace scene;

ExpectedLandmarks::ExpectedLandmarks(SceneDocument &document, const ScanSeries &series, QObject *parent)
    : QObject(parent), m_document(document), m_series(series)
{
    const auto forget = [this] {
        m_isKnown = false;
        emit changed();
    };
    connect(&m_document, &SceneDocument::changed, this, [forget](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            forget();
    });
    connect(&m_series, &ScanSeries::changed, this, forget);
    connect(&m_document, &SceneDocument::opened, this, [this] { m_places.reset(); }); // the model may be large
}

void ExpectedLandmarks::setShown(bool isShown)
{
    if (std::exchange(m_isShown, isShown) != isShown)
        emit changed();
}

const std::vector<ExpectedLandmark> &ExpectedLandmarks::all()
{
    if (!m_isKnown)
        update();
    return m_all;
}

void ExpectedLandmarks::update()
{
    m_isKnown = true;
    m_all.clear();
    m_reason = NoExpectedPlaces::NoOthers;
    const std::optional<std::size_t> current = m_series.current();
    if (!current || m_series.scans().size() < 2)
        return;
    std::vector<const std::vector<Landmark> *> scans{&m_document.landmarks()};
    for (std::size_t k = 0; k < m_series.scans().size(); ++k) {
        if (k != *current)
            scans.push_back(&m_series.scans()[k].points.landmarks);
    }
    const SeriesShapes shapes = shapesOf(scans);
    const Configuration &own = shapes.scans.front();
    std::vector<Configuration> others(shapes.scans.begin() + 1, shapes.scans.end());
    if (others != m_others) { // not at every landmark that is placed here
        m_expectation = PlaceExpectation(others);
        m_others = std::move(others);
    }
    const ExpectedPlaces expected = m_expectation.placesFor(own);
    m_reason = expected.reason;
    const std::vector<Landmark> &landmarks = m_document.landmarks();
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const std::optional<ExpectedPlace> &place = expected.places[shapes.places[0][i]];
        if (place && landmarks[i].isToPlace())
            m_all.push_back(
                {i, WorldPoint(place->place), place->spread, m_document.sceneLandmarks().nextUnplaced() == i});
    }
}

QString ExpectedLandmarks::reasonText() const
{
    if (!m_series.isOpen() || !m_series.current())
        return tr("Expected places come from the other scans of a series. No scan of a series is shown.");
    const std::optional<std::size_t> next = m_document.sceneLandmarks().nextUnplaced();
    if (!next)
        return tr("No landmark is next, so there is no expected place. Choose a landmark that is not placed.");
    if (m_reason) {
        switch (*m_reason) {
        case NoExpectedPlaces::NoOthers:
            return m_series.placing() > 1
                       ? tr("No other scan has landmarks of this placing (%1) that tell where the next one is.")
                             .arg(m_series.placing())
                       : tr("No other scan of the series has landmarks that tell where the next one is.");
        case NoExpectedPlaces::TooFew:
            return tr("Place three landmarks that other scans have. Then the other scans tell where the next one is.");
        case NoExpectedPlaces::OnALine:
            return tr("The placed landmarks are on a line. Place one beside it: then the other scans tell where the "
                      "next one is.");
        }
    }
    const QString name = SceneLandmarks::shownNameOf(m_document.landmarks(), *next);
    return m_series.placing() > 1 ? tr("No other scan has %1 in this placing (%2).").arg(name).arg(m_series.placing())
                                  : tr("No other scan of the series has %1.").arg(name);
}

QString ExpectedLandmarks::faceNext()
{
    const std::vector<ExpectedLandmark> &places = all();
    const auto next = std::find_if(places.begin(), places.end(), [](const auto &place) { return place.isNext; });
    if (next == places.end())
        return reasonText();
    WorldPoint target = next->world;
    std::optional<WorldVector> normal;
    double least = std::numeric_limits<double>::infinity();
    for (const SceneObject &object : m_document.objects()) {
        if (object.isHidden || object.model->triangleCount() == 0)
            continue;
        if (!m_places || &m_places->model() != object.model.get())
            m_places = ray::ClosestPlaces::build(object.model, {});
        const glm::dmat4 worldFromModel = worldFromObject(object.transform);
        const glm::dvec3 asked = glm::dvec3(glm::inverse(worldFromModel) * glm::dvec4(next->world.coordinates(), 1.0));
        const std::optional<ray::ClosestPlace> closest = m_places ? m_places->to(ObjectPoint(asked)) : std::nullopt;
        if (!closest)
            continue;
        const WorldPoint there(glm::dvec3(worldFromModel * glm::dvec4(closest->point.coordinates(), 1.0)));
        if (const double away = distance(there, next->world); away < least) {
            least = away;
            target = there;
            normal = normalAround(closest->point, closest->anchor, object);
        }
    }
    faceSurface(m_document, target, normal);
    return {};
}

} // namespace unprojector::gui
