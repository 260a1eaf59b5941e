#pragma once

#include "core/matrices/pipeline.h"

#include <QString>

namespace unprojector::gui {

class SceneDocument;

/// The clip test in words: "x < −w: left of the view volume, z > w: behind the far plane".
/// @return nothing for a point inside the view volume
QString clipTestText(const geometry::ClipPoint &point);

/// The changes since the click, in words: the view is the same; or it is another one and the point
/// is inside or outside its view volume; or the object was moved, is hidden, or is cut there by a
/// clip plane. For a moved object the text doesn't locate the point in the volume: no surface is
/// there any more.
/// @return nothing without a pick
QString sinceClickText(const SceneDocument &document);

} // namespace unprojector::gui
