#pragma once

#include "core/matrices/pipeline.h"

#include <QString>

namespace unprojector::gui {

class SceneDocument;

/// The clip test in words: "x < −w: left of the view volume, z > w: behind the far plane".
/// @return nothing for a point inside the view volume
QString clipTestText(const geometry::ClipPoint &point);

/// How the pick stands to the document as it is now: that the view is another one and whether the
/// point is in its view volume, or that the object was moved, is hidden, or is cut away there by a clip plane. Of a
/// moved object's point it does not say where it is in the volume: there is nothing at that point any more.
/// @return nothing without a pick, or where the view is as it was
QString sinceClickText(const SceneDocument &document);

} // namespace unprojector::gui
