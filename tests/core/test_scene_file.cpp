// What a scene file says is what is read, and what is read can be written and read again.

#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include "scene_texts.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace scene_texts;

namespace {

SceneFile parsed(const QByteArray &text)
{
    const auto scene = parseScene(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
    if (!scene)
        qFatal("%s", sceneErrorText(scene.error()).c_str());
    return *scene;
}

QByteArray written(const SceneFile &scene)
{
    return QByteArray::fromStdString(sceneText(scene).value());
}

using Json = nlohmann::ordered_json;

/// Puts a key that nobody knows into every object that has room for one.
/// @return how many there are
std::size_t mark(Json &json)
{
    std::size_t marks = 0;
    for (auto it = json.begin(); it != json.end(); ++it) {
        const bool isSteps = json.is_object() && it.key() == "transform";
        if (it->is_structured() && !isSteps)
            marks += mark(*it);
    }
    if (!json.is_object())
        return marks;
    json["mark"] = {{"deep", {1, 2.5, nullptr, true}}};
    return marks + 1;
}

/// How many marks stand where they stood.
std::size_t marksIn(const Json &json, const Json &marked)
{
    std::size_t marks = 0;
    if (marked.is_array()) {
        for (std::size_t i = 0; i < marked.size() && i < json.size(); ++i)
            marks += marksIn(json[i], marked[i]);
    }
    if (!marked.is_object() || !json.is_object())
        return marks;
    for (const auto &[key, value] : marked.items()) {
        if (key == "mark")
            marks += json.contains(key) && json[key] == value ? 1 : 0;
        else if (json.contains(key))
            marks += marksIn(json[key], value);
    }
    return marks;
}

bool isSame(const LookAt &a, const LookAt &b)
{
    return a.eye.coordinates() == b.eye.coordinates() && a.center.coordinates() == b.center.coordinates()
           && a.up == b.up;
}

} // namespace

class TestSceneFile : public QObject {
    Q_OBJECT

private slots:
    void everyKeyIsRead();
    void whatIsLeftOutHasItsDefault();
    void anglesAreDegrees();
    void aPerspectiveWithoutAspectTakesTheViewports();
    void whatIsReadIsWrittenAndReadAgain_data();
    void whatIsReadIsWrittenAndReadAgain();
    void unknownKeysAreKeptEverywhere_data();
    void unknownKeysAreKeptEverywhere();
    void nothingIsLeftOfAnotherProjection();
    void aTextForPeople();
    void everyDoubleSurvives();
    void degreesSurvive();
    void everyAngleSurvives();
    void radiansThatContradictTheDegreesAreRefused();
    void filesAreReadAndWritten();
    void writingReplacesWholeFilesOnly();
    void aNameThatIsNotUtf8IsRefused();
    void aWindowsSceneSurvivesASave();
    void aSceneSavedElsewhereKeepsUnknownKeys_data();
    void aSceneSavedElsewhereKeepsUnknownKeys();
    void withoutUiTheFilesNumbersHold();
    void aWindowShowsWhatMatricesOfItsCamerasSay();
};

void TestSceneFile::everyKeyIsRead()
{
    const SceneFile scene = parsed(kFullScene);
    QCOMPARE(scene.windowWidth, 641);
    QCOMPARE(scene.windowHeight, 479);
    QCOMPARE(scene.devicePixelRatio, 1.25);
    QVERIFY(scene.viewport == (Viewport{3, 5.5, 640, 480}));
    QVERIFY(scene.depthRange == (DepthRange{0.9, 0.1}));
    QVERIFY(std::get<Projection>(scene.projection) == Projection(Frustum{-1.1, 1.2, -0.75, 0.8, 0.1, 1e5}));
    QVERIFY(isSame(std::get<LookAt>(scene.view), {{0.1, 0.2, 5.3}, {1, 2, 3}, {0, 1, 0.5}}));
    QCOMPARE(scene.objects.size(), std::size_t(2));
    QCOMPARE(scene.objects[0].name, "face");
    QVERIFY(scene.objects[0].file == std::filesystem::path("models") / "face.obj");
    QVERIFY(scene.objects[0].transform
            == (std::vector<TransformStep>{Translate{{0, 0, -3}}, Rotate{30, {0, 1, 0}}, Scale{{1, 2, -1}}}));
    QCOMPARE(scene.objects[1].name, "Gr\xC3\xBCn");
    QCOMPARE(scene.objects[1].bundled, "Teapot");
    QVERIFY(scene.objects[1].file.empty());
    QVERIFY(scene.clipPlanes == (std::vector<glm::dvec4>{{0, 1, 0, 0}, {1, 0, 0, -0.25}}));
    QVERIFY(scene.ui.viewportRule == (ViewportRule{ViewportRule::Kind::KeepAspect, {1, 2, 3, 4}, 1.5}));
    QCOMPARE(scene.ui.projectionFollowsViewport, std::optional(true));
    QCOMPARE(scene.ui.clipDistancesFitObjects, std::optional(false));
    QVERIFY(isSame(scene.ui.home.value(), {{9, 8, 7}, {0, 0, 0}, {0, 1, 0}}));
    QCOMPARE(scene.ui.clipPlanesOff.size(), std::size_t(1));
    QCOMPARE(scene.ui.clipPlanesOff[0].place, std::size_t(1));
    QVERIFY(scene.ui.clipPlanesOff[0].plane == glm::dvec4(0, 0, 1, 2));

    const Picture geometry = pictureOf(scene);
    QVERIFY(geometry.surface == (Surface{801, 599, 1.25}));
    QVERIFY(geometry.viewport == *scene.viewport);
    QVERIFY(objectFile(scene.objects[0], "/there/scene.json") == std::filesystem::path("/there/models/face.obj"));
}

void TestSceneFile::whatIsLeftOutHasItsDefault()
{
    const SceneFile scene = parsed(kLeastScene);
    QCOMPARE(scene.devicePixelRatio, 1.0);
    QVERIFY(!scene.viewport && scene.objects.empty() && scene.clipPlanes.empty());
    QVERIFY(scene.depthRange == (DepthRange{0, 1}));
    QVERIFY(pictureOf(scene).viewport == (Viewport{0, 0, 800, 600}));
    QVERIFY(!scene.ui.viewportRule && !scene.ui.home && !scene.ui.projectionFollowsViewport);
}

void TestSceneFile::anglesAreDegrees()
{
    const auto perspective =
        parsed(withProjection(R"({"type": "perspective", "fovy": 90, "aspect": 2, "near": 1, "far": 9})"));
    QVERIFY(std::get<Projection>(perspective.projection) == Projection(Perspective{std::numbers::pi / 2, 2, 1, 9}));
    const auto oblique = parsed(withProjection(
        R"({"type": "oblique", "left": -1, "right": 1, "bottom": -2, "top": 2, "near": -3, "far": 3, "theta": 45, "phi": 90})"));
    QVERIFY(std::get<Projection>(oblique.projection)
            == Projection(Oblique{{-1, 1, -2, 2, -3, 3}, std::numbers::pi / 4, std::numbers::pi / 2}));
}

void TestSceneFile::aPerspectiveWithoutAspectTakesTheViewports()
{
    const char *const projection = R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})";
    SceneFile scene = parsed(withProjection(projection));
    QCOMPARE(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect, 800.0 / 600.0);
    QVERIFY(!written(scene).contains("aspect"));
    QByteArray text = withProjection(projection);
    text.replace("\"unprojector\": 1,",
                 R"("unprojector": 1, "viewport": {"x": 0, "y": 0, "width": 300, "height": 100},)");
    scene = parsed(text);
    QCOMPARE(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect, 3.0);
}

