// Unsaved changes are kept in case of a crash, and offered afterwards.

#include "gui/autosave.h"
#include "gui/main_window.h"
#include "gui/overlay_bars.h"
#include "gui/scene_document.h"

#include "gui_scene.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <cstdio>
#include <cstring>

using namespace unprojector;
using namespace guitest;
using namespace std::chrono_literals;

namespace {

constexpr int kMostMilliseconds = 20000;

const QByteArray kScene = R"({"unprojector": 1, "window": {"width": 300, "height": 200},
    "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
    "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
    "objects": [{"name": "t", "file": "models/triangle.obj", "transform": []}], "author": "somebody"})";

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

/// Not on the screen: nothing here needs the view.
std::unique_ptr<MainWindow> windowKeepingIn(const QString &folder, AutosaveTiming timing = {20ms, 200ms})
{
    MainWindow::Options options;
    options.samples = 0;
    options.remembers = false;
    options.recoveryFolder = folder;
    options.autosave = timing;
    return std::make_unique<MainWindow>(options);
}

bool openAndWait(MainWindow &window, const QString &file)
{
    QSignalSpy ended(&window, &MainWindow::loadingEnded);
    window.openFiles({pathOf(file)});
    return !ended.isEmpty() || ended.wait(kMostMilliseconds);
}

/// Something that a person would not like to lose: a clip plane at height `d`.
void edit(MainWindow &window, double d = 0.3333333333333333)
{
    Scene scene = window.document().scene();
    scene.clipPlanes = {{0.0, 1.0, 0.0, d}};
    if (!window.document().change(scene, QStringLiteral("Plane")))
        qFatal("the plane is refused");
}

QStringList keptIn(const QString &folder)
{
    return QDir(folder).entryList({QStringLiteral("*.recovery")}, QDir::Files);
}

bool becomesKept(const QString &folder, int count = 1)
{
    return QTest::qWaitFor([&] { return keptIn(folder).size() == count; }, kMostMilliseconds);
}

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
    QSignalSpy ended(&window, &MainWindow::loadingEnded);
    buttonOf(window, QStringLiteral("Recover")).click();
    return !ended.isEmpty() || ended.wait(kMostMilliseconds);
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

/// The program until it is killed: opens a scene, changes it, tells when the change is kept.
int runUntilKilled(const QString &folder, const QString &file)
{
    const auto window = windowKeepingIn(folder);
    if (!openAndWait(*window, file) || !window->message().isEmpty())
        return 3;
    edit(*window);
    if (!QTest::qWaitFor([&] { return !keptIn(folder).isEmpty(); }, kMostMilliseconds))
        return 4;
    std::printf("kept\n");
    std::fflush(stdout);
    return QApplication::exec();
}

} // namespace

class TestAutosave : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init();

    void manyChangesAreWrittenOnceAfterAPause();
    void changesWithoutAPauseAreWrittenAllTheSame();
    void aFolderThatCannotBeWrittenIsToldOnce();
    void whatIsWrittenIsReadAgain();

    void changesAreKeptUntilTheyAreSaved();
    void undoneChangesAreNotKept();
    void changesAreNotKeptOnceTheWindowIsClosed();
    void changesAreNotKeptOnceAnotherSceneIsOpened();
    void whoOnlyLooksAroundLeavesNothing();
    void aWindowThatRemembersNothingKeepsNothing();

    void aKilledProgramsChangesAreOfferedAndRecovered();
    void aRecoveredSceneIsKeptUntilItIsSaved();
    void aSceneWithoutAFileIsRecovered();
    void severalAreOfferedTheLastFirst();
    void laterMeansTheNextStart();
    void discardedChangesAreGone();
    void theOfferStandsBesideTheFileOfTheCommandLine();
    void aModelThatIsGoneKeepsTheOffer();
    void aDamagedFileIsPutAside_data();
    void aDamagedFileIsPutAside();
    void whatDeadProgramsLeaveIsCleared();

