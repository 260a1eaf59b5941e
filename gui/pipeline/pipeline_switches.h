#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QWidget>

#include <string>
#include <vector>

class QActionGroup;
class QComboBox;
class QMenu;
class QToolButton;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;

/// The display options of the pipeline: direction, object, and a menu with layout, arrangement,
/// digits and conventions. Each choice changes the model at once. If the view has changed since the
/// click, a further switch selects the values at the click or the current ones. Buttons beside them
/// copy the pipeline and paste a camera. Lessons link to the choices by the names of actions.
class PipelineSwitches : public QWidget {
    Q_OBJECT
public:
    PipelineSwitches(SceneDocument &document, PipelineModel &model, QWidget *parent = nullptr);

    void setDirection(pipeline::PipelineDirection direction);
    void setMatrixView(const MatrixView &view);
    /// Shows the document's objects, and the names of its conventions.
    void refresh();

signals:
    void directionChanged();
    void viewChanged();
    void objectChanged();
    void pasteWanted();

private:
    struct Choice {
        QString action;
        QString text;
        QString toolTip;
    };
    void createFormatMenu();
    /// A titled group of the menu: one choice of several.
    QActionGroup *addGroup(QMenu &menu, const QString &title, const QList<Choice> &choices);
    void createDirectionActions();
    void takeView();
    void showObjects();
    void showWhen();
    void showFormat();
    void takeConventions(geometry::Api api);
    /// Applies the document's conventions, even while hidden: later choices stay.
    void followConventions();
    /// Writes vectors in the API's layout, until the user chooses another one.
    void takeTheirLayout();

    SceneDocument &m_document;
    PipelineModel &m_model;
    SegmentedSwitch *m_directionSwitch;
    SegmentedSwitch *m_when;
    QToolButton *m_format;
    QActionGroup *m_layouts;
    QActionGroup *m_arrangements;
    QActionGroup *m_digits;
    QMenu *m_conventionsMenu;
    QActionGroup *m_conventions; ///< in the order of kApis
    QComboBox *m_object;
    std::vector<std::string> m_objectNames; ///< the items of the combo box
};

} // namespace unprojector::gui
