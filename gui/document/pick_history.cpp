#include "gui/document/pick_history.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace unprojector::gui {
using namespace unproject;

namespace {

/// Returns whether two clicks read the same values at the same pixel, as in a double click.
bool isSameClick(const KeptPick &a, const KeptPick &b)
{
    return a.pick->devicePixel == b.pick->devicePixel && a.pick->window.z == b.pick->window.z
           && a.pick->object == b.pick->object && a.ray.snap == b.ray.snap && a.placement == b.placement
           && a.pick->setup == b.pick->setup;
}

} // namespace

PickHistory::PickHistory(SceneDocument &document, QObject *parent) : QObject(parent), m_document(document)
{
    connect(&document, &SceneDocument::opened, this, [this] {
        m_picks.clear();
        m_lastNumber = m_shown = 0;
        emit changed();
    });
    connect(&document, &SceneDocument::changed, this, &PickHistory::follow);
    connect(&document.picks(), &Picks::takenBack, this, &PickHistory::takeBack);
    takePick();
}

std::vector<EarlierPick> PickHistory::picks() const
{
    std::vector<EarlierPick> there;
    std::copy_if(m_picks.begin(), m_picks.end(), std::back_inserter(there),
                 [](const EarlierPick &earlier) { return !earlier.isLost; });
    return there;
}

void PickHistory::show(int number)
{
    const auto found = std::find_if(m_picks.begin(), m_picks.end(), [number](const EarlierPick &earlier) {
        return earlier.number == number && !earlier.isLost;
    });
    if (found != m_picks.end() && number != m_shown)
        m_document.picks().show(KeptPick(found->kept)); // a copy: the list changes meanwhile
}

void PickHistory::follow(Changes changes)
{
    if (changes & (Change::Objects | Change::Placement | Change::Visibility | Change::Names))
        followObjects(changes.testFlag(Change::Objects));
    if (changes & (Change::Pick | Change::Ray))
        takePick();
    if (changes & (Change::Objects | Change::Names | Change::Pick | Change::Ray))
        emit changed();
}

void PickHistory::followObjects(bool areOthers)
{
    const ObjectList &objects = m_document.picks().objectList();
    for (EarlierPick &earlier : m_picks) {
        if (!areOthers) {
            if (!earlier.isLost)
                earlier.objects = objects; // so that an object is identified by its present state
            continue;
        }
        KeptPick now = earlier.kept;
        gui::follow(now, *earlier.objects, *objects);
        earlier.isLost = earlier.kept.pick->hit() && !now.pick->hit();
        if (earlier.isLost)
            continue; // keeps its old list, which identifies it later
        earlier.kept = std::move(now);
        earlier.objects = objects;
    }
}

void PickHistory::takePick()
{
    const KeptPick &kept = m_document.picks().keptPick();
    m_shown = 0;
    if (!kept.pick)
        return;
    auto found = std::find_if(m_picks.begin(), m_picks.end(),
                              [&kept](const EarlierPick &earlier) { return earlier.kept.click == kept.click; });
    if (found == m_picks.end()) {
        m_isRepeat = !m_picks.empty() && !m_picks.back().isLost && isSameClick(m_picks.back().kept, kept);
        if (!m_isRepeat)
            m_picks.push_back({++m_lastNumber, {}, {}});
        if (m_picks.size() > kMost)
            m_picks.erase(m_picks.begin());
        found = m_picks.end() - 1;
    }
    found->kept = kept;
    found->objects = m_document.picks().objectList();
    m_shown = found->number;
}

void PickHistory::takeBack()
{
    const bool isLast = !m_picks.empty() && m_picks.back().kept.click == m_document.picks().keptPick().click;
    if (!isLast || m_isRepeat)
        return;
    m_picks.pop_back();
    --m_lastNumber;
}

} // namespace unprojector::gui
