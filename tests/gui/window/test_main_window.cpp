// The window as a whole: its panels' arrangement at several sizes, and its kept state.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/window_user.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/lessons/first_steps.h"
#include "gui/lessons/formulas_window.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/shell/appearance.h"
#include "gui/shell/key_sheet.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/help_link.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QSlider>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

const char *const kPanels[] = {"parameters", "comparison", "pipeline", "inspector", "lifecycle"};

} // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theWindowStartsWithinTheScreen()
    {
        MainWindow::Options options;
        options.remembers = false;
        const MainWindow window(options);
        const QSize screen = window.screen()->availableSize();
        QVERIFY(window.width() < screen.width() && window.height() < screen.height());
    }

    void theViewHasMostOfTheWindowAtFirst()
    {
        const auto window = windowOfSize({1280, 800});
        const double share = static_cast<double>(window->view().width()) * window->view().height()
                             / (static_cast<double>(window->width()) * window->height());
        QVERIFY2(share >= 0.5, qPrintable(QString::number(share)));
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
        for (const char *name : {"parameters", "pipeline", "inspector", "lifecycle"})
            QVERIFY2(dockOf(*window, name)->isHidden(), name);
    }

    void eachPlaceShowsItsPanels()
    {
        const auto window = windowOfSize({1280, 800});
        const SceneView &view = window->view();
        actionOf(*window, QStringLiteral("Pipeline"))->trigger();
        QVERIFY(window->workspaces().current() == Workspace::Pipeline);
        settle();
        const auto leftOf = [&](const QWidget &widget) { return widget.mapTo(window.get(), QPoint(0, 0)).x(); };
        for (const char *name : {"parameters", "pipeline", "inspector"})
            QVERIFY2(isSeen(*window, name), name);
        QVERIFY(dockOf(*window, "comparison")->isHidden());
        QVERIFY(leftOf(*dockOf(*window, "parameters")) < leftOf(view));
        QVERIFY(leftOf(*dockOf(*window, "pipeline")) > leftOf(view));
        QVERIFY(dockOf(*window, "inspector")->mapTo(window.get(), QPoint(0, 0)).y() > view.height());
        QVERIFY(window->tabifiedDockWidgets(dockOf(*window, "inspector")).contains(dockOf(*window, "lifecycle")));
        actionOf(*window, QStringLiteral("Click"))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
        QVERIFY(dockOf(*window, "parameters")->isHidden());
    }

    void aPanelAskedForComesToTheFront()
    {
        const auto window = windowOfSize({1280, 800});
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
        for (const char *name : {"pipeline", "objects", "comparison"}) {
            QDockWidget *dock = dockOf(*window, name);
            if (!dock->isHidden())
                dock->toggleViewAction()->trigger();
            QVERIFY(dock->isHidden());
            dock->toggleViewAction()->trigger();
            QTRY_VERIFY2_WITH_TIMEOUT(isSeen(*window, name), name, kPatienceMilliseconds);
        }
    }

    void aPlaceCanBeMadeNarrow()
    {
        for (const char *place : {"click", "pipeline"}) {
            const auto window = windowOfSize({1280, 800});
            enter(*window, place);
            settle();
            QVERIFY2(window->minimumSizeHint().width() <= 800 && window->minimumSizeHint().height() <= 600,
                     qPrintable(QStringLiteral("%1: %2 x %3")
                                    .arg(QLatin1String(place))
                                    .arg(window->minimumSizeHint().width())
                                    .arg(window->minimumSizeHint().height())));
        }
    }

    void theViewKeepsItsHalfOfASmallWindow()
    {
        const auto window = windowOfSize({800, 600});
        for (const char *place : {"click", "pipeline"}) {
            enter(*window, place);
            settle();
            QCOMPARE(window->size(), QSize(800, 600));
            QVERIFY2(2 * window->view().width() >= window->width(), place);
            QVERIFY2(2 * window->view().height() >= window->height(), place);
            QVERIFY(!isSeen(*window, "inspector"));
        }
        for (const char *panel : {"parameters", "inspector", "lifecycle"})
            QVERIFY2(window->tabifiedDockWidgets(dockOf(*window, "pipeline")).contains(dockOf(*window, panel)), panel);
    }

    void theViewCanHaveTheWholeWindow()
    {
        const auto window = windowOfSize({1280, 800});
        const int before = window->view().width();
        window->workspaces().hidePanels(true);
        QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), window->width(), kPatienceMilliseconds);
        window->workspaces().hidePanels(false);
        QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), before, kPatienceMilliseconds);
    }

    void eachPlaceKeepsItsLayoutAndCanBeReset()
    {
        {
            const auto window = windowOfSize({1280, 800}, true);
            window->addDockWidget(Qt::LeftDockWidgetArea, dockOf(*window, "comparison"));
            window->workspaces().enter(Workspace::Pipeline);
            settle(20);
            dockOf(*window, "inspector")->hide();
            dockOf(*window, "lifecycle")->hide();
            window->workspaces().enter(Workspace::Click);
            QCOMPARE(window->dockWidgetArea(dockOf(*window, "comparison")), Qt::LeftDockWidgetArea);
            window->workspaces().enter(Workspace::Pipeline);
            QVERIFY(dockOf(*window, "inspector")->isHidden());
            window->close();
        }
        const auto window = windowOfSize({1280, 800}, true);
        QVERIFY(window->workspaces().current() == Workspace::Pipeline);
        QVERIFY(dockOf(*window, "inspector")->isHidden());
        actionOf(*window, QStringLiteral("Reset Layout"))->trigger();
        QVERIFY(!dockOf(*window, "inspector")->isHidden());
        window->workspaces().enter(Workspace::Click);
        QCOMPARE(window->dockWidgetArea(dockOf(*window, "comparison")), Qt::LeftDockWidgetArea);
        actionOf(*window, QStringLiteral("Reset Layout"))->trigger();
        QCOMPARE(window->dockWidgetArea(dockOf(*window, "comparison")), Qt::RightDockWidgetArea);
        for (const char *name : kPanels)
            QVERIFY2(!dockOf(*window, name)->isFloating(), name);
    }

    void narrowingAndWideningBringsTheOldLayoutBack_data()
    {
        addColumn<QString>("place");
        newRow("click") << QStringLiteral("click");
        newRow("pipeline") << QStringLiteral("pipeline");
    }

    void narrowingAndWideningBringsTheOldLayoutBack()
    {
        QFETCH(QString, place);
        const auto window = windowOfSize({1280, 800});
        enter(*window, place.toUtf8().constData());
        settle();
        const QSize before = window->view().size();
        for (const QSize &size : {QSize(1000, 640), QSize(800, 600), QSize(1280, 800)}) {
            window->resize(size);
            settle();
        }
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), before, kPatienceMilliseconds);
    }

    void nothingThatIsSaidChangesTheViewsSize_data() { narrowingAndWideningBringsTheOldLayoutBack_data(); }

    /// Points near and far, the background, a tiny and a huge world, a camera that is close and one
    /// that is far.
    void nothingThatIsSaidChangesTheViewsSize()
    {
        QFETCH(QString, place);
        const auto window = windowOfSize({1280, 800});
        enter(*window, place.toUtf8().constData());
        settle();
        SceneView &view = window->view();
        const QSize before = view.size();
        const QPointF middle(before.width() / 2.0, before.height() / 2.0);
        for (const double scale : {1.0, 1e-5, 1e6}) {
            std::vector<SceneObject> objects = planeScene({0.0, 0.0, 0.0}, {scale, 0.0, 0.0}, {0.0, scale, 0.0});
            openObjects(window->document(), std::move(objects));
            fitAll(window->document());
            for (const QPointF &place2 : {middle, middle + QPointF(3.0, 1.0), QPointF(2.0, 2.0)}) {
                click(view, place2);
                settle(10);
                QCOMPARE(view.size(), before);
            }
            for (const int notches : {3, -6}) {
                turnWheel(view, middle, notches);
                QTest::mouseMove(&view, middle.toPoint() + QPoint(notches, 1));
                settle(10);
                QCOMPARE(view.size(), before);
            }
        }
    }

    void theViewGetsTheSizeThatIsAskedFor()
    {
        const auto window = windowOfSize({1280, 800});
        for (const QSize &size : {QSize(600, 500), QSize(640, 480), QSize(333, 257)}) {
            window->setViewSize(size);
            QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), size, kPatienceMilliseconds);
        }
    }

    void aPanelsNameStandsOnce()
    {
        const auto window = windowOfSize({1280, 800});
        for (const char *place : {"click", "pipeline"}) {
            enter(*window, place);
            settle();
            for (const char *name : kPanels) {
                QDockWidget *dock = dockOf(*window, name);
                if (dock->isHidden())
                    continue;
                bool isTab = false;
                for (const QDockWidget *other : window->tabifiedDockWidgets(dock))
                    isTab |= !other->isHidden();
                QCOMPARE(dock->titleBarWidget() != nullptr, isTab);
            }
        }
    }

    void theViewFromOutsideLeavesTheViewAlone()
    {
        const auto window = windowOfSize({1280, 800});
        const QSize alone = window->view().size();
        QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
        action->trigger();
        auto *outside = window->findChild<ObserverView *>();
        QVERIFY(outside
                && QTest::qWaitFor([&] { return outside->isVisible() && outside->isReady(); }, kPatienceMilliseconds));
        QCOMPARE(window->view().size(), alone);
        const auto standsInTheView = [&] {
            const QPoint corner = window->view().mapFromGlobal(outside->mapToGlobal(QPoint(0, 0)));
            return window->view().rect().contains(QRect(corner, outside->size()));
        };
        QVERIFY(standsInTheView());
        window->resize(900, 640);
        settle();
        QVERIFY(standsInTheView());
        action->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!outside->isVisible(), kPatienceMilliseconds);
    }

    void theViewFromOutsideCanBeAPanel()
    {
        const auto window = windowOfSize({1280, 800});
        actionOf(*window, QStringLiteral("View from Outside"))->trigger();
        auto *panel = window->findChild<ObserverPanel *>();
        emit panel->dockRequested(true);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
        QVERIFY(dockOf(*window, "observer")->isAncestorOf(panel) && panel->isVisible());
        emit panel->dockRequested(false);
        QVERIFY(dockOf(*window, "observer")->isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(panel->isVisible(), kPatienceMilliseconds);
        QVERIFY(!dockOf(*window, "observer")->isAncestorOf(panel));
    }

    void theMorphHasRoomInACorner()
    {
        const auto window = windowOfSize({1280, 800});
        window->workspaces().enter(Workspace::Pipeline);
        actionOf(*window, QStringLiteral("View from Outside"))->setChecked(true);
        const auto *slider = window->findChild<ObserverPanel *>()->findChild<QSlider *>();
        QTRY_VERIFY_WITH_TIMEOUT(slider->isVisible() && slider->width() >= 3 * slider->height(), kPatienceMilliseconds);
    }

    void noPanelTakesAMenusLetter()
    {
        const auto window = windowOfSize({1280, 800});
        const auto letterOf = [](const QString &text) { return QKeySequence::mnemonic(text); };
        QList<QKeySequence> menus;
        for (const QAction *action : window->menuBar()->actions())
            menus << letterOf(action->text());
        QVERIFY(menus.size() >= 4);
        for (const QAbstractButton *button : window->findChildren<QAbstractButton *>())
            QVERIFY2(!menus.contains(letterOf(button->text())), qPrintable(button->text()));
        for (const QLabel *label : window->findChildren<QLabel *>())
            QVERIFY2(!label->buddy() || !menus.contains(letterOf(label->text())), qPrintable(label->text()));
    }

    void noLetterStandsForTwoSwitchesOfAPanel()
    {
        const auto window = windowOfSize({1280, 800});
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            QMap<QString, QString> texts;
            for (const QAbstractButton *button : dock->findChildren<QAbstractButton *>()) {
                const QString letter = QKeySequence::mnemonic(button->text()).toString();
                if (letter.isEmpty())
                    continue;
                const QString other = texts.value(letter, button->text());
                QVERIFY2(other == button->text(), qPrintable(other + " and " + button->text()));
                texts[letter] = other;
            }
        }
    }

    void aDarkWindowHasADarkView()
    {
        const auto window = windowOfSize({700, 500});
        const auto corner = [&] { return window->view().grabFramebuffer().pixelColor(3, 3).lightness(); };
        QVERIFY(corner() > 160);
        setAppearance(Appearance::Dark);
        settle();
        QVERIFY(corner() < 96);
        // The part of the view outside the viewport is dark as well, and differs from the area behind
        // the objects.
        ViewportRule lowerRight;
        lowerRight.kind = ViewportRule::Kind::Quarter;
        const int behindObjects = corner();
        const DepthRange depths = window->document().scene().depthRange;
        QVERIFY(editViewport(window->document(), lowerRight, depths, {QStringLiteral("Viewport")}));
        settle();
        QVERIFY(corner() < behindObjects - 10);
        QVERIFY(editViewport(window->document(), {}, depths, {QStringLiteral("Viewport")}));
        setAppearance(Appearance::Desktop);
        settle();
        QVERIFY(corner() > 160);
    }

    /// The manual is first, because it answers most questions.
    void helpBeginsWithTheManual()
    {
        const auto window = windowOfSize({700, 500});
        QStringList texts;
        for (const QAction *action : window->menuBar()->actions().last()->menu()->actions())
            texts << action->text().remove(u'&');
        QCOMPARE(texts, QStringList({"Manual", "Manual of This Panel", "Mouse and Keys", "Formulas", "First Steps", "",
                                     "About Unprojector"}));
    }

    void theManualNamesEveryKey()
    {
        QFile file(QStringLiteral(":/manual/keyboard.md"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        static const QRegularExpression betweenKeys(QStringLiteral("[|,;\\n]"));
        QStringList said;
        for (const QString &key : QString::fromUtf8(file.readAll()).split(betweenKeys))
            said << key.trimmed();
        const auto window = windowOfSize({700, 500});
        QStringList missing;
        for (const QAction *menu : window->menuBar()->actions()) {
            for (const QAction *action : menu->menu()->actions()) {
                const QList<QKeySequence> keys = action->shortcuts(); // the first differs from desktop to desktop
                if (!keys.isEmpty() && std::none_of(keys.begin(), keys.end(), [&](const QKeySequence &key) {
                        return said.contains(key.toString());
                    }))
                    missing << keys.first().toString();
            }
        }
        QCOMPARE(missing.join(u' '), QString());
    }

    void theKeySheetNamesEveryKey()
    {
        const auto window = windowOfSize({700, 500});
        actionOf(*window, QStringLiteral("Mouse and Keys"))->trigger();
        auto *sheet = window->findChild<KeySheet *>();
        QVERIFY(sheet && sheet->isVisible() && !sheet->isModal());
        // Each row of the table has keys and their effect.
        const QTextDocument &page = *sheet->findChild<QTextBrowser *>()->document();
        const QTextTable *table = nullptr;
        for (QTextFrame *frame : page.rootFrame()->childFrames())
            table = table ? table : qobject_cast<QTextTable *>(frame);
        QVERIFY(table);
        QStringList said;
        const auto textOf = [&](int row, int column) {
            const QTextTableCell cell = table->cellAt(row, column);
            QTextCursor cursor = cell.firstCursorPosition();
            cursor.setPosition(cell.lastCursorPosition().position(), QTextCursor::KeepAnchor);
            return cursor.selectedText().replace(QChar::Nbsp, u' ').trimmed();
        };
        for (int row = 0; row < table->rows(); ++row) {
            if (table->cellAt(row, 0).columnSpan() == 1)
                said << textOf(row, 0) + QStringLiteral(": ") + textOf(row, 1);
        }
        // No menu has these.
        for (const char *other : {
                 "left button: read the world coordinate of the pixel",
                 "middle drag, or Shift + left drag: move the camera sideways",
                 "wheel: zoom towards the pointer",
                 "double-click: bring the point to the middle",
                 "arrows: turn the camera",
                 "Shift + arrows: move the camera sideways",
                 "Ctrl + arrows: move the crosshair by a pixel, with Shift by ten",
                 "Enter: read the world coordinate at the crosshair",
                 "Esc: cancel opening files",
                 "drag of a plane: move the near or the far plane",
                 "left drag, or arrows: turn about the view volume",
                 "F: show everything",
                 "Space, Enter, Del: show or hide the object, rename it, remove it",
                 "Ctrl+C: copy the selected numbers, with all their digits",
                 "Enter, Left, Right: fold the group or open it",
                 "Up, Down: go to the group above, below",
                 "Enter, Tab: apply the number or the expression, such as 1/3 or 2*pi",
                 "Esc: restore the former value",
                 "Up, Down, Page Up, Page Down: change the digit at the caret by one, by ten",
                 "Ctrl+F: find words in the page",
                 "F3, Shift+F3: go to the next match, to the previous one",
                 "Alt+Up: back to the contents",
                 "Alt+Left, Alt+Right: in the manual, go back to the place before, forward again",
                 "Ctrl+Shift+F: search all pages of the manual",
             })
            QVERIFY2(said.contains(QString::fromUtf8(other)), other);
        int keys = 0;
        for (const QAction *action : window->findChildren<QAction *>()) {
            // Actions of the menus; a panel's buttons have their own texts.
            const QObjectList places = action->associatedObjects();
            const bool isInMenu = std::any_of(places.begin(), places.end(), [](QObject *place) {
                const auto *menu = qobject_cast<QMenu *>(place);
                return menu && !menu->title().isEmpty();
            });
            if (action->shortcut().isEmpty() || !isInMenu)
                continue;
            ++keys;
            QStringList all;
            for (const QKeySequence &key : action->shortcuts())
                all << key.toString(QKeySequence::NativeText);
            const QString does = action->statusTip().isEmpty() ? action->iconText() : action->statusTip();
            const QString row = all.join(QStringLiteral(", ")) + QStringLiteral(": ") + does;
            QVERIFY2(said.count(row) == 1, qPrintable(row));
        }
        QVERIFY(keys > 20);
    }

    void aPanelLeadsToItsFormulas()
    {
        const auto window = windowOfSize({1200, 800});
        const QWidget *parameters = dockOf(*window, "parameters")->widget();
        const QList<HelpLink *> links = parameters->findChildren<HelpLink *>();
        const auto link = std::find_if(links.begin(), links.end(),
                                       [](const HelpLink *one) { return one->anchor() == QLatin1String("viewport"); });
        QVERIFY(link != links.end());
        (*link)->click();
        auto *formulas = window->findChild<FormulasWindow *>();
        QVERIFY(formulas && formulas->isVisible());
        const int there = formulas->page().verticalScrollBar()->value();
        formulas->showFormula(QStringLiteral("viewport"));
        QVERIFY(there > 0);
        QCOMPARE(formulas->page().verticalScrollBar()->value(), there);
    }

    void newcomersSeeThreeStepsUntilTheyAreDone()
    {
        QSettings().clear(); // they start at the first place
        {
            const auto window = windowOfSize({1000, 700}, true);
            auto *steps = window->findChild<FirstSteps *>();
            QVERIFY(steps && steps->isVisible());
            SceneView &view = window->view();
            const QPointF middle(view.width() / 2.0, view.height() / 2.0);
            view.onLButtonDown(geometry::WidgetPoint(middle.x(), middle.y())); // not by the user
            QVERIFY(!steps->isDone(FirstSteps::Click));
            click(view, middle);
            QVERIFY(steps->isDone(FirstSteps::Click) && !steps->isDone(FirstSteps::Drag) && steps->isVisible());
            window->close();
        }
        {
            const auto window = windowOfSize({1000, 700}, true);
            auto *steps = window->findChild<FirstSteps *>();
            QVERIFY(steps->isVisible() && steps->isDone(FirstSteps::Click) && !steps->isDone(FirstSteps::Drag));
            auto *map = window->findChild<QAction *>(QStringLiteral("error_map"));
            map->trigger(); // it needs the corner
            QVERIFY(!steps->isVisible());
            map->trigger();
            QVERIFY(steps->isVisible());
            QTest::keyClick(&window->view(), Qt::Key_Left);
            QVERIFY(steps->isDone(FirstSteps::Drag) && steps->isVisible());
            QVERIFY(part<LessonPlayer>(*window).start("rows"));
            QVERIFY(part<LessonPlayer>(*window).leave());
            QVERIFY(!steps->isVisible());
            window->close();
        }
        const auto window = windowOfSize({1000, 700}, true);
        QVERIFY(!window->findChild<FirstSteps *>());
        actionOf(*window, QStringLiteral("First Steps"))->trigger();
        QVERIFY(window->findChild<FirstSteps *>()->isVisible());
        QVERIFY(!window->findChild<FirstSteps *>()->isDone(FirstSteps::Click));
    }

    void theToolBarHasWordsWhereThereIsRoom()
    {
        const auto window = windowOfSize({1280, 800});
        auto *bar = window->findChild<QToolBar *>(QStringLiteral("tools"));
        const QList<QAction *> workspaces = window->workspaces().actions();
        const auto styleOf = [&](QAction *action) {
            return qobject_cast<QToolButton *>(bar->widgetForAction(action))->toolButtonStyle();
        };
        for (QAction *action : workspaces) {
            QVERIFY(!action->icon().isNull());
            QCOMPARE(styleOf(action), Qt::ToolButtonTextBesideIcon);
        }
        const QWidget *help = bar->widgetForAction(bar->actions().last());
        QVERIFY(help->geometry().right() > bar->width() - 2 * help->width());
        QVERIFY(resized(*window, {600, 500}));
        for (QAction *action : workspaces)
            QCOMPARE(styleOf(action), Qt::ToolButtonTextOnly);
    }

    void anotherKindOfEdgesKeepsTheScene()
    {
        const auto window = windowOfSize({1280, 800});
        click(window->view(), QPointF(window->view().width() / 2.0, window->view().height() / 2.0));
        const std::size_t objects = window->document().objects().size();
        const glm::dvec3 eye = window->document().scene().camera->eye.coordinates();
        actionOf(*window, QStringLiteral("Smooth Edges"))->trigger();
        QVERIFY(window->view().smoothEdges());
        QCOMPARE(window->document().objects().size(), objects);
        QVERIFY(window->document().scene().camera->eye.coordinates() == eye);
        QVERIFY(window->document().picks().pick());
    }

    void aChangeIsUndoneFromTheMenu()
    {
        const auto window = windowOfSize({1280, 800});
        const glm::dvec3 eye = window->document().scene().camera->eye.coordinates();
        actionOf(*window, QStringLiteral("Front"))->trigger();
        QVERIFY(window->document().scene().camera->eye.coordinates() != eye);
        QAction *undo = actionOf(*window, QStringLiteral("Undo Camera"));
        QVERIFY(undo && undo->isEnabled());
        undo->trigger();
        QVERIFY(window->document().scene().camera->eye.coordinates() == eye);
        // Users of every desktop find its key.
        const QAction *redo = actionOf(*window, QStringLiteral("Redo Camera"));
        QVERIFY(redo && redo->isEnabled());
        QVERIFY(redo->shortcuts().contains(QKeySequence(QKeySequence::Redo)));
        QVERIFY(redo->shortcuts().contains(QKeySequence(Qt::CTRL | Qt::Key_Y)));
    }
};

UNPROJECTOR_TEST(TestMainWindow, display)
#include "test_main_window.moc"