void TestSceneFile::whatIsReadIsWrittenAndReadAgain_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("every key") << QByteArray(kFullScene);
    QTest::newRow("as little as can be") << QByteArray(kLeastScene);
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBF").append(kLeastScene);
    QTest::newRow("perspective") << withProjection(
        R"({"type": "perspective", "fovy": 33.3, "aspect": 1.7, "near": 1, "far": 9})");
    QTest::newRow("perspective without aspect")
        << withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})");
    QTest::newRow("oblique") << withProjection(R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1,
                                                   "near": 1, "far": 9, "theta": 44.690708, "phi": 135})");
    QTest::newRow("extreme numbers") << withProjection(
        R"({"type": "ortho", "left": -1.7976931348623157e308, "right": 5e-324,
                                                          "bottom": -0.0, "top": 9007199254740993, "near": 0.1, "far": 0.30000000000000004})");
    QTest::newRow("matrix") << withProjection(kMatrix);
    QTest::newRow("matrix of [0, 1]")
        << QByteArray(withProjection(kMatrix)).replace("\"matrix\", ", "\"matrix\", \"ndcDepth\": [0, 1], ");
    QTest::newRow("view matrix") << withView("{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.1,1]}");
    QTest::newRow("unknown keys") << withMember(R"("by": {"a": [1, {"b": null}]}, "ui": {"theme": "dark"})");
}

