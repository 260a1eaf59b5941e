#pragma once

#include "core/geometry/angle.h"
#include "gui/document/scene_document.h"
#include "gui/view/view_keys.h"

#include <QPointF>
#include <QString>

#include <functional>
#include <optional>

namespace unprojector::gui {

// What a way in logical pixels, x to the right and y down, does to a camera.

/// A press of an arrow key turns by so much.
inline constexpr double kKeyTurnRadians = geometry::kPi / 36.0; // 5 degrees

/// Turns the camera about a pivot: half a turn for the height of the view.
geometry::LookAt turnedBy(const QPointF &way, const geometry::LookAt &camera, const geometry::WorldPoint &pivot,
                          int viewHeight);
/// Moves the camera so that the scene goes the way at the depth of the pivot.
geometry::LookAt pannedBy(const QPointF &way, const geometry::Setup &setup, const geometry::WorldPoint &pivot);
/// The factor that notches of the wheel zoom by, positive: closer.
double zoomFactor(double notches);
/// Whether a drag that begins so moves the camera: with the middle button, or the left one and Shift.
bool isPan(Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// Moves a document's camera for hand and keys, about the point that is under a position of the view. A drag is undone as one,
/// and so are key presses of one kind.
class Navigation {
public:
    /// The world point to turn about, to move with and to zoom to at a position of the view, read from the picture.
    using PivotLookup = std::function<geometry::WorldPoint(const geometry::WidgetPoint &)>;

    /// @param document  outlives it
    Navigation(SceneDocument &document, PivotLookup lookup);

    /// A drag begins, the view's or another one.
    /// @return its merge key, see EditLabel
    const QString &beginDrag();
    void setPivot(const geometry::WorldPoint &pivot) { m_pivot = pivot; }
    /// The pivot of the drag is what is under a position.
    void grab(const geometry::WidgetPoint &position) { m_pivot = pivotAt(position); }
    void orbit(const QPointF &way, int viewHeight);
    void pan(const QPointF &way);

    void zoomByWheel(const geometry::WidgetPoint &position, double notches);
    /// Turns, moves or zooms at a position; the other keys do nothing.
    void press(const ViewKey &key, const geometry::WidgetPoint &position, int viewHeight);

    /// What is seen has changed: the next step reads the pivot again.
    void forgetStill() { m_stillPivot.reset(); }

private:
    geometry::WorldPoint pivotAt(const geometry::WidgetPoint &position);
    void zoom(const geometry::WidgetPoint &position, double notches, const QString &mergeKey);
    /// The camera was moved so that a pivot stays where it is: at this position the next step goes about it as well.
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
