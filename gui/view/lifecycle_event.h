#pragma once

#include <QMetaType>
#include <QString>

namespace unprojector::gui {

/// One step of a view's life, under the names of the paper's MFC view (Weng et al. 2008, section
/// 4), or a parameter of the setup that changed before a frame was drawn.
struct LifecycleEvent {
    enum class Kind {
        PreCreateWindow,
        OnCreate,
        OnSize,
        OnDraw,
        OnLButtonDown,
        OnDestroy,
        Viewport,
        Projection,
        Camera
    };
    /// Returns whether it is a parameter, which takes no time of its own.
    bool isParameter() const { return kind == Kind::Viewport || kind == Kind::Projection || kind == Kind::Camera; }

    Kind kind = Kind::OnDraw;
    QString arguments;         ///< as in a call: "1024, 768"
    QString calls;             ///< the OpenGL calls it stands for: "glViewport(0, 0, 1024, 768)"
    double milliseconds = 0.0; ///< duration
    bool hasStandIns = false;  ///< of a frame: large models were drawn coarse
};

} // namespace unprojector::gui

Q_DECLARE_METATYPE(unprojector::gui::LifecycleEvent)
