#include "gui/shading/light_drag.h"

#include "gui/view/scene_view.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

/// From the left and a little from above, grazing: wrinkles then cast the strongest shades.
constexpr glm::vec2 kFirstPlace(-0.86f, 0.36f);
/// The farthest place from the middle: the light still comes from in front.
constexpr float kFarthest = 0.98f;

bool isLightButton(const QMouseEvent &event)
{
    return event.button() == Qt::LeftButton && event.modifiers() == (Qt::ControlModifier | Qt::ShiftModifier);
}

} // namespace

LightDrag::LightDrag(SceneView &view) : m_view(view), m_place(kFirstPlace), m_fromPlace(kFirstPlace)
{
    view.installEventFilter(this);
}

glm::vec3 LightDrag::direction() const
{
    return {m_place, std::sqrt(std::max(0.0f, 1.0f - glm::dot(m_place, m_place)))};
}

void LightDrag::setPlace(const glm::vec2 &place)
{
    const float length = glm::length(place);
    if (std::isfinite(length))
        m_place = length > kFarthest ? place * (kFarthest / length) : place;
}

bool LightDrag::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
        const auto &mouse = *static_cast<QMouseEvent *>(event);
        if (!m_isDragged && (!isLightButton(mouse) || mouse.buttons() != Qt::LeftButton))
            break;
        if (!m_isDragged) {
            m_isDragged = true;
            m_from = mouse.position();
            m_fromPlace = m_place;
        }
        return true;
    }
    case QEvent::MouseMove: {
        if (!m_isDragged)
            break;
        const QPointF way = static_cast<QMouseEvent *>(event)->position() - m_from;
        const double half = 0.5 * std::max(1, std::min(m_view.width(), m_view.height()));
        setPlace(m_fromPlace + glm::vec2(way.x() / half, -way.y() / half));
        emit turned();
        return true;
    }
    case QEvent::MouseButtonRelease:
        if (!m_isDragged)
            break;
        m_isDragged = static_cast<QMouseEvent *>(event)->buttons() != Qt::NoButton;
        return true;
    case QEvent::ShortcutOverride:
        if (!m_isDragged || static_cast<QKeyEvent *>(event)->key() != Qt::Key_Escape)
            break;
        event->accept();
        return true;
    case QEvent::KeyPress:
        if (!m_isDragged || static_cast<QKeyEvent *>(event)->key() != Qt::Key_Escape)
            break;
        m_isDragged = false;
        m_place = m_fromPlace;
        emit turned();
        return true;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace unprojector::gui
