#pragma once

#include "core/base/json.h"
#include "core/lessons/lesson.h"
#include "core/scene/scene.h"

/// The effect of a link set:NAME.
namespace unprojector::lessons {

/// A scene's settings with a change merged into its document. Settings that the change does not
/// name stay the same to the last bit. A point in the change replaces the whole former point.
/// @param setup   of the scene, in the window that shows it
/// @param change  like a step's "change" (RFC 7396), with the keys projection, view, depthRange,
///         clipPlanes, point and ui only
/// @return an error if the result is no scene, or has no such key, such as left and right of a
///         gluPerspective
base::Expected<scene::SceneSettings, base::Error> settingsWith(const scene::Scene &scene, const geometry::Setup &setup,
                                                               const base::JsonValue &change);

} // namespace unprojector::lessons
