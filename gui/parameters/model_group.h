#pragma once

#include "gui/document/followed_object.h"
#include "gui/parameters/parameter_group.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

/// The placement of one object: an ordered list of glTranslate, glRotate and glScale, in the order
/// of the calls.
class ModelGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ModelGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    void setDefaults(scene::Scene &scene) const override;

private:
    struct Row {
        QWidget *widget;
        QLabel *call;
        QToolButton *up;
        QToolButton *down;
        QToolButton *remove;
        NumberField *first;
    };

    const std::vector<geometry::TransformStep> &steps() const;
    /// Changes the steps of the shown object.
    bool changeSteps(const QString &text, const std::function<void(std::vector<geometry::TransformStep> &)> &edit);
    void addStep(const geometry::TransformStep &step, const QString &text, bool byKeyboard);
    void moveStep(std::size_t from, std::size_t to, bool byKeyboard);
    void removeStep(std::size_t step, bool byKeyboard);
    void removeObject();
    void showObjects();
    void rebuildRows();
    Row makeRow(std::size_t step);

    QComboBox *m_object;
    QToolButton *m_removeObject;
    QLabel *m_hint;
    QVBoxLayout *m_list;
    std::vector<QPushButton *> m_adds;
    std::vector<Row> m_rows;
    FollowedObject *m_shown;
    QStringList m_names;                   ///< the items of the combo box
    std::vector<std::size_t> m_shownKinds; ///< of the steps that the rows were created for
    std::optional<std::size_t> m_rowsOf;   ///< the object that the rows were created for
};

} // namespace unprojector::gui
