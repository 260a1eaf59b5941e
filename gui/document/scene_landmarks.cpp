#include "gui/document/scene_landmarks.h"

#include "core/landmarks/name_key.h"
#include "core/landmarks/protocol.h"
#include "core/ray/placed_landmark.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Absence;
using landmarks::Landmark;

/// The index in one list of a landmark of another list. Landmarks have no id: it is the identical
/// one, else the one at the same index if both lists are equally long. One that kept its index is
/// no other's match.
class IndicesAfter {
public:
    IndicesAfter(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
        : m_before(before), m_after(after), m_isTaken(after.size(), false)
    {
    }

    std::optional<std::size_t> of(std::size_t index)
    {
        if (index >= m_before.size())
            return std::nullopt;
        const Landmark &landmark = m_before[index];
        if (index < m_after.size() && m_after[index] == landmark)
            return taken(index);
        for (std::size_t i = 0; i < m_after.size(); ++i) {
            const bool hasStayed = m_before.size() == m_after.size() && m_before[i] == m_after[i];
            if (!m_isTaken[i] && !hasStayed && m_after[i] == landmark)
                return taken(i);
        }
        return m_before.size() == m_after.size() ? std::optional(taken(index)) : std::nullopt;
    }

private:
    std::size_t taken(std::size_t index)
    {
        m_isTaken[index] = true;
        return index;
    }

    const std::vector<Landmark> &m_before, &m_after;
    std::vector<bool> m_isTaken;
};

/// The single landmark that waits for a click again, as after undoing its placement.
std::optional<std::size_t> waitingAgain(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
{
    std::optional<std::size_t> only;
    for (std::size_t i = 0; before.size() == after.size() && i < after.size(); ++i) {
        if (before[i] == after[i])
            continue;
        const bool waits = after[i].isToPlace()
                           && (before[i].isPlaced()
                               || (before[i].absence != Absence::NotPlaced && after[i].absence == Absence::NotPlaced));
        if (only || !waits)
            return std::nullopt;
        only = i;
    }
    return only;
}

std::optional<std::size_t> nextToPlace(const std::vector<Landmark> &landmarks, std::optional<std::size_t> after)
{
    const std::size_t first = after ? *after + 1 : 0;
    for (const Absence absence : {Absence::NotPlaced, Absence::Skipped}) {
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            const std::size_t index = (first + i) % landmarks.size();
            if (!landmarks[index].isPlaced() && landmarks[index].absence == absence)
                return index;
        }
    }
    return std::nullopt;
}

/// The next landmark to place after an edit.
/// @param index  its index before
/// @param now    its index after; nothing: it is gone
std::optional<std::size_t> nextAfter(const std::vector<Landmark> &before, const std::vector<Landmark> &after,
                                     std::size_t index, std::optional<std::size_t> now)
{
    if (!now)
        return nextToPlace(after, std::nullopt);
    const Landmark &was = before[index], &is = after[*now];
    const bool isPassed = is.isPlaced() || (is.absence != was.absence && is.absence != Absence::NotPlaced);
    return isPassed ? nextToPlace(after, now) : now;
}

/// Copies position, anchor, uncertainty and the edge of the pixel; without a position, it is to be
/// placed.
void takePlace(Landmark &landmark, const Landmark &of)
{
    landmark.world = of.world;
    landmark.absence = Absence::NotPlaced;
    landmark.object = of.object;
    landmark.anchor = of.anchor;
    landmark.uncertainty = of.uncertainty;
    ray::takeEdge(landmark, of);
}

} // namespace

SceneLandmarks::SceneLandmarks(SceneDocument &document, ChangeNotifier &changes)
    : m_document(document), m_changes(changes)
{
    // Nothing is selected in another scene, and the first landmark to place is next.
    connect(&document, &SceneDocument::opened, this,
            [this] { take({}, std::nullopt, nextToPlace(all(), std::nullopt)); });
}

const std::vector<Landmark> &SceneLandmarks::all() const
{
    return m_document.landmarks();
}

QString SceneLandmarks::shownNameOf(const std::vector<Landmark> &landmarks, std::size_t index)
{
    const QString name = index < landmarks.size() ? shownName(landmarks[index].name) : QString();
    return name.isEmpty() ? tr("landmark %1").arg(index + 1) : name;
}

