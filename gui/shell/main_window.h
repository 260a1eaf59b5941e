#pragma once

#include "gui/document/session.h"
#include "gui/pipeline/matrix_view.h"

#include "core/unproject/pick.h"

#include <QElapsedTimer>
#include <QKeySequence>
#include <QMainWindow>
#include <QSize>
#include <QSizeF>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class QDockWidget;
class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace unprojector::gui {
using namespace unproject;

class ComparisonPanel;
class DoctorPanel;
class FirstSteps;
class FormulasWindow;
class KeySheet;
class LandmarkTool;
class LifecycleLog;
class LessonPanel;
class LessonPlayer;
class LoadingBar;
class MapOverlay;
class MessageBar;
class ObserverInset;
class ObserverPanel;
class ParametersPanel;
class PointFiles;
class PointTemplates;
class RecoveryBar;
class ScanSeries;
class SceneCodeWindow;
class SceneDocument;
class SceneView;
class PointsPanel;
class SeriesPanel;
class Translation;
class ViewportInspector;
class WindowQuestions;
class WorkPlaces;

/// That the program would speak Chinese, had it a font for it, and where to get one.
QString missingFontText();

/// The window: a session's document in a view, with panels in work places, menus, tool bar and status bar around it.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    struct Options {
        std::optional<bool> smoothEdges = {}; ///< nothing: as the user chose in the menu
        bool remembers = true;                ///< layout, choices and recent files are read and kept
        /// Where unsaved changes are kept in case of a crash; empty: with the user's data if it `remembers`, else nowhere.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
        /// What the menu of languages goes by, which is not there without it. Outlives the window.
        const Translation *translation = nullptr;
    };
    explicit MainWindow(const Options &options, QWidget *parent = nullptr);
    ~MainWindow() override;

    Session &session() { return *m_session; }
    SceneDocument &document() { return *m_document; }
    SceneView &view() { return *m_view; }
    LandmarkTool &landmarkTool() { return *m_landmarkTool; }
    PointFiles &pointFiles() { return *m_pointFiles; }
    LessonPlayer &lessons() { return *m_lessons; }
    ScanSeries &series() { return *m_series; }
    WorkPlaces &places() { return *m_places; }
    ComparisonPanel &comparison() { return *m_comparison; }
    LifecycleLog &lifecycle() { return *m_lifecycle; }
    MapOverlay &map() { return *m_map; }

    /// Gives the view the whole window, or the panels back.
    void hidePanels(bool isHidden);
    /// Makes the window as large or small as gives the view this size, logical pixels.
    /// @pre the window is shown
    void setViewSize(const QSize &size);
    /// Whether nothing is still finding its place: the view of a lesson has the size that it can have.
    bool isSettled() const { return !m_viewTimer.isActive(); }
    /// Opens a lesson by its name, and its step behind a colon, from 1 on: "weng:3".
    /// @pre the window is shown
    /// @return what there is instead, where there is none of it; else empty
    QString startLesson(const QString &nameAndStep);
    /// What a right click on the tool bar or on a panel's title offers.
    QMenu *createPopupMenu() override;
    /// The message that is on show, or nothing.
    QString message() const;

