// What a scene file says is what is read, and what is read can be written and read again; whatever is wrong with one is
// told with its place.

#include "core/cli/scene_error_text.h"
#include "core/scene_file.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

using namespace unprojector;

namespace {

/// Every key, with numbers that no key has by default and that no other key has.
const char *const kFullScene = R"({
  "unprojector": 1,
  "window": {"width": 641, "height": 479, "devicePixelRatio": 1.25},
  "viewport": {"x": 3, "y": 5.5, "width": 640, "height": 480},
  "depthRange": [0.9, 0.1],
  "projection": {"type": "frustum", "left": -1.1, "right": 1.2, "bottom": -0.75, "top": 0.8, "near": 0.1, "far": 1e5},
  "view": {"eye": [0.1, 0.2, 5.3], "center": [1, 2, 3], "up": [0, 1, 0.5]},
  "objects": [
    {"name": "face", "file": "models/face.obj",
     "transform": [{"translate": [0, 0, -3]}, {"rotate": [30, 0, 1, 0]}, {"scale": [1, 2, -1]}]},
    {"name": "Gr\u00fcn", "bundled": "Teapot", "transform": []}
  ],
  "clipPlanes": [[0, 1, 0, 0], [1, 0, 0, -0.25]],
  "ui": {
    "viewportRule": {"kind": "keepAspect", "aspect": 1.5, "fixed": {"x": 1, "y": 2, "width": 3, "height": 4}},
    "projectionFollowsViewport": true,
    "clipDistancesFitObjects": false,
    "home": {"eye": [9, 8, 7], "center": [0, 0, 0], "up": [0, 1, 0]},
    "clipPlanesOff": [{"place": 1, "plane": [0, 0, 1, 2]}]
  }
})";

const char *const kLeastScene = R"({
  "unprojector": 1,
  "window": {"width": 800, "height": 600},
  "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}
})";

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

QByteArray messageFor(const QByteArray &text)
{
    const auto scene = parseScene(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
    return scene ? QByteArray("it was read") : QByteArray::fromStdString(sceneErrorText(scene.error()));
}

/// The least scene with one piece of it replaced.
QByteArray changed(const char *from, const char *to)
{
    QByteArray text(kLeastScene);
    const qsizetype at = text.indexOf(from);
    if (at < 0)
        qFatal("the scene has no %s", from);
    return text.replace(at, qsizetype(strlen(from)), to);
}

QByteArray withProjection(const char *projection)
{
    return changed(R"({"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100})", projection);
}

QByteArray withView(const char *view)
{
    return changed(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})", view);
}

/// Of no form that the formulas know: its near plane is tilted.
const char *const kMatrix = R"({"type": "matrix", "matrix": [1.5,0,0.1,0, 0,2,0.3,0, 0,0,-1.25,-1, 0,0,-2.25,0]})";

QByteArray withMember(const QByteArray &member)
{
    return changed("\"unprojector\": 1,", ("\"unprojector\": 1, " + member + ",").constData());
}

bool isSame(const LookAt &a, const LookAt &b)
{
    return a.eye.coordinates() == b.eye.coordinates() && a.center.coordinates() == b.center.coordinates() && a.up == b.up;
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
    void unknownKeysAreKept();
    void aTextForPeople();
    void everyDoubleSurvives();
    void degreesSurvive();
    void malformedScenesAreRefusedWithTheirPlace_data();
    void malformedScenesAreRefusedWithTheirPlace();
    void noTruncationIsAccepted();
    void noByteBroken();
    void hugeFilesAreRefusedAtOnce();
    void manyKeysTakeNoTime();
    void filesAreReadAndWritten();
    void writingReplacesWholeFilesOnly();
    void aNameThatIsNotUtf8IsRefused();
    void aWindowsSceneSurvivesASave();
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

    const PictureGeometry geometry = pictureGeometry(scene);
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
    QVERIFY(pictureGeometry(scene).viewport == (Viewport{0, 0, 800, 600}));
    QVERIFY(!scene.ui.viewportRule && !scene.ui.home && !scene.ui.projectionFollowsViewport);
}

