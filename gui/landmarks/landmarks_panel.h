#pragma once

#include "core/landmarks/landmark.h"

#include <QWidget>

#include <filesystem>
#include <vector>

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

/// The landmarks: a table, the one to place next, and actions on them.
class LandmarksPanel : public QWidget {
    Q_OBJECT
public:
    explicit LandmarksPanel(SceneDocument &document, LandmarkTemplates &templates, QWidget *parent = nullptr);

    /// Imports a file's names to be placed one after the other; present landmarks stay unchanged.
    void takeTemplate(const std::filesystem::path &file);

    /// Sets whether a click in the view places a landmark, for the hint in an empty list.
    void setPlacing(bool isPlacing);

    /// Joins the selected landmarks with a curve, or shows why it can't.
    void join(landmarks::CurveKind kind);

    /// Commits pending input, as Enter does.
    void applyTyped();

    /// Opens the menu of the selected landmarks.
    void openMenu(const QPoint &global);

    QSize minimumSizeHint() const override;

signals:
    /// Emitted when there are names to place: the next click should place the first.
    void placingRequested();
    /// Emitted when a template was chosen; its names are in the scene.
    void templateChosen();
    /// Emitted when the panel must be shown: the user is about to type into it.
    void showRequested();
    /// Emitted with an error or import notes.
    void warned(const QString &text);
    /// Emitted with what happened besides.
    void noticed(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Gives the table half of the height, or two thirds, until the user moves the splitter.
    void partHeight();
    void fillTemplateMenu();
    /// Adds a template's names, and reports the names that it replaces.
    void fillFrom(const std::vector<landmarks::Landmark> &landmarks, const QString &name);
    void beginPlacing();
    void loadTemplate();
    void saveTemplate();
    void removeSelected();
    void moveSelected(int by);
    void copySelected();
    void chooseColor();
    void addColorMenu(QMenu &menu);
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
