#include "gui/document/scene_change.h"

#include "gui/document/scene_document.h"

#include <utility>

namespace unprojector::gui {

SceneChange::SceneChange(SceneDocument &document, SceneState before, SceneState after, const QString &text,
                         QString mergeKey)
    : QUndoCommand(text), m_document(document), m_before(std::move(before)), m_after(std::move(after)),
      m_mergeKey(std::move(mergeKey))
{
}

void SceneChange::undo()
{
    m_document.restore(m_before);
}

void SceneChange::redo()
{
    if (std::exchange(m_isApplied, false))
        return;
    m_document.restore(m_after);
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
