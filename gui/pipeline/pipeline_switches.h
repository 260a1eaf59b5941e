#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QWidget>

#include <string>
#include <vector>

class QComboBox;
class QLabel;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;

/// How the pipeline is shown: conventions, direction, object, layout, arrangement and digits, which go into the model at once;
/// with the buttons that copy it and paste matrices. Lessons link to the choices, by the names of actions.
class PipelineSwitches : public QWidget {
    Q_OBJECT
public:
    PipelineSwitches(SceneDocument &document, PipelineModel &model, QWidget *parent = nullptr);

    void setDirection(matrices::PipelineDirection direction);
    void setMatrixView(const MatrixView &view);
    /// Shows the document's objects, and what its conventions change.
    void refresh();

signals:
    void directionChanged();
    void viewChanged();
    void objectChanged();
    void pasteWanted();

private:
    void createActions();
    void showObjects();
    void takeConventions(geometry::Api api);
    /// Takes over the document's conventions, seen or not: what is chosen after that stays.
    void followConventions();
    /// Vectors as the API writes them, until the user chooses otherwise.
    void takeTheirLayout();

    SceneDocument &m_document;
    PipelineModel &m_model;
    SegmentedSwitch *m_directionSwitch;
    SegmentedSwitch *m_layoutSwitch;
    SegmentedSwitch *m_memorySwitch;
    SegmentedSwitch *m_digitsSwitch;
    QComboBox *m_conventions;
    QLabel *m_apiNote;
    QComboBox *m_object;
    std::vector<std::string> m_objectNames; ///< as the combo box lists them
};

} // namespace unprojector::gui
