#pragma once

#include "core/curves/curve_line.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/symmetry.h"
#include "core/scene/scene.h"
#include "gui/document/background.h"
#include "gui/document/change_notifier.h"

#include <QObject>
#include <QString>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A measure that the view draws at its landmarks, with its value.
struct ShownMeasure {
    enum class Shape {
        Polyline, ///< straight from landmark to landmark
        Angle,    ///< at the first landmark, between the second and the third
        Height,   ///< of the fourth landmark over the plane of the first three
        Surface,  ///< along the surface: SceneCurves::throughSelected
        Mirror,   ///< landmarks by twos, each with its partner, or itself in the middle; and `mirror`
    };
    /// A mirror plane, and a rectangle of it.
    struct Mirror {
        landmarks::MirrorPlane plane;
        std::array<geometry::WorldPoint, 4> corners;
        friend bool operator==(const Mirror &, const Mirror &) = default;
    };
    Shape shape = Shape::Polyline;
    std::vector<std::size_t> points; ///< indices into SceneDocument::landmarks()
    QString text;                    ///< "12.3 ± 0.1 mm"
    std::optional<Mirror> mirror = {};
    friend bool operator==(const ShownMeasure &, const ShownMeasure &) = default;
};

/// The curves between the landmarks of a document's scene: their lines on the surface, and edits of
/// single curves. Each edit is one step of undo, named after the curve. Indices refer to
/// SceneDocument::scene().landmarks.curves.
///
/// The landmarks determine a curve's line. It is recomputed whenever they move: on small models at
/// once, on others on a separate thread. Until then the former line is shown and marked as such.
/// Change::Curves reports the new one.
class SceneCurves : public QObject {
    Q_OBJECT
public:
    /// The line of a curve.
    struct Line {
        bool isComputing = false;              ///< `line` still belongs to the former landmarks
        std::optional<curves::CurveLine> line; ///< none: see `reason`, or it is not computed yet
        QString reason;                        ///< a sentence without a full stop
        std::optional<JobFailure> failure;     ///< the reason is not the curve's fault: complete() tries again
        bool isCancelled = false;              ///< the user cancelled it: complete() tries again
    };

    /// @param changes  receives the changes when lines were computed
    SceneCurves(SceneDocument &document, ChangeNotifier &changes);
    ~SceneCurves() override;

    const std::vector<landmarks::Curve> &all() const;
    /// @pre curve < all().size()
    const Line &line(std::size_t curve) const;
    /// The geodesic through the selected landmarks, in the order of their selection; null if fewer
    /// than two are selected.
    const Line *throughSelected() const;
    bool isComputing() const { return m_background.isRunning(); }
    /// The number of curves to compute, how many of them are done, and the share done of all.
    struct Progress {
        std::size_t done = 0, count = 0;
        double share = 0.0;
    };
    Progress progress() const;
    /// Cancels all computations under way; their lines are Line::isCancelled.
    void cancel();
    /// Computes the cancelled lines.
    void computeAgain();
    /// Blocks until all curves are computed, including curves that lacked a thread or memory
    /// before.
    /// @return false if the user gave up waiting (setWaiting); the computation then continues
    bool complete();
    /// Sets a callback that runs an event loop and shows progress until no curve is computing.
    /// @param waiting  returns false if the user gives up. Empty: complete() blocks the calling
    /// thread
    void setWaiting(std::function<bool()> waiting) { m_waiting = std::move(waiting); }
    /// The landmarks and the curves with their semilandmarks, for a file. Waits for curves that are
    /// not computed yet.
    /// @return or the reason why a curve is unknown, a clause: the user gave up waiting, or there
    /// was no thread or no memory
    geometry::Result<landmarks::LandmarkSet, QString> withSemilandmarks();

    /// The measure at the selected landmarks that the view shows. Not undoable.
    const std::optional<ShownMeasure> &shownMeasure() const { return m_shownMeasure; }
    void showMeasure(std::optional<ShownMeasure> measure);

    // Edits.

    /// Adds a curve through these landmarks, in this order.
    /// @return the reason if it was not added; empty on success
    QString join(const std::vector<std::size_t> &points, landmarks::CurveKind kind);
    /// @param count  from 2 to landmarks::kMostSemilandmarks
    void setCount(std::size_t curve, int count);
    void setKind(std::size_t curve, landmarks::CurveKind kind);
    /// @return false for an empty name and for another curve's name: nothing changes then
    bool rename(std::size_t curve, const QString &name);
    void remove(std::size_t curve);

    static QString shownNameOf(const landmarks::Curve &curve, std::size_t index);

signals:
    /// Emitted in at most a hundred steps while lines are computed.
    void progressed();

private:
    struct Request;
    struct Known;
    struct Task;
    class Surfaces;

    /// The largest number of triangles for which a line is computed at once: in less time than a
    /// frame takes.
    static constexpr std::size_t kMostAtOnce = 2'000;
    /// A selection with more landmarks, such as "all", gets no line.
    static constexpr std::size_t kMostMeasured = 20;

    void refresh();
    /// Finds the object that has all landmarks.
    void locate(Request &request) const;
    Request requestOf(const landmarks::Curve &curve) const;
    void begin();
    /// Calls a function with every line and its request.
    template <class Visit>
    void forEachKnown(const Visit &visit);
    void take(const JobResult<std::vector<Line>> &lines);
    void edit(std::vector<landmarks::Curve> curves, const QString &text, const QString &mergeKey = {});

    SceneDocument &m_document;
    ChangeNotifier &m_changes;
    std::shared_ptr<Surfaces> m_surfaces;
    std::vector<Known> m_known;        ///< one a curve
    std::unique_ptr<Known> m_selected; ///< of the selection
    std::shared_ptr<Task> m_task;      ///< under way
    std::optional<ShownMeasure> m_shownMeasure;
    std::function<bool()> m_waiting;
    bool m_isWaiting = false;
    Background m_background;
};

} // namespace unprojector::gui
