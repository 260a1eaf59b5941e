#include "gui/document/scene_change.h"

#include <utility>

namespace unprojector::gui {

SceneChange::SceneChange(SceneState before, SceneState after, const EditLabel &label,
                         std::function<void(const SceneState &)> restore)
    : QUndoCommand(label.text), m_before(std::move(before)), m_after(std::move(after)), m_mergeKey(label.mergeKey),
      m_restore(std::move(restore))
{
}

void SceneChange::undo()
{
    m_restore(m_before);
}

void SceneChange::redo()
{
    if (std::exchange(m_isApplied, false))
        return;
    m_restore(m_after);
}

bool SceneChange::mergeWith(const QUndoCommand *next)
{
    const auto *change = static_cast<const SceneChange *>(next);
    if (change->m_mergeKey != m_mergeKey || change->isEdit() != isEdit())
        return false;
    m_after = change->m_after;
    return true;
}

} // namespace unprojector::gui
