#pragma once

#include "core/scene/scene.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A chosen object of a document, tracked while objects are added, removed, reordered, moved or
/// renamed. In another scene no object is chosen.
class FollowedObject : public QObject {
    Q_OBJECT
public:
    explicit FollowedObject(const SceneDocument &document, QObject *parent = nullptr);

    /// @param index  in the document's list, or nothing
    void choose(std::optional<std::size_t> index);
    /// Its index in the current list; nothing if none was chosen or it was removed.
    std::optional<std::size_t> index();
    /// Its index before it was removed; 0 if none was chosen in this scene.
    std::size_t lastIndex() const { return m_lastIndex; }

private:
    const SceneDocument &m_document;
    std::vector<scene::SceneObject> m_listed; ///< the list at the last look-up
    std::optional<std::size_t> m_index;
    std::size_t m_lastIndex = 0;
};

} // namespace unprojector::gui
