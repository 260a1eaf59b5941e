#pragma once

#include "core/ray/pixel_edge.h"
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

/// A point on a mesh of an object. Other objects may be added or moved in the list; the object may
/// be removed.
struct MetPlace {
    ray::SceneHit hit;
    std::optional<std::size_t> object; ///< its current index; nothing after it was removed
    std::string objectName;            ///< at the click
};

/// The hit of a pick's ray on the meshes themselves, in the scene at the click.
struct PickedRay {
    enum class State {
        Preparing,  ///< a model is not prepared for rays yet; the answer follows
        Impossible, ///< a model could not be prepared (`failure`), or there is no ray
        Answered
    };
    State state = State::Preparing;
    std::optional<JobFailure> failure;
    std::optional<MetPlace> met;        ///< the hit of the ray itself; nothing: it hits nothing
    ray::RayComparison comparison;      ///< of the hit with the frame
    std::optional<ray::PixelEdge> edge; ///< the occluding edge inside the pixel
    std::string edgeObject;             ///< name of the object on its other side, at the click
    ray::Snap snap = ray::Snap::Surface;
    /// The answers of other programs for a click that hits: the clicked pixel's depth as read,
    /// other pixels' depths from ray hits.
    std::optional<unproject::OtherAnswers> others;
    std::optional<MetPlace> taken; ///< the snapped point in that mode; for a surface the same as `met`
};

} // namespace unprojector::gui
