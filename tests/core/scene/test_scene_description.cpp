// A window's scene and its file agree, wherever the file is saved.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"

#include "tests/support/unprojecting.h"

#include "tests/core/parsed_scenes.h"
#include "tests/core/scene_texts.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QTemporaryDir>

#include <fstream>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace scene_texts;
using namespace unprojector::mesh;

class TestSceneDescription : public QObject {
    Q_OBJECT

private slots:
    void aWindowsSceneSurvivesASave()
    {
        const auto model = std::make_shared<Model>();
        model->name = "Teapot";
        Scene scene;
        scene.camera = {{1, 2, 3}, {0, 0.5, 0}, {0, 1, 0}};
        scene.home = {{5, 5, 5}, {0, 0, 0}, {0, 1, 0}};
        scene.projection = Perspective{0.7, 1.5, 0.25, 40};
        scene.viewport = {ViewportRule::Kind::KeepAspect, {1, 2, 30, 40}, 1.25};
        scene.depthRange = {1, 0};
        scene.objects = {{"a", "/there/models/a.obj", model, {Scale{{2, 2, 2}}}}, {"pot", {}, model, {}, true}};
        scene.clipPlanes = {{1, 0, 0, 0.5}};
        scene.clipPlanesOff = {{0, {0, 1, 0, 0.125}}};
        scene.landmarks.unit = "mm";
        scene.landmarks.landmarks.resize(2);
        scene.landmarks.landmarks[0].world = WorldPoint(0.1, 0.2, 0.3);
        scene.landmarks.landmarks[0].extra.edit() = {{"sex", "f"}};
        scene.clipDistancesFitObjects = false;
        for (const bool follows : {true, false}) {
            scene.projectionFollowsViewport = follows;
            const Setup setup = setupOf(scene, {1001, 751, 1.25}, {}).value();
            SceneFile file = sceneFileFrom(scene, setup, "/there/scene.json");
            QVERIFY(file.objects[0].file == std::filesystem::path("models") / "a.obj");
            QCOMPARE(file.objects[1].bundled, "Teapot");
            file = parsed(written(file));

            // Another program sees the window's picture.
            const Setup shown = byParameters(setupOf(file)).value();
            QVERIFY(shown.surface == setup.surface && shown.viewport == setup.viewport);
            QVERIFY(shown.projection() == setup.projection() && shown.depthRange == setup.depthRange);
            QVERIFY(shown.camera() == setup.camera());

            const Scene again =
                sceneFromFile(file, "/there/scene.json", objectsWith(model, file, "/there/scene.json")).value();
            QVERIFY(again.camera == scene.camera && again.home == scene.home);
            QVERIFY(again.viewport == scene.viewport && again.depthRange == scene.depthRange);
            QCOMPARE(again.projectionFollowsViewport, follows);
            QVERIFY(!again.clipDistancesFitObjects);
            QVERIFY(setupOf(again, setup.surface, {}).value().projection() == setup.projection());
            QVERIFY(again.objects[0].file == scene.objects[0].file && again.objects[1].file.empty());
            QVERIFY(again.objects[0].transform == scene.objects[0].transform);
            QVERIFY(!again.objects[0].isHidden && again.objects[1].isHidden);
            QVERIFY(again.clipPlanes == scene.clipPlanes);
            QVERIFY(again.landmarks == scene.landmarks);
            QCOMPARE(again.clipPlanesOff.size(), std::size_t(1));
            QVERIFY(again.clipPlanesOff[0].index == 0 && again.clipPlanesOff[0].plane == scene.clipPlanesOff[0].plane);
        }

        // A scene without a file has absolute paths, and a bundled model has none.
        const SceneFile unnamed = sceneFileFrom(scene, setupOf(scene, {100, 75, 1}, {}).value(), {});
        QVERIFY(unnamed.objects[0].file.is_absolute());
        QVERIFY(unnamed.objects[1].file.empty() && unnamed.objects[1].bundled == "Teapot");
    }

    void aSceneSavedElsewhereKeepsUnknownKeys_data()
    {
        addColumn<QString>("target");
        addColumn<bool>("isAbsolute");
        addColumn<QString>("path"); // expected in the file
        newRow("the same file") << "here/scene.json" << false << "models/a.obj";
        newRow("the folder above") << "scene.json" << false << "here/models/a.obj";
        newRow("another folder") << "there/other.json" << false << "../here/models/a.obj";
        newRow("beside the model") << "here/models/scene.json" << false << "a.obj";
        newRow("absolute path, the same file") << "here/scene.json" << true << "models/a.obj";
        newRow("absolute path, another folder") << "there/other.json" << true << "../here/models/a.obj";
    }

