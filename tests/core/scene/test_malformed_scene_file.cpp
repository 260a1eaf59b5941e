// Any error in a scene file is reported with its position, and soon.

#include "tests/support/test.h"

#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include "tests/core/scene_texts.h"

#include <QFile>
#include <QTemporaryDir>

#include <ctime>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace scene_texts;

namespace {

QByteArray messageFor(const QByteArray &text)
{
    const auto scene = parseScene(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
    return scene ? QByteArray("it was read") : QByteArray::fromStdString(sceneErrorText(scene.error()));
}

} // namespace

class TestMalformedSceneFile : public QObject {
    Q_OBJECT

private slots:
    void malformedScenesAreRefusedWithTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QByteArray("scene.json") + message;
        };
        row("no bytes", "", ": the file is empty");
        row("blanks only", " \r\n\t", ": the file is empty");
        row("no JSON", "hello", ":1:1: hello found where a value is expected");
        row("binary", QByteArray("\0\1\2\3", 4), ":1:1: unexpected zero byte");
        row("zero byte behind", QByteArray(kLeastScene).append('\0').append("x"), ":6:2: unexpected zero byte");
        row("cut off", "{\n \"unprojector\": 1,\n", ":3:1: the file ends too early; a bracket or a value is missing");
        row("comma missing", "{\"a\": 1\n \"b\": 2}", ":2:2: \"b\" found where \",\" or \"}\" is expected");
        row("something behind", QByteArray(kLeastScene) + "x", ":6:2: x follows the end");
        row("not UTF-8", "{\"a\": \"\xFF\"}", ":1:8: a byte here is not UTF-8; save the file as UTF-8");
        row("a line break in a text", "{\"a\": \"b\nc\"}",
            ":1:9: a text in quotes holds a line break, a tab or another control character; write \\n, \\t or \\u and "
            "its "
            "number");
        row("a path of Windows", "{\"a\": \"C:\\parts\"}",
            ":1:11: a text in quotes holds a backslash that JSON does not know; write \\\\ for a backslash");
        row("half a pair", "{\"a\": \"\\ud800\"}",
            ":1:14: half of a \\u surrogate pair is missing; write both halves or the character itself");
        row("no hexadecimal number", "{\"a\": \"\\u00g0\"}", ":1:12: \\u lacks its 4 hexadecimal digits");
        row("an open text", "{\"a\": \"b", ":1:9: a text in quotes does not end; close it with \"");
        row("a number that ends early", "{\"a\": -}", ":1:7: - is not a number; write one such as 1, -0.5 or 2e3");
        row("a key without quotes", "{a: 1}", ":1:2: a found where a key in double quotes is expected");
        row("an equals sign", "{\"a\" = 1}", ":1:6: = found where \":\" is expected");
        row("a comma missing in a list", "[1 2]", ":1:4: 2 found where \",\" or \"]\" is expected");
        row("a comma too many", "{\"a\": [1, ]}", ":1:11: ] found where a value is expected");
        row("a long word", "abcdefghijklmnopqrstuvwxyz0123456789",
            ":1:1: abcdefghijklmnopqrstuvwx… found where a value is expected");
        row("NaN", changed("\"near\": 1", "\"near\": NaN"), ":4:91: NaN found where a value is expected");
        row("1e400", changed("\"near\": 1", "\"near\": 1e400"), ":4:91: 1e400 is too large for a number");
        row("-1e400", changed("\"near\": 1", "\"near\": -1e400"), ":4:91: -1e400 is too large for a number");
        row("10 000 brackets", QByteArray(10000, '['), ":1:65: brackets are nested deeper than 64 levels");
        row("10 000 objects", QByteArray("{\"a\":").repeated(10000),
            ":1:321: brackets are nested deeper than 64 levels");
        row("a key twice", changed("\"near\": 1", "\"near\": 1,\n \"near\": 2"),
            ":5:2: the key \"near\" is here for the second time");
        row("an escaped key twice", "{\"a\\\"\": 1, \"\\u0061\\\"\": 2}",
            ":1:12: the key \"a\"\" is here for the second time");
        row("an unknown key twice", withMember("\"x\": {\"y\": 1, \"y\": 2}"),
            ":2:35: the key \"y\" is here for the second time");

