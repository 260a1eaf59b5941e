#include "gui/document/scene_curves.h"

#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/text/landmark_text.h"

#include <QCoreApplication>
#include <QScopedValueRollback>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using landmarks::Curve;
using landmarks::Landmark;

/// Compares what a curve depends on in a landmark.
bool isSamePlace(const Landmark &a, const Landmark &b)
{
    return a.name == b.name && a.world == b.world && a.anchor == b.anchor && a.uncertainty == b.uncertainty;
}

} // namespace

/// Everything that a line depends on.
struct SceneCurves::Request {
    landmarks::CurveKind kind = landmarks::CurveKind::Geodesic;
    std::vector<Landmark> points;
    std::vector<WorldPoint> given; ///< of a curve without more information
    std::shared_ptr<const Model> model;
    glm::dmat4 placement{1.0};
    QString fault; ///< why no line can be computed

    friend bool operator==(const Request &a, const Request &b)
    {
        return a.kind == b.kind && a.model == b.model && a.placement == b.placement && a.fault == b.fault
               && a.given == b.given
               && std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), isSamePlace);
    }
};

struct SceneCurves::Known {
    std::string name; ///< of the curve
    Request request;
    Line line;
};

/// The surfaces of models, each created once, on the first thread that asks. It keeps no model
/// alive.
class SceneCurves::Surfaces {
public:
    /// @return null if `isEnded` or goesOn requests a stop. Throws std::bad_alloc.
    std::shared_ptr<const curves::SurfaceMesh> of(const std::shared_ptr<const Model> &model,
                                                  const base::Progress &goesOn)
    {
        const std::lock_guard lock(m_mutex);
        std::erase_if(m_kept, [](const auto &entry) { return entry.second.first.expired(); });
        const auto found = m_kept.find(model.get());
        if (found != m_kept.end())
            return found->second.second;
        auto surface =
            curves::SurfaceMesh::build(*model, [&](double share) { return !isEnded && (!goesOn || goesOn(share)); });
        if (surface)
            m_kept[model.get()] = {model, surface};
        return surface;
    }

    std::atomic<bool> isEnded{false};

private:
    std::mutex m_mutex;
    std::map<const Model *, std::pair<std::weak_ptr<const Model>, std::shared_ptr<const curves::SurfaceMesh>>> m_kept;
};

namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SceneCurves)
};

QString quoted(const std::vector<Landmark> &landmarks, std::size_t index)
{
    return QString::fromStdString(landmarks[index].name).simplified();
}

QString absenceOf(const std::vector<Landmark> &landmarks, std::size_t index)
{
    return absenceText(landmarks[index], u'“' + quoted(landmarks, index) + u'”');
}

QString faultOf(const curves::CurveError &error, const std::vector<Landmark> &landmarks)
{
    using Code = curves::CurveError::Code;
    switch (error.code) {
    case Code::TooFew: return Texts::tr("a curve needs at least two landmarks");
    case Code::Missing: return absenceOf(landmarks, error.point);
    case Code::NotOnSurface:
        return Texts::tr("“%1” is not on a surface; select it and press B").arg(quoted(landmarks, error.point));
    case Code::NotConnected:
        return Texts::tr("the surface between “%1” and “%2” is not in one piece")
            .arg(quoted(landmarks, error.point - 1), quoted(landmarks, error.point));
    case Code::NoSection:
        return Texts::tr("no plane along the surface's normals leads from “%1” to “%2”; use the geodesic, or place a "
                         "landmark between them")
            .arg(quoted(landmarks, error.point - 1), quoted(landmarks, error.point));
    }
    return {};
}

/// @return `isComputing` stays set if it was cancelled
template <class Request, class Surfaces>
SceneCurves::Line worked(const Request &request, Surfaces &surfaces, const base::Progress &goesOn)
{
    SceneCurves::Line line;
    try {
        // The shares of the surface, which takes no time if it exists, and of the line.
        constexpr double kSurface = 0.3;
        const auto goesOnFrom = [&goesOn](double from, double to) -> base::Progress {
            return [&goesOn, from, to](double share) { return !goesOn || goesOn(from + (to - from) * share); };
        };
        const std::shared_ptr<const curves::SurfaceMesh> surface =
            surfaces.of(request.model, goesOnFrom(0.0, kSurface));
        line.isComputing = !surface;
        if (!surface)
            return line;
        std::vector<const Landmark *> points;
        for (const Landmark &landmark : request.points)
            points.push_back(&landmark);
        auto through =
            curves::lineThrough(*surface, points, request.kind, request.placement, goesOnFrom(kSurface, 1.0));
        if (through)
            line.line = std::move(through).value();
        else
            line.reason = faultOf(through.error(), request.points);
    } catch (const base::Stopped &) {
        line.isComputing = true;
    } catch (...) { // the other lines may exist
        line.failure = failureOf(std::current_exception());
        line.reason = failureText(*line.failure);
    }
    return line;
}

} // namespace

