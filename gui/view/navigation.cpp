#include "gui/view/navigation.h"

#include "gui/document/camera_looks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

LookAt turnedBy(const QPointF &way, const LookAt &camera, const WorldPoint &pivot, int viewHeight)
{
    const double radiansPerPixel = kPi / std::max(1, viewHeight);
    return orbited(camera, pivot, way.x() * radiansPerPixel, way.y() * radiansPerPixel);
}

LookAt pannedBy(const QPointF &way, const Setup &setup, const WorldPoint &pivot)
{
    const Result<EyeFrame> frame = eyeFrame(setup.camera());
    if (!frame)
        return setup.camera();
    const double scale = worldPerLogicalPixel(setup, pivot);
    return moved(setup.camera(), (frame->upward * way.y() - frame->side * way.x()) * scale);
}

double zoomFactor(double notches)
{
    return std::pow(1.2, notches);
}

bool isPan(Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    return button == Qt::MiddleButton || (button == Qt::LeftButton && modifiers.testFlag(Qt::ShiftModifier));
}

Navigation::Navigation(SceneDocument &document, PivotLookup lookup) : m_document(document), m_lookup(std::move(lookup))
{
}

const QString &Navigation::beginDrag()
{
    m_mergeKey = QStringLiteral("drag %1").arg(++m_dragCount);
    return m_mergeKey;
}

void Navigation::orbit(const QPointF &way, int viewHeight)
{
    setCamera(m_document, turnedBy(way, m_document.setup().camera(), m_pivot, viewHeight), m_mergeKey);
}

void Navigation::pan(const QPointF &way)
{
    setCamera(m_document, pannedBy(way, m_document.setup(), m_pivot), m_mergeKey);
}

void Navigation::zoomByWheel(const WidgetPoint &position, double notches)
{
    zoom(position, notches, QStringLiteral("wheel"));
}

void Navigation::press(const ViewKey &key, const WidgetPoint &position, int viewHeight)
{
    switch (key.kind) {
    case ViewKey::Kind::Turn: {
        const WorldPoint pivot = pivotAt(position);
        const QPointF radians = QPointF(key.way) * kKeyTurnRadians;
        setCamera(m_document, orbited(m_document.setup().camera(), pivot, radians.x(), radians.y()),
                  QStringLiteral("turn by keys"));
        keepPivot(position, pivot);
        return;
    }
    case ViewKey::Kind::Move: {
        constexpr double kShare = 0.05; // of the view's height
        setCamera(m_document, pannedBy(QPointF(key.way) * (kShare * viewHeight), m_document.setup(), pivotAt(position)),
                  QStringLiteral("move by keys"));
        return;
    }
    case ViewKey::Kind::Zoom: zoom(position, key.notches, QStringLiteral("zoom by keys")); return;
    case ViewKey::Kind::Aim:
    case ViewKey::Kind::Pick: return;
    }
}

WorldPoint Navigation::pivotAt(const WidgetPoint &position)
{
    // Steps can be faster than frames. The pivot stays in place, so no frame is drawn to read it
    // again.
    return m_stillPivot && m_stillPosition == position ? *m_stillPivot : m_lookup(position);
}

void Navigation::zoom(const WidgetPoint &position, double notches, const QString &mergeKey)
{
    const WorldPoint pivot = pivotAt(position);
    const Setup next = zoomed(m_document.setup(), pivot, zoomFactor(notches));
    setView(m_document, next.camera(), next.projection(), mergeKey);
    keepPivot(position, pivot);
}

void Navigation::keepPivot(const WidgetPoint &position, const WorldPoint &pivot)
{
    m_stillPosition = position;
    m_stillPivot = pivot;
}

} // namespace unprojector::gui