void TestSceneFile::whatIsReadIsWrittenAndReadAgain()
{
    QFETCH(QByteArray, text);
    const SceneFile first = parsed(text);
    const QByteArray saved = written(first);
    const SceneFile second = parsed(saved);
    QCOMPARE(written(second), saved);
    QCOMPARE(second.projection.index(), first.projection.index());
    if (const auto *matrix = std::get_if<MatrixProjection>(&first.projection)) {
        QVERIFY(std::get<MatrixProjection>(second.projection).clipFromEye == matrix->clipFromEye);
        QCOMPARE(std::get<MatrixProjection>(second.projection).ndcDepth, matrix->ndcDepth);
    } else {
        QVERIFY(std::get<Projection>(second.projection) == std::get<Projection>(first.projection));
    }
    if (const auto *matrix = std::get_if<glm::dmat4>(&first.view))
        QVERIFY(std::get<glm::dmat4>(second.view) == *matrix);
    else
        QVERIFY(isSame(std::get<LookAt>(second.view), std::get<LookAt>(first.view)));
    QVERIFY(second.viewport == first.viewport && second.depthRange == first.depthRange);
    QVERIFY(second.aspectFromViewport == first.aspectFromViewport);
    QVERIFY(second.ui.viewportRule == first.ui.viewportRule);
    QVERIFY(isSame(second.ui.home.value_or(LookAt{}), first.ui.home.value_or(LookAt{})));
    QCOMPARE(second.ui.clipPlanesOff.size(), first.ui.clipPlanesOff.size());
    QCOMPARE(second.objects.size(), first.objects.size());
    for (std::size_t i = 0; i < first.objects.size(); ++i) {
        QVERIFY(second.objects[i].file == first.objects[i].file && second.objects[i].name == first.objects[i].name);
        QVERIFY(second.objects[i].bundled == first.objects[i].bundled);
        QVERIFY(second.objects[i].transform == first.objects[i].transform);
    }
    QVERIFY(second.clipPlanes == first.clipPlanes);
}

void TestSceneFile::unknownKeysAreKeptEverywhere_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("every key") << QByteArray(kFullScene);
    QTest::newRow("perspective") << withProjection(
        R"({"type": "perspective", "fovy": 33.3, "aspect": 1.7, "near": 1, "far": 9})");
    QTest::newRow("oblique") << withProjection(R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1,
                                                   "near": 1, "far": 9, "theta": 44.690708, "phi": 135})");
    QTest::newRow("matrix") << withProjection(kMatrix);
    QTest::newRow("view matrix") << withView("{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.1,1]}");
}

