#pragma once

#include "gui/parameters/parameter_group.h"

class QCheckBox;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

/// One line of the group: a plane of the scene that cuts or is switched off.
struct ClipPlaneLine {
    glm::dvec4 plane{0.0};
    bool isOn = true;
    text::JsonValue extra = {}; ///< as of ClipPlaneOff
};

/// All planes of a scene in the order in which they are shown, and back.
std::vector<ClipPlaneLine> clipPlaneLines(const Scene &scene);
void setClipPlaneLines(Scene &scene, const std::vector<ClipPlaneLine> &lines);

/// "x + 0.5 y − 2 ≥ 0": the side of a plane that is kept, its numbers with at most three digits.
QString keptSideText(const glm::dvec4 &plane);

/// The user clip planes A x + B y + C z + D = 0 (glClipPlane), world space, six at most.
class ClipGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ClipGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    Scene withDefaults(Scene scene) const override;

private:
    struct Row {
        QWidget *widget;
        QCheckBox *isOn;
        QLabel *equation;
        QToolButton *remove;
        NumberField *first;
    };

    void addPlane(bool byKeyboard);
    void removePlane(std::size_t line, bool byKeyboard);
    Row makeRow(std::size_t line);

    QPushButton *m_add;
    QVBoxLayout *m_list;
    std::vector<Row> m_rows;
};

} // namespace unprojector::gui
