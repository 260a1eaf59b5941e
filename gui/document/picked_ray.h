#pragma once

#include "core/ray/ray_comparison.h"
#include "core/ray/scene_rays.h"
#include "core/unproject/other_programs.h"
#include "core/unproject/pick.h"
#include "gui/document/background.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::gui {

/// A place on a mesh, of an object that others may be put beside, moved or removed.
struct MetPlace {
    ray::SceneHit hit;
    std::optional<std::size_t> object; ///< its place in the list as it is now; nothing when it was removed
    std::string objectName;            ///< at the click
};

/// What the ray of a pick meets on the meshes themselves, in the scene as it was at the click.
struct PickedRay {
    enum class State {
        Preparing,  ///< a model is not prepared for rays yet; the answer comes by itself
        Impossible, ///< a model could not be prepared, see `failure`, or there is no ray
        Answered
    };
    State state = State::Preparing;
    std::optional<JobFailure> failure;
    std::optional<MetPlace> met;   ///< by the ray itself; nothing: nothing is met
    ray::RayComparison comparison; ///< of what is met, beside the frame
    ray::Snap snap = ray::Snap::Surface;
    /// What other programs give for the click, of a hit: the clicked pixel's depth as it was read, that of others as rays
    /// meet them.
    std::optional<unproject::OtherAnswers> others;
    std::optional<MetPlace> taken; ///< what the click takes, in that mode: of a surface the same
};

} // namespace unprojector::gui