struct SceneCurves::Task {
    std::vector<Request> requests;
    std::atomic<bool> isEnded{false}; ///< finished lines are used
    std::atomic<std::size_t> done{0};
    double share = 0.0; ///< done, as reported
};

SceneCurves::SceneCurves(SceneDocument &document, ChangeNotifier &changes)
    : m_document(document), m_changes(changes), m_surfaces(std::make_shared<Surfaces>())
{
    connect(&document, &SceneDocument::changed, this, [this](Changes changed) {
        if (changed & (Change::Landmarks | Change::LandmarkSelection | Change::Objects | Change::Placement))
            refresh();
    });
}

SceneCurves::~SceneCurves()
{
    m_surfaces->isEnded = true;
    if (m_task)
        m_task->isEnded = true;
}

const std::vector<Curve> &SceneCurves::all() const
{
    return m_document.scene().landmarks.curves;
}

const SceneCurves::Line &SceneCurves::line(std::size_t curve) const
{
    Q_ASSERT(curve < m_known.size());
    return m_known[curve].line;
}

const SceneCurves::Line *SceneCurves::throughSelected() const
{
    return m_selected ? &m_selected->line : nullptr;
}

QString SceneCurves::shownNameOf(const Curve &curve, std::size_t index)
{
    const QString name = QString::fromStdString(curve.name).simplified();
    return name.isEmpty() ? tr("curve %1").arg(index + 1) : name;
}

// ---- lines --------------------------------------------------------------------------------------

void SceneCurves::locate(Request &request) const
{
    const std::vector<Landmark> &landmarks = request.points;
    for (std::size_t i = 0; i < landmarks.size() && request.fault.isEmpty(); ++i) {
        if (!landmarks[i].isPlaced())
            request.fault = absenceOf(landmarks, i);
        else if (landmarks[i].object.empty())
            request.fault = tr("“%1” is not on a surface; select it and press B").arg(quoted(landmarks, i));
        else if (landmarks[i].object != landmarks.front().object)
            request.fault = tr("“%1” lies on another object than “%2”").arg(quoted(landmarks, i), quoted(landmarks, 0));
    }
    if (!request.fault.isEmpty())
        return;
    for (const SceneObject &object : m_document.objects()) {
        if (object.name == landmarks.front().object) {
            request.model = object.model;
            request.placement = worldFromObject(object.transform);
            return;
        }
    }
    request.fault = tr("there is no object “%1”").arg(QString::fromStdString(landmarks.front().object));
}

SceneCurves::Request SceneCurves::requestOf(const Curve &curve) const
{
    Request request;
    request.kind = curve.kind;
    if (curve.points.empty()) {
        request.given = curve.semilandmarks;
        return request;
    }
    for (const std::string &name : curve.points) {
        const std::vector<Landmark> &all = m_document.landmarks();
        const auto hasName = [&name](const Landmark &landmark) { return landmark.name == name; };
        const auto found = std::find_if(all.begin(), all.end(), hasName);
        const QString shown = QString::fromStdString(name).simplified();
        if (found == all.end())
            request.fault = tr("there is no landmark “%1”").arg(shown);
        else if (std::any_of(found + 1, all.end(), hasName))
            request.fault = tr("several landmarks are called “%1”; rename all but one").arg(shown);
        if (!request.fault.isEmpty())
            return request;
        request.points.push_back(*found);
    }
    if (request.points.size() < 2)
        request.fault = faultOf({curves::CurveError::Code::TooFew, 0}, {});
    else
        locate(request);
    return request;
}

