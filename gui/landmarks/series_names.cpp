#include "gui/landmarks/series_names.h"

#include "core/landmarks/name_key.h"
#include "core/landmarks/point_template.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;

namespace {

std::string nameOrNumber(const LandmarkSet &set, std::size_t index)
{
    return set.landmarks[index].name.empty() ? std::to_string(index + 1) : set.landmarks[index].name;
}

} // namespace

void SeriesNames::add(const std::vector<Landmark> &landmarks)
{
    m_all = withTemplate(std::move(m_all), landmarks);
}

void SeriesNames::remove(const std::vector<Landmark> &landmarks)
{
    for (std::vector<Landmark> *list : {&m_all, &m_atFirst})
        std::erase_if(*list, [&landmarks](const Landmark &name) { return has(landmarks, name.name); });
}

std::vector<Landmark> SeriesNames::with(const Scan *shown) const
{
    std::vector<Landmark> wanted = shown ? shown->points.landmarks : std::vector<Landmark>();
    std::erase_if(wanted, [this](const Landmark &landmark) {
        return has(m_atFirst, landmark.name) && !has(m_all, landmark.name);
    });
    return withTemplate(m_all, wanted);
}

QStringList SeriesNames::namesOn(const std::vector<Scan> &scans) const
{
    QStringList names;
    std::set<std::string> known; // keys
    for (const Landmark &name : m_all) {
        names << QString::fromStdString(name.name);
        known.insert(nameKey(name.name));
    }
    for (const Scan &scan : scans) {
        for (std::size_t i = 0; i < scan.points.landmarks.size(); ++i) {
            const std::string name = nameOrNumber(scan.points, i);
            if (const auto [key, isNew] = known.insert(nameKey(name)); isNew || key->empty())
                names << QString::fromStdString(name);
        }
    }
    return names;
}

std::size_t SeriesNames::wantedCount(const Scan &scan, const Scan *shown) const
{
    return withTemplate(scan.points.landmarks, with(shown)).size();
}

QString SeriesNames::progressText(const Scan &scan, const Scan *shown) const
{
    const std::size_t placed = scan.placedCount(), wanted = wantedCount(scan, shown), missing = scan.missingCount();
    return missing > 0 ? tr("%1 of %2, %3 missing").arg(placed).arg(wanted).arg(missing)
                       : tr("%1 of %2").arg(placed).arg(wanted);
}

} // namespace unprojector::gui