private:
    QString inFolder(const QString &name) const { return m_folder->filePath(name); }
    QString recovery() const { return inFolder(QStringLiteral("recovery")); }
    QString sceneFile() const { return inFolder(QStringLiteral("scene.json")); }
    static void write(const QString &file, const QByteArray &text)
    {
        QFile stream(file);
        QVERIFY(stream.open(QIODevice::WriteOnly) && stream.write(text) == text.size());
    }
    static QByteArray read(const QString &file)
    {
        QFile stream(file);
        return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
    }
    /// What a crash leaves: a window with a change that goes without being closed.
    void leaveChanges(const QString &file, double d);

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestAutosave::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("models")));
    write(inFolder(QStringLiteral("models/triangle.obj")), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write(sceneFile(), kScene);
}

void TestAutosave::leaveChanges(const QString &file, double d)
{
    const int before = static_cast<int>(keptIn(recovery()).size());
    const auto window = windowKeepingIn(recovery());
    QVERIFY(openAndWait(*window, file));
    edit(*window, d);
    QVERIFY(becomesKept(recovery(), before + 1));
}

// ---- when and where ----------------------------------------------------------------------------------------------

void TestAutosave::manyChangesAreWrittenOnceAfterAPause()
{
    int asked = 0;
    Autosave autosave(recovery(), {50ms, 10s}, [&asked] {
        ++asked;
        return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "scene"};
    });
    for (int i = 0; i < 20; ++i)
        autosave.follow(true);
    QCOMPARE(asked, 0);
    QVERIFY(becomesKept(recovery()));
    QTest::qWait(200);
    QCOMPARE(asked, 1);
    autosave.follow(false);
    QVERIFY(QDir(recovery()).isEmpty());
}

void TestAutosave::changesWithoutAPauseAreWrittenAllTheSame()
{
    Autosave autosave(recovery(), {60s, 300ms}, [] {
        return Autosave::Content{{QStringLiteral("a"), {}, QDateTime::currentDateTime()}, "scene"};
    });
    for (int i = 0; i < 200 && keptIn(recovery()).isEmpty(); ++i) {
        autosave.follow(true);
        QTest::qWait(20);
    }
    QCOMPARE(keptIn(recovery()).size(), 1);
}

void TestAutosave::aFolderThatCannotBeWrittenIsToldOnce()
{
    const QString folder = sceneFile() + QStringLiteral("/recovery"); // below a file there is no folder
    const auto window = windowKeepingIn(folder);
    QSignalSpy failed(window->findChild<Autosave *>(), &Autosave::failed);
    window->openBundledScene();
    edit(*window, 1.0);
    QVERIFY(failed.wait(kMostMilliseconds));
    QVERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("scene.json")),
             qPrintable(window->statusBar()->currentMessage()));
    QVERIFY(window->message().isEmpty());
    edit(*window, 2.0);
    QTest::qWait(300);
    QCOMPARE(failed.size(), 1);
    QVERIFY(window->isWindowModified());
}

void TestAutosave::whatIsWrittenIsReadAgain()
{
    const RecoveryInfo info{QStringLiteral("面 “x”.json"), pathOf(inFolder(QStringLiteral("面/x.json"))),
                            QDateTime::currentDateTime()};
    QString path;
    {
        const std::unique_ptr<RecoveryFile> file = RecoveryFile::create(recovery());
        QVERIFY(file && file->write(info, kScene.toStdString()));
        QVERIFY2(RecoveryFile::abandonedIn(recovery()).empty(), "it is held");
        path = file->path();
    }
    const auto files = RecoveryFile::abandonedIn(recovery());
    QCOMPARE(files.size(), std::size_t(1));
    QCOMPARE(files[0]->path(), path);
    const std::optional<RecoveryInfo> again = files[0]->info();
    QVERIFY(again && again->name == info.name && again->sceneFile == info.sceneFile && again->time == info.time);
    const Result<SceneFile, SceneFileError> scene = files[0]->scene();
    QVERIFY(scene && scene->objects.size() == 1);
}

// ---- the window --------------------------------------------------------------------------------------------------

