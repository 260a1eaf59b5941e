#pragma once

class QWidget;

namespace unprojector::gui {

class SceneDocument;

/// Waits until no curve of a document is being worked out any more. Whatever takes longer than is noticed is shown, over a window,
/// with how many are done and a button that gives up.
/// @return false where somebody gave up
bool waitForCurves(QWidget &window, SceneDocument &document);

} // namespace unprojector::gui
