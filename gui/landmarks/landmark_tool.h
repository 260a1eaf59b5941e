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

class ExpectedLandmarks;
class SceneView;

/// The tool for landmarks in the view: draws, selects and drags their marks, moves them by keys,
/// and places new ones by clicks.
class LandmarkTool : public QObject, public ViewTool {
    Q_OBJECT
public:
    LandmarkTool(SceneDocument &document, SceneView &view);
    /// Sets the expected places that are drawn with the marks.
    /// @param expected  outlives the tool
    void setExpected(ExpectedLandmarks &expected);

    /// Returns whether a click places a landmark on release; a drag still navigates. Marks can be
    /// selected and dragged in both modes.
    bool isPlacing() const { return m_isPlacing; }
    void setPlacing(bool isPlacing);

    /// Selects a visible mark. A mark that was already selected can be dragged; in placing mode,
    /// any mark can.
    Press press(const QMouseEvent &event, const QString &mergeKey) override;
    void dragTo(const QPointF &local) override;
    void release(const QPointF &local) override;
    bool takesClicks() const override { return m_isPlacing; }
    void click(const QPointF &local) override;
    void hover(const std::optional<QPointF> &local) override;
    bool isKey(const QKeyEvent &event) const override;
    void pressKey(const QKeyEvent &event, bool isDragged) override;
    bool showMenu(const QPointF &local, const QPoint &global) override;
    bool showTip(const QHelpEvent &event) override;
    bool prepareToDraw() override;
    void draw(QPainter &painter, const std::vector<QRectF> &taken) override;
    void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) override;

signals:
    void placingChanged(bool isPlacing);
    /// Emitted when the menu of the selected landmarks is wanted: a right click on a mark.
    void menuRequested(const QPoint &global);

private:
    enum class Drag { None, Landmark, Axis };

    /// Draws marks with their labels, and the chosen measure.
    /// @param lines  that no label may cover
    void drawMarks(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken,
                   const std::vector<LandmarkMark> &shown, std::vector<QLineF> lines) const;
    /// The marks in the present view.
    const std::vector<LandmarkMark> &marks();
    /// Moves the landmark to the surface under the pointer, and the other selected ones by as many
    /// pixels.
    void dragLandmark(const QPointF &local);
    /// The arrows that move the current landmark off the surface: only in placing mode.
    std::optional<std::array<AxisArrow, 3>> arrows() const;
    /// @return whether an arrow was pressed
    bool pressArrow(const QPointF &pointer);
    void dragAlongAxis(const QPointF &local);
    /// Ends the drag of a landmark, also when the list changes meanwhile.
    void endDrag();
    /// The selected landmarks that are not hidden.
    std::vector<std::size_t> selectedInView() const;
    /// Moves the selected visible landmarks on the surface. @param way  device pixels
    void nudge(const QPointF &way);
    /// Reports how many selected landmarks could not be moved.
    void tellUnmoved(std::size_t count, const QPointF &at);
    /// Shows a position in the loupe during placing and dragging.
    /// @param at  device pixels; nothing: hides it
    void aimLoupe(const std::optional<geometry::DevicePoint> &at);
    /// The centre of the pixel under a position; nothing outside the view.
    std::optional<geometry::DevicePoint> pointedAt(const QPointF &local) const;

    SceneDocument &m_document;
    SceneView &m_view;
    ExpectedLandmarks *m_expected = nullptr;
    bool m_isPlacing = false;
    std::optional<std::vector<LandmarkMark>> m_marks; ///< nothing: must be computed
    Drag m_drag = Drag::None;
    QString m_mergeKey;        ///< of the drag
    std::size_t m_dragged = 0; ///< its index
    QPointF m_dragStart;       ///< position of its mark at the press
    /// The other selected visible landmarks, and the start positions of their marks.
    std::vector<std::pair<std::size_t, QPointF>> m_draggedWith;
    std::size_t m_leftBehind = 0; ///< number of selected landmarks that the drag has not moved
    bool m_isMoving = false;      ///< the tool itself is changing the document
    bool m_hasMoved = false;
    QPointF m_grab;        ///< from the pointer to the dragged mark
    int m_stepAtPress = 0; ///< index in the undo stack when the drag began
    int m_axis = 0;
    geometry::WorldPoint m_axisStart; ///< start position of the dragged landmark
    double m_axisFrom = 0.0;          ///< where along the axis it was grabbed, relative to m_axisStart
    std::optional<geometry::DevicePoint> m_loupeAt;
    QImage m_loupe; ///< the pixels around it
};

} // namespace unprojector::gui
