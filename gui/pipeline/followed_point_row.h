#pragma once

#include <QWidget>

class QToolButton;

namespace unprojector::gui {

class PipelineModel;
class SceneDocument;
class SteadyLabel;

/// The status of the pipeline's point. One button switches between the clicked point and the user's
/// point, the other removes the user's point.
class FollowedPointRow : public QWidget {
    Q_OBJECT
public:
    FollowedPointRow(const SceneDocument &document, PipelineModel &model, QWidget *parent = nullptr);

    void refresh();

private:
    void showButtons();
    void showStatus(const QString &text);

    const SceneDocument &m_document;
    PipelineModel &m_model;
    SteadyLabel *m_status;
    QToolButton *m_follow;
    QToolButton *m_remove;
};

} // namespace unprojector::gui
