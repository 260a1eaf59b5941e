// Unsaved changes are kept in case of a crash, for as long as they are unsaved.

#include "tests/support/test.h"

#include "tests/gui/kept_scene.h"
#include "tests/support/patience.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"

#include <QElapsedTimer>

using namespace keeping;
using namespace std::chrono_literals;
using namespace unprojector::geometry;
using namespace unprojector::gui;

// ---- when and where --------------------------------------------------------------------------

// ---- the window ------------------------------------------------------------------------------

class TestAutosave : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { guitest::redirectSettings(); }
    void init() { m_folder = std::make_unique<Folder>(); }

    void manyChangesAreWrittenOnceAfterAPause()
    {
        int asked = 0;
        Autosave autosave(m_folder->recovery(), {50ms, 10s}, [&asked] {
            ++asked;
            return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "scene"};
        });
        for (int i = 0; i < 20; ++i)
            autosave.follow(true);
        QCOMPARE(asked, 0);
        QVERIFY(becomesKept(m_folder->recovery()));
        QTest::qWait(200);
        QCOMPARE(asked, 1);
        autosave.follow(false);
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
    }

    void changesWithoutAPauseAreWrittenAllTheSame()
    {
        Autosave autosave(m_folder->recovery(), {60s, 300ms}, [] {
            return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "scene"};
        });
        for (int i = 0; i < 200 && keptIn(m_folder->recovery()).isEmpty(); ++i) {
            autosave.follow(true);
            QTest::qWait(20);
        }
        QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
    }

    void hurriedChangesAreWrittenAtOnce()
    {
        int asked = 0;
        Autosave autosave(m_folder->recovery(), {60s, 60s}, [&asked] {
            ++asked;
            return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, std::to_string(asked)};
        });
        autosave.hurry(); // there is nothing to write
        QCoreApplication::processEvents();
        QCOMPARE(asked, 0);
        const auto place = [&autosave] {
            autosave.follow(true);
            autosave.hurry({50ms, 60s});
            autosave.follow(true); // does not put it off
        };
        place();
        QCOMPARE(asked, 0);
        QCoreApplication::processEvents();
        QCOMPARE(asked, 1);
        QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
        for (int i = 0; i < 20; ++i)
            place();
        QTRY_COMPARE_WITH_TIMEOUT(asked, 2, kPatienceMilliseconds);
        place();
        autosave.follow(false); // undone
        QTest::qWait(100);
        QCOMPARE(asked, 2);
        QVERIFY(keptIn(m_folder->recovery()).isEmpty());
    }

    void hurriedChangesAreWrittenLaterIfWritingIsSlow()
    {
        int asked = 0;
        Autosave autosave(m_folder->recovery(), {60s, 60s}, [&asked] {
            ++asked;
            QTest::qSleep(50);
            return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "a large scene"};
        });
        for (int i = 0; i < 2; ++i) {
            autosave.follow(true);
            autosave.hurry({0ms, 20ms});
            QTest::qWait(20);
        }
        QCOMPARE(asked, 1);
    }

    /// 500 landmarks: the last one is in the file after one turn of the event loop.
    void aPlacedLandmarkIsKeptAtOnce()
    {
        MainWindow::Options options;
        options.smoothEdges = options.remembers = false;
        options.recoveryFolder = m_folder->recovery();
        options.autosave = {60s, 60s};
        MainWindow window(options);
        QVERIFY(openAndWait(window, m_folder->sceneFile()));
        QCoreApplication::processEvents();
        std::vector<unprojector::landmarks::Landmark> all(500);
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].name = "L" + std::to_string(i);
            all[i].world = WorldPoint(0.1, 1.0 / double(i + 3), 0.0);
        }
        QVERIFY(editLandmarks(window.document(), all, {QStringLiteral("put")}));
        unprojector::landmarks::Landmark last;
        last.name = "the last one";
        last.world = WorldPoint(0.25, 0.25, 0.0);
        QVERIFY(window.document().sceneLandmarks().place(last));
        QElapsedTimer timer;
        timer.start();
        QCoreApplication::processEvents();
        qInfo("one turn of the event loop: %g ms", double(timer.nsecsElapsed()) / 1e6);
        const QStringList kept = keptIn(m_folder->recovery());
        QCOMPARE(kept.size(), 1);
        QVERIFY(read(m_folder->recovery() + u'/' + kept[0]).contains("the last one"));
    }

    void aFolderThatCannotBeWrittenIsToldOnce()
    {
        const QString folder = m_folder->sceneFile() + QStringLiteral("/recovery"); // below a file there is no folder
        const auto window = windowKeepingIn(folder);
        QSignalSpy failed(window->findChild<Autosave *>(), &Autosave::failed);
        window->session().openBundledScene();
        edit(*window, 1.0);
        QVERIFY(failed.wait(kPatienceMilliseconds));
        QVERIFY2(window->message().contains(QStringLiteral("scene.json")), qPrintable(window->message()));
        QVERIFY2(window->message().contains(QStringLiteral("not protected")), qPrintable(window->message()));
        edit(*window, 2.0);
        QTest::qWait(300);
        QCOMPARE(failed.size(), 1);
        QVERIFY(window->isWindowModified());
    }

    void theReasonIsTold_data()
    {
        addColumn<QString>("folder");
        addColumn<bool>("isInTheWay"); // a folder of the recovery file's name
        addColumn<QString>("problem"); // of the scene
        addColumn<QString>("reason");
        newRow("below a file") << "scene.json/recovery" << false << ""
                               << "scene.json/recovery: ";
        newRow("a folder in its place") << "recovery" << true << ""
                                        << "recovery: ";
        newRow("no words for the scene") << "recovery" << false << "the scene: too large"
                                         << "the scene: too large";
    }

    void theReasonIsTold()
    {
        QFETCH(QString, folder);
        QFETCH(bool, isInTheWay);
        QFETCH(QString, problem);
        QFETCH(QString, reason);
        QString words;
        Autosave autosave(m_folder->file(folder), {20ms, 200ms}, [&words]() -> Result<Autosave::Content, QString> {
            if (!words.isEmpty())
                return words;
            return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "scene"};
        });
        QSignalSpy failed(&autosave, &Autosave::failed);
        if (isInTheWay) {
            autosave.follow(true);
            QVERIFY(becomesKept(m_folder->recovery()));
            const QString file = m_folder->recovery() + u'/' + keptIn(m_folder->recovery())[0];
            QVERIFY(QFile::remove(file) && QDir().mkpath(file + QStringLiteral("/full")));
        }
        words = problem;
        autosave.follow(true);
        QVERIFY(failed.wait(kPatienceMilliseconds));
        const QString told = QDir::fromNativeSeparators(failed[0][0].toString());
        // The system's error text follows the folder.
        QVERIFY2(told.contains(reason) && !told.endsWith(u' '), qPrintable(told));
        QCOMPARE(failed.size(), 1);
    }

    void changesAreKeptUntilTheyAreSaved()
    {
        const auto window = windowKeepingIn(m_folder->recovery());
        QVERIFY(openAndWait(*window, m_folder->sceneFile()));
        QVERIFY(!QFile::exists(m_folder->recovery()));
        edit(*window);
        QVERIFY(becomesKept(m_folder->recovery()));
        QCOMPARE(read(m_folder->sceneFile()), kScene);
        QVERIFY(window->session().saveScene(pathOf(m_folder->sceneFile())));
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
        setCamera(window->document(), {WorldPoint(0.0, 0.0, 4.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
        QVERIFY2(becomesKept(m_folder->recovery()), "of a scene that has a file the view is a part");
    }

    void undoneChangesAreNotKept()
    {
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        edit(*window, 1.0);
        edit(*window, 2.0);
        QVERIFY(becomesKept(m_folder->recovery()));
        window->document().undoStack().undo();
        window->document().undoStack().undo();
        QVERIFY(keptIn(m_folder->recovery()).isEmpty());
        window->document().undoStack().redo();
        QVERIFY(becomesKept(m_folder->recovery()));
    }

    void changesAreNotKeptOnceTheWindowIsClosed()
    {
        {
            const auto window = windowKeepingIn(m_folder->recovery());
            window->session().openBundledScene();
            edit(*window);
            QVERIFY(becomesKept(m_folder->recovery()));
            QVERIFY(window->close());
        }
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
    }

    void changesAreNotKeptOnceAnotherSceneIsOpened()
    {
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        edit(*window);
        QVERIFY(becomesKept(m_folder->recovery()));
        QVERIFY(openAndWait(*window, m_folder->file(QStringLiteral("nowhere.json"))));
        QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
        QVERIFY(openAndWait(*window, m_folder->sceneFile()));
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
    }

    void whoOnlyLooksAroundLeavesNothing()
    {
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        fitAll(window->document());
        switchProjection(window->document());
        QTest::qWait(300);
        QVERIFY(!QFile::exists(m_folder->recovery()));
    }

    void aWindowThatRemembersNothingKeepsNothing()
    {
        const auto window = windowKeepingIn({});
        window->session().openBundledScene();
        edit(*window);
        window->session().offerRecovery();
        QVERIFY(!window->findChild<Autosave *>());
    }

private:
    std::unique_ptr<Folder> m_folder;
};

UNPROJECTOR_TEST(TestAutosave, display)
#include "test_autosave.moc"
