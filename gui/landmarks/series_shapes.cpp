#include "gui/landmarks/series_shapes.h"

#include "core/landmarks/distinct_names.h"

namespace unprojector::gui {
using namespace landmarks;

std::vector<Pair> SeriesShapes::pairs() const
{
    std::vector<Landmark> named(static_cast<std::size_t>(names.size()));
    for (std::size_t i = 0; i < named.size(); ++i)
        named[i].name = names[static_cast<qsizetype>(i)].toStdString();
    return pairsByName(named);
}

SeriesShapes shapesOf(const std::vector<const std::vector<Landmark> *> &scans)
{
    std::vector<LandmarkSet> sets;
    for (const std::vector<Landmark> *scan : scans) {
        LandmarkSet &set = sets.emplace_back();
        for (const Landmark &landmark : *scan)
            set.landmarks.emplace_back().name = landmark.name;
    }
    DistinctNames distinct = distinctNames(sets);
    SeriesShapes shapes;
    for (const std::string &name : distinct.names)
        shapes.names << QString::fromStdString(name);
    for (std::size_t k = 0; k < scans.size(); ++k) {
        Configuration &points = shapes.scans.emplace_back(distinct.names.size());
        for (std::size_t i = 0; i < scans[k]->size(); ++i) {
            const Landmark &landmark = (*scans[k])[i];
            if (landmark.world)
                points[distinct.places[k][i]] = landmark.world->coordinates();
        }
    }
    shapes.places = std::move(distinct.places);
    return shapes;
}

} // namespace unprojector::gui
