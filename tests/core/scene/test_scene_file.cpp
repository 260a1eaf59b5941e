// The contents of a scene file: read as written, and after writing read again.

#include "tests/support/test.h"

#include "tests/core/parsed_scenes.h"
#include "tests/core/scene_texts.h"

#include <QDir>
#include <QTemporaryDir>

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
using namespace unprojector::landmarks;

class TestSceneFile : public QObject {
    Q_OBJECT

private slots:
    void everyKeyIsRead()
    {
        const SceneFile scene = parsed(kFullScene);
        QCOMPARE(scene.windowWidth, 641);
        QCOMPARE(scene.windowHeight, 479);
        QCOMPARE(scene.devicePixelRatio, 1.25);
        QVERIFY(scene.isWindowFixed);
        QVERIFY(scene.viewport == (Viewport{3, 5.5, 640, 480}));
        QVERIFY(scene.depthRange == (DepthRange{0.9, 0.1}));
        QVERIFY(std::get<Projection>(scene.projection) == Projection(Frustum{-1.1, 1.2, -0.75, 0.8, 0.1, 1e5}));
        QVERIFY(std::get<LookAt>(scene.view) == (LookAt{{0.1, 0.2, 5.3}, {1, 2, 3}, {0, 1, 0.5}}));
        QCOMPARE(scene.objects.size(), std::size_t(2));
        QCOMPARE(scene.objects[0].name, "face");
        QVERIFY(scene.objects[0].file == std::filesystem::path("models") / "face.obj");
        QVERIFY(scene.objects[0].transform
                == (std::vector<TransformStep>{Translate{{0, 0, -3}}, Rotate{30, {0, 1, 0}}, Scale{{1, 2, -1}}}));
        QCOMPARE(scene.objects[1].name, "Gr\xC3\xBCn");
        QCOMPARE(scene.objects[1].bundled, "Teapot");
        QVERIFY(!scene.objects[0].isHidden && scene.objects[1].isHidden);
        QCOMPARE(written(scene).count("hidden"), 2); // only where it is so: of an object, and a landmark
        QVERIFY(scene.objects[1].file.empty());
        QVERIFY(scene.clipPlanes == (std::vector<glm::dvec4>{{0, 1, 0, 0}, {1, 0, 0, -0.25}}));
        QVERIFY(scene.ui.viewportRule == (ViewportRule{ViewportRule::Kind::KeepAspect, {1, 2, 3, 4}, 1.5}));
        QCOMPARE(scene.ui.projectionFollowsViewport, std::optional(true));
        QCOMPARE(scene.ui.clipDistancesFitObjects, std::optional(false));
        QVERIFY(scene.ui.home == (LookAt{{9, 8, 7}, {0, 0, 0}, {0, 1, 0}}));
        QCOMPARE(scene.ui.clipPlanesOff.size(), std::size_t(1));
        QCOMPARE(scene.ui.clipPlanesOff[0].index, std::size_t(1));
        QVERIFY(scene.ui.clipPlanesOff[0].plane == glm::dvec4(0, 0, 1, 2));

        using namespace unprojector::landmarks;
        const LandmarkSet &set = scene.landmarks;
        QVERIFY(set.name == "skull 7" && set.mesh == "face.obj" && set.unit == "mm" && set.axes == Axes::Ras);
        QCOMPARE(set.landmarks.size(), std::size_t(4));
        QVERIFY(set.landmarks[0]
                == (Landmark{"Nasion",
                             WorldPoint(0.1, 2.5, -3),
                             {},
                             "face",
                             OnTriangle{4294967295u, {0.2, 0.3, 0.5}},
                             WorldVector(0.01, 0.02, 0.03),
                             "w\xC3\xA9ll",
                             glm::u8vec3(255, 128, 1),
                             true,
                             {}}));
        QVERIFY(set.landmarks[1]
                == (Landmark{"", WorldPoint(1e-300, 2, 3), {}, "", AtVertex{7}, {}, "", {}, false, {}}));
        QVERIFY(set.landmarks[2].anchor == Anchor(OnEdge{{5, 6}, 0.75}));
        QVERIFY(!set.landmarks[3].isPlaced());
        QCOMPARE(set.curves.size(), std::size_t(2));
        QVERIFY(set.curves[0] == (Curve{"brow", {"Nasion", "e"}, CurveKind::PlaneSection, 12, {}, {}}));
        QVERIFY(set.curves[1]
                == (Curve{"as read", {}, CurveKind::Geodesic, 2, {WorldPoint(1, 2, 3), WorldPoint(4, 5, 0.1)}, {}}));

        const Setup setup = setupOf(scene);
        QVERIFY(setup.surface == (Surface{801, 599, 1.25}));
        QVERIFY(setup.viewport == *scene.viewport);
        QVERIFY(objectFile(scene.objects[0], "/there/scene.json") == std::filesystem::path("/there/models/face.obj"));
    }

