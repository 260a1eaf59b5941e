#include "gui/document/landmark_joining.h"

#include "core/landmarks/name_key.h"
#include "core/landmarks/point_template.h"

#include <nlohmann/json.hpp>

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace unprojector::gui {
namespace {

using landmarks::Curve;
using landmarks::Landmark;
using landmarks::LandmarkSet;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::LandmarkFiles)
};

QString keyOf(const std::string &name)
{
    return QString::fromStdString(landmarks::nameKey(name));
}

/// Adds other programs' keys that only one of both has. Returns the ones left out.
QStringList addKeys(base::JsonValue &kept, const base::JsonValue &added)
{
    nlohmann::ordered_json &to = kept.edit();
    const nlohmann::ordered_json &from = added.json();
    QStringList leftOut;
    for (auto it = from.begin(); from.is_object() && it != from.end(); ++it) {
        if (!to.is_object() || !to.contains(it.key()))
            to[it.key()] = *it;
        else if (to[it.key()] != *it)
            leftOut << QString::fromStdString(it.key());
    }
    return leftOut;
}

/// Curves know their points by name.
void rename(std::vector<Curve> &curves, const std::map<std::string, std::string> &names)
{
    for (Curve &curve : curves) {
        for (std::string &point : curve.points) {
            if (const auto now = names.find(point); now != names.end())
                point = now->second;
        }
    }
}

/// Removes curves that were read as points and that the scene has itself: the scene knows their
/// line.
/// @return their names
QStringList leaveKnownOut(std::vector<Curve> &curves, std::size_t taken, const std::vector<Curve> &there)
{
    QStringList known;
    const auto first = curves.end() - static_cast<std::ptrdiff_t>(taken);
    curves.erase(std::remove_if(first, curves.end(),
                                [&](const Curve &curve) {
                                    const bool isThere =
                                        std::any_of(there.begin(), there.end(), [&](const Curve &other) {
                                            return keyOf(other.name) == keyOf(curve.name);
                                        });
                                    if (isThere)
                                        known << QString::fromStdString(curve.name).simplified();
                                    return isThere;
                                }),
                 curves.end());
    return known;
}

void tellKnown(QStringList &notes, const QStringList &known, const QString &file)
{
    if (!known.isEmpty())
        notes << Texts::tr("%1: the scene keeps its own curves: %2.").arg(file, known.join(QStringLiteral(", ")));
}

/// Fills names to place with landmarks.
class Filling {
public:
    Filling(std::vector<Landmark> &all, std::vector<Landmark> &landmarks) : m_all(all), m_landmarks(landmarks)
    {
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!all[i].isPlaced() && !all[i].name.empty())
                m_waiting.push_back(i);
        }
    }

    bool isWaitedFor() const { return !m_waiting.empty(); }

    /// Exact names first: "a b" and "a_b" must not be mixed up.
    void fill()
    {
        m_isTaken.assign(m_landmarks.size(), false);
        pass([](const std::string &name) { return QString::fromStdString(name); });
        pass(keyOf);
        for (std::size_t i = 0; i < m_landmarks.size(); ++i) {
            if (m_isTaken[i])
                continue;
            joined.unmatched.push_back(m_landmarks[i].name);
            m_all.push_back(std::move(m_landmarks[i]));
        }
    }

    JoinedLandmarks joined;
    std::map<std::string, std::string> renamed; ///< from the file's name

private:
    template <class Key>
    void pass(const Key &keyOfName)
    {
        std::multimap<QString, std::size_t> waiting; // in order for equal keys
        for (const std::size_t index : m_waiting) {
            if (const QString key = keyOfName(m_all[index].name); !key.isEmpty())
                waiting.emplace(key, index);
        }
        std::vector<std::size_t> filled;
        for (std::size_t i = 0; i < m_landmarks.size(); ++i) {
            if (m_isTaken[i])
                continue;
            const auto [found, past] = waiting.equal_range(keyOfName(m_landmarks[i].name)); // the first of equal names
            if (found == past)
                continue;
            take(i, found->second);
            filled.push_back(found->second);
            waiting.erase(found);
        }
        std::erase_if(m_waiting, [&](std::size_t index) {
            return std::find(filled.begin(), filled.end(), index) != filled.end();
        });
    }

    void take(std::size_t point, std::size_t index)
    {
        Landmark &from = m_landmarks[point], &to = m_all[index];
        m_isTaken[point] = true;
        if (from.name != to.name)
            renamed[from.name] = to.name;
        from.name = to.name;
        if (from.note.empty())
            from.note = to.note;
        if (!from.color)
            from.color = to.color;
        addKeys(from.extra, to.extra);
        if (from.isPlaced())
            ++joined.filled;
        else if (from.absence == landmarks::Absence::NotPlaced) // the file knows no more
            from.absence = to.absence;
        to = std::move(from);
    }

    std::vector<Landmark> &m_all, &m_landmarks;
    std::vector<std::size_t> m_waiting;
    std::vector<bool> m_isTaken;
};

} // namespace

