#pragma once

#include <QObject>
#include <QPointF>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace unprojector::gui {

class SceneView;

/// The light from the side. Ctrl + Shift + left drag in the view turns it: it comes from where the
/// pointer goes. Esc takes such a drag back.
class LightDrag : public QObject {
    Q_OBJECT
public:
    /// @param view  gets no such drag itself
    explicit LightDrag(SceneView &view);

    /// The direction to the light, eye space, of length 1.
    glm::vec3 direction() const;
    /// x and y of the direction.
    const glm::vec2 &place() const { return m_place; }
    /// @param place  is moved inwards as far as the light reaches surfaces that face the viewer;
    /// not finite: ignored
    void setPlace(const glm::vec2 &place);

    bool eventFilter(QObject *watched, QEvent *event) override;

signals:
    /// Emitted when a drag turns the light, or is taken back.
    void turned();

private:
    SceneView &m_view;
    glm::vec2 m_place;
    bool m_isDragged = false;
    QPointF m_from;        ///< where the drag began
    glm::vec2 m_fromPlace; ///< of the light then
};

} // namespace unprojector::gui
