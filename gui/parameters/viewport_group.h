#pragma once

#include "gui/parameters/parameter_group.h"

class QComboBox;
class QLabel;

namespace unprojector::gui {

/// Which part of the window the picture takes (glViewport), and the depths it is given (glDepthRange).
class ViewportGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ViewportGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    void setDefaults(Scene &scene) const override;

private:
    void addRectangleRow(const QString &name, const QString &objectName, const QString &help, double Viewport::*number);
    static QLabel *selectable(const QString &name);
    void choose(ViewportRule::Kind kind);

    QComboBox *m_kind;
    std::vector<ParameterRow *> m_rectangle;
    ParameterRow *m_aspect;
    QLabel *m_window;
    QLabel *m_call;
    QLabel *m_depthCall;
    Surface m_shownSurface;
    Viewport m_shownViewport;
    std::optional<ViewportRule::Kind> m_shownKind;
};

} // namespace unprojector::gui
