#include "gui/shell/window_menus.h"

#include "gui/document/camera_looks.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/shell/about_dialog.h"
#include "gui/shell/appearance.h"
#include "gui/shell/export_picture_dialog.h"
#include "gui/shell/key_sheet.h"
#include "gui/shell/language_menu.h"
#include "gui/shell/plain_tool_tip.h"
#include "gui/shell/scene_code_window.h"
#include "gui/shell/view_size_dialog.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/help_link.h"
#include "gui/window/actions.h"
#include "gui/window/window.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QLayout>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

WindowMenus::WindowMenus(Window &window, const std::vector<Feature *> &features, MessageBar &messages,
                         const Translation *translation)
    : QObject(&window), m_window(window), m_features(features), m_messages(messages), m_translation(translation),
      m_bar(window.addToolBar(tr("Tools")))
{
    m_bar->setObjectName(QStringLiteral("tools"));
    fitToolBar();
    // The current workspace comes first: a narrow window cuts off the others.
    m_bar->addActions(window.workspaces().actions());
    m_bar->addSeparator();
    addFileMenu();
    addEditMenu();
    addViewMenu();
    addHelpMenu();
    addPreferences();
}

void WindowMenus::fitToolBar()
{
    constexpr int kShareOfWidth = 40;
    const QFontMetrics metrics = m_window.fontMetrics();
    const int icon = std::min(metrics.height() * 3 / 2, std::max(m_window.width() / kShareOfWidth, metrics.ascent()));
    m_bar->setIconSize({icon, icon});
    // Text beside the icons of workspaces and menus, as far as there is room.
    const auto setStyle = [this](bool areMenus, Qt::ToolButtonStyle style) {
        const QList<QAction *> workspaces = m_window.workspaces().actions();
        for (QAction *action : m_bar->actions()) {
            auto *button = qobject_cast<QToolButton *>(m_bar->widgetForAction(action));
            if (button && (areMenus ? button->menu() != nullptr : workspaces.contains(action)))
                button->setToolButtonStyle(style);
        }
    };
    const auto fits = [this] {
        m_bar->layout()->invalidate();
        return m_bar->layout()->sizeHint().width() <= m_window.width();
    };
    setStyle(false, Qt::ToolButtonTextBesideIcon);
    setStyle(true, Qt::ToolButtonTextBesideIcon);
    if (!fits())
        setStyle(false, Qt::ToolButtonTextOnly);
    if (!fits())
        setStyle(true, Qt::ToolButtonIconOnly);
}

QMenu *WindowMenus::addMenu(const QString &title)
{
    return m_window.menuBar()->addMenu(title);
}

void WindowMenus::addFeatureActions(MenuKind kind, QMenu &menu)
{
    for (Feature *feature : m_features)
        feature->addActions(kind, menu, *m_bar);
}

