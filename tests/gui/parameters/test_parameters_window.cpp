// The parameters in the window: their kept state, saving during typing, and the status bar's words.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "gui/lessons/lesson_player.h"
#include "gui/objects/objects_panel.h"
#include "gui/parameters/number_field.h"
#include "gui/parameters/parameter_group.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/window/workspaces.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTreeView>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

class TestParametersWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void whatIsFoldedIsKeptWithTheLayout()
    {
        MainWindow::Options options;
        options.smoothEdges = false;
        {
            MainWindow first(options);
            first.show();
            group(first, "viewGroup")->setOpen(false);
            group(first, "clipGroup")->setOpen(true);
            first.close();
        }
        {
            MainWindow second(options);
            QVERIFY(!group(second, "viewGroup")->isOpen());
            QVERIFY(group(second, "clipGroup")->isOpen());
        }
        options.remembers = false;
        const MainWindow third(options);
        QVERIFY(group(third, "viewGroup")->isOpen());
    }

    void savingSavesWhatIsTyped()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("typed.json"));
        const auto window = shownWindow(false, {1100, 800}, true);
        window->session().openBundledScene();
        QVERIFY(window->session().saveScene(file.toStdString()));
        window->workspaces().enter(Workspace::Pipeline);
        auto *panel = window->findChild<ParametersPanel *>();
        auto *nearField = panel->findChild<NumberField *>(QStringLiteral("nearDistance"));
        window->document().undoStack().setClean();
        nearField->setText(QStringLiteral("0.12345"));
        QVERIFY(nearField->isTyping());
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(QKeySequence::Save))
                action->trigger();
        }
        QVERIFY(!nearField->isTyping());
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll().contains("0.12345"));
    }

    void savingSavesTheNameThatIsTyped()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("named.json"));
        const auto window = shownWindow(false, {1100, 800}, true);
        window->session().openBundledScene();
        QVERIFY(window->session().saveScene(file.toStdString()));
        window->workspaces().show(Panel::Objects);
        auto *list = window->findChild<ObjectsPanel *>()->findChild<QTreeView *>();
        list->setFocus();
        list->edit(list->model()->index(0, 0));
        auto *editor = list->viewport()->findChild<QLineEdit *>();
        QVERIFY(editor);
        editor->setText(QStringLiteral("typed name"));
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(QKeySequence::Save))
                action->trigger();
        }
        QCOMPARE(window->document().objects()[0].name, std::string("typed name"));
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll().contains("typed name"));
        QTRY_VERIFY_WITH_TIMEOUT(!list->viewport()->findChild<QLineEdit *>(), kPatienceMilliseconds);
    }

    void whatIsTypedCountsBeforeAnotherSceneIsOpened_data()
    {
        addColumn<QString>("typed");
        addColumn<bool>("counts");
        newRow("a good number") << QStringLiteral("0.12345") << true;
        newRow("one that is refused") << QStringLiteral("-3") << false;
    }

    /// The number counts in the scene that it was typed for, so the window asks whether to save that;
    /// it never counts in the next one.
    void whatIsTypedCountsBeforeAnotherSceneIsOpened()
    {
        QFETCH(QString, typed);
        QFETCH(bool, counts);
        const auto window = shownWindow(false, {1100, 800}, true);
        window->session().openBundledScene();
        window->workspaces().enter(Workspace::Pipeline);
        auto *nearField =
            window->findChild<ParametersPanel *>()->findChild<NumberField *>(QStringLiteral("nearDistance"));
        nearField->setText(typed);
        const auto nearNow = [&] { return projectionWindow(window->document().scene().projection).nearDistance; };
        bool hasCounted = false;
        connect(&window->document(), &SceneDocument::changed, this, [&] { hasCounted |= nearNow() == 0.12345; });
        QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
        QCOMPARE(hasCounted, counts);
        QVERIFY(!nearField->isTyping() && !nearField->isBad());
        const double opened = nearNow();
        QVERIFY(opened != 0.12345);
        window->findChild<ParametersPanel *>()->applyTyped();
        QCOMPARE(nearNow(), opened);
    }

    void theProjectionIsCalledByItsName_data()
    {
        addColumn<int>("kind");
        addColumn<QString>("text");
        newRow("perspective") << int(ProjectionKind::Perspective) << "Perspective, near 0.5, far 80000";
        newRow("frustum") << int(ProjectionKind::Frustum) << "Perspective, near 0.5, far 80000";
        newRow("box") << int(ProjectionKind::Ortho) << "Orthographic, near 0.5, far 80000";
        newRow("oblique") << int(ProjectionKind::Oblique) << "Oblique, near 0.5, far 80000";
    }

    void theProjectionIsCalledByItsName()
    {
        QFETCH(int, kind);
        QFETCH(QString, text);
        MainWindow::Options options;
        options.remembers = false;
        MainWindow window(options);
        window.session().openBundledScene();
        const Projection start = Perspective{0.7, 1.0, 0.5, 80000.0};
        QVERIFY(editProjection(window.document(),
                               {converted(start, static_cast<ProjectionKind>(kind), 10.0), false, false},
                               {QStringLiteral("test")}));
        QStringList shown;
        for (const QLabel *label : window.statusBar()->findChildren<QLabel *>())
            shown << label->text();
        QVERIFY2(shown.contains(text), qPrintable(shown.join(u'|')));
    }

private:
    static ParameterGroup *group(const MainWindow &window, const char *name)
    {
        return window.findChild<ParameterGroup *>(QString::fromLatin1(name));
    }
};

UNPROJECTOR_TEST(TestParametersWindow, display)
#include "test_parameters_window.moc"
