#include "gui/view/lifecycle_recorder.h"

#include "core/geometry/numbers.h"
#include "gui/document/scene_document.h"
#include "gui/text/number_text.h"
#include "gui/view/lifecycle_log.h"

#include <QStringList>

#include <initializer_list>
#include <utility>
#include <variant>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr int kDigits = 6;

QString call(const char *name, std::initializer_list<double> arguments)
{
    QStringList numbers;
    for (const double argument : arguments)
        numbers << writtenText(argument, kDigits);
    return QStringLiteral("%1(%2)").arg(QLatin1String(name), numbers.join(QStringLiteral(", ")));
}

/// The numbers in memory order: column by column.
QString matrixCall(const glm::dmat4 &m)
{
    QStringList numbers;
    for (int i = 0; i < 16; ++i)
        numbers << writtenText(m[i / 4][i % 4], kDigits);
    return QStringLiteral("glLoadMatrixd({%1})").arg(numbers.join(QStringLiteral(", ")));
}

QString orthoCall(const Ortho &o)
{
    return call("glOrtho", {o.left, o.right, o.bottom, o.top, o.nearDistance, o.farDistance});
}

QString projectionCall(const Projection &projection)
{
    struct Visitor {
        QString operator()(const Frustum &f) const
        {
            const QString frustum =
                call("glFrustum", {f.left, f.right, f.bottom, f.top, f.nearDistance, f.farDistance});
            return f.skew == 0.0
                       ? frustum
                       : frustum + QStringLiteral(", glMultMatrixd(skew = %1)").arg(writtenText(f.skew, kDigits));
        }
        QString operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        QString operator()(const Ortho &o) const { return orthoCall(o); }
        QString operator()(const Perspective &p) const
        {
            return call("gluPerspective", {p.verticalFov.degrees(), p.aspect.value, p.nearDistance, p.farDistance});
        }
        QString operator()(const Oblique &o) const
        {
            return QStringLiteral("%1, glMultMatrixd(θ = %2°, φ = %3°)")
                .arg(orthoCall(o.box), writtenText(o.theta.degrees(), kDigits), writtenText(o.phi.degrees(), kDigits));
        }
    };
    return std::visit(Visitor(), projection);
}

QString cameraCall(const LookAt &camera)
{
    const glm::dvec3 eye = camera.eye.coordinates(), center = camera.center.coordinates(), up = camera.up.coordinates();
    return call("gluLookAt", {eye.x, eye.y, eye.z, center.x, center.y, center.z, up.x, up.y, up.z});
}

} // namespace

LifecycleRecorder::LifecycleRecorder(const SceneDocument &document, LifecycleLog &log, QObject *parent)
    : QObject(parent), m_document(document), m_log(log)
{
}

void LifecycleRecorder::record(const LifecycleEvent &event)
{
    if (event.kind == LifecycleEvent::Kind::OnSize)
        m_viewport = m_document.setup().viewport; // that step contains it
    if (event.kind == LifecycleEvent::Kind::OnDraw)
        recordParameters();
    m_log.append(event);
}

void LifecycleRecorder::recordParameters()
{
    const Setup &setup = m_document.setup();
    const auto tell = [this](LifecycleEvent::Kind kind, const QString &calls) {
        LifecycleEvent event;
        event.kind = kind;
        event.calls = calls;
        m_log.append(event);
    };
    if (std::exchange(m_viewport, setup.viewport) != setup.viewport) {
        const Viewport &v = setup.viewport;
        tell(LifecycleEvent::Kind::Viewport, call("glViewport", {v.x, v.y, v.width, v.height}));
    }
    const auto &lens = m_document.scene().projection.matrix();
    const QString projection = lens ? matrixCall(lens->clipFromEye) : projectionCall(setup.projection());
    if (std::exchange(m_projection, projection) != projection)
        tell(LifecycleEvent::Kind::Projection, projection);
    const auto &pose = m_document.scene().camera.matrix();
    const QString camera = pose ? matrixCall(*pose) : cameraCall(setup.camera());
    if (std::exchange(m_camera, camera) != camera)
        tell(LifecycleEvent::Kind::Camera, camera);
}

} // namespace unprojector::gui