// ---- selection ----------------------------------------------------------------------------------

bool SceneLandmarks::isSelected(std::size_t index) const
{
    return std::binary_search(m_selection.begin(), m_selection.end(), index);
}

bool SceneLandmarks::take(std::vector<std::size_t> indices, std::optional<std::size_t> current,
                          std::optional<std::size_t> nextUnplaced)
{
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    if (indices.empty())
        current = std::nullopt;
    else if (!current || !std::binary_search(indices.begin(), indices.end(), *current))
        current = indices.front();
    orderSelection(indices, current);
    const bool isOther = indices != m_selection || current != m_current || nextUnplaced != m_nextUnplaced;
    m_selection = std::move(indices);
    m_current = current;
    m_nextUnplaced = nextUnplaced;
    return isOther;
}

void SceneLandmarks::orderSelection(const std::vector<std::size_t> &indices, std::optional<std::size_t> current)
{
    std::erase_if(m_order,
                  [&](std::size_t index) { return !std::binary_search(indices.begin(), indices.end(), index); });
    std::vector<std::size_t> added;
    for (const std::size_t index : indices) {
        if (std::find(m_order.begin(), m_order.end(), index) == m_order.end())
            added.push_back(index);
    }
    const bool endsAtCurrent = current && std::find(added.begin(), added.end(), *current) != added.end();
    if (added.size() > 1 && !endsAtCurrent) { // all of them at once
        m_order = indices;
        return;
    }
    if (endsAtCurrent && !m_order.empty() && *current < m_order.back()) // a range upwards
        std::reverse(added.begin(), added.end());
    m_order.insert(m_order.end(), added.begin(), added.end());
}

void SceneLandmarks::select(std::vector<std::size_t> indices, std::optional<std::size_t> current)
{
    const std::vector<Landmark> &landmarks = all();
    indices.erase(
        std::remove_if(indices.begin(), indices.end(), [&](std::size_t index) { return index >= landmarks.size(); }),
        indices.end());
    const bool waits = current && std::find(indices.begin(), indices.end(), *current) != indices.end()
                       && !landmarks[*current].isPlaced();
    if (take(std::move(indices), current, waits ? current : m_nextUnplaced))
        m_changes.notify(Change::LandmarkSelection);
}

void SceneLandmarks::selectInOrder(std::vector<std::size_t> order)
{
    std::erase_if(order, [this](std::size_t index) { return index >= all().size(); });
    const bool isOtherOrder = order != m_order;
    m_order = order;
    if (take(std::move(order), std::nullopt, m_nextUnplaced) || isOtherOrder)
        m_changes.notify(Change::LandmarkSelection);
}

void SceneLandmarks::toggle(std::size_t index)
{
    std::vector<std::size_t> indices = m_selection;
    if (const auto found = std::find(indices.begin(), indices.end(), index); found != indices.end()) {
        indices.erase(found);
        select(std::move(indices), m_current);
        return;
    }
    indices.push_back(index);
    select(std::move(indices), index);
}

void SceneLandmarks::setNextUnplaced(std::optional<std::size_t> index)
{
    if (index && (*index >= all().size() || all()[*index].isPlaced()))
        index = nextToPlace(all(), std::nullopt);
    if (take(m_selection, m_current, index))
        m_changes.notify(Change::LandmarkSelection);
}

void SceneLandmarks::waitForNext(std::optional<std::size_t> after)
{
    setNextUnplaced(nextToPlace(all(), after));
}

