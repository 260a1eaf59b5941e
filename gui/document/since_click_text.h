#pragma once

#include "core/pipeline/pipeline.h"

#include <QString>

namespace unprojector::gui {

class SceneDocument;

/// The clip test in words: "x < −w: left of the view volume, z > w: behind the far plane".
/// @return empty for a point inside the view volume
QString clipTestText(const geometry::ClipPoint &point);

/// A sentence on what has changed since the pick. It is about the first of these that applies: the
/// object is hidden, the object was moved, a clip plane cuts the point away, the view has changed.
/// Only for a changed view it reports the clip test of the point: the point of a moved object is no
/// longer on a surface.
/// @return empty without a pick, or if nothing has changed
QString sinceClickText(const SceneDocument &document);

} // namespace unprojector::gui
