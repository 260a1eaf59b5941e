#pragma once

#include <QTabWidget>

namespace unprojector::gui {

class SceneDocument;

/// All numbers that make the picture, each editable at once and undoably: view, projection, viewport, model, clip
/// planes. Tabs that are not on the screen cost nothing.
class ParametersPanel : public QTabWidget {
    Q_OBJECT
public:
    explicit ParametersPanel(SceneDocument &document, QWidget *parent = nullptr);
};

} // namespace unprojector::gui