Changes SceneLandmarks::follow(const std::vector<Landmark> &before, const std::vector<Landmark> &after)
{
    IndicesAfter places(before, after);
    std::vector<std::size_t> selection;
    std::optional<std::size_t> current;
    for (const std::size_t index : m_order) {
        const std::optional<std::size_t> now = places.of(index);
        if (!now)
            continue;
        selection.push_back(*now);
        if (index == m_current)
            current = now;
    }
    m_order = selection;
    std::optional<std::size_t> next = waitingAgain(before, after);
    const bool isUndone = next.has_value();
    if (!next && m_nextUnplaced && *m_nextUnplaced < before.size())
        next = nextAfter(before, after, *m_nextUnplaced, IndicesAfter(before, after).of(*m_nextUnplaced));
    else if (!next)
        next = nextToPlace(after, std::nullopt);
    // A landmark to place that was next is selected no more: the next click does not place it.
    const std::optional<std::size_t> wasNext =
        m_nextUnplaced ? IndicesAfter(before, after).of(*m_nextUnplaced) : std::nullopt;
    if (next) {
        std::erase_if(selection, [&](std::size_t index) {
            return after[index].isToPlace() && index != *next && (isUndone || index == wasNext);
        });
        if (isUndone && selection.empty())
            selection = {*next};
        m_order = selection;
    }
    return take(std::move(selection), current, next) ? Change::LandmarkSelection : Changes();
}

// ---- edits --------------------------------------------------------------------------------------

std::string SceneLandmarks::freeName() const
{
    const auto isTaken = [this](const std::string &name) {
        return std::any_of(all().begin(), all().end(),
                           [&](const Landmark &landmark) { return landmarks::isSameName(landmark.name, name); });
    };
    for (std::size_t number = all().size() + 1;; ++number) {
        if (std::string name = tr("Landmark %1").arg(number).toStdString(); !isTaken(name))
            return name;
    }
}

Check SceneLandmarks::place(Landmark placed)
{
    const ChangeNotifier::Batch batch(m_changes);
    std::vector<Landmark> landmarks = all();
    const std::size_t index = m_nextUnplaced.value_or(landmarks.size());
    if (m_nextUnplaced) {
        takePlace(landmarks[index], placed);
    } else {
        if (placed.name.empty())
            placed.name = freeName();
        landmarks.push_back(std::move(placed));
    }
    const QString text = tr("Place %1").arg(shownNameOf(landmarks, index));
    if (const Check done = editLandmarks(m_document, std::move(landmarks), {text}); !done)
        return done;
    selectOnly(index);
    return std::monostate{};
}

template <class Change>
Check SceneLandmarks::edit(const std::vector<std::size_t> &indices, const QString &one, const QString &several,
                           const Change &change, const QString &mergeKey)
{
    std::vector<Landmark> landmarks = all();
    std::optional<std::size_t> only;
    for (const std::size_t index : indices) {
        Q_ASSERT(index < landmarks.size());
        only = index;
        change(landmarks[index]);
    }
    if (!only)
        return std::monostate{};
    const QString text = indices.size() == 1 ? one.arg(shownNameOf(all(), *only)) : several;
    return editLandmarks(m_document, std::move(landmarks), {text, mergeKey});
}

Check SceneLandmarks::move(std::size_t index, const Landmark &to, const QString &mergeKey)
{
    return edit(
        {index}, tr("Move %1"), {}, [&](Landmark &landmark) { takePlace(landmark, to); }, mergeKey);
}

Check SceneLandmarks::moveAll(const std::vector<Move> &moves, const QString &mergeKey)
{
    std::vector<std::size_t> indices;
    indices.reserve(moves.size());
    for (const Move &move : moves)
        indices.push_back(move.index);
    std::size_t next = 0; // they are in this order
    return edit(
        indices, tr("Move %1"), tr("Move %n landmarks", nullptr, static_cast<int>(indices.size())),
        [&](Landmark &landmark) { takePlace(landmark, moves[next++].to); }, mergeKey);
}

Check SceneLandmarks::moveTo(std::size_t index, const WorldPoint &to, const QString &mergeKey)
{
    Q_ASSERT(index < all().size());
    Landmark moved;
    moved.world = to;
    moved.object = all()[index].object;
    return move(index, moved, mergeKey);
}

Check SceneLandmarks::rename(std::size_t index, const QString &name)
{
    Q_ASSERT(index < all().size());
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    const std::string wanted = name.trimmed().toStdString();
    for (landmarks::KeptMeasure &measure : set.measures) {
        for (std::string &point : measure.landmarks) {
            if (landmarks::indexOfName(set.landmarks, point) == index && !wanted.empty())
                point = wanted;
        }
    }
    const std::string before = std::exchange(set.landmarks[index].name, wanted);
    for (landmarks::Curve &curve : set.curves) { // which refer to landmarks by name
        if (!before.empty())
            std::replace(curve.points.begin(), curve.points.end(), before, set.landmarks[index].name);
    }
    return editLandmarkSet(m_document, std::move(set), {tr("Rename %1").arg(shownNameOf(all(), index))});
}

