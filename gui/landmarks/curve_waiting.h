#pragma once

class QWidget;

namespace unprojector::gui {

class SceneDocument;

/// Waits until no curve of a document is being computed. After a moment it shows progress over the
/// window, with a button to cancel.
/// @return false if the user cancelled
bool waitForCurves(QWidget &window, SceneDocument &document);

} // namespace unprojector::gui
