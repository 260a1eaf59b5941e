#pragma once

#include "core/landmarks/landmark.h"

#include <QWidget>

#include <filesystem>

class QLabel;
class QMenu;
class QSplitter;
class QToolButton;

namespace unprojector::gui {

class CurvesView;
class NextLandmarkBar;
class LandmarkTemplates;
class LandmarksModel;
class LandmarksTable;
class SceneDocument;

/// The placed points: a table of them, which one is placed next, and what can be done to them.
class LandmarksPanel : public QWidget {
    Q_OBJECT
public:
    explicit LandmarksPanel(SceneDocument &document, LandmarkTemplates &templates, QWidget *parent = nullptr);

    /// The names of a file are to be placed one after the other; those that are there already stay as they are.
    void takeTemplate(const std::filesystem::path &file);

    /// Whether a click in the view places a point, as a word for those who have none yet.
    void setPlacing(bool isPlacing);

    /// Leads a curve through the selected points, or says why not.
    void join(landmarks::CurveKind kind);

    /// What is being typed counts, as if Enter were pressed.
    void applyTyped();

    QSize minimumSizeHint() const override;

signals:
    /// There are names to place now: the next click in the view is to place the first.
    void placingRequested();
    /// What went wrong, or was lost, in words.
    void warned(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Gives the points half of the height, or two thirds of it, as long as the user has not parted it otherwise.
    void partHeight();
    void fillTemplateMenu();
    void beginPlacing();
    void loadTemplate();
    void saveTemplate();
    void removeSelected();
    void moveSelected(int by);
    void copySelected();
    void chooseColor();
    void addColorMenu(QMenu &menu);
    void showMenu(const QPoint &place);
    void updateButtons();

    SceneDocument &m_document;
    LandmarkTemplates &m_templates;
    LandmarksModel *m_model;
    LandmarksTable *m_table;
    NextLandmarkBar *m_next;
    QLabel *m_empty;
    QLabel *m_reason;
    QToolButton *m_template;
    QToolButton *m_up;
    QToolButton *m_down;
    QToolButton *m_remove;
    CurvesView *m_curves;
    QSplitter *m_parts;
    bool m_isPartedByUser = false;
};

} // namespace unprojector::gui
