// Opening files: by name, by drop, several at once, broken ones, cancelled ones. Any failure leaves
// the shown scene and the pick.

#include "tests/support/test.h"

#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include "gui/click/comparison_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/recent_files.h"
#include "gui/shell/overlay_bars.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <glm/geometric.hpp>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

const QByteArray kTriangleObj = "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n";

QByteArray triangleStl(int triangles)
{
    QByteArray text = "solid many\n";
    for (int i = 0; i < triangles; ++i) {
        const QByteArray x = QByteArray::number(i % 1000), y = QByteArray::number(i / 1000);
        text += "facet normal 0 0 1\nouter loop\nvertex " + x + ' ' + y + " 0\nvertex " + x + ".5 " + y + " 0\nvertex "
                + x + ' ' + y + ".5 0\nendloop\nendfacet\n";
    }
    return text + "endsolid many\n";
}

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

QStringList namesOf(const SceneDocument &document)
{
    QStringList names;
    for (const SceneObject &object : document.objects())
        names << QString::fromStdString(object.name);
    return names;
}

bool openAndWait(MainWindow &window, const QStringList &files)
{
    std::vector<std::filesystem::path> paths;
    for (const QString &file : files)
        paths.push_back(pathOf(file));
    window.session().openFiles(std::move(paths));
    return QTest::qWaitFor([&window] { return !window.session().isLoading(); }, kPatienceMilliseconds);
}

/// The state that must stay when an opening fails.
struct State {
    explicit State(MainWindow &window)
        : objects(window.document().objects()), setup(window.document().setup()),
          pick(window.document().picks().pick()), title(window.windowTitle())
    {
    }
    std::vector<SceneObject> objects;
    Setup setup;
    std::optional<Pick> pick;
    QString title;

    bool isThatOf(MainWindow &window) const
    {
        const State now(window);
        const auto same = [](const LookAt &a, const LookAt &b) {
            return a.eye.coordinates() == b.eye.coordinates() && a.center.coordinates() == b.center.coordinates()
                   && a.up == b.up;
        };
        if (objects.size() != now.objects.size() || title != now.title
            || !(setup.projection() == now.setup.projection()) || !same(setup.camera(), now.setup.camera())
            || pick.has_value() != now.pick.has_value())
            return false;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            if (objects[i].model != now.objects[i].model)
                return false;
        }
        return !pick
               || (pick->hit() == now.pick->hit()
                   && pick->point.world[Method::Formula]->coordinates()
                          == now.pick->point.world[Method::Formula]->coordinates());
    }
};

} // namespace

class TestOpenFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        redirectSettings();
        QVERIFY(m_folder.isValid());
    }

    void init() { QSettings().clear(); }

    void aNamedFileIsShown()
    {
        const auto window = shownWindow(false, {500, 400});
        QVERIFY(openAndWait(*window, {write(QStringLiteral("triangle.obj"), kTriangleObj)}));
        QCOMPARE(namesOf(window->document()), QStringList{QStringLiteral("triangle.obj")});
        QVERIFY(window->windowTitle().startsWith(QStringLiteral("triangle.obj")));
        QVERIFY(window->message().isEmpty());
        QVERIFY(!window->session().isLoading());
        // It can be clicked: the triangle lies in z = 0.
        click(window->view(), localOf(*window, {0.5, 0.5, 0.0}));
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        QVERIFY(glm::length(window->document().picks().pick()->point.world[Method::Formula]->coordinates()
                            - glm::dvec3(0.5, 0.5, 0.0))
                < 0.02);
    }

    void aDroppedFileIsShown()
    {
        const auto window = shownWindow(false, {500, 400});
        SceneView &view = window->view();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(write(QStringLiteral("dropped file.obj"), kTriangleObj))});
        QSignalSpy ended(&window->session(), &Session::loadingEnded);
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &drop);
        QVERIFY(drop.isAccepted());
        QVERIFY(ended.wait(kPatienceMilliseconds));
        QCOMPARE(namesOf(window->document()), QStringList{QStringLiteral("dropped file.obj")});

        // Dropped text is not a file.
        QMimeData text;
        text.setText(QStringLiteral("words"));
        QDragEnterEvent refused(QPoint(50, 50), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
        refused.ignore();
        QCoreApplication::sendEvent(&view, &refused);
        QVERIFY(!refused.isAccepted());
    }

    void severalFilesAreOneScene()
    {
        const auto window = shownWindow(false, {500, 400});
        QVERIFY(openAndWait(
            *window, {write(QStringLiteral("b.obj"), kTriangleObj), write(QStringLiteral("a.stl"), triangleStl(2))}));
        QCOMPARE(namesOf(window->document()), (QStringList{QStringLiteral("b.obj"), QStringLiteral("a.stl")}));
        QVERIFY(window->message().isEmpty());
    }

    void theGoodOfSeveralFilesAreShownAndTheBrokenNamed()
    {
        const auto window = shownWindow(false, {500, 400});
        const QString good = write(QStringLiteral("good.obj"), kTriangleObj),
                      other = write(QStringLiteral("other.stl"), triangleStl(2));
        const QString broken = write(QStringLiteral("broken.obj"), "v 0 0 0\nf 1 2 9\n");
        QVERIFY(openAndWait(*window, {good, broken, other}));
        QCOMPARE(namesOf(window->document()), (QStringList{QStringLiteral("good.obj"), QStringLiteral("other.stl")}));
        QVERIFY(window->message().contains(QStringLiteral("broken.obj")));
        QVERIFY(!window->message().contains(QStringLiteral("good.obj")));
        QVERIFY(!window->message().contains(QStringLiteral("other.stl")));
    }

    void aBrokenFileChangesNothing_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<QString>("reason");

        QByteArray truncated(80, ' ');
        truncated +=
            QByteArray::fromHex("0a000000") + QByteArray(120, '\0'); // ten triangles announced, two and a bit there
        newRow("truncated binary STL") << "cut.stl" << truncated << "damaged";
        newRow("truncated ASCII STL") << "cut_text.stl" << triangleStl(3).left(150) << "damaged";
        newRow("OBJ face without such a vertex")
            << "index.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n") << "7";
        newRow("empty file") << "empty.ply" << QByteArray() << "empty";
        newRow("PLY without triangles") << "none.ply"
                                        << QByteArray("ply\nformat ascii 1.0\nelement vertex 0\nproperty float "
                                                      "x\nproperty float y\nproperty float z\nelement face 0\n"
                                                      "property list uchar int vertex_indices\nend_header\n")
                                        << "neither triangles nor points";
        newRow("NaN vertex")
            << "nan.ply"
            << QByteArray("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                          "z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n")
            << "vertex 1 is NaN, infinite, or beyond 3.4e38";
        newRow("unknown suffix") << "notes.doc" << QByteArray("words\n") << "OBJ, STL, PLY, OFF, glTF or GLB";
        newRow("a text, not of landmarks") << "notes.txt" << QByteArray("words\n") << "there is no column x";
        newRow("no suffix") << "model" << QByteArray("words\n") << "OBJ, STL, PLY, OFF, glTF or GLB";
        newRow("words in an OFF") << "words.off" << QByteArray("not a model at all\n") << "damaged";
        newRow("words in a GLB") << "words.glb" << QByteArray("not a model at all\n") << "damaged";
        newRow("missing file") << "missing.obj" << QByteArray("(none)") << "no such file";
        newRow("folder") << "folder.obj" << QByteArray("(folder)") << "folder";
    }

    void aBrokenFileChangesNothing()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, reason);
        QString path = m_folder.filePath(name);
        if (content == "(folder)")
            QVERIFY(QDir().mkpath(path));
        else if (content != "(none)")
            path = write(name, content);

        const auto window = shownWindow(false, {500, 400});
        openObjects(window->document(), cubeScene());
        click(window->view(), localOf(*window, kCubeCenter));
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        turnWheel(window->view(), QPointF(100.0, 100.0), 1);
        const State before(*window);
        QSignalSpy failures(window.get(), &MainWindow::openFailed);
        QVERIFY(openAndWait(*window, {path}));
        QCOMPARE(failures.count(), 1);
        QVERIFY2(window->message().contains(name), qPrintable(window->message()));
        QVERIFY2(window->message().contains(reason), qPrintable(window->message()));
        QVERIFY2(!window->message().contains(QStringLiteral("%1")) && !window->message().contains(QStringLiteral("%2")),
                 qPrintable(window->message()));
        QVERIFY(before.isThatOf(*window));
        QVERIFY(!window->session().isLoading());
    }

    void aMessageGoesWithTheNextFile()
    {
        const auto window = shownWindow(false, {500, 400});
        QVERIFY(openAndWait(*window, {m_folder.filePath(QStringLiteral("nowhere.obj"))}));
        QVERIFY(!window->message().isEmpty());
        QVERIFY(openAndWait(*window, {write(QStringLiteral("triangle.obj"), kTriangleObj)}));
        QVERIFY(window->message().isEmpty());
    }

    void cancelEndsLoadingAndChangesNothing_data()
    {
        addColumn<bool>("isByKey");
        newRow("its button") << false;
        newRow("Esc") << true;
    }

    void cancelEndsLoadingAndChangesNothing()
    {
        QFETCH(bool, isByKey);
        const auto window = shownWindow(false, {500, 400});
        window->activateWindow(); // keys are for the active one
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        openObjects(window->document(), cubeScene());
        click(window->view(), localOf(*window, kCubeCenter));
        const State before(*window);
        QSignalSpy ended(&window->session(), &Session::loadingEnded);
        std::vector<std::filesystem::path> files;
        for (const QString &file : bigFiles())
            files.push_back(pathOf(file));
        QSignalSpy noticed(&window->session(), &Session::noticed);
        window->session().openFiles(files);
        auto *bar = window->findChild<LoadingBar *>();
        QVERIFY(bar);
        QVERIFY(QTest::qWaitFor([&] { return bar->isVisible(); }, kPatienceMilliseconds));
        QVERIFY(window->session().isLoading());
        auto *cancel = bar->findChild<QPushButton *>();
        const QPoint place = cancel->mapTo(window.get(), cancel->rect().center());
        QSignalSpy progressed(&window->session(), &Session::loadingProgressed);
        if (isByKey)
            QTest::keyClick(&window->view(), Qt::Key_Escape);
        else
            QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatienceMilliseconds);
        QVERIFY2(progressed.size() < static_cast<int>(files.size()), "the other files are read all the same");
        QVERIFY(!window->session().isLoading());
        QVERIFY(bar->isHidden());
        QCOMPARE(noticed.count(), 1);
        QCOMPARE(noticed.at(0).at(0).toString(),
                 QStringLiteral("Opening of big.stl and 49 more cancelled. The scene is as it was."));
        // A click that was meant for the button does not fall on the view.
        QVERIFY(window->childAt(place) != &window->view());
        QTRY_COMPARE_WITH_TIMEOUT(window->childAt(place), &window->view(), kPatienceMilliseconds);
        QVERIFY(before.isThatOf(*window));
        QTest::qWait(300); // nothing comes after it
        QCOMPARE(ended.count(), 1);
        QVERIFY(bar->isHidden());
        QVERIFY(window->message().isEmpty());
        QVERIFY(before.isThatOf(*window));
    }

    void theBarStaysUntilThePictureIsThere()
    {
        const auto window = shownWindow(false, {500, 400});
        auto *bar = window->findChild<LoadingBar *>();
        const auto *cancel = bar->findChild<QPushButton *>();
        emit window->session().loadingStarted();
        emit window->session().loadingProgressed(QStringLiteral("scan.ply"), 0.5);
        QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), kPatienceMilliseconds);
        const QRect place = bar->geometry();
        openObjects(window->document(), cubeScene());
        emit window->session().loadingEnded();
        QVERIFY2(bar->isVisible(), "the cube is not drawn yet");
        QVERIFY(bar->findChild<QLabel *>()->text().startsWith(QStringLiteral("Drawing")));
        QVERIFY(cancel->isHidden());
        bar->parentWidget()->layout()->activate();
        QCOMPARE(bar->geometry(), place);
        QTRY_VERIFY_WITH_TIMEOUT(bar->isHidden(), kPatienceMilliseconds);
        QVERIFY(window->childAt(bar->parentWidget()->mapTo(window.get(), place.center())) != &window->view());

        // A file without anything to draw needs no waiting.
        emit window->session().loadingStarted();
        QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), kPatienceMilliseconds);
        QVERIFY(!cancel->isHidden());
        emit window->session().loadingEnded();
        QVERIFY(bar->isHidden());
    }

    void aSecondLoadingTakesTheFirstOnesPlace()
    {
        const auto window = shownWindow(false, {500, 400});
        const QString small = write(QStringLiteral("small.obj"), kTriangleObj);
        std::vector<std::filesystem::path> files;
        for (const QString &file : bigFiles())
            files.push_back(pathOf(file));
        QSignalSpy progressed(&window->session(), &Session::loadingProgressed);
        window->session().openFiles(files);
        QTRY_VERIFY_WITH_TIMEOUT(!progressed.isEmpty(), kPatienceMilliseconds);
        QVERIFY(window->session().isLoading());
        window->session().openFiles({pathOf(small)});
        QVERIFY(QTest::qWaitFor([&] { return !window->session().isLoading(); }, kPatienceMilliseconds));
        QCOMPARE(namesOf(window->document()), QStringList{QStringLiteral("small.obj")});
        QTest::qWait(300);
        QCOMPARE(namesOf(window->document()), QStringList{QStringLiteral("small.obj")});
        QVERIFY(window->message().isEmpty());
        QVERIFY(window->findChild<LoadingBar *>()->isHidden());
    }

    void theWindowClosesWhileLoading()
    {
        for (const int reports : {0, 1, 5}) {
            auto window = shownWindow(false, {500, 400});
            std::vector<std::filesystem::path> files;
            for (const QString &file : bigFiles())
                files.push_back(pathOf(file));
            QSignalSpy progressed(&window->session(), &Session::loadingProgressed);
            window->session().openFiles(files);
            QTRY_VERIFY_WITH_TIMEOUT(progressed.size() >= reports, kPatienceMilliseconds);
            QVERIFY(window->session().isLoading());
            QVERIFY(window->close());
            window.reset(); // waits for the thread, which ends at its next report
            QCoreApplication::processEvents();
        }
    }

    void recentFilesAreRemembered()
    {
        MainWindow::Options options;
        options.smoothEdges = false;
        const QString first = write(QStringLiteral("first.obj"), kTriangleObj),
                      second = write(QStringLiteral("second & third.obj"), kTriangleObj);
        const QString broken = write(QStringLiteral("broken.obj"), "f 1 2 3\n");
        const auto recentMenu = [](MainWindow &window) {
            for (QMenu *menu : window.findChildren<QMenu *>()) {
                if (menu->title() == QStringLiteral("Open &Recent"))
                    return menu;
            }
            return static_cast<QMenu *>(nullptr);
        };
        const auto native = [](const QStringList &files) {
            QStringList clean;
            for (const QString &file : files)
                clean << QDir::fromNativeSeparators(file);
            return clean;
        };
        {
            MainWindow window(options);
            QVERIFY(recentMenu(window));
            QVERIFY(!recentMenu(window)->isEnabled());
            QVERIFY(openAndWait(window, {first}));
            QVERIFY(openAndWait(window, {second, broken}));
            QCOMPARE(native(recentFiles()), (QStringList{second, first}));
            QVERIFY(openAndWait(window, {first})); // again: to the front, not twice
            QCOMPARE(native(recentFiles()), (QStringList{first, second}));
            QVERIFY(window.close());
        }
        {
            MainWindow window(options); // the next day
            QMenu *menu = recentMenu(window);
            QVERIFY(menu->isEnabled());
            QVERIFY(menu->actions().at(1)->text().startsWith(QStringLiteral("second && third.obj – ")));
            QSignalSpy ended(&window.session(), &Session::loadingEnded);
            menu->actions().at(1)->trigger();
            QVERIFY(ended.wait(kPatienceMilliseconds));
            QCOMPARE(namesOf(window.document()), QStringList{QStringLiteral("second & third.obj")});
            menu->actions().last()->trigger(); // clear
            QVERIFY(recentFiles().isEmpty());
            QVERIFY(!menu->isEnabled());
        }
        for (int i = 0; i < 15; ++i)
            addRecentFile(QStringLiteral("/models/%1.obj").arg(i));
        QCOMPARE(recentFiles().size(), 10);
        QCOMPARE(recentFiles().first(), QStringLiteral("/models/14.obj"));
    }

    void aWindowThatRemembersNothingLeavesTheSettingsAlone()
    {
        const auto window = shownWindow(false, {500, 400});
        QVERIFY(openAndWait(*window, {write(QStringLiteral("triangle.obj"), kTriangleObj)}));
        part<ComparisonPanel>(*window).setShowsFloat(true);
        QVERIFY(window->close());
        QVERIFY(QSettings().allKeys().isEmpty());
    }

    void namesInOtherScriptsOpen()
    {
        const auto window = shownWindow(false, {500, 400});
        const QString name = QString::fromUtf8("模型 – ёлка.obj");
        const QString path = write(name, kTriangleObj);
        if (!QFile::exists(path) || QFile::decodeName(QFile::encodeName(name)) != name)
            QSKIP("this locale has no such file names");
        QVERIFY(openAndWait(*window, {path}));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QCOMPARE(namesOf(window->document()), QStringList{name});
    }

private:
    QString write(const QString &name, const QByteArray &content)
    {
        QString path = m_folder.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("%s cannot be written", qPrintable(path));
        return path;
    }

    /// Takes long enough to be cancelled: the same big file many times over.
    QStringList bigFiles()
    {
        if (!m_big.isEmpty())
            return m_big;
        m_big << write(QStringLiteral("big.stl"), triangleStl(300000));
        for (int i = 1; i < 50; ++i) { // each is a separate file, since a file named again is not read again
            m_big << m_folder.filePath(QStringLiteral("big%1.stl").arg(i));
            std::filesystem::create_hard_link(pathOf(m_big[0]), pathOf(m_big[i]));
        }
        return m_big;
    }

    QTemporaryDir m_folder;
    QStringList m_big;
};

UNPROJECTOR_TEST(TestOpenFiles, display)
#include "test_open_files.moc"
