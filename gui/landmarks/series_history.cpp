#include "gui/landmarks/series_history.h"

#include "core/landmarks/point_template.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/scan.h"
#include "gui/text/error_text.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <iterator>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace scene;

namespace {

const SceneObject *objectOf(const std::filesystem::path &scan, const std::vector<SceneObject> &objects)
{
    const auto found = std::find_if(objects.begin(), objects.end(), [&scan](const SceneObject &object) {
        return object.file.filename() == scan.filename();
    });
    return found != objects.end() ? &*found : nullptr;
}

/// The landmarks of a scene in coordinates of the scan's own file.
/// @return nothing without the scan, or if a coordinate would not be finite
std::optional<LandmarkSet> inFile(LandmarkSet set, const std::vector<SceneObject> &objects,
                                  const std::filesystem::path &scan)
{
    const SceneObject *object = objectOf(scan, objects);
    if (!object)
        return std::nullopt;
    set.measures.clear();             // they belong to the series
    for (Curve &curve : set.curves) { // they follow from the rest
        if (!curve.points.empty())
            curve.semilandmarks.clear();
    }
    return transformed(std::move(set), *object, asInItsFile(scan, *object));
}

/// Returns whether the same landmarks are placed, at the same positions. Names to place may differ:
/// they come from other scans too.
bool areAs(std::vector<Landmark> now, std::vector<Landmark> expected)
{
    for (std::vector<Landmark> *each : {&now, &expected})
        std::erase_if(*each, [](const Landmark &landmark) { return !landmark.isPlaced(); });
    return std::equal(now.begin(), now.end(), expected.begin(), expected.end(),
                      [](const Landmark &a, const Landmark &b) { return a.name == b.name && isStill(a, b); });
}

/// Adds the names to place and the curves that came from other scans.
void addFromOthers(LandmarkSet &to, const LandmarkSet &from, const LandmarkSet &now)
{
    const std::vector<Landmark> all = withTemplate(from.landmarks, now.landmarks);
    const auto others = all.begin() + static_cast<std::ptrdiff_t>(from.landmarks.size());
    to.landmarks = withTemplate(std::move(to.landmarks), std::vector<Landmark>(others, all.end()));
    for (const Curve &curve : now.curves) {
        const auto hasName = [&curve](const Curve &other) { return other.name == curve.name; };
        if (std::none_of(from.curves.begin(), from.curves.end(), hasName)
            && std::none_of(to.curves.begin(), to.curves.end(), hasName))
            to.curves.push_back(curve);
    }
}

} // namespace

/// A change on the document's stack; its scan may not be shown.
class SeriesHistory::Command : public QUndoCommand {
public:
    Command(SeriesHistory &history, std::shared_ptr<const ScanStep> step, const QString &text)
        : QUndoCommand(text), m_history(history), m_step(std::move(step))
    {
    }
    void undo() override { setObsolete(!m_history.apply(m_step, false)); }
    void redo() override { setObsolete(!m_history.apply(m_step, true)); }
    const std::shared_ptr<const ScanStep> &step() const { return m_step; }

private:
    SeriesHistory &m_history;
    std::shared_ptr<const ScanStep> m_step;
};

SeriesHistory::SeriesHistory(SceneDocument &document, QObject *parent) : QObject(parent), m_document(document) {}

void SeriesHistory::collect(const ScanPlacing &shown)
{
    const QUndoStack &stack = m_document.undoStack();
    m_steps.clear();
    m_index = 0;
    for (int i = 0; i < stack.count(); ++i) {
        std::shared_ptr<const ScanStep> step;
        if (const auto *other = dynamic_cast<const Command *>(stack.command(i))) {
            step = other->step();
        } else if (const auto *change = dynamic_cast<const SceneChange *>(stack.command(i));
                   change && change->before().landmarks != change->after().landmarks) {
            auto before = inFile(*change->before().landmarks, *change->before().objects, shown.scan);
            auto after = inFile(*change->after().landmarks, *change->after().objects, shown.scan);
            if (before && after) {
                takeExact(after->landmarks, before->landmarks); // the scan was moved, not they
                if (*before != *after)
                    step = std::make_shared<const ScanStep>(
                        ScanStep{shown, change->text(), *std::move(before), *std::move(after)});
            }
        }
        if (!step)
            continue;
        m_steps.push_back(std::move(step));
        if (i < stack.index())
            ++m_index;
    }
}

