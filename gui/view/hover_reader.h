#pragma once

#include "gui/view/frame.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

class QOpenGLWidget;

namespace unprojector::gui {

class SceneDocument;

/// The sample with the drawn size of a point, if its object is a point cloud.
unproject::DepthSample withDot(const SceneDocument &document, unproject::DepthSample sample);

/// Reads the pixel under the pointer without waiting for the GPU, and reports the sample when it
/// arrives. A new position doesn't replace a pending request: a pointer that never rests would
/// otherwise never get an answer.
class HoverReader : public QObject {
    Q_OBJECT
public:
    /// Returns the frame if it is up to date, otherwise null: the reader draws nothing, and asks
    /// again at the next frame.
    using ReadableFrame = std::function<Frame *()>;

    /// @param view  makes the OpenGL context current; view and document outlive the reader
    HoverReader(QOpenGLWidget &view, const SceneDocument &document, ReadableFrame frame);

    /// Reads a position, and reads it again in every new frame.
    void follow(const geometry::WidgetPoint &position);
    /// Reads a position once.
    void readOnce(const geometry::WidgetPoint &position);
    /// Requests the waiting position. Call it after every frame.
    void request();
    /// Call it before a new frame is drawn: a position requested from the last frame is requested
    /// again from the new one.
    /// @param mayFollow  whether the followed position is read again: the pointer rests, and the
    /// scene under it has changed
    void renew(bool mayFollow);
    /// Drops the request, before its OpenGL context goes.
    void forgetRequest() { m_requested.reset(); }
    /// Stops reading, and follows no position.
    void stop();

signals:
    void answered(const unprojector::unproject::PixelClick &click);

private:
    void takeAnswer();

    QOpenGLWidget &m_view;
    const SceneDocument &m_document;
    ReadableFrame m_frame;
    std::optional<geometry::WidgetPoint> m_followed;
    std::optional<geometry::WidgetPoint> m_waiting;
    std::optional<unproject::PixelClick> m_requested;
    QTimer m_timer;
};

} // namespace unprojector::gui
