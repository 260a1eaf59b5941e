#pragma once

#include "gui/parameters/parameter_group.h"

class QCheckBox;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

/// The user clip planes A x + B y + C z + D = 0 (glClipPlane), world space, six at most.
class ClipGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ClipGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    void setDefaults(scene::Scene &scene) const override;

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