Check SceneLandmarks::setNote(std::size_t index, const QString &note)
{
    return edit({index}, tr("Note on %1"), {}, [&](Landmark &landmark) { landmark.note = note.toStdString(); });
}

Check SceneLandmarks::setColor(const std::vector<std::size_t> &indices, const std::optional<glm::u8vec3> &color)
{
    return edit(indices, tr("Colour of %1"), tr("Colour of %n landmarks", nullptr, static_cast<int>(indices.size())),
                [&](Landmark &landmark) { landmark.color = color; });
}

Check SceneLandmarks::setHidden(const std::vector<std::size_t> &indices, bool isHidden)
{
    const int count = static_cast<int>(indices.size());
    return edit(indices, isHidden ? tr("Hide %1") : tr("Show %1"),
                isHidden ? tr("Hide %n landmarks", nullptr, count) : tr("Show %n landmarks", nullptr, count),
                [&](Landmark &landmark) { landmark.isHidden = isHidden; });
}

Check SceneLandmarks::setMissing(const std::vector<std::size_t> &indices, bool isMissing)
{
    const int count = static_cast<int>(indices.size());
    return edit(indices, isMissing ? tr("Mark %1 as missing") : tr("Mark %1 as not missing"),
                isMissing ? tr("Mark %n landmarks as missing", nullptr, count)
                          : tr("Mark %n landmarks as not missing", nullptr, count),
                [isMissing](Landmark &landmark) {
                    if (isMissing)
                        takePlace(landmark, {});
                    if (isMissing || landmark.isMissing())
                        landmark.absence = isMissing ? Absence::Missing : Absence::NotPlaced;
                });
}

Check SceneLandmarks::skip(std::size_t index)
{
    Q_ASSERT(index < all().size());
    if (all()[index].isPlaced() || all()[index].absence != Absence::NotPlaced) {
        waitForNext(index);
        return std::monostate{};
    }
    return edit({index}, tr("Skip %1"), {}, [](Landmark &landmark) { landmark.absence = Absence::Skipped; });
}

Check SceneLandmarks::placeAgain(const std::vector<std::size_t> &indices)
{
    return edit(indices, tr("Place %1 again"),
                tr("Place %n landmarks again", nullptr, static_cast<int>(indices.size())),
                [](Landmark &landmark) { takePlace(landmark, {}); });
}

Check SceneLandmarks::remove(const std::vector<std::size_t> &indices)
{
    std::vector<Landmark> left;
    for (std::size_t i = 0; i < all().size(); ++i) {
        if (std::find(indices.begin(), indices.end(), i) == indices.end())
            left.push_back(all()[i]);
    }
    if (left.size() == all().size())
        return std::monostate{};
    const QString text = indices.size() == 1 ? tr("Remove %1").arg(shownNameOf(all(), indices.front()))
                                             : tr("Remove %n landmarks", nullptr, static_cast<int>(indices.size()));
    return editLandmarks(m_document, std::move(left), {text});
}

Check SceneLandmarks::reorder(std::size_t from, std::size_t to)
{
    Q_ASSERT(from < all().size() && to < all().size());
    std::vector<std::size_t> order(all().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto at = [&order](std::size_t index) { return order.begin() + static_cast<std::ptrdiff_t>(index); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
    return arrange(order);
}

Check SceneLandmarks::arrange(const std::vector<std::size_t> &order)
{
    Q_ASSERT(std::is_permutation(order.begin(), order.end(),
                                 [this] {
                                     std::vector<std::size_t> indices(all().size());
                                     std::iota(indices.begin(), indices.end(), std::size_t{0});
                                     return indices;
                                 }()
                                     .begin()));
    std::vector<Landmark> landmarks;
    landmarks.reserve(order.size());
    for (const std::size_t index : order)
        landmarks.push_back(all()[index]);
    return editLandmarks(m_document, std::move(landmarks), {tr("Order of landmarks")});
}

} // namespace unprojector::gui
