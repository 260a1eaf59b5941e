#pragma once

#include <QWidget>

class QLabel;
class QToolButton;
class QTreeView;

namespace unprojector::gui {

class ObjectsModel;
class SceneDocument;

/// The objects of the scene: show, hide, rename, fit, remove and reorder them.
class ObjectsPanel : public QWidget {
    Q_OBJECT
public:
    explicit ObjectsPanel(SceneDocument &document, QWidget *parent = nullptr);

    /// Commits pending input, as Enter does.
    void applyTyped();

    QSize minimumSizeHint() const override;

protected:
    /// Handles the keys of the list.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    int current() const;
    void fitCurrent();
    void removeCurrent();
    void renameCurrent();
    void showMenu(const QPoint &place);
    void updateButtons();

    SceneDocument &m_document;
    ObjectsModel *m_model;
    QTreeView *m_list;
    QLabel *m_reason;
    QToolButton *m_fit;
    QToolButton *m_remove;
    int m_rowBeforeReset = -1;
};

} // namespace unprojector::gui