        row("a list", "[]", ": expected an object in { }, found a list in [ ]");
        row("another JSON file", "{\"asset\": {}}", ": unprojector: is missing");
        row("a later version", changed("\"unprojector\": 1", "\"unprojector\": 2"),
            ": unprojector: version 2 cannot be read, only version 1");
        row("no window", changed("\"window\"", "\"widow\""), ": window: is missing");
        row("width a text", changed("800", "\"800\""), ": window.width: expected a number, found \"800\"");
        row("width with a fraction", changed("800", "800.5"), ": window.width: 800.5 must be a whole number");
        row("width 0", changed("800", "0"), ": window.width: 0 must lie between 1 and 65536");
        row("width huge", changed("800", "1e300"), ": window.width: 1e+300 must lie between 1 and 65536");
        row("pixel ratio 0", changed("600}", "600, \"devicePixelRatio\": 0}"),
            ": window.devicePixelRatio: the device pixel ratio is 0; it must be greater than 0");
        row("pixel ratio huge", changed("600}", "600, \"devicePixelRatio\": 1e9}"),
            ": window.devicePixelRatio: 1000000000 must lie between 0.0008333333333333334 and 81.92");
        row("point in no space", withMember(R"("point": {"space": "screen", "coordinates": [1, 2, 3]})"),
            ": point.space: \"screen\" must be object, world, eye, clip, ndc or window");
        row("clip point of three", withMember(R"("point": {"space": "clip", "coordinates": [1, 2, 3]})"),
            ": point.coordinates: has 3 elements; it must have 4");
        row("viewport a list", withMember("\"viewport\": [0, 0, 8, 6]"),
            ": viewport: expected an object in { }, found a list in [ ]");
        row("viewport empty", withMember(R"("viewport": {"x": 0, "y": 0, "width": 8, "height": 0})"),
            ": viewport.height: the viewport is 8 x 0 pixels; width and height must be greater than 0");
        row("depth range empty", withMember("\"depthRange\": [1, 1]"),
            ": depthRange: both ends of the depth range are 1; they must differ");
        row("depth range of three", withMember("\"depthRange\": [0, 1, 2]"),
            ": depthRange: has 3 elements; it must have 2");
        row("no projection", changed("\"projection\"", "\"Projection\""), ": projection: is missing");
        row("projection null", withProjection("null"), ": projection: expected an object in { }, found null");
        row("projection unknown", withProjection("{\"type\": \"fisheye\"}"),
            ": projection.type: \"fisheye\" must be frustum, ortho, perspective, oblique, pinhole or matrix");
        row("near missing", changed("\"near\": 1, ", ""), ": projection.near: is missing");
        row("near null", changed("\"near\": 1", "\"near\": null"), ": projection.near: expected a number, found null");
        row("near 0", changed("\"ortho\"", "\"frustum\"").replace("\"near\": 1,", "\"near\": 0,"),
            ": projection.near: near is 0; it must be greater than 0 and smaller than far (100)");
        row("near behind far", changed("\"near\": 1", "\"near\": 100"),
            ": projection.near: near is 100; it must be smaller than far (100)");
        row("left equals right", changed("\"left\": -1", "\"left\": 1"),
            ": projection.left: left and right are both 1; they must differ");
        row("fovy 180", withProjection(R"({"type": "perspective", "fovy": 180, "near": 1, "far": 9})"),
            ": projection.fovy: the vertical field of view is 180 degrees; it must lie between 0 and 180, both "
            "excluded");
        row("aspect negative",
            withProjection(R"({"type": "perspective", "fovy": 18, "aspect": -1, "near": 1, "far": 9})"),
            ": projection.aspect: the aspect is -1; it must be greater than 0");
        row("phi 0",
            withProjection(
                R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "theta": 45, "phi": 0})"),
            ": projection.phi: the angle is 0 degrees; it must lie between 0 and 180, both excluded");
        row("matrix of 15", withProjection(R"({"type": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]})"),
            ": projection.matrix: has 15 elements; it must have 16");
        row("matrix in rows",
            withProjection(R"({"type": "matrix", "matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"),
            ": projection.matrix: has 4 elements; it must have 16");
        row("matrix without inverse",
            withProjection(R"({"type": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1]})"),
            ": projection.matrix: the matrix has no inverse");
        row("NDC depth of another kind",
            QByteArray(withProjection(kMatrix)).replace("\"matrix\", ", "\"matrix\", \"ndcDepth\": [0, 2], "),
            ": projection.ndcDepth: [0,2] must be [-1, 1] or [0, 1]");
        row("view matrix a number", withView("{\"matrix\": 1}"),
            ": view.matrix: expected a list of 16 numbers, column by column, found a number");
        row("eye of two numbers", changed("[0, 0, 5]", "[0, 0]"), ": view.eye: has 2 elements; it must have 3");
        row("eye with a text", changed("[0, 0, 5]", "[0, 0, \"5\"]"), ": view.eye[2]: expected a number, found \"5\"");
        row("eye at the center", changed("[0, 0, 5]", "[0, 0, 0]"),
            ": view.center: eye and center are the same point; move one of them");
        row("up along the view", changed("[0, 1, 0]", "[0, 0, 2]"),
            ": view.up: up points along the view direction; choose another direction");
        row("object a text", withMember("\"objects\": [\"a.obj\"]"),
            ": objects[0]: expected an object in { }, found \"a.obj\"");
        row("object without file", withMember("\"objects\": [{\"file\": \"a\"}, {\"name\": \"b\"}]"),
            ": objects[1]: must have exactly one of file or bundled");
        row("hidden in words", withMember("\"objects\": [{\"file\": \"a\", \"hidden\": \"yes\"}]"),
            ": objects[0].hidden: expected true or false, found \"yes\"");
        row("object of two sources", withMember("\"objects\": [{\"file\": \"a\", \"bundled\": \"b\"}]"),
            ": objects[0]: must have exactly one of file or bundled");
        row("file name empty", withMember("\"objects\": [{\"file\": \"\"}]"),
            ": objects[0].file: this is not a name of a file");
        row("file name with a zero byte", withMember("\"objects\": [{\"file\": \"a\\u0000b\"}]"),
            ": objects[0].file: this is not a name of a file");
        row("step unknown", withMember(R"("objects": [{"file": "a", "transform": [{"shear": [1]}]}])"),
            ": objects[0].transform[0]: must have exactly one of translate, rotate or scale");
        row("step of two",
            withMember(R"("objects": [{"file": "a", "transform": [{"scale": [1, 1, 1], "translate": [1, 1, 1]}]}])"),
            ": objects[0].transform[0]: must have exactly one of translate, rotate or scale");
        row("rotation of three",
            withMember(
                R"("objects": [{"file": "a", "transform": [{"translate": [0, 0, 0]}, {"rotate": [30, 0, 1]}]}])"),
            ": objects[0].transform[1].rotate: has 3 elements; it must have 4");
        row("axis without length",
            withMember(R"("objects": [{"file": "a", "transform": [{"rotate": [30, 0, 0, 0]}]}])"),
            ": objects[0].transform[0].rotate: the rotation axis is (0, 0, 0); give it a length");
        row("scale 0", withMember(R"("objects": [{"file": "a", "transform": [{"scale": [1, 0, 1]}]}])"),
            ": objects[0].transform[0].scale: the scale is 0; it must differ from 0");
        row("clip plane of three", withMember("\"clipPlanes\": [[0, 1, 0]]"),
            ": clipPlanes[0]: has 3 elements; it must have 4");
        row("clip plane without normal", withMember("\"clipPlanes\": [[0, 1, 0, 0], [0, 0, 0, 1]]"),
            ": clipPlanes[1]: A, B and C of the clip plane are all 0; one of them must differ");
        row("seven clip planes",
            withMember("\"clipPlanes\": [[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0],[0,1,0,0]]"),
            ": clipPlanes: has 7 elements; there may be at most 6");
        row("ui a number", withMember("\"ui\": 1"), ": ui: expected an object in { }, found a number");
        row("rule unknown", withMember("\"ui\": {\"viewportRule\": {\"kind\": \"half\"}}"),
            ": ui.viewportRule.kind: \"half\" must be wholeWindow, fixed, keepAspect or quarter");
        row("rule's aspect 0", withMember("\"ui\": {\"viewportRule\": {\"kind\": \"keepAspect\", \"aspect\": 0}}"),
            ": ui.viewportRule.aspect: the aspect is 0; it must be greater than 0");
        row("flag a number", withMember("\"ui\": {\"clipDistancesFitObjects\": 1}"),
            ": ui.clipDistancesFitObjects: expected true or false, found a number");
        const auto landmark = [](const char *members) {
            return withMember(QByteArray("\"landmarks\": {\"points\": [{") + members + "}]}");
        };
        row("landmark of two coordinates", landmark("\"position\": [1, 2]"),
            ": landmarks.points[0].position: has 2 elements; it must have 3");
        row("landmark held by two", landmark("\"held\": {\"vertex\": 1, \"triangle\": 2}"),
            ": landmarks.points[0].held: must have exactly one of triangle, vertex or edge");
        row("landmark on no triangle", landmark("\"held\": {\"triangle\": -1}"),
            ": landmarks.points[0].held.triangle: -1 must lie between 0 and 4294967295");
        row("landmark on half a triangle", landmark("\"held\": {\"triangle\": 0.5}"),
            ": landmarks.points[0].held.triangle: 0.5 must be a whole number");
        row("edge of three", landmark("\"held\": {\"edge\": [1, 2, 3], \"share\": 0}"),
            ": landmarks.points[0].held.edge: has 3 elements; it must have 2");
        row("colour of a landmark", landmark("\"color\": [1, 2, 256]"),
            ": landmarks.points[0].color[2]: 256 must lie between 0 and 255");
        row("axes of the landmarks", withMember("\"landmarks\": {\"axes\": \"IJK\"}"),
            ": landmarks.axes: \"IJK\" must be LPS or RAS");
        row("place of a plane", withMember("\"ui\": {\"clipPlanesOff\": [{\"place\": 7, \"plane\": [0, 1, 0, 0]}]}"),
            ": ui.clipPlanesOff[0].place: 7 must lie between 0 and 0");
    }

    void malformedScenesAreRefusedWithTheirPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        QCOMPARE(messageFor(text), message);
    }

    void noTruncationIsAccepted()
    {
        const QByteArray text(kFullScene);
        for (qsizetype length = 0; length < text.size(); ++length) {
            const QByteArray message = messageFor(text.left(length));
            QVERIFY2(message.startsWith("scene.json:"), message);
        }
    }

    void noByteBroken()
    {
        // The file is either read or rejected if any byte is replaced by any of these.
        const QByteArray text(kFullScene);
        for (qsizetype at = 0; at < text.size(); ++at) {
            for (const char byte : {'\0', '"', '{', ']', ',', '9', '-', 'e', '\xFF', '\\', '\n'}) {
                QByteArray broken = text;
                broken[at] = byte;
                QVERIFY(!messageFor(broken).isEmpty());
            }
        }
    }

    void hugeFilesAreRefused()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("huge.json");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            QVERIFY(file.resize((qint64{256} << 20) + 1));
        }
        const auto scene = readSceneFile(path.toStdString());
        QVERIFY(!scene && scene.error().code == SceneFileErrorCode::TooLarge);
        QCOMPARE(QByteArray::fromStdString(sceneErrorText(scene.error())),
                 path.toUtf8()
                     + ": a scene may have at most 256 MiB; keep the landmarks in a file of their own (File > "
                       "Export Landmarks), then remove them from the scene");
    }

    void manyKeysTakeLittleTime()
    {
        QByteArray members;
        for (int i = 0; i < 300000; ++i)
            members += "\"k" + QByteArray::number(i) + "\": 0,";
        members.chop(1);
        // The processor's time, which other programs on the machine do not take.
        const std::clock_t start = std::clock();
        QCOMPARE(messageFor(withMember("\"many\": {" + members + "}")), QByteArray("it was read"));
        // A search among the keys before for each key would take minutes.
        QVERIFY((std::clock() - start) / CLOCKS_PER_SEC < 30);
    }
};

UNPROJECTOR_TEST(TestMalformedSceneFile)
#include "test_malformed_scene_file.moc"