void TestSceneFile::unknownKeysAreKeptEverywhere()
{
    QFETCH(QByteArray, text);
    Json marked = Json::parse(text.toStdString());
    const std::size_t marks = mark(marked);
    QVERIFY(marks >= 4);
    const SceneFile scene = parsed(QByteArray::fromStdString(marked.dump()));
    const Json again = Json::parse(written(scene).toStdString());
    QCOMPARE(marksIn(again, marked), marks);
    // Behind the keys that are known.
    QCOMPARE(again.begin().key(), "unprojector");
    QCOMPARE(std::prev(again.end()).key(), "mark");
    QCOMPARE(written(parsed(written(scene))), written(scene));
}

void TestSceneFile::nothingIsLeftOfAnotherProjection()
{
    SceneFile scene = parsed(withProjection(
        R"({"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "lens": "P"})"));
    scene.projection = Projection(Perspective{1, 1.5, 1, 9});
    const Json json = Json::parse(written(scene).toStdString());
    QVERIFY(!json["projection"].contains("left") && json["projection"]["lens"] == "P");
    // A key that meant nothing and now means something is written once.
    scene = parsed(withProjection(
        R"({"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "fovy": 12})"));
    scene.projection = Projection(Perspective{1, 1.5, 1, 9});
    QCOMPARE(written(scene).count("\"fovy\""), 1);
    QVERIFY(std::get<Projection>(parsed(written(scene)).projection) == Projection(Perspective{1, 1.5, 1, 9}));
}

void TestSceneFile::aTextForPeople()
{
    const QByteArray text = written(parsed(kFullScene));
    QVERIFY2(text.contains("\n  \"window\": {\"width\": 641, \"height\": 479, \"devicePixelRatio\": 1.25},\n"), text);
    QVERIFY2(text.contains("\n  \"depthRange\": [0.9, 0.1],\n"), text);
    QVERIFY2(text.contains("\"Gr\xC3\xBCn\""), text);
    for (const QByteArray &line : text.split('\n'))
        QVERIFY2(line.size() <= 120, line);
    QVERIFY(text.endsWith("}\n") && !text.contains('\t') && !text.contains('\r'));
}

void TestSceneFile::everyDoubleSurvives()
{
    SceneFile scene = parsed(kLeastScene);
    std::uint64_t bits = 0x123456789abcdef;
    for (int i = 0; i < 2000; ++i) {
        glm::dvec3 v(0.0);
        for (int k = 0; k < 3; ++k) {
            do
                bits = bits * 6364136223846793005u + 1442695040888963407u;
            while (!std::isfinite(std::bit_cast<double>(bits)));
            v[k] = std::bit_cast<double>(bits);
        }
        scene.objects.push_back({"", "a.obj", "", {Translate{v}}, {}, {}});
    }
    const SceneFile again = parsed(written(scene));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        QVERIFY(again.objects[i].transform == scene.objects[i].transform);
}

void TestSceneFile::degreesSurvive()
{
    for (int tenths = 1; tenths < 1800; ++tenths) {
        const QByteArray degrees = QByteArray::number(tenths / 10.0);
        const QByteArray text =
            withProjection("{\"type\": \"perspective\", \"fovy\": " + degrees + ", \"near\": 1, \"far\": 9}");
        QVERIFY2(written(parsed(text)).contains("\"fovy\": " + degrees + ","), degrees);
    }
}

void TestSceneFile::everyAngleSurvives()
{
    std::mt19937_64 random(20261121);
    std::uniform_real_distribution<double> angle(1e-3, std::numbers::pi - 1e-3);
    int withRadians = 0;
    for (int i = 0; i < 2000; ++i) {
        SceneFile scene = parsed(kLeastScene);
        const Oblique oblique{{-1, 1, -1, 1, 1, 9}, angle(random), angle(random)};
        scene.projection = Projection(oblique);
        const QByteArray text = written(scene);
        withRadians += text.count("Radians");
        QVERIFY2(std::get<Projection>(parsed(text).projection) == Projection(oblique), text);
    }
    // One in ten has no degrees that give it.
    QVERIFY2(withRadians > 200 && withRadians < 800, QByteArray::number(withRadians));
}

