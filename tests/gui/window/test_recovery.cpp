// Unsaved changes left by a crash are offered at the next start.

#include "tests/support/test.h"

#include "tests/gui/kept_scene.h"
#include "tests/support/patience.h"

#include "gui/document/portable.h"
#include "gui/document/recovery_file.h"
#include "gui/document/scene_document.h"
#include "gui/shell/overlay_bars.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <cstdio>

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

using namespace keeping;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene_file;

namespace {

RecoveryBar &barOf(MainWindow &window)
{
    return *window.findChild<RecoveryBar *>();
}

QString offeredBy(MainWindow &window)
{
    const RecoveryBar &bar = barOf(window);
    return bar.isHidden() ? QString() : bar.findChild<QLabel *>()->text();
}

QPushButton &buttonOf(MainWindow &window, const QString &text)
{
    for (QPushButton *button : barOf(window).findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == text)
            return *button;
    }
    qFatal("no such button");
}

bool recover(MainWindow &window)
{
    QSignalSpy ended(&window.session(), &Session::loadingEnded);
    buttonOf(window, QStringLiteral("Recover")).click();
    return !ended.isEmpty() || ended.wait(kPatienceMilliseconds);
}

/// Answers the message box that comes up next.
void answerNext(QMessageBox::StandardButton answer)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, answer] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        if (!box)
            return;
        timer->deleteLater();
        box->button(answer)->click();
    });
    timer->start(10);
}

/// Runs the program until it is killed: opens a scene, changes it, and reports when the change is
/// kept.
int runUntilKilled(const QString &folder, const QString &file)
{
    const auto window = windowKeepingIn(folder);
    if (!openAndWait(*window, file) || !window->message().isEmpty())
        return 3;
    edit(*window);
    if (!QTest::qWaitFor([&] { return !keptIn(folder).isEmpty(); }, kPatienceMilliseconds))
        return 4;
    std::printf("kept\n");
    std::fflush(stdout);
    return QApplication::exec();
}

} // namespace

