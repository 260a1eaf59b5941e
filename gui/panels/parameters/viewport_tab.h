#pragma once

#include "gui/panels/parameters/parameter_tab.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace unprojector::gui {

/// Which part of the window the picture takes (glViewport), and the depths it is given (glDepthRange).
class ViewportTab : public ParameterTab {
    Q_OBJECT
public:
    explicit ViewportTab(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    Check edit(const Scene &next, const Deed &deed) override;

private:
    void addRectangleRow(const QString &name, const QString &objectName, const QString &help, double Viewport::*number);
    void choose(ViewportRule::Kind kind);

    QComboBox *m_kind;
    QFormLayout *m_form;
    std::vector<NumberField *> m_rectangle;
    NumberField *m_aspect;
    QLabel *m_window;
    QLabel *m_call;
    QLabel *m_depthCall;
    Surface m_shownSurface;
    Viewport m_shownViewport;
    std::optional<ViewportRule::Kind> m_shownKind;
};

} // namespace unprojector::gui
