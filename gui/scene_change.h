#pragma once

#include "core/scene.h"

#include <QString>
#include <QUndoCommand>

namespace unprojector {

class SceneDocument;

/// One undoable change: the scene before and after it. Scenes are small; the models in them are shared.
class SceneChange : public QUndoCommand {
public:
    SceneChange(SceneDocument &document, Scene before, Scene after, const QString &text, QString mergeKey);

    void undo() override;
    void redo() override;
    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand *next) override;

private:
    SceneDocument &m_document;
    Scene m_before;
    Scene m_after;
    QString m_mergeKey;
    bool m_isApplied = true; ///< the document made the change before it pushed this command
};

} // namespace unprojector
