#pragma once

#include "core/curves/curve_line.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "gui/document/background.h"
#include "gui/document/change_notifier.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A measure that the view shows where it is measured.
struct ShownMeasure {
    enum class Shape {
        Polyline, ///< straight from point to point
        Angle,    ///< at the first point, between those to the second and the third
        Height,   ///< of the fourth point over the plane of the three before it
        Surface,  ///< along the surface: SceneCurves::throughSelected
    };
    Shape shape = Shape::Polyline;
    std::vector<std::size_t> points; ///< indices into SceneDocument::landmarks()
    QString text;                    ///< "12.3 ± 0.1 mm"
    friend bool operator==(const ShownMeasure &, const ShownMeasure &) = default;
};

/// The curves between the landmarks of a document's scene: their lines on the surface, and edits of single curves. Each edit
/// is one step of undo, named after the curve. An index is one into SceneDocument::scene().landmarks.curves.
///
/// The landmarks determine a curve's line. It is computed again whenever they move: on small models at once, on others on a
/// thread of its own. Until then the former line is shown and marked as such. Change::Curves reports the new one.
class SceneCurves : public QObject {
    Q_OBJECT
public:
    /// How a curve goes.
    struct Line {
        bool isComputing = false;              ///< `line` is of where the points were before
        std::optional<curves::CurveLine> line; ///< none: `reason` says why, or it is not known yet
        QString reason;                        ///< a sentence without a full stop
        std::optional<JobFailure> failure;     ///< the reason is no fault of the curve: complete() tries again
    };

    /// @param changes  reports the lines that were computed
    SceneCurves(SceneDocument &document, ChangeNotifier &changes);
    ~SceneCurves() override;

    const std::vector<landmarks::Curve> &all() const;
    /// @pre curve < all().size()
    const Line &line(std::size_t curve) const;
    /// The geodesic through the points that are selected, in their order in the list; null where fewer than two are.
    const Line *throughSelected() const;
    bool isComputing() const { return m_background.isRunning(); }
    /// How many curves are being worked out, and how many of them are done.
    struct Progress {
        std::size_t done = 0, count = 0;
    };
    Progress progress() const;
    /// Works all of them out before it returns, also those for which there was no thread or no memory before.
    /// @return false where the waiting, see setWaiting, was given up; what is under way goes on
    bool complete();
    /// Who shows that curves are waited for, and waits until none is computing, with the events of the program going on.
    /// @param waiting  returns false where somebody gives up. Empty: the thread that asks is blocked until all are there
    void setWaiting(std::function<bool()> waiting) { m_waiting = std::move(waiting); }
    /// The points and the curves with their semilandmarks, for a file. Waits for what is not known yet.
    /// @return or why a curve is not known, a clause: the waiting was given up, or there was no thread or no memory
    geometry::Result<landmarks::LandmarkSet, QString> withSemilandmarks();

    /// What is shown in the view of what is measured at the selected points. Not undoable.
    const std::optional<ShownMeasure> &shownMeasure() const { return m_shownMeasure; }
    void showMeasure(std::optional<ShownMeasure> measure);

    // Edits.

    /// Another curve through these points, in this order.
    /// @return why there is none, in words; empty: it is there
    QString join(const std::vector<std::size_t> &points, landmarks::CurveKind kind);
    /// @param count  from 2 to landmarks::kMostSemilandmarks
    void setCount(std::size_t curve, int count);
    void setKind(std::size_t curve, landmarks::CurveKind kind);
    /// @return false of an empty name, and of one that another curve has: they change nothing
    bool rename(std::size_t curve, const QString &name);
    void remove(std::size_t curve);

    static QString shownNameOf(const landmarks::Curve &curve, std::size_t index);

private:
    struct Request;
    struct Known;
    struct Task;
    class Surfaces;

    /// Of so many triangles a line is worked out at once: in less time than a picture takes.
    static constexpr std::size_t kMostAtOnce = 2'000;
    /// Through more points that are selected, as all of them, nobody has asked for a line.
    static constexpr std::size_t kMostMeasured = 20;

    void refresh();
    /// Finds the object that all points lie on.
    void locate(Request &request) const;
    Request requestOf(const landmarks::Curve &curve) const;
    void begin();
    void take(const JobResult<std::vector<Line>> &lines);
    void edit(std::vector<landmarks::Curve> curves, const QString &text, const QString &mergeKey = {});

    SceneDocument &m_document;
    ChangeNotifier &m_changes;
    std::shared_ptr<Surfaces> m_surfaces;
    std::vector<Known> m_known;        ///< one a curve
    std::unique_ptr<Known> m_selected; ///< of what is selected
    std::shared_ptr<Task> m_task;      ///< the one under way
    std::optional<ShownMeasure> m_shownMeasure;
    std::function<bool()> m_waiting;
    bool m_isWaiting = false;
    Background m_background;
};

} // namespace unprojector::gui
