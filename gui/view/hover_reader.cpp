#include "gui/view/hover_reader.h"

#include "core/scene/point_size.h"
#include "gui/document/scene_document.h"

#include <QOpenGLWidget>

#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

DepthSample withDot(const SceneDocument &document, DepthSample sample)
{
    const std::vector<scene::SceneObject> &objects = document.objects();
    if (sample.object && *sample.object < objects.size() && objects[*sample.object].model->pointCount() > 0)
        sample.dotPixels = scene::pointPixels(document.setup().surface);
    return sample;
}

HoverReader::HoverReader(QOpenGLWidget &view, const SceneDocument &document, ReadableFrame frame)
    : m_view(view), m_document(document), m_frame(std::move(frame))
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &HoverReader::takeAnswer);
}

void HoverReader::follow(const WidgetPoint &position)
{
    m_followed = position;
    readOnce(position);
}

void HoverReader::readOnce(const WidgetPoint &position)
{
    m_waiting = position;
    request();
}

void HoverReader::request()
{
    Frame *frame = m_frame();
    if (!frame || !m_waiting || frame->isRequested())
        return;
    const WidgetPoint position = *std::exchange(m_waiting, std::nullopt);
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.setup().surface, position);
    if (!pixel)
        return;
    m_requested = {position, *pixel, {}};
    m_view.makeCurrent();
    frame->request(*pixel);
    m_view.doneCurrent();
    m_timer.start(0);
}

void HoverReader::takeAnswer()
{
    constexpr int kPollMilliseconds = 2;
    Frame *frame = m_frame();
    if (!frame || !m_requested)
        return; // the answer would belong to an old frame
    m_view.makeCurrent();
    const std::optional<DepthSample> sample = frame->takeRequested();
    m_view.doneCurrent();
    if (frame->isRequested()) {
        m_timer.start(kPollMilliseconds);
        return;
    }
    PixelClick click = *std::exchange(m_requested, std::nullopt);
    if (sample) {
        click.sample = withDot(m_document, *sample);
        emit answered(click);
    }
    request();
}

void HoverReader::renew(bool mayFollow)
{
    if (const std::optional<PixelClick> dropped = std::exchange(m_requested, std::nullopt); dropped && !m_waiting)
        m_waiting = dropped->position;
    if (mayFollow && !m_waiting)
        m_waiting = m_followed;
}

void HoverReader::stop()
{
    m_followed.reset();
    m_waiting.reset();
    if (!std::exchange(m_requested, std::nullopt))
        return;
    if (Frame *frame = m_frame()) {
        m_view.makeCurrent();
        frame->dropRequest();
        m_view.doneCurrent();
    }
}

} // namespace unprojector::gui
