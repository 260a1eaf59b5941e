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

/// The first view from outside: its camera, its view volume with the near and far planes, the ray through the clicked
/// pixel, the point and the scene; all of it can be morphed into the canonical view volume. It has a camera of its own,
/// which a hand turns and which stays where it is when the first one moves. The edges of the near and far planes can be
/// dragged. It never unprojects.
class ObserverView : public FrameView {
    Q_OBJECT
public:
    explicit ObserverView(SceneDocument &document, QWidget *parent = nullptr);
    ~ObserverView() override;

    /// 0: eye space, as it is; 1: the canonical view volume. Between them it morphs.
    double morph() const { return m_t; }
    void setMorph(double t);
    /// What a lesson letters in the picture.
    void setHighlights(const std::set<lessons::Highlight> &highlights);

    /// Marks a quantity of the pick's formulas, see quantity_marks.h; empty: none.
    void setMarkedTerm(const QString &term);

    /// Shows the eye, the view volume and the points that another program got fully, from the direction that the observer looks in.
    void fit();

    const geometry::LookAt &observer() const { return m_observer.camera(); }
    /// Where a world point stands in this view's picture, logical pixels; nothing when it has no place in it.
    std::optional<QPointF> placeOf(const geometry::WorldPoint &point) const;
    /// What of a lesson and of a marked quantity is written into the picture as it is now.
    HighlightMarks highlightMarks() const;

signals:
    void morphChanged(double t);
    /// The pointer is over the edge of the near plane ("n") or of the far plane ("f"), or over none (empty).
    void quantityPointed(const QString &term);
    /// Whether all points that another program got lie in the picture. Told while it is drawn.
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
    /// Takes the default place once it is known how large the pictures are, and again until a hand has taken over.
    void placeObserver();
    std::optional<ObserverPicture> picture() const;

    /// The planes that the objects are cut at, world space.
    std::vector<glm::dvec4> cuttingPlanes(const ObserverPicture &p) const;
    /// Draws the objects into the frame where it does not show the document from here, as it is.
    void updateFrame(const ObserverPicture &p);
    void tellWrongPoints(const ObserverPicture &p);
    void drawHighlighted();

    /// The plane whose edge is under the pointer, in the hand.
    std::optional<geometry::ClipPlaneDrag> planeAt(const QPointF &position) const;
    void dragPlane(const QPointF &position);
    void setHotPlane(const std::optional<geometry::ClipPlaneDrag> &drag);
    /// A hand moves the observer.
    void setCamera(const geometry::LookAt &camera);
    /// By steps of the arrow keys.
    void turn(int right, int down);
    void zoom(const QPointF &position, double notches);

    SceneDocument &m_document;
    ObserverOverlay m_overlay;

    glm::dmat4 m_drawnFrom{0.0}; ///< clipFromWorld of the frame, whether or not it could be drawn
    geometry::Surface m_drawnOn; ///< the same of its surface
    double m_t = 0.0;
    std::set<lessons::Highlight> m_highlights;
    QString m_markedTerm;
    geometry::Setup m_observer;
    geometry::Placement m_reference; ///< where the cube stands
    bool m_isPlaced = false;
    bool m_isTouched = false; ///< a hand has moved the observer
    bool m_areWrongPointsSeen = true;
    geometry::Surface m_placedFor; ///< the first view's surface when the observer was placed

    Drag m_drag = Drag::None;
    std::optional<geometry::ClipPlaneDrag> m_planeDrag;
    std::optional<geometry::ClipPlane> m_hotPlane;
    QPointF m_lastPosition;
    QString m_gesture; ///< the drag that is under way, undone as one
    int m_gestureCount = 0;
};

} // namespace unprojector::gui