void SceneCurves::refresh()
{
    std::vector<Known> before = std::exchange(m_known, {});
    const auto known = [&](const std::string &name, Request request, const Known *former) {
        Known now{name, std::move(request), {}};
        if (former && former->request == now.request) {
            now.line = former->line;
            return now;
        }
        Line &line = now.line;
        if (!now.request.fault.isEmpty()) {
            line.reason = now.request.fault;
        } else if (!now.request.model) {
            line.line.emplace().path = now.request.given;
            double &length = line.line->length.value;
            for (std::size_t i = 1; i < now.request.given.size(); ++i)
                length += distance(now.request.given[i - 1], now.request.given[i]);
        } else if (now.request.model->triangleCount() <= kMostAtOnce) {
            line = worked(now.request, *m_surfaces, {});
        } else {
            line.isComputing = true;
            if (former)
                line.line = former->line.line;
        }
        return now;
    };
    for (std::size_t i = 0; i < all().size(); ++i) {
        const Curve &curve = all()[i];
        const auto former =
            std::find_if(before.begin(), before.end(), [&](const Known &other) { return other.name == curve.name; });
        m_known.push_back(known(curve.name, requestOf(curve), former != before.end() ? &*former : nullptr));
    }
    const std::vector<std::size_t> &selection = m_document.sceneLandmarks().selectionInOrder();
    const std::unique_ptr<Known> formerSelected = std::move(m_selected);
    if (selection.size() >= 2) {
        Request request;
        for (const std::size_t index : selection) {
            request.points.push_back(m_document.landmarks()[index]);
            request.points.back().name = SceneLandmarks::shownNameOf(m_document.landmarks(), index).toStdString();
        }
        if (selection.size() > kMostMeasured)
            request.fault = tr("it can have at most %1 landmarks").arg(kMostMeasured);
        else
            locate(request);
        m_selected = std::make_unique<Known>(known({}, std::move(request), formerSelected.get()));
    }
    const auto isWanted = [this](const Request &request) {
        const auto asks = [&](const Known &each) { return each.line.isComputing && each.request == request; };
        return std::any_of(m_known.begin(), m_known.end(), asks) || (m_selected && asks(*m_selected));
    };
    if (!m_task)
        begin();
    else if (!std::all_of(m_task->requests.begin(), m_task->requests.end(), isWanted))
        m_task->isEnded = true; // its finished lines are used; the rest is requested again
}

void SceneCurves::begin()
{
    const auto task = std::make_shared<Task>();
    const auto ask = [&](const Known &known) {
        if (known.line.isComputing)
            task->requests.push_back(known.request);
    };
    forEachKnown(ask);
    if (task->requests.empty())
        return;
    m_task = task;
    m_background.start(
        [task, surfaces = m_surfaces](Job &job) {
            std::vector<Line> lines;
            for (const Request &request : task->requests) {
                if (task->isEnded)
                    break;
                lines.push_back(worked(request, *surfaces, [&](double share) {
                    return job.report((double(task->done) + share) / double(task->requests.size())) && !task->isEnded;
                }));
                ++task->done;
            }
            return lines;
        },
        [this](const JobResult<std::vector<Line>> &lines) { take(lines); },
        [this, task](double share) {
            task->share = share;
            emit progressed();
        });
}

template <class Visit>
void SceneCurves::forEachKnown(const Visit &visit)
{
    std::for_each(m_known.begin(), m_known.end(), visit);
    if (m_selected)
        visit(*m_selected);
}

void SceneCurves::cancel()
{
    if (!m_task)
        return;
    m_task->isEnded = true;
    forEachKnown([](Known &known) {
        if (known.line.isComputing)
            known.line = {false, {}, tr("cancelled; its menu computes it again"), {}, true};
    });
    m_changes.notify(Change::Curves);
}

void SceneCurves::computeAgain()
{
    forEachKnown([](Known &known) {
        if (known.line.isCancelled)
            known.line = {true, {}, {}, {}};
    });
    if (!m_task)
        begin();
    m_changes.notify(Change::Curves);
}

void SceneCurves::take(const JobResult<std::vector<Line>> &lines)
{
    const std::shared_ptr<const Task> task = std::exchange(m_task, nullptr);
    const std::size_t count = lines ? lines->size() : task->requests.size();
    const auto lineOf = [&](std::size_t i) {
        return lines ? (*lines)[i] : Line{false, {}, failureText(lines.error()), lines.error()};
    };
    const auto put = [&](Known &known) {
        for (std::size_t i = 0; i < count && known.line.isComputing; ++i) {
            if (Line line = lineOf(i); !line.isComputing && task->requests[i] == known.request)
                known.line = std::move(line);
        }
    };
    forEachKnown(put);
    begin();
    m_changes.notify(Change::Curves);
}