    void whatIsLeftOutHasItsDefault()
    {
        const SceneFile scene = parsed(kLeastScene);
        QCOMPARE(scene.devicePixelRatio, 1.0);
        QVERIFY(!scene.isWindowFixed);
        QVERIFY(!scene.viewport && scene.objects.empty() && scene.clipPlanes.empty());
        QVERIFY(scene.depthRange == (DepthRange{0, 1}));
        QVERIFY(setupOf(scene).viewport == (Viewport{0, 0, 800, 600}));
        QVERIFY(!scene.ui.viewportRule && !scene.ui.home && !scene.ui.projectionFollowsViewport);
    }

    void anglesAreDegrees()
    {
        const auto perspective =
            parsed(withProjection(R"({"type": "perspective", "fovy": 90, "aspect": 2, "near": 1, "far": 9})"));
        QVERIFY(std::get<Projection>(perspective.projection)
                == Projection(Perspective{Angle::fromDegrees(90), 2, 1, 9}));
        const auto oblique = parsed(withProjection(
            R"({"type": "oblique", "left": -1, "right": 1, "bottom": -2, "top": 2, "near": -3, "far": 3, "theta": 45, "phi": 90})"));
        QVERIFY(std::get<Projection>(oblique.projection)
                == Projection(Oblique{{-1, 1, -2, 2, -3, 3}, Angle::fromDegrees(45), Angle::fromDegrees(90)}));
    }

    void skewsAndPinholesAreKept()
    {
        const Frustum frustum{-1, 1, -0.75, 0.75, 1, 9, 0.25};
        SceneFile scene = parsed(withProjection(
            R"({"type": "frustum", "left": -1, "right": 1, "bottom": -0.75, "top": 0.75, "near": 1, "far": 9, "skew": 0.25})"));
        QVERIFY(std::get<Projection>(scene.projection) == Projection(frustum));
        QVERIFY(parsed(written(scene)).projection == scene.projection);
        scene = parsed(withProjection(
            R"({"type": "pinhole", "fx": 611.2, "fy": 609.9, "cx": 318.7, "cy": 243.1, "width": 640, "height": 480,
            "pixelCenters": "integer", "near": 0.1, "far": 1000})"));
        QVERIFY(std::get<Projection>(scene.projection)
                == Projection(Pinhole{611.2, 609.9, 318.7, 243.1, 0, 640, 480, 0.1, 1000, true}));
        QVERIFY(!written(scene).contains("skew"));
        QVERIFY(parsed(written(scene)).projection == scene.projection);
        scene.projection = Projection(Pinhole{611.2, 609.9, 318.7, 243.1, 1.5, 640, 480, 0.1, 1000, false});
        QVERIFY(written(scene).contains("half"));
        QVERIFY(parsed(written(scene)).projection == scene.projection);
    }