void SeriesHistory::putBack(const ScanPlacing &shown, const std::function<bool(const std::filesystem::path &)> &isHere)
{
    m_shown = shown;
    m_wanted.reset();
    const QScopedValueRollback<bool> quiet(m_isQuiet, true);
    QUndoStack &stack = m_document.undoStack();
    stack.clear();
    int index = 0;
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const std::shared_ptr<const ScanStep> &step = m_steps[i];
        if (!isHere(step->where.scan))
            continue;
        stack.push(new Command(
            *this, step,
            step->where == shown ? step->text : tr("%1 on %2").arg(step->text, pathText(step->where.scan.filename()))));
        if (static_cast<int>(i) < m_index)
            ++index;
    }
    stack.setIndex(index);
}

void SeriesHistory::forget()
{
    m_steps.clear();
    m_index = 0;
    m_shown.reset();
    m_wanted.reset();
    QUndoStack &stack = m_document.undoStack();
    for (int i = 0; i < stack.count(); ++i) {
        if (!dynamic_cast<const Command *>(stack.command(i)))
            continue;
        const bool isModified = m_document.isModified();
        stack.clear();
        if (isModified)
            stack.resetClean();
        return;
    }
}

std::optional<int> SeriesHistory::indexOf(const ScanStep *step) const
{
    const QUndoStack &stack = m_document.undoStack();
    for (int i = 0; i < stack.count(); ++i) {
        const auto *command = dynamic_cast<const Command *>(stack.command(i));
        if (command && command->step().get() == step)
            return i;
    }
    return std::nullopt;
}

void SeriesHistory::setIndexQuietly(int index)
{
    const QScopedValueRollback<bool> quiet(m_isQuiet, true);
    m_document.undoStack().setIndex(index);
}

bool SeriesHistory::apply(const std::shared_ptr<const ScanStep> &step, bool isRedo)
{
    if (m_isQuiet || m_wanted) // passOn puts the stack right
        return true;
    if (m_shown != step->where) {
        m_wanted = {step, isRedo};
        // Later: the stack moves its index first.
        QMetaObject::invokeMethod(this, &SeriesHistory::passOn, Qt::QueuedConnection);
        return true;
    }
    const LandmarkSet &from = isRedo ? step->before : step->after;
    LandmarkSet to = isRedo ? step->after : step->before;
    const std::filesystem::path &scan = step->where.scan;
    const std::vector<SceneObject> &objects = m_document.objects();
    const std::optional<LandmarkSet> now = inFile(m_document.scene().landmarks, objects, scan);
    std::optional<LandmarkSet> shown;
    if (now && areAs(now->landmarks, from.landmarks)) {
        addFromOthers(to, from, *now);
        const SceneObject *object = objectOf(scan, objects);
        to.measures = m_document.scene().landmarks.measures;
        shown = transformed(std::move(to), asInItsFile(scan, *object), *object);
    }
    if (!shown) {
        emit refused((isRedo ? tr("“%1” on %2 cannot be redone: its landmarks have changed since.")
                             : tr("“%1” on %2 cannot be undone: its landmarks have changed since."))
                         .arg(step->text, pathText(scan.filename())));
        return false;
    }
    m_document.restoreLandmarks(*std::move(shown));
    return true;
}

void SeriesHistory::passOn()
{
    const std::optional<Wanted> wish = std::exchange(m_wanted, std::nullopt);
    const std::optional<int> index = wish ? indexOf(wish->step.get()) : std::nullopt;
    if (!index)
        return;
    setIndexQuietly(wish->isRedo ? *index : *index + 1);
    emit wanted(wish->step, wish->isRedo);
}

bool SeriesHistory::run(const std::shared_ptr<const ScanStep> &step, bool isRedo)
{
    QUndoStack &stack = m_document.undoStack();
    const std::optional<int> index = indexOf(step.get());
    if (!index || stack.index() != (isRedo ? *index : *index + 1))
        return false;
    isRedo ? stack.redo() : stack.undo();
    return indexOf(step.get()).has_value(); // a refused one is not kept
}

} // namespace unprojector::gui
