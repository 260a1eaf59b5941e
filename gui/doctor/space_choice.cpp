#include "gui/doctor/space_choice.h"

#include "gui/document/followed_object.h"
#include "gui/document/scene_document.h"
#include "gui/text/bundled_names.h"

#include <algorithm>

namespace unprojector::gui {
using namespace doctor;
using namespace scene;

namespace {

// The items after the world; a chosen object that was removed comes last.
constexpr int kEyeItem = 1;
constexpr int kFirstObjectItem = 2;

} // namespace

SpaceChoice::SpaceChoice(const SceneDocument &document, QWidget *parent)
    : QComboBox(parent), m_document(document), m_object(new FollowedObject(document, this))
{
    setAccessibleName(tr("Space of the points that the program got"));
    setToolTip(tr("Space in which the program expresses its points"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(8);
    connect(this, &QComboBox::activated, this, &SpaceChoice::take);
    refresh();
}

void SpaceChoice::take(int index)
{
    const std::vector<SceneObject> &objects = m_document.objects();
    const auto object = static_cast<std::size_t>(std::max(0, index - kFirstObjectItem));
    if (index >= kFirstObjectItem && object >= objects.size())
        return; // the removed one, once more
    const bool isObject = index >= kFirstObjectItem;
    m_object->choose(isObject ? std::optional(object) : std::nullopt);
    m_name = isObject ? std::optional(objects[object].name) : std::nullopt;
    refresh(); // a removed one is no choice any more
}

void SpaceChoice::refresh()
{
    const std::vector<SceneObject> &objects = m_document.objects();
    if (m_name && !m_object->index()) {
        // Removing may be undone. Names are unique in a scene that this program has written.
        const auto isIt = [this](const SceneObject &object) { return object.name == *m_name; };
        if (const auto found = std::ranges::find_if(objects, isIt);
            found != objects.end() && std::ranges::count_if(objects, isIt) == 1)
            m_object->choose(static_cast<std::size_t>(found - objects.begin()));
    }
    const std::optional<std::size_t> chosen = m_object->index();
    int item = m_name ? kFirstObjectItem : currentIndex() == kEyeItem ? kEyeItem : 0;
    QStringList names{tr("World"), tr("Eye")};
    for (const SceneObject &object : objects)
        names << tr("Object: %1").arg(readName(object.name, objects));
    if (chosen) {
        m_name = objects[*chosen].name;
        item += static_cast<int>(*chosen);
    } else if (m_name) {
        item = static_cast<int>(names.size());
        names << tr("Object: %1 (removed)").arg(readName(*m_name));
    }
    QStringList shown;
    for (int i = 0; i < count(); ++i)
        shown << itemText(i);
    if (names != shown) {
        clear();
        addItems(names);
    }
    setCurrentIndex(item);
}

std::optional<SpaceChoice::Space> SpaceChoice::space() const
{
    const int item = currentIndex();
    if (item < kFirstObjectItem)
        return Space{item == kEyeItem ? PointSpace::Eye : PointSpace::World, 0};
    const auto object = static_cast<std::size_t>(item - kFirstObjectItem);
    return object < m_document.objects().size() ? std::optional(Space{PointSpace::Object, object}) : std::nullopt;
}

} // namespace unprojector::gui
