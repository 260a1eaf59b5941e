#pragma once

#include "gui/document/scene_document.h"
#include "gui/landmarks/axis_dragger.h"
#include "gui/landmarks/landmark_marks.h"
#include "gui/view/view_tool.h"

#include <QImage>
#include <QObject>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::gui {

class SceneView;

/// Placed landmarks in the view: their marks are drawn, selected, dragged and moved by keys, and clicks place new ones.
class LandmarkTool : public QObject, public ViewTool {
    Q_OBJECT
public:
    LandmarkTool(SceneDocument &document, SceneView &view);

    /// Whether a click places a landmark, where it is released; a drag navigates as ever. Marks are selected and dragged in
    /// either case.
    bool isPlacing() const { return m_isPlacing; }
    void setPlacing(bool isPlacing);

    /// A mark in sight is selected; one that was selected before, and any while landmarks are placed, can be dragged.
    Press press(const QMouseEvent &event, const QString &mergeKey) override;
    void dragTo(const QPointF &local) override;
    void release(const QPointF &local) override;
    bool takesClicks() const override { return m_isPlacing; }
    void click(const QPointF &local) override;
    void hover(const std::optional<QPointF> &local) override;
    bool isKey(const QKeyEvent &event) const override;
    void pressKey(const QKeyEvent &event, bool isDragged) override;
    bool showTip(const QHelpEvent &event) override;
    bool prepareToDraw() override;
    void draw(QPainter &painter, const std::vector<QRectF> &taken) override;
    void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) override;

signals:
    void placingChanged(bool isPlacing);

private:
    enum class Drag { None, Landmark, Axis };

    /// Draws marks with their labels, and the chosen measure.
    /// @param lines  that no label covers
    void drawMarks(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken,
                   const std::vector<LandmarkMark> &shown, std::vector<QLineF> lines) const;
    /// As they are seen now.
    const std::vector<LandmarkMark> &marks();
    /// Slides the landmark on the surface under the pointer, and those that are selected besides by as many pixels.
    void dragLandmark(const QPointF &local);
    /// The arrows by which the current landmark is moved off the surface: while landmarks are placed.
    std::optional<std::array<AxisArrow, 3>> arrows() const;
    /// @return whether one was pressed
    bool pressArrow(const QPointF &pointer);
    void dragAlongAxis(const QPointF &local);
    /// Lets go of a landmark that is dragged, as where the list changes below the hand.
    void endDrag();
    /// The selected landmarks that are not hidden.
    std::vector<std::size_t> selectedInView() const;
    /// Moves the selected landmarks that are in sight on the surface. @param way  device pixels
    void nudge(const QPointF &way);
    /// Says of how many selected landmarks that they stayed.
    void tellUnmoved(std::size_t count, const QPointF &at);
    /// Shows a place large while landmarks are placed and dragged.
    /// @param at  device pixels; nothing: no more
    void aimLoupe(const std::optional<geometry::DevicePoint> &at);
    /// The centre of the pixel under a position; nothing outside the view.
    std::optional<geometry::DevicePoint> pointedAt(const QPointF &local) const;

    SceneDocument &m_document;
    SceneView &m_view;
    bool m_isPlacing = false;
    std::optional<std::vector<LandmarkMark>> m_marks; ///< nothing: to be looked for
    Drag m_drag = Drag::None;
    QString m_mergeKey;        ///< of the drag
    std::size_t m_dragged = 0; ///< its index
    QPointF m_dragStart;       ///< where its mark was at the press
    /// The other selected landmarks in sight, and where their marks were.
    std::vector<std::pair<std::size_t, QPointF>> m_draggedWith;
    std::size_t m_leftBehind = 0; ///< selected landmarks that the drag has not moved
    bool m_isMoving = false;      ///< what changes now is what the hand does
    bool m_hasMoved = false;
    QPointF m_grab;        ///< from the pointer to the dragged mark
    int m_stepAtPress = 0; ///< of undo, when the drag began
    int m_axis = 0;
    geometry::WorldPoint m_axisStart; ///< where the dragged landmark was
    double m_axisFrom = 0.0;          ///< where along the axis it was grabbed, from there
    std::optional<geometry::DevicePoint> m_loupeAt;
    QImage m_loupe; ///< the pixels about it
};

} // namespace unprojector::gui
