// Scenes saved from the window and opened in it again.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "gui/document/camera_looks.h"
#include "gui/view/scene_view.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;

class TestSceneFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void whatIsSavedOpensAgainAsItWas()
    {
        const auto window = shownWindow(false, {640, 480});
        window->session().openBundledScene();
        SceneDocument &document = window->document();
        QVERIFY(editProjection(document, {Frustum{-0.6, 0.4, -0.3, 0.5, 1.0, 60.0}, false, false}, {}));
        LookAt camera = document.scene().camera;
        camera.eye = WorldPoint(5.0, 1.0 / 3.0, 12.0);
        QVERIFY(editCamera(document, camera, {}));
        QVERIFY(editTransform(document, 1, {Rotate{33.3, {0.0, 0.0, 1.0}}}, {}));
        QVERIFY(editClipPlanes(document, {{0.0, 1.0, 0.0, -0.25}}, {}, {}));
        const Scene saved = document.scene();
        QVERIFY(window->session().saveScene(path("saved.json")));
        QVERIFY(!window->isWindowModified());

        window->session().openBundledScene();
        openAndWait(*window, path("saved.json"));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        const Scene &opened = document.scene();
        QVERIFY(opened.projection == saved.projection);
        QVERIFY(opened.projectionFollowsViewport == saved.projectionFollowsViewport);
        QVERIFY(opened.clipDistancesFitObjects == saved.clipDistancesFitObjects);
        QVERIFY(opened.camera->eye.coordinates() == saved.camera->eye.coordinates());
        QVERIFY(opened.clipPlanes == saved.clipPlanes);
        QCOMPARE(opened.objects.size(), saved.objects.size());
        for (std::size_t i = 0; i < opened.objects.size(); ++i) {
            QCOMPARE(opened.objects[i].name, saved.objects[i].name);
            QVERIFY(opened.objects[i].transform == saved.objects[i].transform);
            QCOMPARE(opened.objects[i].model->triangleCount(), saved.objects[i].model->triangleCount());
        }
        setCamera(document, document.scene().home);
        QVERIFY(window->isWindowModified());
    }

    void modelsAreFoundBesideTheScene()
    {
        write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("beside.json", R"({"unprojector": 1, "window": {"width": 300, "height": 200},
        "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
        "objects": [{"name": "t", "file": "triangle.obj", "transform": [{"translate": [0.25, 0, 0]}]}]})");
        const auto window = shownWindow(false, {640, 480});
        openAndWait(*window, path("beside.json"));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QCOMPARE(window->document().objects().size(), std::size_t(1));
        QVERIFY(window->document().objects()[0].transform == (std::vector<TransformStep>{Translate{{0.25, 0.0, 0.0}}}));
        const auto *ortho = std::get_if<Ortho>(&*window->document().scene().projection);
        QVERIFY(ortho && *ortho == (Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0}));
    }

    /// No window shows them yet, and none drops them.
    void landmarksStay()
    {
        const QByteArray landmarks =
            R"({"unit": "mm", "points": [{"name": "Nasion", "position": [0.1, 0.2, 0.3], "more": 1}]})";
        write("landmarks.json", R"({"unprojector": 1, "window": {"width": 300, "height": 200},
        "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, "landmarks": )"
                                    + landmarks + "}");
        const auto window = shownWindow(false, {640, 480});
        openAndWait(*window, path("landmarks.json"));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        LookAt camera = window->document().scene().camera;
        camera.eye = WorldPoint(1.0, 2.0, 7.0);
        QVERIFY(editCamera(window->document(), camera, {}));
        window->document().undoStack().undo();
        QVERIFY(window->session().saveScene(path("saved.json")));
        QFile file(m_folder.filePath("saved.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY2(text.contains(landmarks), text.constData());
    }

    void matricesStayUntilTheyAreChanged()
    {
        const QByteArray projection =
            "[1.1, 0, 0, 0, 0, 1.3333333333333333, 0, 0, 0.1, -0.3, -1.25, -1, 0, 0, -2.25, 0]";
        const QByteArray view = "[0.6, 0, 0.8, 0, 0, 1, 0, 0, -0.8, 0, 0.6, 0, 0.3333333333333333, -2.7, -5.1, 1]";
        write("matrices.json", R"({"unprojector": 1, "window": {"width": 300, "height": 200},
        "projection": {"type": "matrix", "matrix": )"
                                   + projection + R"(}, "view": {"matrix": )" + view + "}}");
        const auto window = shownWindow(false, {640, 480});
        openAndWait(*window, path("matrices.json"));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        const auto saved = [&] {
            window->statusBar()->clearMessage();
            if (!window->session().saveScene(path("matrices.json")))
                return QByteArray();
            QFile file(m_folder.filePath("matrices.json"));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QVERIFY(resized(*window, {700, 500}));
        QByteArray text = saved();
        QVERIFY2(text.contains(projection) && text.contains(view), text.constData());
        QVERIFY(window->statusBar()->currentMessage().isEmpty());

        setCamera(window->document(), {WorldPoint(1.0, 2.0, 7.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
        text = saved();
        QVERIFY2(text.contains(projection) && !text.contains(view), text.constData());
        QVERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("view")),
                 qPrintable(window->statusBar()->currentMessage()));
        window->document().undoStack().undo();
        text = saved();
        QVERIFY2(text.contains(projection) && text.contains(view), text.constData());

        setProjection(window->document(), Frustum{-1.0, 1.0, -0.5, 0.5, 1.0, 10.0});
        text = saved();
        QVERIFY2(!text.contains(projection) && text.contains(view), text.constData());
        QVERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("projection")),
                 qPrintable(window->statusBar()->currentMessage()));
    }

    void modelsOpenedByARelativeNameAreFoundAgain()
    {
        write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("elsewhere")));
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_folder.path()));
        const auto window = shownWindow(false, {640, 480});
        openAndWait(*window, "triangle.obj");
        QVERIFY(QDir::setCurrent(before));
        QVERIFY(window->session().saveScene(path("elsewhere/scene.json")));
        window->session().openBundledScene();
        openAndWait(*window, path("elsewhere/scene.json"));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QCOMPARE(window->document().objects().size(), std::size_t(1));
    }

    void aSceneThatCannotBeOpenedChangesNothing_data()
    {
        const QByteArray head =
            R"({"unprojector": 1, "window": {"width": 300, "height": 200}, "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, )";
        const QByteArray ortho =
            R"("projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9})";
        addColumn<QByteArray>("text");
        addColumn<QString>("named");
        newRow("cut off") << head << "bad.json";
        newRow("near is 0")
            << head
                   + R"("projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0, "far": 9}})"
            << "projection.near";
        newRow("a model that is not there") << head + ortho + R"(, "objects": [{"name": "a", "file": "nowhere.obj"}]})"
                                            << "nowhere.obj";
        newRow("an unknown bundled model") << head + ortho + R"(, "objects": [{"name": "a", "bundled": "Nessie"}]})"
                                           << "Nessie";
    }

    void aSceneThatCannotBeOpenedChangesNothing()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, named);
        write("bad.json", text);
        const auto window = shownWindow(false, {640, 480});
        window->session().openBundledScene();
        const glm::dvec3 eye = window->document().scene().camera->eye.coordinates();
        openAndWait(*window, path("bad.json"));
        QVERIFY2(window->message().contains(named), qPrintable(window->message()));
        QCOMPARE(window->document().objects().size(), std::size_t(5));
        QVERIFY(window->document().scene().camera->eye.coordinates() == eye);
    }

    void aFolderThatIsNotThereIsTold()
    {
        const auto window = shownWindow(false, {640, 480});
        window->session().openBundledScene();
        QVERIFY(!window->session().saveScene(path("no/such/folder/scene.json")));
        QVERIFY2(window->message().contains(QStringLiteral("scene.json")), qPrintable(window->message()));
    }

private:
    std::filesystem::path path(const QString &name) const
    {
        return std::filesystem::path(m_folder.filePath(name).toStdU16String());
    }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    static void openAndWait(MainWindow &window, const std::filesystem::path &file)
    {
        window.session().openFiles({file});
        QVERIFY(QTest::qWaitFor([&window] { return !window.session().isLoading(); }, kPatienceMilliseconds));
    }

    QTemporaryDir m_folder;
};

UNPROJECTOR_TEST(TestSceneFiles, display)
#include "test_scene_files.moc"