class TestRecovery : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { guitest::redirectSettings(); }
    void init() { m_folder = std::make_unique<Folder>(); }

    void aProgramThatIsCarriedAboutKeepsThemBesideItself()
    {
        const QString program = m_folder->path();
        QVERIFY(!isPortable(program));
        QVERIFY(!RecoveryFile::defaultFolder(program).startsWith(program));
        write(m_folder->file(QStringLiteral("portable")), {});
        QVERIFY(isPortable(program));
        QCOMPARE(RecoveryFile::defaultFolder(program), program + QStringLiteral("/recovery"));
    }

    void whatIsWrittenIsReadAgain()
    {
        const RecoveryInfo info{QStringLiteral("面 “x”.json"), pathOf(m_folder->file(QStringLiteral("面/x.json"))),
                                QDateTime::currentDateTime()};
        QString path;
        {
            const auto created = RecoveryFile::create(m_folder->recovery());
            QVERIFY(created);
            const std::unique_ptr<RecoveryFile> &file = *created;
            QVERIFY(file->write(info, kScene.toStdString()));
            QVERIFY2(RecoveryFile::abandonedIn(m_folder->recovery()).empty(), "it is held");
            path = file->path();
        }
        const auto files = RecoveryFile::abandonedIn(m_folder->recovery());
        QCOMPARE(files.size(), std::size_t(1));
        QCOMPARE(files[0]->path(), path);
        const std::optional<RecoveryInfo> again = files[0]->info();
        QVERIFY(again && again->name == info.name && again->sceneFile == info.sceneFile && again->time == info.time);
        const SceneOrError scene = files[0]->scene();
        QVERIFY(scene && scene->objects.size() == 1);
    }

    void aLargeSceneIsKept()
    {
        constexpr int kCount = 60000; // more than 8 MiB
        const auto created = RecoveryFile::create(m_folder->recovery());
        QVERIFY(created);
        SceneFile scene = *parseScene(kScene.toStdString(), "scene.json");
        for (int i = 0; i < kCount; ++i) {
            unprojector::landmarks::Landmark landmark;
            landmark.name = "landmark number " + std::to_string(i);
            landmark.world = WorldPoint(i / 3.0, i / 7.0, i / 11.0);
            landmark.uncertainty = WorldVector(1e-5 / 3.0, 1e-5 / 7.0, 1e-5 / 11.0);
            scene.landmarks.landmarks.push_back(std::move(landmark));
        }
        const auto text = sceneText(scene);
        QVERIFY(text && text->size() > std::size_t{8} << 20);
        QVERIFY((*created)->write({QStringLiteral("x.json"), {}, QDateTime::currentDateTime()}, *text));
        const SceneOrError again = (*created)->scene();
        QVERIFY(again && again->landmarks.landmarks == scene.landmarks.landmarks);
    }

    void aKilledProgramsChangesAreOfferedAndRecovered()
    {
        QProcess program;
        program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        program.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("--until-killed"), m_folder->recovery(), m_folder->sceneFile()});
        QVERIFY(program.waitForStarted(kPatienceMilliseconds));
        QByteArray said;
        while (!said.contains("kept") && program.waitForReadyRead(kPatienceMilliseconds))
            said += program.readAllStandardOutput();
        QVERIFY2(said.contains("kept"), said.constData());

        {
            const auto beside = windowKeepingIn(m_folder->recovery());
            beside->session().openBundledScene();
            beside->session().offerRecovery();
            QVERIFY2(offeredBy(*beside).isEmpty(), "the other program is running");
        }
        program.kill();
        QVERIFY(program.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        window->session().offerRecovery();
        QVERIFY2(offeredBy(*window).contains(QStringLiteral("scene.json")), qPrintable(offeredBy(*window)));
        QVERIFY(recover(*window));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QVERIFY(offeredBy(*window).isEmpty());
        QVERIFY(window->isWindowModified());
        QVERIFY(window->document().scene().clipPlanes == (std::vector{glm::dvec4(0.0, 1.0, 0.0, 0.3333333333333333)}));
        QCOMPARE(window->document().objects().size(), std::size_t(1));
        QVERIFY(std::filesystem::equivalent(window->document().objects()[0].file, pathOf(m_folder->triangleFile())));
        QVERIFY2(window->windowTitle().startsWith(QStringLiteral("scene.json")), qPrintable(window->windowTitle()));
        QCOMPARE(read(m_folder->sceneFile()), kScene);

        // The scene's own file is where it is saved to.
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(QKeySequence::Save))
                action->trigger();
        }
        QVERIFY(!window->isWindowModified());
        QVERIFY(read(m_folder->sceneFile()).contains("0.3333333333333333"));
        QVERIFY(read(m_folder->sceneFile()).contains("\"models/triangle.obj\""));
        QVERIFY(read(m_folder->sceneFile()).contains("somebody"));
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
    }

    void aRecoveredSceneIsKeptUntilItIsSaved()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        for (int crash = 0; crash < 3; ++crash) {
            const auto window = windowKeepingIn(m_folder->recovery());
            window->session().offerRecovery();
            QVERIFY(recover(*window));
            QVERIFY(window->document().scene().clipPlanes == (std::vector{glm::dvec4(0.0, 1.0, 0.0, 0.125)}));
            QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
            const auto beside = windowKeepingIn(m_folder->recovery());
            beside->session().offerRecovery();
            QVERIFY(offeredBy(*beside).isEmpty());
        }
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        QVERIFY(recover(*window));
        edit(*window, 0.25);
        window->document().undoStack().undo();
        QVERIFY2(window->isWindowModified(), "what was recovered is on no disk yet");
        QVERIFY(window->session().saveScene(pathOf(m_folder->sceneFile())));
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
    }

    void aSceneWithoutAFileIsRecovered()
    {
        // Opened by a name that means something in this folder only.
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_folder->path()));
        leaveChanges(QStringLiteral("models/triangle.obj"), 0.125);
        QVERIFY(QDir::setCurrent(before));
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        QVERIFY2(offeredBy(*window).contains(QStringLiteral("triangle.obj")), qPrintable(offeredBy(*window)));
        QVERIFY(recover(*window));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QVERIFY(window->isWindowModified());
        QCOMPARE(window->document().scene().clipPlanes.size(), std::size_t(1));
        QVERIFY2(window->windowTitle().startsWith(QStringLiteral("triangle.obj")), qPrintable(window->windowTitle()));
    }

    void severalAreOfferedTheLastFirst()
    {
        const QString other = m_folder->file(QStringLiteral("other.json"));
        write(other, kScene);
        leaveChanges(m_folder->sceneFile(), 0.125);
        QTest::qWait(20); // the times are in milliseconds
        leaveChanges(other, 0.25);
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        const auto *choice = barOf(*window).findChild<QComboBox *>();
        QVERIFY(!choice->isHidden());
        QCOMPARE(choice->count(), 2);
        QVERIFY2(choice->itemText(0).startsWith(QStringLiteral("other.json")), qPrintable(choice->itemText(0)));
        QVERIFY2(choice->itemText(1).startsWith(QStringLiteral("scene.json")), qPrintable(choice->itemText(1)));
        QVERIFY(recover(*window));
        QCOMPARE(window->document().scene().clipPlanes.at(0).w, 0.25);
        QVERIFY2(offeredBy(*window).contains(QStringLiteral("scene.json")), qPrintable(offeredBy(*window)));
        QVERIFY(choice->isHidden());
    }

    void laterMeansTheNextStart()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        for (int start = 0; start < 2; ++start) {
            const auto window = windowKeepingIn(m_folder->recovery());
            window->session().openBundledScene();
            window->session().offerRecovery();
            QVERIFY(!offeredBy(*window).isEmpty());
            buttonOf(*window, QStringLiteral("Later")).click();
            QVERIFY(offeredBy(*window).isEmpty());
            QVERIFY(window->close());
        }
        QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
    }

    void discardedChangesAreGone()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        answerNext(QMessageBox::Cancel);
        buttonOf(*window, QStringLiteral("Discard")).click();
        QVERIFY(!offeredBy(*window).isEmpty());
        answerNext(QMessageBox::Discard);
        buttonOf(*window, QStringLiteral("Discard")).click();
        QVERIFY(offeredBy(*window).isEmpty());
        QVERIFY(QDir(m_folder->recovery()).isEmpty());
        QCOMPARE(read(m_folder->sceneFile()), kScene);
    }

    void theOfferStandsBesideTheFileOfTheCommandLine()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        const auto window = windowKeepingIn(m_folder->recovery());
        QSignalSpy ended(&window->session(), &Session::loadingEnded);
        window->session().openFiles({pathOf(m_folder->triangleFile())});
        window->session().offerRecovery();
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get(), kPatienceMilliseconds));
        QVERIFY(!ended.isEmpty() || ended.wait(kPatienceMilliseconds));
        QVERIFY(window->windowTitle().startsWith(QStringLiteral("triangle.obj")));
        QVERIFY(barOf(*window).isVisible());
        QVERIFY(!QApplication::activeModalWidget());
        const QSize size = barOf(*window).size();
        QVERIFY2(size.height() < window->height() / 4 && size.width() < window->width(),
                 "most of the view can be seen and used");
    }

    void aModelThatIsGoneKeepsTheOffer()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        QVERIFY(QFile::remove(m_folder->triangleFile()));
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        window->session().offerRecovery();
        QVERIFY(recover(*window));
        QVERIFY2(window->message().contains(QStringLiteral("triangle.obj")), qPrintable(window->message()));
        QCOMPARE(window->document().objects().size(), std::size_t(5));
        QVERIFY(!offeredBy(*window).isEmpty() && barOf(*window).isEnabled());
        QCOMPARE(keptIn(m_folder->recovery()).size(), 1);
        write(m_folder->triangleFile(), kTriangle);
        QVERIFY(recover(*window));
        QVERIFY(window->message().isEmpty());
        QCOMPARE(window->document().objects().size(), std::size_t(1));
    }

    void aDamagedFileIsPutAside_data()
    {
        addColumn<QByteArray>("text");
        addColumn<bool>("isOffered"); // its first line is good: that the rest is not shows when it is opened
        const QByteArray head = R"({"unprojectorRecovery": 1, "name": "n", "time": "2024-01-01T00:00:00.000Z")";
        newRow("empty") << QByteArray() << false;
        newRow("zeros") << QByteArray(4096, '\0') << false;
        newRow("cut off in the first line") << head.left(40) << false;
        newRow("without its first line") << kScene << false;
        newRow("of another version") << QByteArray(head).replace("1,", "2,") + "}\n" + kScene << false;
        newRow("of no time") << QByteArray(head).replace("2024-01", "2024-13") + "}\n" + kScene << false;
        newRow("of a relative scene file") << head + R"(, "sceneFile": "scene.json"})" + "\n" + kScene << false;
        newRow("a first line without end") << QByteArray(2 << 20, ' ') << false;
        newRow("no scene") << head + "}\n" << true;
        newRow("cut off in the scene") << head + "}\n" + kScene.left(200) << true;
    }

    void aDamagedFileIsPutAside()
    {
        QFETCH(QByteArray, text);
        QFETCH(bool, isOffered);
        QVERIFY(QDir().mkpath(m_folder->recovery()));
        write(m_folder->recovery() + QStringLiteral("/0123.recovery"), text);
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        window->session().offerRecovery();
        QCOMPARE(!offeredBy(*window).isEmpty(), isOffered);
        if (isOffered)
            buttonOf(*window, QStringLiteral("Recover")).click();
        QVERIFY(offeredBy(*window).isEmpty());
        QVERIFY2(window->message().contains(QStringLiteral("0123.damaged")), qPrintable(window->message()));
        QCOMPARE(read(m_folder->recovery() + QStringLiteral("/0123.damaged")), text);
        QVERIFY(keptIn(m_folder->recovery()).isEmpty());
        QCOMPARE(window->document().objects().size(), std::size_t(5));

        const auto next = windowKeepingIn(m_folder->recovery());
        next->session().offerRecovery();
        QVERIFY(offeredBy(*next).isEmpty() && next->message().isEmpty());
    }

    void whatDeadProgramsLeaveIsCleared()
    {
        leaveChanges(m_folder->sceneFile(), 0.125);
        const QString half =
            m_folder->recovery() + u'/' + keptIn(m_folder->recovery()).constFirst() + QStringLiteral(".aBcDeF");
        write(half, "{");
        write(m_folder->recovery() + QStringLiteral("/0123.recovery.XyZabc"), "{");
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        QVERIFY(!offeredBy(*window).isEmpty());
        const QStringList left = QDir(m_folder->recovery()).entryList(QDir::Files | QDir::Hidden);
        QVERIFY2(left.size() == 2, qPrintable(left.join(u' '))); // the file and its lock
    }

    void whatIsKeptIsTheUsersAlone()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows' rights are those of the folder");