void TestSceneFile::anglesAreDegrees()
{
    const auto perspective = parsed(withProjection(R"({"type": "perspective", "fovy": 90, "aspect": 2, "near": 1, "far": 9})"));
    QVERIFY(std::get<Projection>(perspective.projection) == Projection(Perspective{std::numbers::pi / 2, 2, 1, 9}));
    const auto oblique = parsed(withProjection(
        R"({"type": "oblique", "left": -1, "right": 1, "bottom": -2, "top": 2, "near": -3, "far": 3, "theta": 45, "phi": 90})"));
    QVERIFY(std::get<Projection>(oblique.projection) == Projection(Oblique{{-1, 1, -2, 2, -3, 3}, std::numbers::pi / 4, std::numbers::pi / 2}));
}

void TestSceneFile::aPerspectiveWithoutAspectTakesTheViewports()
{
    const char *const projection = R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})";
    SceneFile scene = parsed(withProjection(projection));
    QCOMPARE(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect, 800.0 / 600.0);
    QVERIFY(!written(scene).contains("aspect"));
    QByteArray text = withProjection(projection);
    text.replace("\"unprojector\": 1,", R"("unprojector": 1, "viewport": {"x": 0, "y": 0, "width": 300, "height": 100},)");
    scene = parsed(text);
    QCOMPARE(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect, 3.0);
}

void TestSceneFile::whatIsReadIsWrittenAndReadAgain_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("every key") << QByteArray(kFullScene);
    QTest::newRow("as little as can be") << QByteArray(kLeastScene);
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBF").append(kLeastScene);
    QTest::newRow("perspective") << withProjection(R"({"type": "perspective", "fovy": 33.3, "aspect": 1.7, "near": 1, "far": 9})");
    QTest::newRow("perspective without aspect") << withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})");
    QTest::newRow("oblique") << withProjection(R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1,
                                                   "near": 1, "far": 9, "theta": 44.690708, "phi": 135})");
    QTest::newRow("extreme numbers") << withProjection(R"({"type": "ortho", "left": -1.7976931348623157e308, "right": 5e-324,
                                                          "bottom": -0.0, "top": 9007199254740993, "near": 0.1, "far": 0.30000000000000004})");
    QTest::newRow("matrix") << withProjection(kMatrix);
    QTest::newRow("matrix of [0, 1]") << QByteArray(withProjection(kMatrix)).replace("\"matrix\", ", "\"matrix\", \"ndcDepth\": [0, 1], ");
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

void TestSceneFile::unknownKeysAreKept()
{
    const char *const text = R"({
      "unprojector": 1, "author": "A", "nested": {"deep": [1, 2.5, null, true]},
      "window": {"width": 800, "height": 600, "title": "W"},
      "viewport": {"x": 0, "y": 0, "width": 80, "height": 60, "why": "V"},
      "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "lens": "P"},
      "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0], "taken": "E"},
      "objects": [{"file": "a.obj", "colour": [1, 0, 0]}],
      "ui": {"theme": "dark"}
    })";
    const SceneFile scene = parsed(text);
    const auto json = nlohmann::ordered_json::parse(written(scene).toStdString());
    QVERIFY(json["author"] == "A");
    QVERIFY(json["nested"] == nlohmann::ordered_json::parse(R"({"deep": [1, 2.5, null, true]})"));
    QVERIFY(json["window"]["title"] == "W");
    QVERIFY(json["viewport"]["why"] == "V");
    QVERIFY(json["projection"]["lens"] == "P");
    QVERIFY(json["view"]["taken"] == "E");
    QVERIFY(json["objects"][0]["colour"] == nlohmann::ordered_json::parse("[1, 0, 0]"));
    QVERIFY(json["ui"]["theme"] == "dark");
    // The keys that are known come first, in their own order.
    QCOMPARE(json.begin().key(), "unprojector");
    QCOMPARE(std::prev(json.end()).key(), "nested");

    // A change of the projection's type leaves nothing of the old one.
    SceneFile other = scene;
    other.projection = Projection(Perspective{1, 1.5, 1, 9});
    const auto otherJson = nlohmann::ordered_json::parse(written(other).toStdString());
    QVERIFY(!otherJson["projection"].contains("left") && otherJson["projection"]["lens"] == "P");
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
        scene.objects.push_back({"", "a.obj", "", {Translate{v}}, {}});
    }
    const SceneFile again = parsed(written(scene));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        QVERIFY(again.objects[i].transform == scene.objects[i].transform);
}