void TestSceneFile::radiansThatContradictTheDegreesAreRefused()
{
    const auto read = [](const char *angles) {
        const QByteArray text = withProjection(QByteArray("{\"type\": \"perspective\", ")
                                                   .append(angles)
                                                   .append(", \"aspect\": 1, \"near\": 1, \"far\": 9}")
                                                   .constData());
        return parseScene(text.toStdString(), "scene.json");
    };
    const auto fovyOf = [](const SceneFile &scene) {
        return std::get<Perspective>(std::get<Projection>(scene.projection)).verticalFovRadians;
    };
    QCOMPARE(fovyOf(*read(R"("fovy": 57.2957795, "fovyRadians": 1)")), 1.0); // shortened by another program
    const auto edited = read(R"("fovy": 45, "fovyRadians": 1)");
    QVERIFY(!edited);
    QCOMPARE(
        QByteArray::fromStdString(sceneErrorText(edited.error())),
        QByteArray("scene.json: projection.fovyRadians: 1 is not the angle of fovy, 45 degrees; remove the one that "
                   "does not hold"));
}

void TestSceneFile::filesAreReadAndWritten()
{
    QTemporaryDir folder;
    const std::filesystem::path directory(folder.path().toStdU16String());
    const std::filesystem::path file = directory / std::u8string(u8"Szene \u00e4.json");
    QVERIFY(writeSceneFile(file, parsed(kFullScene)).hasValue());
    const auto again = readSceneFile(file);
    QVERIFY(again.hasValue());
    QCOMPARE(written(*again), written(parsed(kFullScene)));

    const auto missing = readSceneFile(directory / "none.json");
    QVERIFY(!missing && missing.error().code == SceneFileErrorCode::NotFound);
    const auto isFolder = readSceneFile(directory);
    QVERIFY(!isFolder && isFolder.error().code == SceneFileErrorCode::IsDirectory);
    const auto toFolder = writeSceneFile(directory, parsed(kFullScene));
    QVERIFY(!toFolder && toFolder.error().code == SceneFileErrorCode::IsDirectory);
    const auto nowhere = writeSceneFile(directory / "none" / "a.json", parsed(kFullScene));
    QVERIFY(!nowhere && nowhere.error().code == SceneFileErrorCode::NotWritable);
}

void TestSceneFile::writingReplacesWholeFilesOnly()
{
    QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdU16String()) / "a.json";
    QVERIFY(writeSceneFile(file, parsed(kFullScene)).hasValue());
    QVERIFY(writeSceneFile(file, parsed(kLeastScene)).hasValue());
    QCOMPARE(written(readSceneFile(file).value()), written(parsed(kLeastScene)));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList("a.json"));

    // What cannot be written leaves what was there.
    SceneFile bad = parsed(kFullScene);
    bad.objects[0].name = "\xFF";
    QVERIFY(!writeSceneFile(file, bad).hasValue());
    QCOMPARE(written(readSceneFile(file).value()), written(parsed(kLeastScene)));
}

void TestSceneFile::aNameThatIsNotUtf8IsRefused()
{
    SceneFile scene = parsed(kFullScene);
    scene.objects[1].name = "\xC3(";
    const auto text = sceneText(scene);
    QVERIFY(!text && text.error().code == SceneFileErrorCode::NotUtf8);
    QCOMPARE(text.error().keyPath, "objects[1].name");
}

