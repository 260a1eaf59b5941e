#pragma once

#include "core/geometry/setup.h"
#include "gui/view/lifecycle_event.h"

#include <QObject>

#include <optional>

namespace unprojector::gui {

class LifecycleLog;
class SceneDocument;

/// Logs a view's steps and, before each frame, the calls of its parameters if these have changed
/// since the last frame: glViewport, the projection's and gluLookAt.
class LifecycleRecorder : public QObject {
    Q_OBJECT
public:
    LifecycleRecorder(const SceneDocument &document, LifecycleLog &log, QObject *parent = nullptr);

    void record(const LifecycleEvent &event);

private:
    void recordParameters();

    const SceneDocument &m_document;
    LifecycleLog &m_log;
    std::optional<geometry::Viewport> m_viewport;
    QString m_projection, m_camera; ///< the calls of the last frame
};

} // namespace unprojector::gui