void TestAutosave::changesAreKeptUntilTheyAreSaved()
{
    const auto window = windowKeepingIn(recovery());
    QVERIFY(openAndWait(*window, sceneFile()));
    QVERIFY(!QFile::exists(recovery()));
    edit(*window);
    QVERIFY(becomesKept(recovery()));
    QCOMPARE(read(sceneFile()), kScene);
    QVERIFY(window->saveScene(pathOf(sceneFile())));
    QVERIFY(QDir(recovery()).isEmpty());
    window->document().setCamera({WorldPoint(0.0, 0.0, 4.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
    QVERIFY2(becomesKept(recovery()), "of a scene that has a file the view is a part");
}

void TestAutosave::undoneChangesAreNotKept()
{
    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    edit(*window, 1.0);
    edit(*window, 2.0);
    QVERIFY(becomesKept(recovery()));
    window->document().undoStack().undo();
    window->document().undoStack().undo();
    QVERIFY(keptIn(recovery()).isEmpty());
    window->document().undoStack().redo();
    QVERIFY(becomesKept(recovery()));
}

void TestAutosave::changesAreNotKeptOnceTheWindowIsClosed()
{
    {
        const auto window = windowKeepingIn(recovery());
        window->openBundledScene();
        edit(*window);
        QVERIFY(becomesKept(recovery()));
        QVERIFY(window->close());
    }
    QVERIFY(QDir(recovery()).isEmpty());
}

void TestAutosave::changesAreNotKeptOnceAnotherSceneIsOpened()
{
    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    edit(*window);
    QVERIFY(becomesKept(recovery()));
    QVERIFY(openAndWait(*window, inFolder(QStringLiteral("nowhere.json"))));
    QCOMPARE(keptIn(recovery()).size(), 1);
    QVERIFY(openAndWait(*window, sceneFile()));
    QVERIFY(QDir(recovery()).isEmpty());
}

void TestAutosave::whoOnlyLooksAroundLeavesNothing()
{
    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    window->document().fit();
    window->document().switchProjection();
    QTest::qWait(300);
    QVERIFY(!QFile::exists(recovery()));
}

void TestAutosave::aWindowThatRemembersNothingKeepsNothing()
{
    const auto window = windowKeepingIn({});
    window->openBundledScene();
    edit(*window);
    window->offerRecovery();
    QVERIFY(!window->findChild<Autosave *>());
}

// ---- after a crash -----------------------------------------------------------------------------------------------

void TestAutosave::aKilledProgramsChangesAreOfferedAndRecovered()
{
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--until-killed"), recovery(), sceneFile()});
    QVERIFY(program.waitForStarted());
    QByteArray said;
    while (!said.contains("kept") && program.waitForReadyRead(kMostMilliseconds))
        said += program.readAllStandardOutput();
    QVERIFY2(said.contains("kept"), said.constData());

    {
        const auto beside = windowKeepingIn(recovery());
        beside->openBundledScene();
        beside->offerRecovery();
        QVERIFY2(offeredBy(*beside).isEmpty(), "the other program is running");
    }
    program.kill();
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);

    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    window->offerRecovery();
    QVERIFY2(offeredBy(*window).contains(QStringLiteral("scene.json")), qPrintable(offeredBy(*window)));
    QVERIFY(recover(*window));
    QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
    QVERIFY(offeredBy(*window).isEmpty());
    QVERIFY(window->isWindowModified());
    QVERIFY(window->document().scene().clipPlanes == (std::vector{glm::dvec4(0.0, 1.0, 0.0, 0.3333333333333333)}));
    QCOMPARE(window->document().objects().size(), std::size_t(1));
    QVERIFY(std::filesystem::equivalent(window->document().objects()[0].file,
                                        pathOf(inFolder(QStringLiteral("models/triangle.obj")))));
    QVERIFY2(window->windowTitle().startsWith(QStringLiteral("scene.json")), qPrintable(window->windowTitle()));
    QCOMPARE(read(sceneFile()), kScene);

    // The scene's own file is where it is saved to.
    for (QAction *action : window->findChildren<QAction *>()) {
        if (action->shortcut() == QKeySequence(QKeySequence::Save))
            action->trigger();
    }
    QVERIFY(!window->isWindowModified());
    QVERIFY(read(sceneFile()).contains("0.3333333333333333"));
    QVERIFY(read(sceneFile()).contains("\"models/triangle.obj\""));
    QVERIFY(read(sceneFile()).contains("somebody"));
    QVERIFY(QDir(recovery()).isEmpty());
}

void TestAutosave::aRecoveredSceneIsKeptUntilItIsSaved()
{
    leaveChanges(sceneFile(), 0.125);
    for (int crash = 0; crash < 3; ++crash) {
        const auto window = windowKeepingIn(recovery());
        window->offerRecovery();
        QVERIFY(recover(*window));
        QVERIFY(window->document().scene().clipPlanes == (std::vector{glm::dvec4(0.0, 1.0, 0.0, 0.125)}));
        QCOMPARE(keptIn(recovery()).size(), 1);
        const auto beside = windowKeepingIn(recovery());
        beside->offerRecovery();
        QVERIFY(offeredBy(*beside).isEmpty());
    }
    const auto window = windowKeepingIn(recovery());
    window->offerRecovery();
    QVERIFY(recover(*window));
    edit(*window, 0.25);
    window->document().undoStack().undo();
    QVERIFY2(window->isWindowModified(), "what was recovered is on no disk yet");
    QVERIFY(window->saveScene(pathOf(sceneFile())));
    QVERIFY(QDir(recovery()).isEmpty());
}

void TestAutosave::aSceneWithoutAFileIsRecovered()
{
    // Opened by a name that means something in this folder only.
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    leaveChanges(QStringLiteral("models/triangle.obj"), 0.125);
    QVERIFY(QDir::setCurrent(before));
    const auto window = windowKeepingIn(recovery());
    window->offerRecovery();
    QVERIFY2(offeredBy(*window).contains(QStringLiteral("triangle.obj")), qPrintable(offeredBy(*window)));
    QVERIFY(recover(*window));
    QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
    QVERIFY(window->isWindowModified());
    QCOMPARE(window->document().scene().clipPlanes.size(), std::size_t(1));
    QVERIFY2(window->windowTitle().startsWith(QStringLiteral("triangle.obj")), qPrintable(window->windowTitle()));
}

void TestAutosave::severalAreOfferedTheLastFirst()
{
    const QString other = inFolder(QStringLiteral("other.json"));
    write(other, kScene);
    leaveChanges(sceneFile(), 0.125);
    QTest::qWait(20); // the times are in milliseconds
    leaveChanges(other, 0.25);
    const auto window = windowKeepingIn(recovery());
    window->offerRecovery();
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

void TestAutosave::laterMeansTheNextStart()
{
    leaveChanges(sceneFile(), 0.125);
    for (int start = 0; start < 2; ++start) {
        const auto window = windowKeepingIn(recovery());
        window->openBundledScene();
        window->offerRecovery();
        QVERIFY(!offeredBy(*window).isEmpty());
        buttonOf(*window, QStringLiteral("Later")).click();
        QVERIFY(offeredBy(*window).isEmpty());
        QVERIFY(window->close());
    }
    QCOMPARE(keptIn(recovery()).size(), 1);
}

void TestAutosave::discardedChangesAreGone()
{
    leaveChanges(sceneFile(), 0.125);
    const auto window = windowKeepingIn(recovery());
    window->offerRecovery();
    answerNext(QMessageBox::Cancel);
    buttonOf(*window, QStringLiteral("Discard")).click();
    QVERIFY(!offeredBy(*window).isEmpty());
    answerNext(QMessageBox::Discard);
    buttonOf(*window, QStringLiteral("Discard")).click();
    QVERIFY(offeredBy(*window).isEmpty());
    QVERIFY(QDir(recovery()).isEmpty());
    QCOMPARE(read(sceneFile()), kScene);
}

void TestAutosave::theOfferStandsBesideTheFileOfTheCommandLine()
{
    leaveChanges(sceneFile(), 0.125);
    const auto window = windowKeepingIn(recovery());
    QSignalSpy ended(window.get(), &MainWindow::loadingEnded);
    window->openFiles({pathOf(inFolder(QStringLiteral("models/triangle.obj")))});
    window->offerRecovery();
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    QVERIFY(!ended.isEmpty() || ended.wait(kMostMilliseconds));
    QVERIFY(window->windowTitle().startsWith(QStringLiteral("triangle.obj")));
    QVERIFY(barOf(*window).isVisible());
    QVERIFY(!QApplication::activeModalWidget());
    const QSize size = barOf(*window).size();
    QVERIFY2(size.height() < window->height() / 4 && size.width() < window->width(),
             "most of the view can be seen and used");
}

void TestAutosave::aModelThatIsGoneKeepsTheOffer()
{
    leaveChanges(sceneFile(), 0.125);
    QVERIFY(QFile::remove(inFolder(QStringLiteral("models/triangle.obj"))));
    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    window->offerRecovery();
    QVERIFY(recover(*window));
    QVERIFY2(window->message().contains(QStringLiteral("triangle.obj")), qPrintable(window->message()));
    QCOMPARE(window->document().objects().size(), std::size_t(5));
    QVERIFY(!offeredBy(*window).isEmpty() && barOf(*window).isEnabled());
    QCOMPARE(keptIn(recovery()).size(), 1);
    write(inFolder(QStringLiteral("models/triangle.obj")), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QVERIFY(recover(*window));
    QVERIFY(window->message().isEmpty());
    QCOMPARE(window->document().objects().size(), std::size_t(1));
}

void TestAutosave::aDamagedFileIsPutAside_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isOffered"); // its first line is good: that the rest is not shows when it is opened
    const QByteArray head = R"({"unprojectorRecovery": 1, "name": "n", "time": "2024-01-01T00:00:00.000Z")";
    QTest::newRow("empty") << QByteArray() << false;
    QTest::newRow("zeros") << QByteArray(4096, '\0') << false;
    QTest::newRow("cut off in the first line") << head.left(40) << false;
    QTest::newRow("without its first line") << kScene << false;
    QTest::newRow("of another version") << QByteArray(head).replace("1,", "2,") + "}\n" + kScene << false;
    QTest::newRow("of no time") << QByteArray(head).replace("2024-01", "2024-13") + "}\n" + kScene << false;
    QTest::newRow("of a relative scene file") << head + R"(, "sceneFile": "scene.json"})" + "\n" + kScene << false;
    QTest::newRow("a first line without end") << QByteArray(2 << 20, ' ') << false;
    QTest::newRow("no scene") << head + "}\n" << true;
    QTest::newRow("cut off in the scene") << head + "}\n" + kScene.left(200) << true;
}

void TestAutosave::aDamagedFileIsPutAside()
{
    QFETCH(QByteArray, text);
    QFETCH(bool, isOffered);
    QVERIFY(QDir().mkpath(recovery()));
    write(recovery() + QStringLiteral("/0123.recovery"), text);
    const auto window = windowKeepingIn(recovery());
    window->openBundledScene();
    window->offerRecovery();
    QCOMPARE(!offeredBy(*window).isEmpty(), isOffered);
    if (isOffered)
        buttonOf(*window, QStringLiteral("Recover")).click();
    QVERIFY(offeredBy(*window).isEmpty());
    QVERIFY2(window->message().contains(QStringLiteral("0123.damaged")), qPrintable(window->message()));
    QCOMPARE(read(recovery() + QStringLiteral("/0123.damaged")), text);
    QVERIFY(keptIn(recovery()).isEmpty());
    QCOMPARE(window->document().objects().size(), std::size_t(5));

    const auto next = windowKeepingIn(recovery());
    next->offerRecovery();
    QVERIFY(offeredBy(*next).isEmpty() && next->message().isEmpty());
}

void TestAutosave::whatDeadProgramsLeaveIsCleared()
{
    leaveChanges(sceneFile(), 0.125);
    const QString half = recovery() + u'/' + keptIn(recovery()).constFirst() + QStringLiteral(".aBcDeF");
    write(half, "{");
    write(recovery() + QStringLiteral("/0123.recovery.XyZabc"), "{");
    const auto window = windowKeepingIn(recovery());
    window->offerRecovery();
    QVERIFY(!offeredBy(*window).isEmpty());
    const QStringList left = QDir(recovery()).entryList(QDir::Files | QDir::Hidden);
    QVERIFY2(left.size() == 2, qPrintable(left.join(u' '))); // the file and its lock
}

int main(int argc, char **argv)
{
    const bool isChild = argc == 4 && std::strcmp(argv[1], "--until-killed") == 0;
    QApplication application(argc, argv);
    if (isChild) {
        redirectSettings();
        return runUntilKilled(QString::fromLocal8Bit(argv[2]), QString::fromLocal8Bit(argv[3]));
    }
    TestAutosave test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_autosave.moc"