#else
        const auto permissionsIn = [](const QString &path) {
            return static_cast<int>(std::filesystem::status(pathOf(path)).permissions());
        };
        const QString folder = m_folder->recovery();
        const auto areAlone = [&] {
            const QFileInfoList files = QDir(folder).entryInfoList(QDir::Files | QDir::Hidden);
            return files.size() >= 2 && permissionsIn(folder) == 0700
                   && std::all_of(files.begin(), files.end(),
                                  [&](const QFileInfo &file) { return permissionsIn(file.filePath()) == 0600; });
        };
        const mode_t before = umask(022);
        {
            const auto window = windowKeepingIn(folder);
            QVERIFY(openAndWait(*window, m_folder->sceneFile()));
            edit(*window);
            QVERIFY(becomesKept(folder));
            QVERIFY(areAlone()); // the file and its lock
        }
        // An earlier version left them so.
        using std::filesystem::perms;
        for (const QFileInfo &file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden))
            std::filesystem::permissions(pathOf(file.filePath()), perms(0644));
        std::filesystem::permissions(pathOf(folder), perms(0755));
        write(folder + QStringLiteral("/0123.damaged"), "{");
        const auto window = windowKeepingIn(folder);
        window->session().offerRecovery();
        QVERIFY(!offeredBy(*window).isEmpty());
        QVERIFY(areAlone());
        umask(before);
