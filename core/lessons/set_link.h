#pragma once

#include "core/base/json.h"
#include "core/lessons/lesson.h"
#include "core/scene/scene.h"

#include <array>
#include <string_view>

/// The effect of a link set:NAME.
namespace unprojector::lessons {

/// The keys of a scene document that it may change.
inline constexpr std::array<std::string_view, 6> kSettableKeys{"projection", "view",  "depthRange",
                                                               "clipPlanes", "point", "ui"};

/// A scene's settings with a change merged into its document. Settings that the change does not
/// name stay the same to the last bit. A point in the change replaces the whole former point.
/// @param setup   of the scene, in the window that shows it
/// @param change  like a step's "change" (RFC 7396), with kSettableKeys only
/// @return an error if the result is no scene, or has no such key, such as left and right of a
///         gluPerspective
geometry::Result<scene::SceneSettings, LessonError>
settingsWith(const scene::Scene &scene, const geometry::Setup &setup, const base::JsonValue &change);

} // namespace unprojector::lessons
