#pragma once

#include "core/geometry/drawable.h"
#include "core/unproject/pick.h"
#include "gui/view/lifecycle_event.h"

#include <QElapsedTimer>

class QSurfaceFormat;

namespace unprojector::gui {

/// Measures a step of the view's life from its beginning, and describes it at its end: arguments,
/// OpenGL calls, time.
class LifecycleTimer {
public:
    LifecycleTimer() { m_timer.start(); }

    /// Has no duration: the format is requested before the window exists.
    static LifecycleEvent preCreateWindow(const QSurfaceFormat &wanted, const QSurfaceFormat &given);
    LifecycleEvent onCreate() const;
    LifecycleEvent onSize(const geometry::Drawable &drawn) const;
    /// The objects were drawn into the frame, which is not shown yet.
    LifecycleEvent onDrawFrame() const;
    /// The frame was shown.
    /// @param hasObjects  whether objects were drawn into it
    LifecycleEvent onDraw(bool hasObjects, bool hasStandIns) const;
    LifecycleEvent onLButtonDown(const geometry::Surface &surface, const unproject::PixelClick &click) const;
    LifecycleEvent onDestroy() const;

private:
    LifecycleEvent step(LifecycleEvent::Kind kind, const QString &arguments, const QString &calls) const;

    QElapsedTimer m_timer;
};

} // namespace unprojector::gui