bool areNameless(const std::vector<Landmark> &landmarks)
{
    return !landmarks.empty() && std::all_of(landmarks.begin(), landmarks.end(), [](const Landmark &landmark) {
        return landmark.name.empty();
    });
}

void nameByOrder(std::vector<Landmark> &landmarks, const std::vector<Landmark> &there)
{
    auto point = landmarks.begin();
    for (const Landmark &other : there) {
        if (point == landmarks.end())
            return;
        if (!other.isPlaced() && !other.name.empty())
            (point++)->name = other.name;
    }
}

JoinedLandmarks fillLandmarks(LandmarkSet &set, const std::vector<Landmark> &there)
{
    std::vector<Landmark> all = there;
    Filling filling(all, set.landmarks);
    const bool isWaitedFor = filling.isWaitedFor();
    filling.fill();
    set.landmarks = std::move(all);
    rename(set.curves, filling.renamed);
    if (!isWaitedFor)
        filling.joined.unmatched.clear();
    return std::move(filling.joined);
}

JoinedLandmarks replaceLandmarks(LandmarkSet &set, const LandmarkSet &before, std::size_t taken, const QString &file)
{
    JoinedLandmarks joined;
    if (areNameless(set.landmarks) && set.landmarks.size() == before.landmarks.size()
        && !areNameless(before.landmarks)) {
        for (std::size_t i = 0; i < set.landmarks.size(); ++i)
            set.landmarks[i].name = before.landmarks[i].name;
        joined.notes
            << Texts::tr("%1 has no names: its landmarks took the names of the former ones, in order.").arg(file);
    }
    std::map<QString, std::string> names; // of the scene
    for (const Landmark &landmark : before.landmarks) {
        if (const QString key = keyOf(landmark.name); !key.isEmpty() && !names.emplace(key, landmark.name).second)
            names[key].clear(); // ambiguous
    }
    for (const Landmark &landmark : set.landmarks) { // a name that is already spelled the same stays
        if (const auto known = names.find(keyOf(landmark.name)); known != names.end() && known->second == landmark.name)
            known->second.clear();
    }
    std::map<std::string, std::string> renamed;
    for (Landmark &landmark : set.landmarks) {
        const auto known = names.find(keyOf(landmark.name));
        if (known == names.end() || known->second.empty())
            continue;
        renamed[landmark.name] = known->second;
        landmark.name = std::exchange(known->second, std::string()); // once
    }
    rename(set.curves, renamed);
    if (set.unit.empty())
        set.unit = before.unit;
    else if (!before.unit.empty() && set.unit != before.unit)
        joined.notes << Texts::tr("%1 is in %2, which replaces the scene's unit, %3. Coordinates are not converted.")
                            .arg(file, QString::fromStdString(set.unit), QString::fromStdString(before.unit));
    if (set.name.empty())
        set.name = before.name;
    if (set.mesh.empty())
        set.mesh = before.mesh;
    set.placing = before.placing;
    set.measures = before.measures;   // the protocol of the scene and of its series
    if (set.curves.size() == taken) { // the file defines no curves as such
        tellKnown(joined.notes, leaveKnownOut(set.curves, taken, before.curves), file);
        set.curves.insert(set.curves.begin(), before.curves.begin(),
                          before.curves.end()); // they name their landmarks
    }
    addKeys(set.extra, before.extra); // for equal keys the file's value wins
    return joined;
}

JoinedLandmarks appendLandmarks(LandmarkSet &set, const LandmarkSet &before, std::size_t taken, const QString &file)
{
    LandmarkSet all = before;
    JoinedLandmarks joined = fillLandmarks(set, before.landmarks);
    all.landmarks = std::move(set.landmarks);
    tellKnown(joined.notes, leaveKnownOut(set.curves, taken, before.curves), file);
    all.curves.insert(all.curves.end(), std::make_move_iterator(set.curves.begin()),
                      std::make_move_iterator(set.curves.end()));
    if (!set.unit.empty() && set.unit != before.unit)
        joined.notes << (before.unit.empty()
                             ? Texts::tr("%1 is in %2; the scene has no unit. Coordinates are not converted.")
                                   .arg(file, QString::fromStdString(set.unit))
                             : Texts::tr("%1 is in %2, the scene in %3. Coordinates are not converted.")
                                   .arg(file, QString::fromStdString(set.unit), QString::fromStdString(before.unit)));
    if (const QStringList leftOut = addKeys(all.extra, set.extra); !leftOut.isEmpty())
        joined.notes << Texts::tr("%1: the scene keeps its own values of these: %2.")
                            .arg(file, leftOut.join(QStringLiteral(", ")));
    set = std::move(all);
    return joined;
}

} // namespace unprojector::gui
