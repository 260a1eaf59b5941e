#pragma once

#include "gui/view/frame.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

class QOpenGLWidget;

namespace unprojector::gui {

class SceneDocument;

/// The sample with the size of the dot that a point is drawn as, where its object is a cloud.
unproject::DepthSample withDot(const SceneDocument &document, unproject::DepthSample sample);

/// Reads what is under the pointer without waiting for the GPU: asks it, and reports the sample when the GPU has it. A
/// request under way is not overtaken, or a pointer that never rests would never be answered.
class HoverReader : public QObject {
    Q_OBJECT
public:
    /// Returns the frame while it shows the document as it is, otherwise null: the reader draws nothing, and asks again at
    /// the next picture.
    using ReadableFrame = std::function<Frame *()>;

    /// @param view  makes the OpenGL context current; view and document outlive the reader
    HoverReader(QOpenGLWidget &view, const SceneDocument &document, ReadableFrame frame);

    /// Reads a position, and reads it again in every new picture.
    void follow(const geometry::WidgetPoint &position);
    /// Reads a position once.
    void readOnce(const geometry::WidgetPoint &position);
    /// Asks for the position that waits. To be called after every picture.
    void request();
    /// A new picture is about to be drawn: the position that was asked of the last one is asked of the new one.
    /// @param mayFollow  whether the followed position is read again: the pointer rests, and another place is under it
    void renew(bool mayFollow);
    /// The OpenGL context is about to go, and its request with it.
    void forgetRequest() { m_requested.reset(); }
    /// Reads nothing any more, and follows no position.
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