    void aSceneSavedElsewhereKeepsUnknownKeys()
    {
        QFETCH(QString, target);
        QFETCH(bool, isAbsolute);
        QFETCH(QString, path);
        const QTemporaryDir folder;
        for (const char *name : {"here/models", "there"})
            QVERIFY(QDir(folder.path()).mkpath(name));
        const std::filesystem::path root(folder.path().toStdU16String());
        const std::filesystem::path source = root / "here" / "scene.json";

        Json marked = Json::parse(kFullScene);
        marked["objects"][0]["file"] =
            isAbsolute ? (folder.path() + "/here/models/a.obj").toStdString() : "models/a.obj";
        const std::size_t marks = mark(marked);
        QCOMPARE(marks, std::size_t(22));
        marked["objects"][0]["mark"] = "of the first object";
        QFile file(folder.filePath("here/scene.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(marked.dump()));
        file.close();

        const auto model = std::make_shared<Model>();
        model->name = "Teapot";
        const SceneFile before = readSceneFile(source).value();
        const Scene scene = sceneFromFile(before, source, objectsWith(model, before, source)).value();
        const std::filesystem::path written = root / target.toStdU16String();
        const SceneFile after = sceneFileFrom(scene, setupOf(scene, {801, 599, 1.25}, {}).value(), written);
        QVERIFY(writeSceneFile(written, after).hasValue());
        const SceneFile again = readSceneFile(written).value();
        const Json json = Json::parse(sceneText(again).value());
        marked["objects"][0]["file"] = path.toStdString();
        QVERIFY2(marksIn(json, marked) == marks, json.dump(2).c_str());
        QVERIFY(json["objects"][0]["mark"] == "of the first object");
        QCOMPARE(QString::fromStdString(json["objects"][0]["file"]), path);
    }

    void unknownKeysGoWithTheirObject()
    {
        const SceneFile file = parsed(changed(
            "\"window\"",
            R"("author": "A", "viewport": {"x": 0, "y": 0, "width": 800, "height": 600}, "conventions": "opengl",
        "objects": [{"name": "a", "file": "a.obj", "colour": "red"}, {"name": "b", "file": "a.obj"}],
        "ui": {"clipPlanesOff": [{"place": 0, "plane": [0, 0, 1, 2], "by": "hand"}]}, "window")"));
        Scene scene =
            sceneFromFile(file, "scene.json", objectsWith(std::make_shared<Model>(), file, "scene.json")).value();
        scene.objects[0].name = "other name";
        std::swap(scene.objects[0], scene.objects[1]);
        const Setup setup = setupOf(scene, {800, 600, 1}, {}).value();
        const Json json = Json::parse(sceneText(sceneFileFrom(scene, setup, "there.json")).value());
        QVERIFY(json["author"] == "A");
        QVERIFY(json.contains("viewport") && json["conventions"] == "opengl");
        QVERIFY(json["objects"][1]["colour"] == "red" && !json["objects"][0].contains("colour"));
        QVERIFY(json["ui"]["clipPlanesOff"][0]["by"] == "hand");
        // A click has the numbers of its picture alone.
        const Click click = clickOf(pickAt(setup, {50, 37}, {0.5, 0}).value(), scene);
        const Json clicked = Json::parse(sceneText(click.scene).value());
        QVERIFY(!clicked.contains("author") && !clicked.contains("conventions"));
        QVERIFY(!clicked["objects"][1].contains("colour"));
    }

    void whatNoWindowDrawsIsRefusedWithItsKey_data()
    {
        addColumn<QByteArray>("members");
        addColumn<QByteArray>("message"); // nothing: it is drawn
        const auto row = [](const char *name, const char *members, const char *message) {
            newRow(name) << QByteArray(members) << QByteArray(message);
        };
        row("a fraction", R"("viewport": {"x": 0, "y": 5.5, "width": 80, "height": 60})",
            "s.json: viewport.y: 5.5 is not a whole number of pixels");
        row("too wide", R"("viewport": {"x": 0, "y": 0, "width": 16385, "height": 60})",
            "s.json: viewport.width: 16385 pixels are too many; use at most 16384");
        row("a fraction that the rule leaves unused",
            R"("viewport": {"x": 0, "y": 5.5, "width": 80, "height": 60}, "ui": {"viewportRule": {"kind": "wholeWindow"}})",
            "");
        row("a fraction of the rule's",
            R"("ui": {"viewportRule": {"kind": "fixed", "fixed": {"x": -0.5, "y": 5, "width": 80, "height": 60}}})",
            "s.json: ui.viewportRule.fixed.x: -0.5 is not a whole number of pixels");
        row("near below 0", R"("depthRange": [-0.25, 1])",
            "s.json: depthRange[0]: the depth is -0.25; it must lie between 0 and 1");
        row("far above 1", R"("depthRange": [0, 1.5])",
            "s.json: depthRange[1]: the depth is 1.5; it must lie between 0 and 1");
        row("one end in single precision", R"("depthRange": [0.5, 0.500000001])",
            "s.json: depthRange: both ends of the depth range are 0.5; they must differ");
        row("out of reach", R"("objects": [{"file": "a"}, {"file": "b", "transform": [{"translate": [0, 3e200, 0]}]}])",
            "s.json: objects[1].transform: an object reaches to 3e+200, farther than can be computed; check its scales "
            "and "
            "translations");
    }

    void whatNoWindowDrawsIsRefusedWithItsKey()
    {
        QFETCH(QByteArray, members);
        QFETCH(QByteArray, message);
        const SceneFile file = parsed(changed("\"window\"", members + ", \"window\""));
        const auto model = std::make_shared<Model>();
        model->bounds = {glm::dvec3(-1.0), glm::dvec3(1.0)};
        const auto scene = sceneFromFile(file, "folder/s.json", objectsWith(model, file, "folder/s.json"));
        QCOMPARE(scene ? QByteArray() : QByteArray::fromStdString(scene.error().message()), message);
    }

    void aModelBehindALinkStaysTheSame_data()
    {
        addColumn<QString>("model");  // as the scene is given it
        addColumn<QString>("target"); // where the scene is written
        addColumn<QString>("path");   // expected in the file
        // far/folder/m.obj and far/m.obj are there, and m.obj; link leads to far/folder.
        newRow("in a linked folder") << "link/m.obj"
                                     << "scene.json"
                                     << "link/m.obj";
        newRow("above a linked folder") << "link/../m.obj"
                                        << "scene.json"
                                        << "far/m.obj";
        newRow("below a folder, above a linked one") << "link/deep/../../m.obj"
                                                     << "scene.json"
                                                     << "far/m.obj";
        newRow("no link") << "far/../m.obj"
                          << "scene.json"
                          << "m.obj";
        newRow("a linked model") << "linked.obj"
                                 << "scene.json"
                                 << "linked.obj";
        newRow("a missing model") << "none/../missing.obj"
                                  << "scene.json"
                                  << "missing.obj";
        newRow("the scene in a linked folder") << "m.obj"
                                               << "link/scene.json"
                                               << "../../m.obj";
        newRow("the scene and the model in a linked folder") << "link/m.obj"
                                                             << "link/scene.json"
                                                             << "m.obj";
        newRow("the scene in a linked folder, the model in its own") << "far/folder/m.obj"
                                                                     << "link/scene.json"
                                                                     << "m.obj";
        newRow("a linked model seen from a linked folder") << "linked.obj"
                                                           << "link/scene.json"
                                                           << "../../linked.obj";
    }

    void aModelBehindALinkStaysTheSame()
    {
        QFETCH(QString, model);
        QFETCH(QString, target);
        QFETCH(QString, path);
#ifdef Q_OS_WIN
        QSKIP("Windows goes up from a link to the folder that it lies in");
#endif
        const QTemporaryDir folder;
        const std::filesystem::path root(folder.path().toStdU16String());
        QVERIFY(QDir(folder.path()).mkpath("far/folder/deep"));
        for (const char *name : {"m.obj", "far/m.obj", "far/folder/m.obj"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        std::filesystem::create_directory_symlink(std::filesystem::path("far") / "folder", root / "link");
        std::filesystem::create_symlink("m.obj", root / "linked.obj");

        Scene scene;
        scene.objects = {{"m", root / model.toStdU16String(), std::make_shared<Model>(), {}}};
        const std::filesystem::path sceneFile = root / target.toStdU16String();
        const Setup setup = setupOf(scene, {100, 75, 1}, {}).value();
        const SceneFile written = sceneFileFrom(scene, setup, sceneFile);
        QCOMPARE(QString::fromStdU16String(written.objects[0].file.generic_u16string()), path);
        const std::filesystem::path read = objectFile(written.objects[0], sceneFile);
        if (std::filesystem::exists(scene.objects[0].file))
            QVERIFY(std::filesystem::equivalent(read, scene.objects[0].file));
        else
            QVERIFY(!std::filesystem::exists(read));
    }

    /// A recovered scene names its models from the folder that it was saved in.
    void theFolderOfTheSceneMayBeGone()
    {
        const QTemporaryDir dir;
        const std::filesystem::path root(dir.path().toStdU16String());
        std::ofstream(root / "model.obj") << "v 0 0 0";
        SceneFileObject object;
        object.file = "../../model.obj";
        const std::filesystem::path sceneFile = root / "gone" / "deeper" / "scene.json";
        QVERIFY(std::filesystem::equivalent(objectFile(object, sceneFile), root / "model.obj"));
        object.file = "../../missing.obj";
        QVERIFY(objectFile(object, sceneFile) == root / "gone" / "deeper" / object.file);
    }

    /// A scene has the typed numbers, a click the numbers used for drawing. A depth that was read at
    /// the far end is in the range of the click's scene, and not of the other one.
    void theDepthRangeOfAClickIsInSinglePrecision()
    {
        Scene scene;
        scene.depthRange = {0.0, 0.3};
        const DepthRange drawn{0.0, double(0.3f)};
        const Setup shown = setupOf(scene, {100, 75, 1}, {}).value();
        QVERIFY(shown.depthRange == drawn);
        const SceneFile saved = parsed(written(sceneFileFrom(scene, shown, "scene.json")));
        QVERIFY(saved.depthRange == scene.depthRange);
        QVERIFY(sceneFromFile(saved, "scene.json", {}).value().depthRange == scene.depthRange);

        const DepthSample sample{drawn.atFar, 0};
        const Click click = clickOf(pickAt(shown, {50, 37}, sample).value(), scene);
        QVERIFY(click.scene.depthRange == drawn);
        QVERIFY(pickAt(setupOf(click.scene), {50, 37}, sample).hasValue());
        const Result<Pick> refused = pickAt(setupOf(saved), {50, 37}, sample);
        QVERIFY(!refused && refused.error().code == ErrorCode::DepthOutsideRange);
    }

    void withoutUiTheFilesNumbersHold()
    {
        const Scene scene = sceneFromFile(parsed(kLeastScene), "scene.json", {}).value();
        QVERIFY(!scene.projectionFollowsViewport && !scene.clipDistancesFitObjects);
        QVERIFY(scene.viewport.kind == ViewportRule::Kind::WholeWindow);
        QVERIFY(scene.home == scene.camera);
        const auto rule = [](const QByteArray &viewport) {
            return sceneFromFile(parsed(withMember("\"viewport\": " + viewport)), "scene.json", {}).value().viewport;
        };
        QVERIFY(rule(R"({"x": 0, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::WholeWindow);
        QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::Fixed);
        QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").fixed == (Viewport{1, 0, 800, 600}));
        const auto perspective = parsed(withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})"));
        QVERIFY(sceneFromFile(perspective, "scene.json", {}).value().projectionFollowsViewport);
    }

    void aWindowShowsWhatMatricesOfItsCamerasSay()
    {
        // glFrustum(-1, 1, -0.75, 0.75, 1, 9), and the view from (0, 0, 5.5).
        QByteArray text = withProjection(
            R"({"type": "matrix", "matrix": [1,0,0,0, 0,1.3333333333333333,0,0, 0,0,-1.25,-1, 0,0,-2.25,0]})");
        text.replace(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})",
                     "{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.5,1]}");
        const Scene scene = sceneFromFile(parsed(text), "scene.json", {}).value();
        QVERIFY(scene.projection == Projection(Frustum{-1, 1, -0.75, 0.75, 1, 9}));
        QVERIFY(scene.camera == (LookAt{{0, 0, 5.5}, {0, 0, 2.5}, {0, 1, 0}}));
        const auto refused = sceneFromFile(parsed(withProjection(kMatrix)), "scene.json", {});
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(), "scene.json: projection.matrix: the projection matrix has no known form: "
                                            "0.1 is in row 3, column 1");
    }
};

UNPROJECTOR_TEST(TestSceneDescription)
#include "test_scene_description.moc"