signals:
    /// What could not be opened, saved or drawn, in words.
    void openFailed(const QString &reason);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    /// How long the status bar tells what needs no answer.
    static constexpr int kNoticeMilliseconds = 12000;
    /// After which panels and window manager have done what a change of the window's size makes them do.
    static constexpr int kSettlingMilliseconds = 40;

    void createOverlays();
    void createView();
    void setSmoothEdges(bool smooth);
    void createPanels();
    void createStatusBar();
    void connectPanels();
    void connectSession();
    void restoreLayout();
    void keepLayout() const;
    void leaveLessonOrStay();
    /// Another step, another lesson or none.
    void showLesson();
    /// What lessons opened, closed, switched and sized is as it was before them.
    void putBackAfterLesson();
    void showPanelOfLesson(const char *panel);
    /// The larger part of the side that its text shares with other panels, from where the user may draw it to another
    /// size.
    /// @param isAgain  also where it was given before: another panel has come
    void giveLessonRoom(bool isAgain);
    /// Those that the step brings, less those that would show the answer that is still to be found.
    void showPanelsOfStep();
    /// Those of the step's question, until it is answered.
    std::vector<std::string> panelsWithAnswer() const;
    /// Hides these at the current place, and brings those back that were hidden there and tell nothing any more.
    void hideAnswers();
    /// Gives the view the size that a step's numbers are of, or that a link says: the panels around it make room. Where they
    /// cannot, only for a link the window grows, and it is said where that does not suffice.
    /// @param size  device pixels; not valid: as large as the window allows
    void wantViewOfLesson(const QSize &size, bool isAskedFor);
    /// The next trial to do so.
    void fitViewOfLesson();
    /// That a view which a link has asked for has another size.
    /// @param isFitted  as near to it as whole logical pixels are
    void tellOfView(bool isFitted);
    /// What the step letters, in both views.
    void showHighlights();
    /// Brings the view from outside, beside the view, of which a lesson may speak at any place.
    void showObserverOfLesson();
    /// As it was before.
    void putObserverBack();
    void followLessonLink(const QString &scheme, const QString &target);
    /// Does what an action does, of a menu or of a panel, which is shown then.
    /// @param isOff  one that can be on is switched off, else on
    void triggerForLesson(const QString &name, bool isOff);
    /// The larger part of the side that it shares with the view from outside: a link has led to it.
    void giveLinkedRoom(QDockWidget &dock);
    /// What clicks take, whether they place points, and how the pipeline is shown: before a link changes it.
    void rememberSwitches();
    /// As it was then.
    void putSwitchesBack();
    /// A lesson's text and the view from outside, in a dock, go along from place to place.
    void showAccompanying();
    void showObserver(bool isShown);
    /// Shown, in a dock or over the view, as it stood last.
    void createObserver();
    /// Into a dock, or over the view.
    void dockObserver(bool isDocked);

    void createActions();
    void fitToolBar();
    void createFileMenu(QToolBar &bar);
    void createLessonsMenu(QMenu &menu);
    void importPoints();
    void exportPoints();
    /// Whether an export may go to a file; where not, the message bar has the reason.
    bool mayExportTo(const std::filesystem::path &file);
    void createPointActions(QMenu &menu);
    void createEditMenu(QToolBar &bar);
    /// What clicks take on the meshes.
    void createSnapActions(QMenu &menu, QToolBar &bar);
    /// What is done with placed points in the view.
    void createPlacingActions(QMenu &menu, QToolBar &bar);
    void createViewMenu(QToolBar &bar);
    void createPlaceActions(QMenu &menu);
    void createAppearanceMenu(QMenu &menu);
    void createLanguageMenu(QMenu &menu);
    /// That the language of the desktop cannot be shown, once.
    void tellOfFont();
    void createHelpMenu();
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip,
                       std::function<void()> slot);
    void updateRecentMenu();
    std::vector<std::filesystem::path> askForModels(const QString &title, const QString &filter);

    void showName();
    void showFailure(const QString &reason);
    void showHover(const PixelClick &click);
    void showCamera();
    void showPreparing(double share);
    void exportMap();
    void showFormulas(const QString &anchor);
    void showCode();
    void showKeys();
    void showFirstSteps(bool isShown);
    /// They tell of the place Click, and are seen there.
    void placeFirstSteps();
    void showAbout();

    Options m_options;
    bool m_smoothEdges = true;
    SceneDocument *m_document;
    std::unique_ptr<WindowQuestions> m_questions;
    std::unique_ptr<PointTemplates> m_templates;
    PointFiles *m_pointFiles;
    Session *m_session;
    ScanSeries *m_series;
    LifecycleLog *m_lifecycle;
    SceneView *m_view = nullptr;
    LandmarkTool *m_landmarkTool = nullptr;
    ObserverPanel *m_observer = nullptr; ///< made when it is first asked for
    QWidget *m_observerHome = nullptr;   ///< where it stands in its dock
    ObserverInset *m_inset = nullptr;    ///< where it stands over the view, if it does
    QSizeF m_insetShare;                 ///< what it took of the view when it last stood there
    QAction *m_observerAction = nullptr;
    QWidget *m_viewFrame = nullptr; ///< the view and what stands over it
    QGridLayout *m_center = nullptr;
    QVBoxLayout *m_overlays = nullptr; ///< what stands over the top of the view, one below the other
    RecoveryBar *m_recovery = nullptr;
    MessageBar *m_message = nullptr;
    LoadingBar *m_loading = nullptr;
    MapOverlay *m_map = nullptr;
    WorkPlaces *m_places = nullptr;
    ComparisonPanel *m_comparison = nullptr;
    ParametersPanel *m_parameters = nullptr;
    ViewportInspector *m_inspector = nullptr;
    PointsPanel *m_pointsPanel = nullptr;
    SeriesPanel *m_seriesPanel = nullptr;
    DoctorPanel *m_doctor = nullptr;
    LessonPlayer *m_lessons;
    LessonPanel *m_lessonPanel = nullptr;
    std::string m_lessonPlace;                 ///< where the lesson wants to be
    std::set<const char *> m_placesWithLesson; ///< where it was given room
    std::string m_lessonShown;                 ///< its name; empty: none
    struct PlaceBefore {
        const char *place;
        bool arePanelsHidden;
        std::vector<const char *> fronts; ///< panels that were seen there
    };
    std::optional<PlaceBefore> m_placeBeforeLesson = {}; ///< none: no lesson
    /// Places, and the panels that a lesson has brought there.
    std::vector<std::pair<const char *, const char *>> m_panelsOfLesson;
    /// The same of those that it has hidden until the answer is given.
    std::vector<std::pair<const char *, std::string>> m_panelsWithAnswer;
    QSize m_viewOfLesson;          ///< the step's or a link's, device pixels; not valid: as large as the window allows
    bool m_isViewAskedFor = false; ///< by a link
    QTimer m_viewTimer;            ///< until it is looked at again
    int m_viewTrials = 0;
    /// How the view from outside was before a lesson brought it.
    struct ObserverBefore {
        bool isShown;
        bool isDocked;
        double morph;
    };
    std::optional<ObserverBefore> m_observerBeforeLesson = {};
    struct SwitchesBefore {
        QString taken; ///< the name of the action that says what clicks take
        bool arePlaced;
        bool isBackward;
        MatrixView matrices;
    };
    std::optional<SwitchesBefore> m_switchesBeforeLesson = {};
    /// Sizes of the window, where a link has made it larger.
    struct Grown {
        QSize before;
        QSize given; ///< what came of it; not valid: not known yet
    };
    std::optional<Grown> m_grown = {};
    FormulasWindow *m_formulas = nullptr; ///< made when it is first asked for
    KeySheet *m_keys = nullptr;           ///< so is this
    SceneCodeWindow *m_code = nullptr;    ///< and this
    FirstSteps *m_firstSteps = nullptr;   ///< and this, too
    bool m_areFirstStepsShown = false;    ///< where they are seen
    QMenu *m_recentMenu = nullptr;
    QAction *m_projectionAction = nullptr;
    QAction *m_placingAction = nullptr;
    QAction *m_mapAction = nullptr;
    QLabel *m_hover = nullptr;
    QLabel *m_preparing = nullptr;  ///< how far the models are prepared for rays
    QElapsedTimer m_sincePreparing; ///< invalid while nothing is prepared
    QLabel *m_camera = nullptr;
};

} // namespace unprojector::gui
