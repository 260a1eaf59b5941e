#include "gui/document/landmark_objects.h"

#include "core/ray/closest_place.h"
#include "gui/document/document_change.h"
#include "gui/document/scene_landmarks.h"
#include "gui/text/landmark_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

using landmarks::Landmark;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::LandmarkObjects)
};

/// The change of an object, for its landmarks.
struct ObjectAfter {
    const SceneObject *object = nullptr; ///< afterwards; null: removed
    bool isMoved = false;
    glm::dmat4 motion{1.0}; ///< new world from old world
};

ObjectAfter afterOf(const std::vector<SceneObject> &before, std::size_t index, const std::vector<SceneObject> &after)
{
    const bool isOtherList = changesBetween(before, after).testFlag(Change::Objects);
    const std::optional<std::size_t> found = isOtherList ? indexAfter(before, index, after) : std::optional(index);
    if (!found)
        return {};
    const SceneObject &was = before[index], &is = after[*found];
    if (was.transform == is.transform)
        return {&is, false, {}};
    return {&is, true, worldFromObject(is.transform) * glm::inverse(worldFromObject(was.transform))};
}

/// Transforms the axes' errors as independent ones: a rotation keeps their total size.
WorldVector stretched(const WorldVector &uncertainty, const glm::dmat4 &motion)
{
    glm::dvec3 squares(0.0);
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 part = glm::dvec3(motion[column]) * uncertainty.coordinates()[column];
        squares += part * part;
    }
    return WorldVector(std::sqrt(squares.x), std::sqrt(squares.y), std::sqrt(squares.z));
}

void move(Landmark &landmark, const ObjectAfter &to)
{
    if (!landmark.world)
        return;
    const std::optional<WorldPoint> held = worldOf(landmark.anchor, *to.object);
    landmark.world = held ? *held : WorldPoint(glm::dvec3(to.motion * glm::dvec4(landmark.world->coordinates(), 1.0)));
    if (landmark.uncertainty)
        landmark.uncertainty = stretched(*landmark.uncertainty, to.motion);
}

} // namespace

QString detachStale(std::vector<Landmark> &landmarks, const std::vector<SceneObject> &objects)
{
    /// Relative to the object's size: the error of single precision and rounding.
    constexpr double kSamePlace = 1e-5;
    std::size_t absent = 0, unknown = 0, elsewhere = 0;
    QString firstAbsent, firstUnknown, firstElsewhere;
    double farthest = 0.0;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        Landmark &landmark = landmarks[i];
        const auto object = std::find_if(objects.begin(), objects.end(),
                                         [&](const SceneObject &each) { return each.name == landmark.object; });
        if (!landmark.object.empty() && object == objects.end()) {
            if (absent++ == 0)
                firstAbsent =
                    Texts::tr("“%1” (on “%2”)")
                        .arg(SceneLandmarks::shownNameOf(landmarks, i), QString::fromStdString(landmark.object));
            landmark.object.clear();
            landmark.anchor = landmarks::Free{};
            continue;
        }
        if (!landmark.world || object == objects.end() || std::holds_alternative<landmarks::Free>(landmark.anchor))
            continue;
        const std::optional<WorldPoint> held = worldOf(landmark.anchor, *object);
        const double off = held ? distance(*held, *landmark.world) : 0.0;
        if (held && !(off > kSamePlace * boundsOf(*object).diagonal()))
            continue;
        const QString what =
            Texts::tr("“%1” (%2)").arg(SceneLandmarks::shownNameOf(landmarks, i), heldByText(landmark));
        landmark.anchor = landmarks::Free{};
        landmark.uncertainty.reset(); // it was that of another position, or of another mesh
        if (!held && unknown++ == 0)
            firstUnknown = what;
        if (held && (elsewhere++ == 0 || off > farthest)) {
            firstElsewhere = what;
            farthest = off;
        }
    }
    QStringList said;
    if (absent > 0)
        said << Texts::tr("Landmarks on a missing object: %1, such as %2.").arg(absent).arg(firstAbsent);
    if (unknown > 0)
        said << Texts::tr("Landmarks whose triangle, edge or vertex does not exist: %1, such as %2.")
                    .arg(unknown)
                    .arg(firstUnknown);
    if (elsewhere > 0)
        said << Texts::tr("Landmarks away from their anchor, as if the model had been changed: %1; %2 by %3.")
                    .arg(QString::number(elsewhere), firstElsewhere, readableText(farthest));
    if (!said.isEmpty())
        said << Texts::tr("They are free now. To put selected landmarks onto the surface, press B.");
    return joinSentences(said);
}