void TestSceneFile::aWindowsSceneSurvivesASave()
{
    const auto model = std::make_shared<Model>();
    model->name = "Teapot";
    Scene scene;
    scene.camera = {{1, 2, 3}, {0, 0.5, 0}, {0, 1, 0}};
    scene.home = {{5, 5, 5}, {0, 0, 0}, {0, 1, 0}};
    scene.projection = Perspective{0.7, 1.5, 0.25, 40};
    scene.viewport = {ViewportRule::Kind::KeepAspect, {1, 2, 30, 40}, 1.25};
    scene.depthRange = {1, 0};
    scene.objects = {{"a", "/there/models/a.obj", model, {Scale{{2, 2, 2}}}}, {"pot", {}, model, {}}};
    scene.clipPlanes = {{1, 0, 0, 0.5}};
    scene.clipPlanesOff = {{0, {0, 1, 0, 0.125}}};
    scene.clipDistancesFitObjects = false;
    for (const bool follows : {true, false}) {
        scene.projectionFollowsViewport = follows;
        const Picture geometry = pictureOf(scene, {1001, 751, 1.25}, {}).value();
        SceneFile file = sceneFileFrom(scene, geometry, "/there/scene.json");
        QVERIFY(file.objects[0].file == std::filesystem::path("models") / "a.obj");
        QCOMPARE(file.objects[1].bundled, "Teapot");
        file = parsed(written(file));

        // Another program sees what the window showed.
        const Picture shown = byParameters(pictureOf(file)).value();
        QVERIFY(shown.surface == geometry.surface && shown.viewport == geometry.viewport);
        QVERIFY(shown.projection() == geometry.projection() && shown.depthRange == geometry.depthRange);
        QVERIFY(isSame(shown.camera(), geometry.camera()));

        const Scene again = sceneFromFile(file, "/there/scene.json", {model, model}).value();
        QVERIFY(isSame(again.camera, scene.camera) && isSame(again.home, scene.home));
        QVERIFY(again.viewport == scene.viewport && again.depthRange == scene.depthRange);
        QCOMPARE(again.projectionFollowsViewport, follows);
        QVERIFY(!again.clipDistancesFitObjects);
        QVERIFY(pictureOf(again, geometry.surface, {}).value().projection() == geometry.projection());
        QVERIFY(again.objects[0].file == scene.objects[0].file && again.objects[1].file.empty());
        QVERIFY(again.objects[0].transform == scene.objects[0].transform);
        QVERIFY(again.clipPlanes == scene.clipPlanes);
        QCOMPARE(again.clipPlanesOff.size(), std::size_t(1));
        QVERIFY(again.clipPlanesOff[0].place == 0 && again.clipPlanesOff[0].plane == scene.clipPlanesOff[0].plane);
    }

    // Of a scene that has no file yet the paths are absolute, and a bundled model has none.
    const SceneFile unnamed = sceneFileFrom(scene, pictureOf(scene, {100, 75, 1}, {}).value(), {});
    QVERIFY(unnamed.objects[0].file == unnamed.objects[0].absoluteFile && unnamed.objects[0].file.is_absolute());
    QVERIFY(unnamed.objects[1].file.empty() && unnamed.objects[1].bundled == "Teapot");

    SceneFile before = parsed(kLeastScene);
    before.extra = {{"author", "A"}};
    before.objects = {{"a", std::filesystem::path("models") / "a.obj", "", {}, {{"colour", "red"}}, {}}};
    const SceneFile kept =
        sceneFileFrom(scene, pictureOf(scene, {100, 75, 1}, {}).value(), "/there/scene.json", before);
    QVERIFY(kept.extra["author"] == "A");
    QVERIFY(kept.objects[0].extra["colour"] == "red" && kept.objects[1].extra.is_null());
}

void TestSceneFile::aSceneSavedElsewhereKeepsUnknownKeys_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<bool>("isAbsolute");
    QTest::addColumn<QString>("path"); // of the object, as it is to be written
    QTest::newRow("the same file") << "here/scene.json" << false << "models/a.obj";
    QTest::newRow("the folder above") << "scene.json" << false << "here/models/a.obj";
    QTest::newRow("another folder") << "there/other.json" << false << "../here/models/a.obj";
    QTest::newRow("beside the model") << "here/models/scene.json" << false << "a.obj";
    QTest::newRow("absolute path, the same file") << "here/scene.json" << true << "models/a.obj";
    QTest::newRow("absolute path, another folder") << "there/other.json" << true << "../here/models/a.obj";
}