void TestSceneFile::degreesSurvive()
{
    for (int tenths = 1; tenths < 1800; ++tenths) {
        const QByteArray degrees = QByteArray::number(tenths / 10.0);
        const QByteArray text = withProjection("{\"type\": \"perspective\", \"fovy\": " + degrees + ", \"near\": 1, \"far\": 9}");
        QVERIFY2(written(parsed(text)).contains("\"fovy\": " + degrees + ","), degrees);
    }
}

void TestSceneFile::malformedScenesAreRefusedWithTheirPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *name, const QByteArray &text, const char *message) {
        QTest::newRow(name) << text << QByteArray("scene.json") + message;
    };
    row("no bytes", "", ": the file is empty");
    row("blanks only", " \r\n\t", ": the file is empty");
    row("no JSON", "hello", ":1:1: while parsing value - invalid literal");
    row("binary", QByteArray("\0\1\2\3", 4), ":1:1: unexpected zero byte");
    row("zero byte behind", QByteArray(kLeastScene).append('\0').append("x"), ":6:2: unexpected zero byte");
    row("cut off", "{\n \"unprojector\": 1,\n", ":3:1: while parsing object key - unexpected end of input; expected string literal");
    row("comma missing", "{\"a\": 1\n \"b\": 2}", ":2:4: while parsing object - unexpected string literal; expected '}'");
    row("something behind", QByteArray(kLeastScene) + "x", ":6:2: while parsing value - invalid literal; expected end of input");
    row("not UTF-8", "{\"a\": \"\xFF\"}", ":1:8: while parsing value - invalid string: ill-formed UTF-8 byte");
    row("NaN", changed("\"near\": 1", "\"near\": NaN"), ":4:91: while parsing value - invalid literal");
    row("1e400", changed("\"near\": 1", "\"near\": 1e400"), ":4:91: 1e400 is too large for a number");
    row("-1e400", changed("\"near\": 1", "\"near\": -1e400"), ":4:91: -1e400 is too large for a number");
    row("10 000 brackets", QByteArray(10000, '['), ":1:65: brackets are nested deeper than 64 levels");
    row("10 000 objects", QByteArray("{\"a\":").repeated(10000), ":1:321: brackets are nested deeper than 64 levels");
    row("a key twice", changed("\"near\": 1", "\"near\": 1,\n \"near\": 2"), ":5:2: the key \"near\" stands here for the second time");
    row("an escaped key twice", "{\"a\\\"\": 1, \"\\u0061\\\"\": 2}", ":1:12: the key \"a\"\" stands here for the second time");
    row("an unknown key twice", withMember("\"x\": {\"y\": 1, \"y\": 2}"), ":2:35: the key \"y\" stands here for the second time");

    row("a list", "[]", ": expected an object in { }, found a list in [ ]");
    row("another JSON file", "{\"asset\": {}}", ": unprojector: is missing");
    row("a later version", changed("\"unprojector\": 1", "\"unprojector\": 2"), ": unprojector: version 2 cannot be read, only version 1");
    row("no window", changed("\"window\"", "\"widow\""), ": window: is missing");
    row("width a text", changed("800", "\"800\""), ": window.width: expected a number, found \"800\"");
    row("width with a fraction", changed("800", "800.5"), ": window.width: 800.5 must be a whole number");
    row("width 0", changed("800", "0"), ": window.width: 0 must lie between 1 and 65536");
    row("width huge", changed("800", "1e300"), ": window.width: 1e+300 must lie between 1 and 65536");
    row("pixel ratio 0", changed("600}", "600, \"devicePixelRatio\": 0}"), ": window.devicePixelRatio: 0 must be greater than 0");
    row("pixel ratio huge", changed("600}", "600, \"devicePixelRatio\": 1e9}"), ": window.devicePixelRatio: 1e+09 must lie between 0.0008333333333333334 and 81.92");
    row("viewport a list", withMember("\"viewport\": [0, 0, 8, 6]"), ": viewport: expected an object in { }, found a list in [ ]");
    row("viewport empty", withMember(R"("viewport": {"x": 0, "y": 0, "width": 8, "height": 0})"), ": viewport.height: the size 8 x 0 is empty; width and height must be greater than 0");
    row("depth range empty", withMember("\"depthRange\": [1, 1]"), ": depthRange: both ends are 1; they must differ");
    row("depth range of three", withMember("\"depthRange\": [0, 1, 2]"), ": depthRange: has 3 elements; it must have 2");
    row("no projection", changed("\"projection\"", "\"Projection\""), ": projection: is missing");
    row("projection null", withProjection("null"), ": projection: expected an object in { }, found null");
    row("projection unknown", withProjection("{\"type\": \"fisheye\"}"), ": projection.type: \"fisheye\" must be frustum, ortho, perspective, oblique or matrix");
    row("near missing", changed("\"near\": 1, ", ""), ": projection.near: is missing");
    row("near null", changed("\"near\": 1", "\"near\": null"), ": projection.near: expected a number, found null");
    row("near 0", changed("\"ortho\"", "\"frustum\"").replace("\"near\": 1,", "\"near\": 0,"), ": projection.near: 0 must be greater than 0");
    row("near behind far", changed("\"near\": 1", "\"near\": 100"), ": projection.near: 100 must be smaller than far (100)");
    row("left equals right", changed("\"left\": -1", "\"left\": 1"), ": projection.left: 1 must differ from right");
    row("fovy 180", withProjection(R"({"type": "perspective", "fovy": 180, "near": 1, "far": 9})"), ": projection.fovy: 180 must lie between 0 and 180 degrees");
    row("aspect negative", withProjection(R"({"type": "perspective", "fovy": 18, "aspect": -1, "near": 1, "far": 9})"), ": projection.aspect: -1 must be greater than 0");
    row("phi 0", withProjection(R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "theta": 45, "phi": 0})"), ": projection.phi: 0 must lie between 0 and 180 degrees");
    row("matrix of 15", withProjection(R"({"type": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]})"), ": projection.matrix: has 15 elements; it must have 16");
    row("matrix in rows", withProjection(R"({"type": "matrix", "matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"), ": projection.matrix: has 4 elements; it must have 16");
    row("matrix without inverse", withProjection(R"({"type": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1]})"), ": projection.matrix: the matrix has no inverse");
    row("NDC depth of another kind", QByteArray(withProjection(kMatrix)).replace("\"matrix\", ", "\"matrix\", \"ndcDepth\": [0, 2], "), ": projection.ndcDepth: [0,2] must be [-1, 1] or [0, 1]");
    row("view matrix a number", withView("{\"matrix\": 1}"), ": view.matrix: expected a list of 16 numbers, column by column, found a number");
    row("eye of two numbers", changed("[0, 0, 5]", "[0, 0]"), ": view.eye: has 2 elements; it must have 3");
    row("eye with a text", changed("[0, 0, 5]", "[0, 0, \"5\"]"), ": view.eye[2]: expected a number, found \"5\"");
    row("eye at the center", changed("[0, 0, 5]", "[0, 0, 0]"), ": view.center: must be another point than the eye");
    row("up along the view", changed("[0, 1, 0]", "[0, 0, 2]"), ": view.up: must not point along the view direction");
    row("object a text", withMember("\"objects\": [\"a.obj\"]"), ": objects[0]: expected an object in { }, found \"a.obj\"");
    row("object without file", withMember("\"objects\": [{\"file\": \"a\"}, {\"name\": \"b\"}]"), ": objects[1].file: is missing");
    row("object of two sources", withMember("\"objects\": [{\"file\": \"a\", \"bundled\": \"b\"}]"), ": objects[0]: must have exactly one of file or bundled");
    row("file name empty", withMember("\"objects\": [{\"file\": \"\"}]"), ": objects[0].file: this is no name of a file");
    row("file name with a zero byte", withMember("\"objects\": [{\"file\": \"a\\u0000b\"}]"), ": objects[0].file: this is no name of a file");
    row("step unknown", withMember(R"("objects": [{"file": "a", "transform": [{"shear": [1]}]}])"), ": objects[0].transform[0]: must have exactly one of translate, rotate or scale");
    row("step of two", withMember(R"("objects": [{"file": "a", "transform": [{"scale": [1, 1, 1], "translate": [1, 1, 1]}]}])"), ": objects[0].transform[0]: must have exactly one of translate, rotate or scale");
    row("rotation of three", withMember(R"("objects": [{"file": "a", "transform": [{"translate": [0, 0, 0]}, {"rotate": [30, 0, 1]}]}])"), ": objects[0].transform[1].rotate: has 3 elements; it must have 4");
    row("axis without length", withMember(R"("objects": [{"file": "a", "transform": [{"rotate": [30, 0, 0, 0]}]}])"), ": objects[0].transform[0].rotate: the axis (0, 0, 0) has no direction");
    row("scale 0", withMember(R"("objects": [{"file": "a", "transform": [{"scale": [1, 0, 1]}]}])"), ": objects[0].transform[0].scale: a factor is 0; it must differ from 0");
    row("clip plane of three", withMember("\"clipPlanes\": [[0, 1, 0]]"), ": clipPlanes[0]: has 3 elements; it must have 4");
    row("clip plane without normal", withMember("\"clipPlanes\": [[0, 1, 0, 0], [0, 0, 0, 1]]"), ": clipPlanes[1]: the first three numbers are all 0; one of them must differ from 0");
    row("seven clip planes", withMember("\"clipPlanes\": [[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0]]"), ": clipPlanes: has 7 elements; there may be at most 6");
    row("ui a number", withMember("\"ui\": 1"), ": ui: expected an object in { }, found a number");
    row("rule unknown", withMember("\"ui\": {\"viewportRule\": {\"kind\": \"half\"}}"), ": ui.viewportRule.kind: \"half\" must be wholeWindow, fixed, keepAspect or quarter");
    row("rule's aspect 0", withMember("\"ui\": {\"viewportRule\": {\"kind\": \"keepAspect\", \"aspect\": 0}}"), ": ui.viewportRule.aspect: 0 must be greater than 0");
    row("flag a number", withMember("\"ui\": {\"clipDistancesFitObjects\": 1}"), ": ui.clipDistancesFitObjects: expected true or false, found a number");
    row("place of a plane", withMember("\"ui\": {\"clipPlanesOff\": [{\"place\": 7, \"plane\": [0, 1, 0, 0]}]}"), ": ui.clipPlanesOff[0].place: 7 must lie between 0 and 0");
}

void TestSceneFile::malformedScenesAreRefusedWithTheirPlace()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, message);
    const QByteArray found = messageFor(text);
    // The parser's own words are not ours to fix: its sentence may go on.
    if (message.contains("while parsing"))
        QVERIFY2(found.startsWith(message), found);
    else
        QCOMPARE(found, message);
}

