#include "gui/view/lifecycle_timer.h"

#include "core/geometry/viewport.h"
#include "gui/text/number_text.h"
#include "gui/view/scene_view.h"

#include <QSurfaceFormat>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

using Kind = LifecycleEvent::Kind;

const QString kObjectCalls = QStringLiteral("glBindFramebuffer, glClearBuffer, glDrawElements");

QString formatText(const QSurfaceFormat &format)
{
    return SceneView::tr("OpenGL %1.%2 core, depth %3 bits, stencil %4 bits, %5 samples")
        .arg(format.majorVersion())
        .arg(format.minorVersion())
        .arg(format.depthBufferSize())
        .arg(format.stencilBufferSize())
        .arg(std::max(0, format.samples()));
}

} // namespace

LifecycleEvent LifecycleTimer::preCreateWindow(const QSurfaceFormat &wanted, const QSurfaceFormat &given)
{
    return {Kind::PreCreateWindow,
            {},
            SceneView::tr("requested: %1; received: %2").arg(formatText(wanted), formatText(given))};
}

LifecycleEvent LifecycleTimer::onCreate() const
{
    return step(Kind::OnCreate, {}, QStringLiteral("glCreateProgram, glCreateShader, glCompileShader, glLinkProgram"));
}

LifecycleEvent LifecycleTimer::onSize(const Drawable &drawn) const
{
    const Surface &surface = drawn.setup.surface;
    return step(
        Kind::OnSize, QStringLiteral("%1, %2").arg(surface.widthPixels).arg(surface.heightPixels),
        QStringLiteral("glViewport(%1, %2, %3, %4)").arg(drawn.x).arg(drawn.y).arg(drawn.width).arg(drawn.height));
}

LifecycleEvent LifecycleTimer::onDrawFrame() const
{
    return step(Kind::OnDraw, {}, kObjectCalls);
}

LifecycleEvent LifecycleTimer::onDraw(bool hasObjects, bool hasStandIns) const
{
    LifecycleEvent event = step(Kind::OnDraw, {},
                                hasObjects ? kObjectCalls + QStringLiteral(", glDrawArrays")
                                           : SceneView::tr("glDrawArrays: the objects are as they were drawn before"));
    event.hasStandIns = hasStandIns;
    return event;
}

LifecycleEvent LifecycleTimer::onLButtonDown(const Surface &surface, const PixelClick &click) const
{
    return step(
        Kind::OnLButtonDown, QStringLiteral("%1, %2").arg(click.position.x).arg(click.position.y),
        QStringLiteral("glReadPixels(%1, %2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth): depth = %3, object id %4")
            .arg(click.pixel.i)
            .arg(framebufferRow(surface, click.pixel))
            .arg(depthText(click.sample.depth))
            .arg(click.sample.object ? *click.sample.object + 1 : 0));
}

LifecycleEvent LifecycleTimer::onDestroy() const
{
    return step(Kind::OnDestroy, {},
                QStringLiteral("glDeleteFramebuffers, glDeleteProgram, glDeleteBuffers, glDeleteVertexArrays, "
                               "glDeleteTextures"));
}

LifecycleEvent LifecycleTimer::step(Kind kind, const QString &arguments, const QString &calls) const
{
    return {kind, arguments, calls, static_cast<double>(m_timer.nsecsElapsed()) * 1e-6};
}

} // namespace unprojector::gui
