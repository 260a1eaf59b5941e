#pragma once

#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/text/json_value.h"

#include <array>
#include <string_view>

/// What a link set:NAME does.
namespace unprojector::lessons {

/// The keys of a scene document that it may change.
inline constexpr std::array<std::string_view, 6> kSettableKeys{"projection", "view",  "depthRange",
                                                               "clipPlanes", "point", "ui"};

/// A scene's settings with a change merged into its document. What the change does not speak of stays to the last bit;
/// a point it gives whole, whatever point there was.
/// @param setup   of the scene, in the window that shows it
/// @param change  as "change" of a step (RFC 7396), of kSettableKeys alone
/// @return an error where the result is no scene, or has no such key, as left and right of a gluPerspective
geometry::Result<scene::SceneSettings, LessonError>
settingsWith(const scene::Scene &scene, const geometry::Setup &setup, const text::JsonValue &change);

} // namespace unprojector::lessons
