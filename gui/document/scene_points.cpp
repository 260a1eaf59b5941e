#include "gui/document/scene_points.h"

#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace unprojector::gui {
namespace {

using landmarks::Landmark;

/// Where a point of one list is in another one. Points have no mark of their own: it is the one that is alike in everything,
/// else the one in its place where both lists are as long. One that stays where it was is no other point's.
class PlacesAfter {
public:
    PlacesAfter(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
        : m_before(before), m_after(after), m_isTaken(after.size(), false)
    {
    }

    std::optional<std::size_t> of(std::size_t place)
    {
        if (place >= m_before.size())
            return std::nullopt;
        const Landmark &point = m_before[place];
        if (place < m_after.size() && m_after[place] == point)
            return taken(place);
        for (std::size_t i = 0; i < m_after.size(); ++i) {
            const bool hasStayed = m_before.size() == m_after.size() && m_before[i] == m_after[i];
            if (!m_isTaken[i] && !hasStayed && m_after[i] == point)
                return taken(i);
        }
        return m_before.size() == m_after.size() ? std::optional(taken(place)) : std::nullopt;
    }

private:
    std::size_t taken(std::size_t place)
    {
        m_isTaken[place] = true;
        return place;
    }

    const std::vector<Landmark> &m_before, &m_after;
    std::vector<bool> m_isTaken;
};

/// The single point that has lost its place, as by the undoing of its placing.
std::optional<std::size_t> unplaced(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
{
    std::optional<std::size_t> only;
    for (std::size_t i = 0; before.size() == after.size() && i < after.size(); ++i) {
        if (before[i] == after[i])
            continue;
        if (only || before[i].isMissing() || !after[i].isMissing())
            return std::nullopt;
        only = i;
    }
    return only;
}

std::optional<std::size_t> nextMissing(const std::vector<Landmark> &points, std::optional<std::size_t> after)
{
    const std::size_t first = after ? *after + 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t place = (first + i) % points.size();
        if (points[place].isMissing())
            return place;
    }
    return std::nullopt;
}

/// Where it is, and how that is known.
void takePlace(Landmark &point, const Landmark &of)
{
    point.world = of.world;
    point.object = of.object;
    point.hold = of.hold;
    point.uncertainty = of.uncertainty;
}

} // namespace

ScenePoints::ScenePoints(SceneDocument &document, ChangeNotifier &changes) : m_document(document), m_changes(changes)
{
    // In another scene nothing is selected, and the first missing landmark waits.
    connect(&document, &SceneDocument::opened, this,
            [this] { take({}, std::nullopt, nextMissing(all(), std::nullopt)); });
}

const std::vector<Landmark> &ScenePoints::all() const
{
    return m_document.landmarks();
}

QString ScenePoints::shownNameOf(const std::vector<Landmark> &points, std::size_t place)
{
    const QString name = place < points.size() ? shownName(points[place].name) : QString();
    return name.isEmpty() ? tr("point %1").arg(place + 1) : name;
}

// ---- what is selected --------------------------------------------------------------------------------------------

bool ScenePoints::isSelected(std::size_t place) const
{
    return std::binary_search(m_selection.begin(), m_selection.end(), place);
}

bool ScenePoints::take(std::vector<std::size_t> places, std::optional<std::size_t> current,
                       std::optional<std::size_t> waiting)
{
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.empty())
        current = std::nullopt;
    else if (!current || !std::binary_search(places.begin(), places.end(), *current))
        current = places.front();
    const bool isOther = places != m_selection || current != m_current || waiting != m_waiting;
    m_selection = std::move(places);
    m_current = current;
    m_waiting = waiting;
    return isOther;
}

void ScenePoints::select(std::vector<std::size_t> places, std::optional<std::size_t> current)
{
    const std::vector<Landmark> &points = all();
    places.erase(
        std::remove_if(places.begin(), places.end(), [&](std::size_t place) { return place >= points.size(); }),
        places.end());
    const bool waits = current && *current < points.size() && points[*current].isMissing();
    if (take(std::move(places), current, waits ? current : m_waiting))
        m_changes.notify(Change::LandmarkSelection);
}

