#pragma once

#include "core/geometry/setup.h"
#include "gui/view/lifecycle_event.h"

#include <QObject>

#include <optional>

namespace unprojector::gui {

class LifecycleLog;
class SceneDocument;

/// Writes a view's steps into the log, and before each picture the calls that its parameters cause, where these changed since
/// the picture before: glViewport, the projection's and gluLookAt.
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
    QString m_projection, m_camera; ///< the calls of the last picture
};

} // namespace unprojector::gui
