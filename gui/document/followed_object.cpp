#include "gui/document/followed_object.h"

#include "gui/document/scene_document.h"

namespace unprojector::gui {
using namespace scene;

FollowedObject::FollowedObject(const SceneDocument &document, QObject *parent) : QObject(parent), m_document(document)
{
    connect(&document, &SceneDocument::opened, this, [this] {
        choose(std::nullopt);
        m_lastIndex = 0;
    });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        // Follows step by step: of an object that is moved and then renamed, only the first step
        // reveals its origin.
        if (changes & (Change::Objects | Change::Names | Change::Placement))
            static_cast<void>(index());
    });
}

void FollowedObject::choose(std::optional<std::size_t> index)
{
    m_index = index;
    m_lastIndex = index.value_or(m_lastIndex);
    m_listed = index ? m_document.objects() : std::vector<SceneObject>();
}

std::optional<std::size_t> FollowedObject::index()
{
    if (!m_index)
        return std::nullopt;
    // Receivers that are notified before this object need the current list.
    const std::vector<SceneObject> &now = m_document.objects();
    const bool isOtherList = changesBetween(m_listed, now).testFlag(Change::Objects);
    choose(isOtherList ? indexAfter(m_listed, *m_index, now) : m_index);
    return m_index;
}

} // namespace unprojector::gui