    void aPerspectiveWithoutAspectTakesTheViewports()
    {
        const char *const projection = R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})";
        SceneFile scene = parsed(withProjection(projection));
        QVERIFY(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect == DoubleDouble(800.0) / 600.0);
        QVERIFY(!written(scene).contains("aspect"));
        QByteArray text = withProjection(projection);
        text.replace("\"unprojector\": 1,",
                     R"("unprojector": 1, "viewport": {"x": 0, "y": 0, "width": 300, "height": 100},)");
        scene = parsed(text);
        QVERIFY(std::get<Perspective>(std::get<Projection>(scene.projection)).aspect == 3.0);
    }

    void whatIsReadIsWrittenAndReadAgain_data()
    {
        addColumn<QByteArray>("text");
        newRow("every key") << QByteArray(kFullScene);
        newRow("as little as can be") << QByteArray(kLeastScene);
        newRow("byte order mark") << QByteArray("\xEF\xBB\xBF").append(kLeastScene);
        newRow("perspective") << withProjection(
            R"({"type": "perspective", "fovy": 33.3, "aspect": 1.7, "near": 1, "far": 9})");
        newRow("perspective without aspect")
            << withProjection(R"({"type": "perspective", "fovy": 45, "near": 1, "far": 9})");
        newRow("oblique") << withProjection(
            R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1,
                                                   "near": 1, "far": 9, "theta": 44.690708, "phi": 135})");
        newRow("extreme numbers") << withProjection(
            R"({"type": "ortho", "left": -1.7976931348623157e308, "right": 5e-324,
                                                          "bottom": -0.0, "top": 9007199254740993, "near": 0.1, "far": 0.30000000000000004})");
        newRow("matrix") << withProjection(kMatrix);
        newRow("matrix of [0, 1]")
            << QByteArray(withProjection(kMatrix)).replace("\"matrix\", ", "\"matrix\", \"ndcDepth\": [0, 1], ");
        newRow("view matrix") << withView("{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.1,1]}");
        newRow("unknown keys") << withMember(R"("by": {"a": [1, {"b": null}]}, "ui": {"theme": "dark"})");
        newRow("object point") << withMember(
            R"("point": {"space": "object", "coordinates": [0.1, -0.0, 5e-324], "object": "a face", "by": 1})");
        newRow("clip point") << withMember(R"("point": {"space": "clip", "coordinates": [1, 2, 3, -4.1]})");
        for (const char *space : {"world", "eye", "ndc", "window"})
            newRow(space) << withMember(
                QByteArray(R"("point": {"space": "SPACE", "coordinates": [1, 2, 0.3]})").replace("SPACE", space));
    }

    void whatIsReadIsWrittenAndReadAgain()
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
            QVERIFY(std::get<LookAt>(second.view) == std::get<LookAt>(first.view));
        QVERIFY(second.viewport == first.viewport && second.depthRange == first.depthRange);
        QVERIFY(second.aspectFromViewport == first.aspectFromViewport);
        QVERIFY(second.ui.viewportRule == first.ui.viewportRule);
        QVERIFY(second.ui.home == first.ui.home);
        QCOMPARE(second.ui.clipPlanesOff.size(), first.ui.clipPlanesOff.size());
        QCOMPARE(second.objects.size(), first.objects.size());
        for (std::size_t i = 0; i < first.objects.size(); ++i) {
            QVERIFY(second.objects[i].file == first.objects[i].file && second.objects[i].name == first.objects[i].name);
            QVERIFY(second.objects[i].bundled == first.objects[i].bundled);
            QVERIFY(second.objects[i].isHidden == first.objects[i].isHidden);
            QVERIFY(second.objects[i].transform == first.objects[i].transform);
        }
        QVERIFY(second.clipPlanes == first.clipPlanes);
        QCOMPARE(second.point.has_value(), text.contains("coordinates"));
        QVERIFY(second.point == first.point);
    }

    void unknownKeysAreKeptEverywhere_data()
    {
        addColumn<QByteArray>("text");
        newRow("every key") << QByteArray(kFullScene);
        newRow("perspective") << withProjection(
            R"({"type": "perspective", "fovy": 33.3, "aspect": 1.7, "near": 1, "far": 9})");
        newRow("oblique") << withProjection(
            R"({"type": "oblique", "left": -1, "right": 1, "bottom": -1, "top": 1,
                                                   "near": 1, "far": 9, "theta": 44.690708, "phi": 135})");
        newRow("matrix") << withProjection(kMatrix);
        newRow("view matrix") << withView("{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.1,1]}");
    }

    void unknownKeysAreKeptEverywhere()
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

    void numbersOfUnknownKeysAreKeptToTheDigit_data()
    {
        addColumn<QByteArray>("number");
        for (const char *number :
             {"9007199254740993", "18446744073709551615", "18446744073709551617", "-9223372036854775809",
              "123456789012345678901234567890", "0.1000000000000000055511151231257827", "3.14159265358979323846",
              "-0.0", "1.7976931348623157081e308", "1234567890.12345678901234567890e-5", "1e-07", "0.5", "5e-324",
              "0.00000000001234567890123456789"})
            newRow(number) << QByteArray(number);
    }

    void numbersOfUnknownKeysAreKeptToTheDigit()
    {
        QFETCH(QByteArray, number);
        const QByteArray text =
            changed("\"window\"", "\"made\": [{\"serial\": N}, N], \"window\"").replace("N", number);
        const QByteArray again = written(parsed(text));
        QVERIFY2(again.contains("[{\"serial\": " + number + "}, " + number + "]"), again);
        QCOMPARE(written(parsed(again)), again);
    }

    /// A known key counts as its double, which is written in the fewest digits.
    void manyDigitsAreANumber()
    {
        const SceneFile scene =
            parsed(changed("[0, 0, 5]", "[0.1000000000000000055511151231257827, 5, 123456789012345678901]"));
        QVERIFY(std::get<LookAt>(scene.view).eye == WorldPoint(0.1, 5.0, 123456789012345678901.0));
        QVERIFY2(written(scene).contains("\"eye\": [0.1, 5, 1.2345678901234568e+20]"), written(scene));
    }

    void nothingIsLeftOfAnotherProjection()
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
        // A key that the new projection lacks does not come back either.
        scene = parsed(withProjection(
            R"({"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9, "aspect": 2})"));
        scene.projection = Projection(Perspective{1, 4.0 / 3.0, 1, 9});
        scene.aspectFromViewport = true;
        QVERIFY(!written(scene).contains("aspect"));
        QVERIFY(parsed(written(scene)).aspectFromViewport);
    }

    void aTextForPeople()
    {
        const QByteArray text = written(parsed(kFullScene));
        QVERIFY2(
            text.contains(
                "\n  \"window\": {\"width\": 641, \"height\": 479, \"devicePixelRatio\": 1.25, \"fixed\": true},\n"),
            text);
        QVERIFY2(text.contains("\n  \"depthRange\": [0.9, 0.1],\n"), text);
        QVERIFY2(text.contains("\"Gr\xC3\xBCn\""), text);
        for (const QByteArray &line : text.split('\n'))
            QVERIFY2(line.size() <= 120, line);
        QVERIFY(text.endsWith("}\n") && !text.contains('\t') && !text.contains('\r'));
    }

    void everyDoubleSurvives()
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

    void degreesSurvive()
    {
        for (int tenths = 1; tenths < 1800; ++tenths) {
            const QByteArray degrees = QByteArray::number(tenths / 10.0);
            const QByteArray text =
                withProjection("{\"type\": \"perspective\", \"fovy\": " + degrees + ", \"near\": 1, \"far\": 9}");
            QVERIFY2(written(parsed(text)).contains("\"fovy\": " + degrees + ","), degrees);
        }
    }

    void everyAngleSurvives()
    {
        std::mt19937_64 random(20261121);
        std::uniform_real_distribution<double> angle(1e-3, std::numbers::pi - 1e-3);
        std::uniform_real_distribution<double> degrees(0.1, 179.9);
        for (int i = 0; i < 2000; ++i) {
            SceneFile scene = parsed(kLeastScene);
            const Oblique oblique{{-1, 1, -1, 1, 1, 9}, angle(random), Angle::fromDegrees(degrees(random))};
            scene.projection = Projection(oblique);
            const QByteArray text = written(scene);
            QVERIFY2(text.contains("thetaRadians") && !text.contains("phiRadians"), text);
            QVERIFY2(std::get<Projection>(parsed(text).projection) == Projection(oblique), text);
        }
    }

    void radiansThatContradictTheDegreesAreRefused()
    {
        const auto read = [](const char *angles) {
            const QByteArray text = withProjection(QByteArray("{\"type\": \"perspective\", ")
                                                       .append(angles)
                                                       .append(", \"aspect\": 1, \"near\": 1, \"far\": 9}")
                                                       .constData());
            return parseScene(text.toStdString(), "scene.json");
        };
        const auto fovyOf = [](const SceneFile &scene) {
            return std::get<Perspective>(std::get<Projection>(scene.projection)).verticalFov;
        };
        QVERIFY(fovyOf(*read(R"("fovy": 57.2957795, "fovyRadians": 1)")) == 1.0); // shortened by another program
        const auto edited = read(R"("fovy": 45, "fovyRadians": 1)");
        QVERIFY(!edited);
        QCOMPARE(
            messageWithoutPlace(edited.error()),
            QByteArray("scene.json: projection.fovyRadians: 1 radians differ from fovy, which is 45 degrees; remove "
                       "the wrong key"));
    }

    void filesAreReadAndWritten()
    {
        QTemporaryDir folder;
        const std::filesystem::path directory(folder.path().toStdU16String());
        const std::filesystem::path file = directory / std::u8string(u8"Szene \u00e4.json");
        QVERIFY(writeSceneFile(file, parsed(kFullScene)).hasValue());
        const auto again = readSceneFile(file);
        QVERIFY(again.hasValue());
        QCOMPARE(written(*again), written(parsed(kFullScene)));

        const auto missing = readSceneFile(directory / "none.json");
        QVERIFY(!missing && missing.error().kind == base::Error::Kind::NoFile);
        const auto isFolder = readSceneFile(directory);
        QVERIFY(!isFolder && isFolder.error().kind == base::Error::Kind::File);
        const auto toFolder = writeSceneFile(directory, parsed(kFullScene));
        QVERIFY(!toFolder && toFolder.error().kind == base::Error::Kind::File);
        const auto nowhere = writeSceneFile(directory / "none" / "a.json", parsed(kFullScene));
        QVERIFY(!nowhere && nowhere.error().kind == base::Error::Kind::File);
    }

    void manyLandmarksAreWrittenAndRead()
    {
        constexpr int kCount = 60000; // more than 8 MiB
        SceneFile scene = parsed(kLeastScene);
        for (int i = 0; i < kCount; ++i) {
            unprojector::landmarks::Landmark landmark;
            landmark.name = "landmark number " + std::to_string(i);
            landmark.world = WorldPoint(i / 3.0, i / 7.0, i / 11.0);
            landmark.uncertainty = WorldVector(1e-5 / 3.0, 1e-5 / 7.0, 1e-5 / 11.0);
            scene.landmarks.landmarks.push_back(std::move(landmark));
        }
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("many.json")).toStdString();
        QVERIFY(writeSceneFile(file, scene));
        QVERIFY(std::filesystem::file_size(file) > std::size_t{8} << 20);
        QVERIFY(isSceneFile(file));
        const auto again = readSceneFile(file);
        QVERIFY(again && again->landmarks.landmarks == scene.landmarks.landmarks);
    }

    void writingReplacesWholeFilesOnly()
    {
        QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdU16String()) / "a.json";
        QVERIFY(writeSceneFile(file, parsed(kFullScene)).hasValue());
        QVERIFY(writeSceneFile(file, parsed(kLeastScene)).hasValue());
        QCOMPARE(written(readSceneFile(file).value()), written(parsed(kLeastScene)));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList("a.json"));

        // A failed write leaves the old file.
        SceneFile bad = parsed(kFullScene);
        bad.objects[0].name = "\xFF";
        QVERIFY(!writeSceneFile(file, bad).hasValue());
        QCOMPARE(written(readSceneFile(file).value()), written(parsed(kLeastScene)));
    }

    void aNameThatIsNotUtf8IsRefused()
    {
        SceneFile scene = parsed(kFullScene);
        scene.objects[1].name = "\xC3(";
        const auto text = sceneText(scene);
        QVERIFY(!text && text.error().subject == "objects[1].name");
        QCOMPARE(text.error().message(), "objects[1].name: the name is not UTF-8 and cannot be written; rename it");
    }
};

UNPROJECTOR_TEST(TestSceneFile)
#include "test_scene_file.moc"