void TestSceneFile::noTruncationIsAccepted()
{
    const QByteArray text(kFullScene);
    for (qsizetype length = 0; length < text.size(); ++length) {
        const QByteArray message = messageFor(text.left(length));
        QVERIFY2(message.startsWith("scene.json:"), message);
    }
}

void TestSceneFile::noByteBroken()
{
    // Any byte replaced by any of these: the file is read or refused, whatever else it says.
    const QByteArray text(kFullScene);
    for (qsizetype at = 0; at < text.size(); ++at) {
        for (const char byte : {'\0', '"', '{', ']', ',', '9', '-', 'e', '\xFF', '\\', '\n'}) {
            QByteArray broken = text;
            broken[at] = byte;
            QVERIFY(!messageFor(broken).isEmpty());
        }
    }
}

void TestSceneFile::hugeFilesAreRefusedAtOnce()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("huge.json");
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QByteArray line = QByteArray(1 << 20, ' ');
        for (int i = 0; i < 100; ++i)
            QCOMPARE(file.write(line), line.size());
    }
    QElapsedTimer timer;
    timer.start();
    const auto scene = readSceneFile(path.toStdString());
    QVERIFY(!scene && scene.error().code == SceneFileErrorCode::TooLarge);
    QCOMPARE(QByteArray::fromStdString(sceneErrorText(scene.error())), path.toUtf8() + ": a scene may have at most 8 MiB");
    QVERIFY(timer.elapsed() < 2000);
}

