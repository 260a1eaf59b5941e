#pragma once

#include "core/lessons/highlight.h"
#include "gui/document/scene_document.h"
#include "gui/outside/observer_overlay.h"
#include "gui/view/frame_view.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/observer_picture.h"

#include <optional>
#include <set>

namespace unprojector::gui {

/// The first view from outside: its camera, its view volume with the near and far planes, the ray
/// through the clicked pixel, the point and the scene; all of it can be morphed into the canonical
/// view volume. Its own camera is turned by the user and stays when the first one moves. The edges
/// of the near and far planes can be dragged. It never unprojects.
class ObserverView : public FrameView {
    Q_OBJECT
public:
    explicit ObserverView(SceneDocument &document, QWidget *parent = nullptr);
    ~ObserverView() override;

    /// The morph parameter. 0: eye space; 1: the canonical view volume.
    double morph() const { return m_t; }
    void setMorph(double t);
    /// Sets the lesson's labels in the view.
    void setHighlights(const std::set<lessons::Highlight> &highlights);

    /// Marks a quantity of the pick's formulas, see quantity_marks.h; empty: none.
    void setMarkedTerm(const QString &term);

    /// Fits the eye, the view volume and the wrong points of another program into the view. The
    /// observer's direction does not change.
    void fit();

    const geometry::LookAt &observer() const { return m_observer.camera(); }
    /// The position of a world point in this view, logical pixels; nothing if it is not in it.
    std::optional<QPointF> placeOf(const geometry::WorldPoint &point) const;
    /// The labels and arrows of the lesson and of the marked quantity in the current view.
    HighlightMarks highlightMarks() const;

signals:
    void morphChanged(double t);
    /// Emitted when the pointer is over the edge of the near plane ("n") or of the far plane ("f"),
    /// or over none (empty).
    void quantityPointed(const QString &term);
    /// Emitted during painting, when the answer changes: whether all wrong points of another
    /// program are in the view.
    void wrongPointsSeen(bool areSeen);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void releaseGL() final;

    bool event(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    enum class Drag { None, Orbit, Pan, Plane };

    void updateSurface();
    /// Moves the observer to its default once the views' sizes are known, and again until the user
    /// moves it.
    void placeObserver();
    std::optional<ObserverPicture> picture() const;

    /// The planes that cut the objects, world space.
    std::vector<glm::dvec4> cuttingPlanes(const ObserverPicture &p) const;
    /// Draws the objects into the frame if it is out of date.
    void updateFrame(const ObserverPicture &p);
    void tellWrongPoints(const ObserverPicture &p);
    void drawHighlighted();

    /// The plane whose edge is under the pointer, ready to be dragged.
    std::optional<geometry::ClipPlaneDrag> planeAt(const QPointF &position) const;
    void dragPlane(const QPointF &position);
    void setHotPlane(const std::optional<geometry::ClipPlaneDrag> &drag);
    /// Moves the observer for the user.
    void setCamera(const geometry::LookAt &camera);
    /// Turns by steps of the arrow keys.
    void turn(int right, int down);
    void zoom(const QPointF &position, double notches);

    SceneDocument &m_document;
    ObserverOverlay m_overlay;

    glm::dmat4 m_drawnFrom{0.0}; ///< clipFromWorld of the frame, even if drawing failed
    geometry::Surface m_drawnOn; ///< the same for its surface
    double m_t = 0.0;
    std::set<lessons::Highlight> m_highlights;
    QString m_markedTerm;
    geometry::Setup m_observer;
    geometry::Placement m_reference; ///< of the cube
    bool m_isPlaced = false;
    bool m_isTouched = false; ///< the user has moved the observer
    bool m_areWrongPointsSeen = true;
    geometry::Surface m_placedFor; ///< the first view's surface when the observer was placed

    Drag m_drag = Drag::None;
    std::optional<geometry::ClipPlaneDrag> m_planeDrag;
    std::optional<geometry::ClipPlane> m_hotPlane;
    QPointF m_lastPosition;
    QString m_gesture; ///< merge key of the present drag, which is undone as one
    int m_gestureCount = 0;
};

} // namespace unprojector::gui