void ScenePoints::toggle(std::size_t place)
{
    std::vector<std::size_t> places = m_selection;
    if (const auto found = std::find(places.begin(), places.end(), place); found != places.end()) {
        places.erase(found);
        select(std::move(places), m_current);
        return;
    }
    places.push_back(place);
    select(std::move(places), place);
}

void ScenePoints::setWaiting(std::optional<std::size_t> place)
{
    if (place && (*place >= all().size() || !all()[*place].isMissing()))
        place = std::nullopt;
    if (take(m_selection, m_current, place))
        m_changes.notify(Change::LandmarkSelection);
}

void ScenePoints::waitForNext(std::optional<std::size_t> after)
{
    setWaiting(nextMissing(all(), after));
}

Changes ScenePoints::follow(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
{
    PlacesAfter places(before, after);
    std::vector<std::size_t> selection;
    std::optional<std::size_t> current;
    for (const std::size_t place : m_selection) {
        const std::optional<std::size_t> now = places.of(place);
        if (!now)
            continue;
        selection.push_back(*now);
        if (place == m_current)
            current = now;
    }
    std::optional<std::size_t> waiting = m_waiting ? PlacesAfter(before, after).of(*m_waiting) : std::nullopt;
    if (waiting && !after[*waiting].isMissing())
        waiting = std::nullopt;
    if (const std::optional<std::size_t> again = unplaced(before, after))
        waiting = again;
    return take(std::move(selection), current, waiting) ? Change::LandmarkSelection : Changes();
}

// ---- edits -------------------------------------------------------------------------------------------------------

std::string ScenePoints::freeName() const
{
    const auto isTaken = [this](const std::string &name) {
        return std::any_of(all().begin(), all().end(), [&](const Landmark &point) { return point.name == name; });
    };
    for (std::size_t number = all().size() + 1;; ++number) {
        if (std::string name = tr("Point %1").arg(number).toStdString(); !isTaken(name))
            return name;
    }
}

Check ScenePoints::place(Landmark placed)
{
    const ChangeNotifier::Batch batch(m_changes);
    std::vector<Landmark> points = all();
    const std::size_t place = m_waiting.value_or(points.size());
    if (m_waiting) {
        takePlace(points[place], placed);
    } else {
        if (placed.name.empty())
            placed.name = freeName();
        points.push_back(std::move(placed));
    }
    const QString text = tr("Place %1").arg(shownNameOf(points, place));
    const bool hasWaited = m_waiting.has_value();
    if (const Check done = editLandmarks(m_document, std::move(points), {text}); !done)
        return done;
    selectOnly(place);
    if (hasWaited)
        waitForNext(place);
    return std::monostate{};
}

template <class Change>
Check ScenePoints::edit(const std::vector<std::size_t> &places, const QString &one, const QString &several,
                        const Change &change, const QString &mergeKey)
{
    std::vector<Landmark> points = all();
    std::optional<std::size_t> only;
    for (const std::size_t place : places) {
        Q_ASSERT(place < points.size());
        only = place;
        change(points[place]);
    }
    if (!only)
        return std::monostate{};
    const QString text = places.size() == 1 ? one.arg(shownNameOf(all(), *only)) : several;
    return editLandmarks(m_document, std::move(points), {text, mergeKey});
}

Check ScenePoints::move(std::size_t place, const Landmark &to, const QString &mergeKey)
{
    return edit(
        {place}, tr("Move %1"), {}, [&](Landmark &point) { takePlace(point, to); }, mergeKey);
}

Check ScenePoints::moveAll(const std::vector<Move> &moves, const QString &mergeKey)
{
    std::vector<std::size_t> places;
    places.reserve(moves.size());
    for (const Move &move : moves)
        places.push_back(move.place);
    std::size_t next = 0; // they come in this order
    return edit(
        places, tr("Move %1"), tr("Move %n points", nullptr, static_cast<int>(places.size())),
        [&](Landmark &point) { takePlace(point, moves[next++].to); }, mergeKey);
}

Check ScenePoints::moveTo(std::size_t place, const WorldPoint &to, const QString &mergeKey)
{
    Q_ASSERT(place < all().size());
    Landmark moved;
    moved.world = to;
    moved.object = all()[place].object;
    return move(place, moved, mergeKey);
}

Check ScenePoints::rename(std::size_t place, const QString &name)
{
    Q_ASSERT(place < all().size());
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    const std::string before = std::exchange(set.landmarks[place].name, name.trimmed().toStdString());
    for (landmarks::Curve &curve : set.curves) { // which know their points by their names
        if (!before.empty())
            std::replace(curve.points.begin(), curve.points.end(), before, set.landmarks[place].name);
    }
    return editLandmarkSet(m_document, std::move(set), {tr("Rename %1").arg(shownNameOf(all(), place))});
}

Check ScenePoints::setNote(std::size_t place, const QString &note)
{
    return edit({place}, tr("Note on %1"), {}, [&](Landmark &point) { point.note = note.toStdString(); });
}

Check ScenePoints::setColor(const std::vector<std::size_t> &places, const std::optional<glm::u8vec3> &color)
{
    return edit(places, tr("Colour of %1"), tr("Colour of %n points", nullptr, static_cast<int>(places.size())),
                [&](Landmark &point) { point.color = color; });
}

Check ScenePoints::setHidden(const std::vector<std::size_t> &places, bool isHidden)
{
    const int count = static_cast<int>(places.size());
    return edit(places, isHidden ? tr("Hide %1") : tr("Show %1"),
                isHidden ? tr("Hide %n points", nullptr, count) : tr("Show %n points", nullptr, count),
                [&](Landmark &point) { point.isHidden = isHidden; });
}

Check ScenePoints::setMissing(const std::vector<std::size_t> &places)
{
    const ChangeNotifier::Batch batch(m_changes);
    const std::optional<std::size_t> waiting = m_waiting; // what is not there is not what is placed next
    const Check done = edit(places, tr("%1 missing"), tr("%n points missing", nullptr, static_cast<int>(places.size())),
                            [](Landmark &point) { takePlace(point, {}); });
    setWaiting(waiting);
    return done;
}

Check ScenePoints::remove(const std::vector<std::size_t> &places)
{
    std::vector<Landmark> left;
    for (std::size_t i = 0; i < all().size(); ++i) {
        if (std::find(places.begin(), places.end(), i) == places.end())
            left.push_back(all()[i]);
    }
    if (left.size() == all().size())
        return std::monostate{};
    const QString text = places.size() == 1 ? tr("Remove %1").arg(shownNameOf(all(), places.front()))
                                            : tr("Remove %n points", nullptr, static_cast<int>(places.size()));
    return editLandmarks(m_document, std::move(left), {text});
}

Check ScenePoints::reorder(std::size_t from, std::size_t to)
{
    Q_ASSERT(from < all().size() && to < all().size());
    std::vector<std::size_t> order(all().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto at = [&order](std::size_t place) { return order.begin() + static_cast<std::ptrdiff_t>(place); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
    return arrange(order);
}

Check ScenePoints::arrange(const std::vector<std::size_t> &order)
{
    Q_ASSERT(std::is_permutation(order.begin(), order.end(),
                                 [this] {
                                     std::vector<std::size_t> places(all().size());
                                     std::iota(places.begin(), places.end(), std::size_t{0});
                                     return places;
                                 }()
                                     .begin()));
    std::vector<Landmark> points;
    points.reserve(order.size());
    for (const std::size_t place : order)
        points.push_back(all()[place]);
    return editLandmarks(m_document, std::move(points), {tr("Order of points")});
}

} // namespace unprojector::gui