void TestSceneFile::manyKeysTakeNoTime()
{
    QByteArray members;
    for (int i = 0; i < 300000; ++i)
        members += "\"k" + QByteArray::number(i) + "\": 0,";
    members.chop(1);
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(messageFor(withMember("\"many\": {" + members + "}")), QByteArray("it was read"));
    // A search among the keys before for each key would take minutes.
    QVERIFY(timer.elapsed() < 10000);
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
        const ViewGeometry geometry = viewGeometry(scene, {1001, 751, 1.25}, {}).value();
        SceneFile file = sceneFileFrom(scene, geometry, "/there/scene.json");
        QVERIFY(file.objects[0].file == std::filesystem::path("models") / "a.obj");
        QCOMPARE(file.objects[1].bundled, "Teapot");
        file = parsed(written(file));

        // Another program sees what the window showed.
        const ViewGeometry shown = viewGeometry(pictureGeometry(file)).value();
        QVERIFY(shown.surface == geometry.surface && shown.viewport == geometry.viewport);
        QVERIFY(shown.projection == geometry.projection && shown.depthRange == geometry.depthRange);
        QVERIFY(isSame(shown.camera, geometry.camera));

        const Scene again = sceneFromFile(file, "/there/scene.json", {model, model}).value();
        QVERIFY(isSame(again.camera, scene.camera) && isSame(again.home, scene.home));
        QVERIFY(again.viewport == scene.viewport && again.depthRange == scene.depthRange);
        QCOMPARE(again.projectionFollowsViewport, follows);
        QVERIFY(!again.clipDistancesFitObjects);
        QVERIFY(viewGeometry(again, geometry.surface, {}).value().projection == geometry.projection);
        QVERIFY(again.objects[0].file == scene.objects[0].file && again.objects[1].file.empty());
        QVERIFY(again.objects[0].transform == scene.objects[0].transform);
        QVERIFY(again.clipPlanes == scene.clipPlanes);
        QCOMPARE(again.clipPlanesOff.size(), std::size_t(1));
        QVERIFY(again.clipPlanesOff[0].place == 0 && again.clipPlanesOff[0].plane == scene.clipPlanesOff[0].plane);
    }

    SceneFile before = parsed(kLeastScene);
    before.extra.document = {{"author", "A"}};
    before.objects = {{"a", std::filesystem::path("models") / "a.obj", "", {}, {{"colour", "red"}}}};
    const SceneFile kept = sceneFileFrom(scene, viewGeometry(scene, {100, 75, 1}, {}).value(), "/there/scene.json", before);
    QVERIFY(kept.extra.document["author"] == "A");
    QVERIFY(kept.objects[0].extra["colour"] == "red" && kept.objects[1].extra.is_null());
}

