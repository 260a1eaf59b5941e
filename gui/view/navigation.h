#pragma once

#include "core/geometry/numbers.h"
#include "gui/document/scene_document.h"
#include "gui/view/view_keys.h"

#include <QPointF>
#include <QString>

#include <functional>
#include <optional>

namespace unprojector::gui {

// Camera changes by a movement in logical pixels, x to the right and y down.

/// The angle of one press of an arrow key.
inline constexpr double kKeyTurnRadians = geometry::kPi / 36.0; // 5 degrees

/// Turns the camera about a pivot: half a turn for the height of the view.
geometry::LookAt turnedBy(const QPointF &way, const geometry::LookAt &camera, const geometry::WorldPoint &pivot,
                          int viewHeight);
/// Moves the camera so that the scene follows the movement at the depth of the pivot.
geometry::LookAt pannedBy(const QPointF &way, const geometry::Setup &setup, const geometry::WorldPoint &pivot);
/// The zoom factor of notches of the wheel, positive: closer.
double zoomFactor(double notches);
/// Returns whether such a drag pans the camera: with the middle button, or the left one and Shift.
bool isPan(Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// Moves a document's camera by mouse and keys, about the point under a position of the view. A
/// drag is one step of undo, and so are key presses of one kind.
class Navigation {
public:
    /// Returns the world point at a position of the view, read from the frame: the pivot to turn
    /// about, to pan with and to zoom to.
    using PivotLookup = std::function<geometry::WorldPoint(const geometry::WidgetPoint &)>;

    /// @param document  outlives it
    Navigation(SceneDocument &document, PivotLookup lookup);

    /// Begins a drag in this view or another one.
    /// @return its merge key, see EditLabel
    const QString &beginDrag();
    void setPivot(const geometry::WorldPoint &pivot) { m_pivot = pivot; }
    /// Sets the pivot of the drag to the point under a position.
    void grab(const geometry::WidgetPoint &position) { m_pivot = pivotAt(position); }
    void orbit(const QPointF &way, int viewHeight);
    void pan(const QPointF &way);

    void zoomByWheel(const geometry::WidgetPoint &position, double notches);
    /// Turns, pans or zooms at a position; ignores other keys.
    void press(const ViewKey &key, const geometry::WidgetPoint &position, int viewHeight);

    /// Forgets the cached pivot after the view has changed: the next step reads it again.
    void forgetStill() { m_stillPivot.reset(); }

private:
    geometry::WorldPoint pivotAt(const geometry::WidgetPoint &position);
    void zoom(const geometry::WidgetPoint &position, double notches, const QString &mergeKey);
    /// Caches a pivot that the last camera move kept in place: the next step at this position uses
    /// it too.
    void keepPivot(const geometry::WidgetPoint &position, const geometry::WorldPoint &pivot);

    SceneDocument &m_document;
    PivotLookup m_lookup;
    geometry::WorldPoint m_pivot;
    QString m_mergeKey;
    int m_dragCount = 0;
    geometry::WidgetPoint m_stillPosition;
    std::optional<geometry::WorldPoint> m_stillPivot; ///< under m_stillPosition
};

} // namespace unprojector::gui
