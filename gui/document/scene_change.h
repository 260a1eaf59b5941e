#pragma once

#include "core/scene/scene.h"

#include <QString>
#include <QUndoCommand>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace unprojector::gui {

/// The name of an edit in the undo menu.
struct EditLabel {
    QString text;          ///< "Near"
    QString mergeKey = {}; ///< consecutive edits with the same key are undone as one; empty: never
};

/// A state of the document. Copies share the objects and the landmarks, which may be many: looking
/// around copies a few numbers.
struct SceneState {
    scene::SceneSettings settings;
    std::shared_ptr<const std::vector<scene::SceneObject>> objects;
    std::shared_ptr<const landmarks::LandmarkSet> landmarks;
    /// The number of the last edit in this state. Changes of the view keep the number, so two
    /// states with the same number can differ only in the view.
    std::uint64_t edit = 0;
};

/// One undoable change: the state before and after it.
class SceneChange : public QUndoCommand {
public:
    /// @param restore  applies a state
    SceneChange(SceneState before, SceneState after, const EditLabel &label,
                std::function<void(const SceneState &)> restore);

    void undo() override;
    void redo() override;
    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand *next) override;
    const SceneState &before() const { return m_before; }
    const SceneState &after() const { return m_after; }

private:
    bool isEdit() const { return m_before.edit != m_after.edit; }

    SceneState m_before;
    SceneState m_after;
    QString m_mergeKey;
    std::function<void(const SceneState &)> m_restore;
    bool m_isApplied = true; ///< the document made the change before it pushed this command
};

} // namespace unprojector::gui
