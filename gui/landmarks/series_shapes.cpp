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
            set.landmarks.emplace_back().name = QString::fromStdString(landmark.name).toCaseFolded().toStdString();
    }
    DistinctNames distinct = distinctNames(sets);
    SeriesShapes shapes;
    for (const std::string &name : distinct.names)
        shapes.names << QString::fromStdString(name);
    std::vector<bool> isNamed(distinct.names.size(), false);
    for (std::size_t k = 0; k < scans.size(); ++k) {
        Configuration &points = shapes.scans.emplace_back(distinct.names.size());
        for (std::size_t i = 0; i < scans[k]->size(); ++i) {
            const Landmark &landmark = (*scans[k])[i];
            const std::size_t place = distinct.places[k][i];
            if (landmark.world)
                points[place] = landmark.world->coordinates();
            QString &name = shapes.names[static_cast<qsizetype>(place)];
            const QString written = QString::fromStdString(landmark.name);
            if (!isNamed[place] && name.compare(written, Qt::CaseInsensitive) == 0)
                name = written;
            isNamed[place] = true;
        }
    }
    shapes.places = std::move(distinct.places);
    return shapes;
}

} // namespace unprojector::gui
