// The program's start: the command line, and the resulting window for a user and for a screenshot.

#include "tests/support/test.h"

#include "gui/document/picks.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_panel.h"
#include "gui/shell/screenshot_run.h"
#include "gui/shell/start_window.h"
#include "tests/support/patience.h"

#include "tests/gui/gui_scene.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

using namespace unprojector;
using namespace unprojector::gui;

namespace {

StartOptions optionsOf(const QStringList &words)
{
    const geometry::Result<StartOptions, QString> options = startOptions(QStringList{"unprojector"} + words);
    if (!options)
        qFatal("%s", qPrintable(options.error()));
    return options.value();
}

/// A window's state, as far as the command line sets it.
QStringList stateOf(MainWindow &window)
{
    if (!QTest::qWaitFor([&window] { return !window.session().isLoading(); }, kPatienceMilliseconds))
        qFatal("the files are not opened");
    const LessonPlayer &player = *window.findChild<LessonPlayer *>();
    return {window.session().name(),
            lessons::nameOf(window.workspaces().current()),
            window.workspaces().arePanelsHidden() ? "without panels" : "with panels",
            window.hasSmoothEdges() ? "smooth" : "with steps",
            player.lesson() ? QStringLiteral("step %1").arg(player.index() + 1) : QStringLiteral("no lesson"),
            QStringLiteral("%1x%2").arg(window.view().width()).arg(window.view().height())};
}

} // namespace

class TestStart : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { guitest::redirectSettings(); }

    void theWordsBecomeOptions()
    {
        const StartOptions none = optionsOf({});
        QVERIFY(!none.isScreenshotRun() && !none.windowSize && !none.workspace && !none.lesson && none.hasPanels);
        QVERIFY(none.textToPrint.isEmpty() && none.files.empty());
        const StartOptions all = optionsOf({"--screenshot", "a.png", "--view-size", "640x480", "--no-panels", "--place",
                                            "doctor", "--appearance", "dark", "--language", "zh_CN", "--click", "1,2.5",
                                            "--click", "3,4", "--smooth-edges", "off", "a.obj", "b.obj"});
        QCOMPARE(all.picture, std::optional(QStringLiteral("a.png")));
        QCOMPARE(all.windowSize, std::optional(QSize(1280, 800)));
        QCOMPARE(all.viewSize, std::optional(QSize(640, 480)));
        QVERIFY(!all.hasPanels && all.workspace == lessons::Workspace::Doctor && all.smoothEdges == false);
        QVERIFY(all.appearance == Appearance::Dark && all.language == Language::Chinese);
        QVERIFY(all.clicks.size() == 2 && all.clicks[0].y == 2.5);
        QVERIFY(all.files.size() == 2 && all.files[1] == "b.obj");
    }

    void bothRunsStartTheSameWay_data()
    {
        addColumn<QStringList>("words");
        addColumn<QStringList>("state"); // its beginning
        const auto row = [](const char *name, const QStringList &words, const QStringList &state) {
            newRow(name) << words << state;
        };
        row("a size", {"--size", "1000x700"}, {"Bundled scene", "click", "with panels", "smooth", "no lesson"});
        row("looks", {"--size", "1000x700", "--place", "pipeline", "--no-panels", "--smooth-edges", "off"},
            {"Bundled scene", "pipeline", "without panels", "with steps", "no lesson"});
        row("a step of a lesson", {"--view-size", "500x400", "--lesson", "first:2"},
            {"Window Coordinates", "click", "with panels", "smooth", "step 2", "500x400"});
        row("a file", {"--view-size", "500x400", "start.obj"},
            {"start.obj", "click", "with panels", "smooth", "no lesson", "500x400"});
    }

    void bothRunsStartTheSameWay()
    {
        QFETCH(QStringList, words);
        QFETCH(QStringList, state);
        const QTemporaryDir folder;
        if (words.last() == "start.obj") {
            words.last() = folder.filePath(words.last());
            QFile file(words.last());
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") > 0);
        }
        QSettings().clear();
        QStringList users;
        {
            const StartOptions options = optionsOf(words);
            MainWindow::Options ofWindow;
            ofWindow.smoothEdges = options.smoothEdges;
            ofWindow.recoveryFolder = folder.filePath("recovery");
            MainWindow window(ofWindow);
            QCOMPARE(startWindow(window, options), QString());
            guitest::settle(100);
            users = stateOf(window);
        }
        ScreenshotRun run(optionsOf(words + QStringList{"--screenshot", folder.filePath("never.png")}));
        run.start();
        MainWindow *pictures = nullptr;
        for (QWidget *window : QApplication::topLevelWidgets())
            pictures = pictures ? pictures : qobject_cast<MainWindow *>(window);
        QVERIFY(pictures);
        guitest::settle(100);
        QCOMPARE(stateOf(*pictures), users);
        QCOMPARE(users.mid(0, state.size()), state);
    }

    void theFirstScreenHasAPick()
    {
        QSettings().clear();
        const QTemporaryDir folder;
        MainWindow::Options options;
        options.recoveryFolder = folder.filePath("recovery");
        MainWindow window(options);
        QCOMPARE(startWindow(window, optionsOf({"--size", "1000x700"})), QString());
        const Picks &picks = window.document().picks();
        QTRY_VERIFY_WITH_TIMEOUT(picks.pick() && picks.pick()->hit(), kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(window.findChild<ObserverPanel *>()
                                     && window.findChild<ObserverPanel *>()->isVisible(),
                                 kPatienceMilliseconds);
        QVERIFY(!window.session().hasUnsavedChanges());
        // The first pick follows the view's size, until the user does something.
        window.resize(1100, 760);
        QTRY_VERIFY_WITH_TIMEOUT(picks.pick()->setup.surface.widthPixels == window.view().width()
                                     && !picks.sinceClick().isAnything(),
                                 kPatienceMilliseconds);
        QTest::keyClick(&window.view(), Qt::Key_Left);
        const geometry::Setup before = picks.pick()->setup;
        window.resize(1000, 700);
        guitest::settle(100);
        QVERIFY(picks.pick()->setup == before);
        // A start with a file or a lesson has no pick.
        MainWindow other(options);
        QCOMPARE(startWindow(other, optionsOf({"--lesson", "rows"})), QString());
        guitest::settle(100);
        QVERIFY(other.findChild<LessonPlayer *>()->lesson() && !other.document().picks().pick());
    }
};

UNPROJECTOR_TEST(TestStart, display)
#include "test_start.moc"
