#pragma once

#include <QWidget>

class QToolButton;

namespace unprojector::gui {

class PipelineModel;
class SceneDocument;
class SteadyLabel;

/// What the points of the pipeline are, and buttons that follow the other one of click and given point, and remove the
/// latter.
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