void TestSceneFile::aSceneSavedElsewhereKeepsUnknownKeys()
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
    marked["objects"][0]["file"] = isAbsolute ? (folder.path() + "/here/models/a.obj").toStdString() : "models/a.obj";
    const std::size_t marks = mark(marked);
    QCOMPARE(marks, std::size_t(12));
    marked["objects"][0]["mark"] = "of the first object";
    QFile file(folder.filePath("here/scene.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(marked.dump()));
    file.close();

    const auto model = std::make_shared<Model>();
    model->name = "Teapot";
    const SceneFile before = readSceneFile(source).value();
    const Scene scene = sceneFromFile(before, source, {model, model}).value();
    const std::filesystem::path written = root / target.toStdU16String();
    const SceneFile after = sceneFileFrom(scene, pictureOf(scene, {801, 599, 1.25}, {}).value(), written, before);
    QVERIFY(writeSceneFile(written, after).hasValue());
    const SceneFile again = readSceneFile(written).value();
    const Json json = Json::parse(sceneText(again).value());
    marked["objects"][0]["file"] = path.toStdString();
    QVERIFY2(marksIn(json, marked) == marks, json.dump(2).c_str());
    QVERIFY(json["objects"][0]["mark"] == "of the first object");
    QCOMPARE(QString::fromStdString(json["objects"][0]["file"]), path);
    QVERIFY(again.objects[0].absoluteFile == before.objects[0].absoluteFile);
    // And from there to where it was.
    const SceneFile back = sceneFileFrom(sceneFromFile(again, written, {model, model}).value(),
                                         pictureOf(scene, {801, 599, 1.25}, {}).value(), source, after);
    QVERIFY(back.objects[0].extra["mark"] == "of the first object");
}

void TestSceneFile::withoutUiTheFilesNumbersHold()
{
    const Scene scene = sceneFromFile(parsed(kLeastScene), "scene.json", {}).value();
    QVERIFY(!scene.projectionFollowsViewport && !scene.clipDistancesFitObjects);
    QVERIFY(scene.viewport.kind == ViewportRule::Kind::WholeWindow);
    QVERIFY(isSame(scene.home, scene.camera));
    const auto rule = [](const QByteArray &viewport) {
        return sceneFromFile(parsed(withMember("\"viewport\": " + viewport)), "scene.json", {}).value().viewport;
    };
    QVERIFY(rule(R"({"x": 0, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::WholeWindow);
    QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::Fixed);
    QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").fixed == (Viewport{1, 0, 800, 600}));
    const auto perspective = parsed(withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})"));
    QVERIFY(sceneFromFile(perspective, "scene.json", {}).value().projectionFollowsViewport);
}

void TestSceneFile::aWindowShowsWhatMatricesOfItsCamerasSay()
{
    // glFrustum(-1, 1, -0.75, 0.75, 1, 9), and the view from (0, 0, 5.5).
    QByteArray text = withProjection(
        R"({"type": "matrix", "matrix": [1,0,0,0, 0,1.3333333333333333,0,0, 0,0,-1.25,-1, 0,0,-2.25,0]})");
    text.replace(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})",
                 "{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.5,1]}");
    const Scene scene = sceneFromFile(parsed(text), "scene.json", {}).value();
    QVERIFY(scene.projection == Projection(Frustum{-1, 1, -0.75, 0.75, 1, 9}));
    QVERIFY(isSame(scene.camera, {{0, 0, 5.5}, {0, 0, 2.5}, {0, 1, 0}}));
    const auto refused = sceneFromFile(parsed(withProjection(kMatrix)), "scene.json", {});
    QVERIFY(!refused && refused.error().code == ErrorCode::MatrixNotAProjection);
    QCOMPARE(refused.error().other, 2.0);
}

QTEST_GUILESS_MAIN(TestSceneFile)
#include "test_scene_file.moc"