#endif
    }

    void namesAreNoMarkup()
    {
        RecoveryBar bar;
        const RecoveryInfo info{QStringLiteral("<h1>x"), pathOf(QStringLiteral("/a/<img src=b>")),
                                QDateTime::currentDateTime()};
        bar.offer({info});
        const auto *label = bar.findChild<QLabel *>();
        QVERIFY(label->text().contains(QStringLiteral("<h1>x")));
        QCOMPARE(label->textFormat(), Qt::PlainText);
        QVERIFY2(label->toolTip().contains(QStringLiteral("&lt;img src=b&gt;")), qPrintable(label->toolTip()));
        bar.offer({info, info});
        const QString tip = bar.findChild<QComboBox *>()->itemData(0, Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(QStringLiteral("&lt;img src=b&gt;")), qPrintable(tip));
        LoadingBar loading;
        QCOMPARE(loading.findChild<QLabel *>()->textFormat(), Qt::PlainText);
    }

private:
    /// Leaves the state of a crash: a window with a change that goes without being closed.
    void leaveChanges(const QString &file, double d)
    {
        const int before = static_cast<int>(keptIn(m_folder->recovery()).size());
        const auto window = windowKeepingIn(m_folder->recovery());
        QVERIFY(openAndWait(*window, file));
        edit(*window, d);
        QVERIFY(becomesKept(m_folder->recovery(), before + 1));
    }

    std::unique_ptr<Folder> m_folder;
};

namespace {
const tests::Helper untilKilled(QStringLiteral("until-killed"), [](const QStringList &words) {
    guitest::redirectSettings();
    return runUntilKilled(words.at(0), words.at(1));
});
} // namespace

UNPROJECTOR_TEST(TestRecovery, display)
#include "test_recovery.moc"
