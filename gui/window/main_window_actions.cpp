// The window's menus and tool bar.

#include "gui/window/main_window.h"

#include "core/scene/examples.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/panels/parameters_panel.h"
#include "gui/text/error_text.h"
#include "gui/text/example_texts.h"
#include "gui/view/scene_view.h"
#include "gui/window/formulas_window.h"

#include <QFileDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSettings>
#include <QToolBar>

namespace unprojector::gui {

QAction *MainWindow::addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip,
                               std::function<void()> slot)
{
    QAction *action = menu->addAction(text);
    // On a button of the tool bar, "打开(&O)…" is "打开…".
    static const QRegularExpression keyInParentheses(QStringLiteral("\\(&.\\)"));
    action->setIconText(QString(text).remove(keyInParentheses).remove(u'&'));
    action->setShortcut(key);
    action->setToolTip(key.isEmpty() ? tip
                                     : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, std::move(slot));
    return action;
}

void MainWindow::createActions()
{
    QToolBar *bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    createFileMenu(*bar);
    createEditMenu();
    createViewMenu(*bar);
    createHelpMenu();
}

std::vector<std::filesystem::path> MainWindow::askForModels(const QString &title, const QString &filter)
{
    std::vector<std::filesystem::path> files;
    for (const QString &name : QFileDialog::getOpenFileNames(this, title, {}, filter))
        files.emplace_back(name.toStdU16String());
    return files;
}

void MainWindow::createFileMenu(QToolBar &bar)
{
    const QString models = modelFileFilter(), all = QStringLiteral(";;") + tr("All files (*)");
    QMenu *menu = menuBar()->addMenu(tr("&File"));
    bar.addAction(
        addAction(menu, tr("&Open…"), QKeySequence::Open, tr("Open model files or a scene"), [this, models, all] {
            std::vector<std::filesystem::path> files =
                askForModels(tr("Open Models or a Scene"), openableFileFilter() + QStringLiteral(";;") + models
                                                               + QStringLiteral(";;") + tr("Scenes (*.json)") + all);
            if (!files.empty())
                m_session->openFiles(std::move(files));
        }));
    bar.addSeparator();
    addAction(menu, tr("A&dd Models…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O,
              tr("Put more models beside the objects of this scene"), [this, models, all] {
                  std::vector<std::filesystem::path> files = askForModels(tr("Add Models"), models + all);
                  if (!files.empty())
                      m_session->addFiles(std::move(files));
              });
    m_recentMenu = menu->addMenu(tr("Open &Recent"));
    addAction(menu, tr("&Save Scene"), QKeySequence::Save, tr("Write the scene to its file"), [this] {
        m_parameters->applyTyped();
        m_session->save();
    });
    addAction(menu, tr("Save Scene &As…"), QKeySequence::SaveAs, tr("Write the scene to another file"), [this] {
        m_parameters->applyTyped();
        m_session->saveAs();
    });
    menu->addSeparator();
    addAction(menu, tr("&Bundled Scene"), {}, tr("Show the scene that comes with the program"),
              [this] { m_session->openBundledScene(); });
    createExamplesMenu(*menu->addMenu(tr("&Examples")));
    menu->addSeparator();
    addAction(menu, tr("&Quit"), QKeySequence::Quit, tr("Close the window"), [this] { close(); });
    updateRecentMenu();
}

void MainWindow::createExamplesMenu(QMenu &menu)
{
    std::string tutorial;
    for (const Example &example : examples()) {
        const std::optional<ExampleText> text = exampleText(example.id);
        Q_ASSERT(text);
        if (example.tutorial != tutorial) {
            tutorial = example.tutorial;
            menu.addSection(tutorialName(tutorial));
        }
        addAction(&menu, text->name, {}, text->source, [this, id = example.id] { m_session->openExample(id); });
    }
}

void MainWindow::updateRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_session->recentFiles();
    m_recentMenu->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recentMenu->addAction(recentFileText(file)), &QAction::triggered, this,
                [this, file] { m_session->openFiles({std::filesystem::path(file.toStdU16String())}); });
    if (files.isEmpty())
        return;
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("&Clear This List")), &QAction::triggered, m_session,
            &Session::clearRecentFiles);
}

void MainWindow::createEditMenu()
{
    QMenu *menu = menuBar()->addMenu(tr("&Edit"));
    QAction *undo = m_document->undoStack().createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = m_document->undoStack().createRedoAction(this, tr("&Redo"));
    redo->setShortcut(QKeySequence::Redo);
    menu->addActions({undo, redo});
}

