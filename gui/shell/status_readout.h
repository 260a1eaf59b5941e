#pragma once

#include "core/unproject/pick.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

class QLabel;

namespace unprojector::gui {

class Window;

/// The status bar: the world coordinate under the pointer, the progress of preparing models for
/// rays, and the projection.
class StatusReadout : public QObject {
    Q_OBJECT
public:
    explicit StatusReadout(Window &window);

private:
    /// The world coordinate at a pixel; empty if there is none. While coordinates are hidden, only
    /// the pixel.
    QString pointedText(const unproject::PixelClick &click) const;
    void showPreparing(double share);
    void showProjection();

    Window &m_window;
    QLabel *m_pointed;
    QLabel *m_preparing;
    QElapsedTimer m_sincePreparing; ///< invalid while no model is being prepared
    QLabel *m_projection;
    bool m_areHidden = false; ///< coordinates, see Window::coordinatesHidden
};

} // namespace unprojector::gui
