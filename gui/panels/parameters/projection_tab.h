#pragma once

#include "gui/panels/parameters/parameter_tab.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace unprojector::gui {

/// The projection: its kind and the arguments of glFrustum, gluPerspective, glOrtho or the sheared box.
class ProjectionTab : public ParameterTab {
    Q_OBJECT
public:
    explicit ProjectionTab(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    Check edit(const Scene &next, const Deed &deed) override;

private:
    enum class Number { Left, Right, Bottom, Top, Near, Far, Fovy, Aspect, Theta, Phi };
    /// Where a projection keeps a number, angles in radians; null where it has none such.
    static double *numberIn(Projection &projection, Number number);
    static bool isAngle(Number number);

    void addRow(Number number, const QString &name, const QString &objectName, const QString &help);
    void choose(ProjectionKind kind);

    QComboBox *m_kind;
    QFormLayout *m_form;
    std::vector<std::pair<Number, NumberField *>> m_rows;
    QCheckBox *m_followsViewport;
    QCheckBox *m_fitsObjects;
    std::optional<ProjectionKind> m_shownKind;
};

} // namespace unprojector::gui