void MainWindow::createViewMenu(QToolBar &bar)
{
    const auto look = [this](StandardView side) {
        return [this, side] { m_document->setCamera(seenFrom(m_document->geometry().camera(), side)); };
    };
    QMenu *menu = menuBar()->addMenu(tr("&View"));
    bar.addAction(addAction(menu, tr("&Fit"), Qt::Key_F, tr("Move the camera until all objects fill the view"),
                            [this] { m_document->fit(); }));
    bar.addAction(addAction(menu, tr("&Home"), Qt::Key_Home, tr("Back to the camera that the scene opened with"),
                            [this] { m_document->goHome(); }));
    menu->addSeparator();
    bar.addSeparator();
    bar.addAction(
        addAction(menu, tr("Fr&ont"), Qt::Key_1, tr("Look from the front, along −z"), look(StandardView::Front)));
    bar.addAction(
        addAction(menu, tr("&Right"), Qt::Key_3, tr("Look from the right, along −x"), look(StandardView::Right)));
    bar.addAction(addAction(menu, tr("&Top"), Qt::Key_7, tr("Look from the top, along −y"), look(StandardView::Top)));
    addAction(menu, tr("B&ack"), Qt::CTRL | Qt::Key_1, tr("Look from the back, along z"), look(StandardView::Back));
    addAction(menu, tr("&Left"), Qt::CTRL | Qt::Key_3, tr("Look from the left, along x"), look(StandardView::Left));
    addAction(menu, tr("Botto&m"), Qt::CTRL | Qt::Key_7, tr("Look from below, along y"), look(StandardView::Bottom));
    menu->addSeparator();
    bar.addSeparator();
    m_projectionAction = addAction(menu, tr("&Perspective"), Qt::Key_5,
                                   tr("Switch between perspective (glFrustum) and orthographic (glOrtho)"),
                                   [this] { m_document->switchProjection(); });
    m_projectionAction->setCheckable(true);
    bar.addAction(m_projectionAction);

    QAction *observer = addAction(menu, tr("&View from Outside"), Qt::Key_0,
                                  tr("Show the camera and its view volume from outside, beside the view"), [] {});
    observer->setCheckable(true);
    connect(observer, &QAction::toggled, this, &MainWindow::showObserver);
    bar.addAction(observer);
    QAction *smooth =
        addAction(menu, tr("&Smooth Edges"), {},
                  tr("Draw the edges of surfaces without steps. The depths that clicks read stay the same"), [] {});
    smooth->setCheckable(true);
    smooth->setChecked(m_smoothEdges);
    connect(smooth, &QAction::toggled, this, &MainWindow::setSmoothEdges);
    menu->addSeparator();
    createPanelActions(*menu);
}

void MainWindow::createHelpMenu()
{
    QMenu *menu = menuBar()->addMenu(tr("&Help"));
    addAction(menu, tr("&Formulas"), QKeySequence::HelpContents,
              tr("All formulas with their sources, and the errors in the originals"), [this] { showFormulas({}); });
    addAction(menu, tr("&Mouse and Keys"), {}, tr("How to move the camera and pick points"),
              [this] { showControls(); });
    addAction(menu, tr("&About Unprojector"), {}, tr("What this program is"), [this] { showAbout(); });
}

void MainWindow::showFormulas(const QString &anchor)
{
    if (!m_formulas)
        m_formulas = new FormulasWindow(this);
    m_formulas->show();
    m_formulas->raise();
    m_formulas->activateWindow();
    if (!anchor.isEmpty())
        m_formulas->showFormula(anchor);
}

void MainWindow::showControls()
{
    QMessageBox box(QMessageBox::NoIcon, tr("Mouse and Keys"),
                    tr("<table cellspacing='6'>"
                       "<tr><td>Left button</td><td>read the world coordinate of the pixel</td></tr>"
                       "<tr><td>… and drag</td><td>turn the camera about that point</td></tr>"
                       "<tr><td>Middle button, or Shift + left</td><td>move the camera sideways</td></tr>"
                       "<tr><td>Wheel</td><td>zoom towards the pointer</td></tr>"
                       "<tr><td>Double-click</td><td>bring the point to the middle</td></tr>"
                       "<tr><td>1, 3, 7 (with Ctrl: the opposite)</td><td>look from the front, right, top</td></tr>"
                       "<tr><td>5</td><td>switch perspective and orthographic</td></tr>"
                       "<tr><td>F, Home</td><td>fit all objects; back to the first camera</td></tr>"
                       "</table>"),
                    QMessageBox::Close, this);
    box.exec();
}

void MainWindow::showAbout()
{
    const QString wayBack = m_view->objectIds() == ObjectIds::Colors
                                ? tr("<p>This graphics driver draws no integers, so the view tells by colours which "
                                     "object was clicked.</p>")
                                : QString();
    QMessageBox::about(this, tr("About Unprojector"),
                       tr("<p><b>Unprojector %1</b></p><p>Click a pixel of a 3-D view and get its world coordinate, "
                          "computed twice: by the "
                          "closed-form inverse formulas of Weng, Huang and Cai (2008) and by the inverted matrix, with "
                          "the difference, its "
                          "cause and how certain the coordinate is.</p><p>MIT licence.</p>")
                               .arg(QStringLiteral(UNPROJECTOR_VERSION))
                           + wayBack);
}

} // namespace unprojector::gui