void WindowMenus::addFileMenu()
{
    const QString models = modelFileFilter(), all = QStringLiteral(";;") + tr("All files (*)");
    QMenu &menu = *addMenu(tr("&File"));
    Session &session = m_window.session();
    putOnBar(*m_bar,
             *addAction(menu, tr("&Open…"), QKeySequence::Open, tr("Open model files or a scene"),
                        [this, &session, models, all] {
                            std::vector<std::filesystem::path> files =
                                askFileNames(m_window, FileKind::Model, tr("Open Models or a Scene"),
                                             openableFileFilter() + QStringLiteral(";;") + models + QStringLiteral(";;")
                                                 + tr("Scenes (*.json)") + all);
                            if (!files.empty())
                                session.openFiles(std::move(files));
                        }),
             Drawing::Open);
    addAction(menu, tr("A&dd to Scene…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O, tr("Add more models to this scene"),
              [this, &session, models, all] {
                  std::vector<std::filesystem::path> files =
                      askFileNames(m_window, FileKind::Model, tr("Add Models"), models + all);
                  if (!files.empty())
                      session.addFiles(std::move(files));
              });
    m_recent = menu.addMenu(tr("Open &Recent"));
    QAction *save = addAction(menu, tr("&Save Scene"), QKeySequence::Save,
                              tr("Write the scene to its file; in a series, the landmarks beside their scan"),
                              [&session] { session.save(); });
    putOnBar(*m_bar, *save, Drawing::Save);
    const auto nameSave = [&session, save] {
        save->setText(session.savesLandmarks() ? tr("&Save Landmarks of the Scan") : tr("&Save Scene"));
    };
    connect(&session, &Session::changed, save, nameSave);
    connect(&session, &Session::opened, save, nameSave);
    m_bar->addSeparator();
    addAction(menu, tr("Save Scene &As…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S, tr("Write the scene to another file"),
              [&session] { session.saveAs(); });
    addAction(
        menu, tr("Sce&ne as Code…"), {},
        tr("Show the calls of this setup, for GLU and MFC, GLM, Qt, three.js or NumPy, with the inverse from a pixel"),
        [this] { showCode(); });
    addAction(menu, tr("&Export Image…"), Qt::CTRL | Qt::Key_E,
              tr("Write only the view as a PNG image, at any size, with or without markers"),
              [this] { exportPicture(m_window); });
    addFeatureActions(MenuKind::File, menu);
    menu.addSeparator();
    addAction(menu, tr("&Quit"), QKeySequence::Quit, tr("Close the window"), [this] { m_window.close(); });
    connect(&session, &Session::recentFilesChanged, this, &WindowMenus::updateRecentFiles);
    updateRecentFiles();
}

void WindowMenus::updateRecentFiles()
{
    Session &session = m_window.session();
    m_recent->clear();
    const QStringList files = session.recentFiles();
    m_recent->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recent->addAction(recentFileText(file)), &QAction::triggered, this,
                [&session, file] { session.openFiles({std::filesystem::path(file.toStdU16String())}); });
    if (files.isEmpty())
        return;
    m_recent->addSeparator();
    connect(m_recent->addAction(tr("&Clear This List")), &QAction::triggered, &session, &Session::clearRecentFiles);
}

void WindowMenus::addEditMenu()
{
    QMenu &menu = *addMenu(tr("&Edit"));
    m_edit = &menu;
    QUndoStack &stack = m_window.document().undoStack();
    QAction *undo = stack.createUndoAction(&menu, tr("&Undo"));
    undo->setObjectName(QStringLiteral("undo")); // for links in lessons
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = stack.createRedoAction(&menu, tr("&Redo"));
    QList<QKeySequence> redoKeys = QKeySequence::keyBindings(QKeySequence::Redo);
    if (const QKeySequence key(Qt::CTRL | Qt::Key_Y); !redoKeys.contains(key))
        redoKeys << key; // some desktops don't have it
    redo->setShortcuts(redoKeys);
    for (QAction *action : {undo, redo}) {
        keepToolTipPlain(action);
        QObject::disconnect(action, &QAction::triggered, &stack, nullptr);
    }
    // The text is the step's own; afterwards the stack has that of another one. A refused step goes
    // from the stack and has a message of its own.
    connect(undo, &QAction::triggered, this, [this, &stack] {
        const QString text = stack.undoText();
        const int count = stack.count();
        stack.undo();
        if (stack.count() == count)
            m_window.notice(tr("Undone: %1.").arg(text));
    });
    connect(redo, &QAction::triggered, this, [this, &stack] {
        const QString text = stack.redoText();
        const int count = stack.count();
        stack.redo();
        if (stack.count() == count)
            m_window.notice(tr("Redone: %1.").arg(text));
    });
    menu.addActions({undo, redo});
    putOnBar(*m_bar, *undo, Drawing::Undo);
    putOnBar(*m_bar, *redo, Drawing::Redo);
    m_bar->addSeparator();
    addFeatureActions(MenuKind::Edit, menu);
}

void WindowMenus::addPreferences()
{
    m_edit->addSeparator();
    addAction(*m_edit, tr("Prefere&nces…"), QKeySequence::Preferences,
              tr("Colours, language, smooth edges; first steps and layout can be reset"), [this] { showPreferences(); })
        ->setMenuRole(QAction::PreferencesRole);
}

void WindowMenus::addLooks(QMenu &menu)
{
    SceneDocument &document = m_window.document();
    const auto look = [&document](StandardView side) {
        return [&document, side] { setCamera(document, seenFrom(document.setup().camera(), side)); };
    };
    putOnBar(*m_bar,
             *addAction(menu, tr("&Fit"), Qt::Key_F, tr("Move the camera until all objects fill the view"),
                        [&document] { fitAll(document); }),
             Drawing::Fit);
    putOnBar(*m_bar,
             *addAction(menu, tr("&Home"), Qt::Key_Home, tr("Return to the scene's initial camera"),
                        [&document] { goHome(document); }),
             Drawing::Home);
    menu.addSeparator();
    m_bar->addSeparator();
    // These have keys, and no room on the bar of a small window.
    addAction(menu, tr("Fr&ont"), Qt::Key_1, tr("Look from the front, along −z"), look(StandardView::Front));
    addAction(menu, tr("&Right"), Qt::Key_3, tr("Look from the right, along −x"), look(StandardView::Right));
    addAction(menu, tr("&Top"), Qt::Key_7, tr("Look from the top, along −y"), look(StandardView::Top));
    addAction(menu, tr("B&ack"), Qt::CTRL | Qt::Key_1, tr("Look from the back, along z"), look(StandardView::Back));
    addAction(menu, tr("&Left"), Qt::CTRL | Qt::Key_3, tr("Look from the left, along x"), look(StandardView::Left));
    addAction(menu, tr("Botto&m"), Qt::CTRL | Qt::Key_7, tr("Look from below, along y"), look(StandardView::Bottom));
    menu.addSeparator();
    QAction *perspective = addSwitch(menu, tr("&Perspective"), Qt::Key_5,
                                     tr("Switch between perspective (glFrustum) and orthographic (glOrtho)"));
    perspective->setObjectName(QStringLiteral("perspective")); // for links in lessons
    connect(perspective, &QAction::triggered, this, [&document] { switchProjection(document); });
    putOnBar(*m_bar, *perspective, Drawing::Perspective);
    const auto show = [&document, perspective] {
        perspective->setChecked(isPerspective(document.setup().projection()));
    };
    connect(&document, &SceneDocument::changed, perspective, [show](Changes changes) {
        if (changes & Change::Setup)
            show();
    });
    show();
}

void WindowMenus::addViewMenu()
{
    QMenu &menu = *addMenu(tr("&View"));
    addLooks(menu);
    addFeatureActions(MenuKind::View, menu);
    addSizeActions(menu);
    QAction *smooth =
        addSwitch(menu, tr("&Smooth Edges"), {}, tr("Draw smooth edges of surfaces. Clicks read the same depths"));
    smooth->setChecked(m_window.hasSmoothEdges());
    connect(smooth, &QAction::toggled, this, &WindowMenus::smoothEdgesChosen);
    QMenu *colours = menu.addMenu(tr("Co&lours"));
    addAppearanceMenu(*colours);
    QMenu *languages = m_window.remembers() && m_translation ? menu.addMenu(tr("Lan&guage")) : nullptr;
    if (languages)
        fillLanguageMenu(*languages, m_window, *m_translation, m_messages);
    m_choices = {colours, languages, smooth};
    menu.addSeparator();
    addWorkspaceActions(menu);
}

void WindowMenus::addSizeActions(QMenu &menu)
{
    SceneDocument &document = m_window.document();
    QAction *size = addAction(menu, tr("View Si&ze…"), {},
                              tr("Set the view's size in pixels, to match a program or an article"), [this, &document] {
                                  m_window.session().commitTyped();
                                  auto *dialog = new ViewSizeDialog(document, m_window.view(), &m_window);
                                  dialog->setAttribute(Qt::WA_DeleteOnClose);
                                  dialog->open();
                              });
    size->setObjectName(kViewSizeAction);
    QAction *fit = addAction(menu, tr("Fit the Wi&ndow"), {}, tr("Let the view fill the window"),
                             [&document] { fitWindow(document); });
    const auto enable = [&document, fit] { fit->setEnabled(document.scene().windowSize.has_value()); };
    connect(&document, &SceneDocument::changed, fit, [enable](Changes changes) {
        if (changes & Change::Setup)
            enable();
    });
    enable();
}

void WindowMenus::addAppearanceMenu(QMenu &menu)
{
    auto *group = new QActionGroup(&menu);
    const auto add = [&](Appearance appearance, const QString &text, const QString &tip) {
        QAction *action = addAction(menu, text, {}, tip, [this, appearance] {
            setAppearance(appearance);
            if (m_window.remembers())
                QSettings().setValue(QStringLiteral("window/appearance"), appearanceName(appearance));
        });
        action->setCheckable(true);
        action->setActionGroup(group);
        action->setChecked(appearance == currentAppearance());
    };
    add(Appearance::Desktop, tr("&System"), tr("Light or dark as the desktop is"));
    add(Appearance::Light, tr("&Light"), tr("Dark letters on a light ground"));
    add(Appearance::Dark, tr("D&ark"), tr("Light letters on a dark ground"));
}

void WindowMenus::addWorkspaceActions(QMenu &menu)
{
    Workspaces &workspaces = m_window.workspaces();
    menu.addMenu(tr("&Workspace"))->addActions(workspaces.actions()); // two panels have the names of workspaces
    menu.addSeparator();
    for (QDockWidget *dock : workspaces.sharedDocks())
        menu.addAction(dock->toggleViewAction());
    QAction *hides = addSwitch(menu, tr("H&ide All Panels"), Qt::Key_F9, tr("Give the view the whole window"));
    connect(hides, &QAction::toggled, &workspaces, &Workspaces::hidePanels);
    connect(&workspaces, &Workspaces::panelsHidden, hides, &QAction::setChecked);
    addAction(menu, tr("R&eset Layout"), {}, tr("Restore the default layout of this workspace"),
              [&workspaces] { workspaces.reset(); });
}

void WindowMenus::addHelpMenu()
{
    QMenu &menu = *addMenu(tr("&Help"));
    addAction(menu, tr("Ma&nual"), {}, tr("How to do each task in this window, with contents and search"),
              [] { openManual({}); });
    addAction(menu, tr("Manual of This &Panel"), Qt::SHIFT | Qt::Key_F1,
              tr("The page of the manual on the panel that has the focus, or on that of the workspace"),
              [this] { openManual(m_window.workspaces().manualPlace()); });
    addAction(menu, tr("&Mouse and Keys"), Qt::Key_Question, tr("List of mouse actions and keys"),
              [this] { showKeys(); });
    addFeatureActions(MenuKind::Help, menu);
    menu.addSeparator();
    addAction(menu, tr("&About Unprojector"), {}, tr("Version and licence of the program"), [this] { showAbout(); });
    auto *button = new QToolButton;
    button->setText(tr("Help"));
    button->setIcon(drawnIcon(Drawing::Help));
    button->setToolTip(tr("Manual, formulas, keys, version and licence"));
    button->setMenu(&menu);
    button->setPopupMode(QToolButton::InstantPopup);
    m_bar->addWidget(button);
    fitToolBar();
}

void WindowMenus::showCode()
{
    m_window.session().commitTyped();
    if (!m_code) {
        m_code = new SceneCodeWindow(m_window.document(), m_window.session(), &m_window);
        if (m_window.remembers()) {
            const QString key = QStringLiteral("sceneCode/dialect");
            m_code->setDialect(static_cast<scene_code::CodeDialect>(QSettings().value(key, 0).toInt()));
            connect(m_code, &SceneCodeWindow::dialectChosen, this,
                    [key](scene_code::CodeDialect dialect) { QSettings().setValue(key, static_cast<int>(dialect)); });
        }
    }
    m_code->show();
    m_code->raise();
    m_code->activateWindow();
}

void WindowMenus::showPreferences()
{
    auto *dialog = new PreferencesDialog(m_choices, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PreferencesDialog::firstStepsRequested, this, [this] {
        if (m_window.remembers())
            QSettings().remove(QStringLiteral("firstSteps/areDone"));
        m_window.findChild<QAction *>(QStringLiteral("firstSteps"))->trigger();
    });
    connect(dialog, &PreferencesDialog::layoutResetRequested, &m_window.workspaces(), &Workspaces::resetAll);
    dialog->open();
}

void WindowMenus::showKeys()
{
    if (!m_keys)
        m_keys = new KeySheet(*m_window.menuBar(), &m_window);
    m_keys->show();
    m_keys->raise();
}

void WindowMenus::showAbout()
{
    const SceneView &view = m_window.view();
    const QString wayBack =
        view.objectIds() == ObjectIds::Colors
            ? tr("This graphics driver cannot draw integers, so the view identifies clicked objects by colours.")
            : QString();
    AboutDialog(view.openGLName(), wayBack, &m_window).exec();
}

} // namespace unprojector::gui
