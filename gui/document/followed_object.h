#pragma once

#include "core/scene/scene.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// One object of a document, chosen by somebody and known from then on, whatever is done to the list: others are added
/// and removed, it is dragged elsewhere, moved in the world, renamed. In another scene nothing is chosen.
class FollowedObject : public QObject {
    Q_OBJECT
public:
    explicit FollowedObject(const SceneDocument &document, QObject *parent = nullptr);

    /// @param index  in the document's list, or nothing
    void choose(std::optional<std::size_t> index);
    /// Where it is in the list as it is now; nothing where none was chosen, or it was removed.
    std::optional<std::size_t> index();
    /// Where it was before it was removed; 0 where none was chosen in this scene.
    std::size_t lastIndex() const { return m_lastIndex; }

private:
    const SceneDocument &m_document;
    std::vector<scene::SceneObject> m_listed; ///< when it was last looked for
    std::optional<std::size_t> m_index;
    std::size_t m_lastIndex = 0;
};

} // namespace unprojector::gui