std::optional<WorldPoint> worldOf(const landmarks::Anchor &anchor, const SceneObject &object)
{
    const std::optional<ObjectPoint> point = ray::placeOf(anchor, *object.model);
    if (!point)
        return std::nullopt;
    return WorldPoint(glm::dvec3(worldFromObject(object.transform) * glm::dvec4(point->coordinates(), 1.0)));
}

std::shared_ptr<const landmarks::LandmarkSet> withObjects(const std::shared_ptr<const landmarks::LandmarkSet> &set,
                                                          const std::vector<SceneObject> &before,
                                                          const std::vector<SceneObject> &after)
{
    std::map<std::string, std::optional<ObjectAfter>> objects; // nothing: no object has this name
    std::shared_ptr<landmarks::LandmarkSet> changed;
    for (std::size_t i = 0; i < set->landmarks.size(); ++i) {
        const Landmark &landmark = set->landmarks[i];
        if (landmark.object.empty())
            continue;
        auto found = objects.find(landmark.object);
        if (found == objects.end()) {
            const auto object = std::find_if(before.begin(), before.end(),
                                             [&](const SceneObject &o) { return o.name == landmark.object; });
            std::optional<ObjectAfter> becomes;
            if (object != before.end())
                becomes = afterOf(before, static_cast<std::size_t>(object - before.begin()), after);
            found = objects.emplace(landmark.object, becomes).first;
        }
        const std::optional<ObjectAfter> &to = found->second;
        if (!to || (to->object && !to->isMoved && to->object->name == landmark.object))
            continue;
        if (!changed)
            changed = std::make_shared<landmarks::LandmarkSet>(*set);
        Landmark &other = changed->landmarks[i];
        if (!to->object) {
            other.object.clear();
            other.anchor = landmarks::Free{};
            continue;
        }
        other.object = to->object->name;
        if (to->isMoved)
            move(other, *to);
    }
    return changed ? changed : set;
}

std::optional<landmarks::LandmarkSet> transformed(landmarks::LandmarkSet set, const SceneObject &from,
                                                  const SceneObject &to)
{
    const bool isMoved = from.transform != to.transform;
    ObjectAfter after{&to, isMoved, {}};
    if (isMoved)
        after.motion = worldFromObject(to.transform) * glm::inverse(worldFromObject(from.transform));
    for (Landmark &landmark : set.landmarks) {
        const bool isOnIt = landmark.object == from.name;
        if (isMoved && isOnIt) {
            move(landmark, after);
        } else if (isMoved) { // its anchor is not part of this mesh
            const landmarks::Anchor anchor = std::exchange(landmark.anchor, landmarks::Free{});
            move(landmark, after);
            landmark.anchor = anchor;
        }
        if (isOnIt)
            landmark.object = to.name;
        const auto isFinite = [](const auto &v) {
            return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        };
        if ((landmark.world && !isFinite(*landmark.world))
            || (landmark.uncertainty && !isFinite(*landmark.uncertainty)))
            return std::nullopt;
    }
    for (landmarks::Curve &curve : set.curves) {
        for (WorldPoint &point : curve.semilandmarks) {
            if (isMoved)
                point = WorldPoint(glm::dvec3(after.motion * glm::dvec4(point.coordinates(), 1.0)));
        }
    }
    return set;
}

} // namespace unprojector::gui