void TestSceneFile::withoutUiTheFilesNumbersHold()
{
    const Scene scene = sceneFromFile(parsed(kLeastScene), "scene.json", {}).value();
    QVERIFY(!scene.projectionFollowsViewport && !scene.clipDistancesFitObjects);
    QVERIFY(scene.viewport.kind == ViewportRule::Kind::WholeWindow);
    QVERIFY(isSame(scene.home, scene.camera));
    const auto rule = [](const QByteArray &viewport) {
        return sceneFromFile(parsed(withMember("\"viewport\": " + viewport)), "scene.json", {})->viewport;
    };
    QVERIFY(rule(R"({"x": 0, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::WholeWindow);
    QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").kind == ViewportRule::Kind::Fixed);
    QVERIFY(rule(R"({"x": 1, "y": 0, "width": 800, "height": 600})").fixed == (Viewport{1, 0, 800, 600}));
    const auto perspective = parsed(withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})"));
    QVERIFY(sceneFromFile(perspective, "scene.json", {})->projectionFollowsViewport);
}

void TestSceneFile::aWindowShowsWhatMatricesOfItsCamerasSay()
{
    // glFrustum(-1, 1, -0.75, 0.75, 1, 9), and the view from (0, 0, 5.5).
    QByteArray text = withProjection(R"({"type": "matrix", "matrix": [1,0,0,0, 0,1.3333333333333333,0,0, 0,0,-1.25,-1, 0,0,-2.25,0]})");
    text.replace(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})", "{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.5,1]}");
    const Scene scene = sceneFromFile(parsed(text), "scene.json", {}).value();
    QVERIFY(scene.projection == Projection(Frustum{-1, 1, -0.75, 0.75, 1, 9}));
    QVERIFY(isSame(scene.camera, {{0, 0, 5.5}, {0, 0, 2.5}, {0, 1, 0}}));
    const auto refused = sceneFromFile(parsed(withProjection(kMatrix)), "scene.json", {});
    QVERIFY(!refused && refused.error().code == ErrorCode::MatrixNotAProjection);
    QCOMPARE(refused.error().other, 2.0);
}

QTEST_GUILESS_MAIN(TestSceneFile)
#include "test_scene_file.moc"