SceneCurves::Progress SceneCurves::progress() const
{
    return m_task ? Progress{m_task->done, m_task->requests.size(), m_task->share} : Progress{};
}

bool SceneCurves::complete()
{
    for (Known &known : m_known) {
        if (known.line.failure || known.line.isCancelled)
            known.line = {true, {}, {}, {}};
    }
    if (!m_task)
        begin();
    if (m_task && m_waiting && !m_isWaiting) { // a nested call shows nothing: it blocks until all is done
        const QScopedValueRollback<bool> waiting(m_isWaiting, true);
        return m_waiting();
    }
    m_background.finish();
    return true;
}

geometry::Result<landmarks::LandmarkSet, QString> SceneCurves::withSemilandmarks()
{
    if (!complete())
        return tr("computing its curves was cancelled");
    for (const Known &known : m_known) {
        if (known.line.failure)
            return failureText(*known.line.failure);
    }
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    for (std::size_t i = 0; i < set.curves.size(); ++i) {
        Curve &curve = set.curves[i];
        if (curve.points.empty())
            continue;
        const std::optional<curves::CurveLine> &known = line(i).line;
        curve.semilandmarks =
            known && !line(i).isComputing ? curves::resampled(known->path, curve.count) : std::vector<WorldPoint>();
    }
    return set;
}

void SceneCurves::showMeasure(std::optional<ShownMeasure> measure)
{
    if (measure == m_shownMeasure)
        return;
    m_shownMeasure = std::move(measure);
    m_changes.notify(Change::Curves);
}

// ---- edits --------------------------------------------------------------------------------------

void SceneCurves::edit(std::vector<Curve> curves, const QString &text, const QString &mergeKey)
{
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    set.curves = std::move(curves);
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {text, mergeKey}));
}

QString SceneCurves::join(const std::vector<std::size_t> &points, landmarks::CurveKind kind)
{
    const std::vector<Landmark> &landmarks = m_document.landmarks();
    if (points.size() < 2)
        return faultOf({curves::CurveError::Code::TooFew, 0}, {});
    Curve curve;
    curve.kind = kind;
    for (const std::size_t index : points) {
        const Landmark &landmark = landmarks[index];
        if (landmark.name.empty())
            return tr("%1 has no name; give it one, because curves refer to landmarks by name")
                .arg(SceneLandmarks::shownNameOf(landmarks, index));
        curve.points.push_back(landmark.name);
    }
    if (const Request request = requestOf(curve); !request.fault.isEmpty())
        return request.fault;
    std::vector<Curve> curves = all();
    for (std::size_t number = curves.size() + 1; curve.name.empty(); ++number) {
        const std::string name = tr("Curve %1").arg(number).toStdString();
        if (std::none_of(curves.begin(), curves.end(), [&](const Curve &other) { return other.name == name; }))
            curve.name = name;
    }
    const QString text = tr("Join %1").arg(shownNameOf(curve, curves.size()));
    curves.push_back(std::move(curve));
    edit(std::move(curves), text);
    return {};
}

void SceneCurves::setCount(std::size_t curve, int count)
{
    std::vector<Curve> curves = all();
    curves[curve].count = static_cast<std::uint32_t>(std::clamp(count, 2, landmarks::kMostSemilandmarks));
    edit(std::move(curves), tr("Semilandmarks of %1").arg(shownNameOf(all()[curve], curve)),
         QStringLiteral("count of curve %1").arg(curve));
}

void SceneCurves::setKind(std::size_t curve, landmarks::CurveKind kind)
{
    std::vector<Curve> curves = all();
    curves[curve].kind = kind;
    edit(std::move(curves), tr("Kind of %1").arg(shownNameOf(all()[curve], curve)));
}

bool SceneCurves::rename(std::size_t curve, const QString &name)
{
    std::vector<Curve> curves = all();
    const std::string wanted = name.trimmed().toStdString();
    if (wanted == curves[curve].name)
        return true;
    const bool isTaken = std::any_of(curves.begin(), curves.end(), [&](const Curve &c) { return c.name == wanted; });
    if (wanted.empty() || isTaken)
        return false;
    curves[curve].name = wanted;
    edit(std::move(curves), tr("Rename %1").arg(shownNameOf(all()[curve], curve)));
    return true;
}

void SceneCurves::remove(std::size_t curve)
{
    std::vector<Curve> curves = all();
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(curve));
    edit(std::move(curves), tr("Remove %1").arg(shownNameOf(all()[curve], curve)));
}

} // namespace unprojector::gui
