#pragma once

#include "gui/parameters/parameter_group.h"

class QComboBox;
class QLabel;

namespace unprojector::gui {

/// The part of the window that shows the scene (glViewport), and its depth range (glDepthRange).
class ViewportGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ViewportGroup(SceneDocument &document, QWidget *parent = nullptr);

signals:
    /// Emitted when the user wants to resize the window.
    void sizeRequested();

protected:
    void showScene() override;
    void setDefaults(scene::Scene &scene) const override;

private:
    void addRectangleRow(const QString &name, const QString &objectName, const QString &help,
                         double geometry::Viewport::*number);
    static QLabel *selectable(const QString &name);
    void choose(scene::ViewportRule::Kind kind);

    QComboBox *m_kind;
    std::vector<ParameterRow *> m_rectangle;
    ParameterRow *m_aspect;
    QLabel *m_window;
    QLabel *m_call;
    QLabel *m_depthCall;
    geometry::Surface m_shownSurface;
    bool m_isFixed = false; ///< the displayed window size is fixed
    geometry::Viewport m_shownViewport;
    std::optional<scene::ViewportRule::Kind> m_shownKind;
};

} // namespace unprojector::gui
