// A click's JSON is all that is needed to compute it again, to the last bit.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"
#include "core/unproject/object_from_world.h"
#include "tests/core/parsed_scenes.h"
#include "tests/support/core_scene.h"
#include "tests/support/unprojecting.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace unprojector::mesh;

namespace {

using Json = nlohmann::ordered_json;

constexpr int kScenes = 2000;

bool isSameBits(const glm::dvec3 &a, const glm::dvec3 &b)
{
    for (int i = 0; i < 3; ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i]))
            return false;
    }
    return true;
}

template <class Space>
bool isSame(const ClickPoint &point, const Answers<Space> &answers)
{
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
        const Result<Point<Space>> &answer = answers[kMethods[i]];
        if (point[i].has_value() != answer.hasValue() || (answer && !isSameBits(*point[i], answer->coordinates())))
            return false;
    }
    return true;
}

bool isSame(const Lens &a, const Lens &b)
{
    return std::get<Projection>(a) == std::get<Projection>(b);
}

std::vector<Click> readAgain(const std::vector<Click> &clicks)
{
    const auto read = parseSceneOrClicks(clicksText(clicks).value(), "clicks.json");
    if (!read)
        qFatal("%s", read.error().message().c_str());
    return std::get<std::vector<Click>>(*read);
}

/// A scene with a cube around a point, turned and stretched.
Scene sceneAround(const Setup &setup, const glm::dvec3 &centre)
{
    const auto model = std::make_shared<Model>();
    model->name = "Cube";
    Scene scene;
    scene.camera = setup.camera();
    scene.projection = setup.projection();
    scene.depthRange = setup.depthRange;
    scene.projectionFollowsViewport = true;
    scene.objects = {{"far away", "models/a.obj", model, {Translate{{1e9, 0, 0}}}},
                     {"W\xC3\xBCrfel", {}, model, {Translate{centre}, Rotate{33.3, {1, 2, 3}}, Scale{{0.5, 2, 3}}}}};
    scene.clipPlanes = {{0, 1, 0, 0.125}};
    return scene;
}

/// The pick on the pixel of a random position, in a window of whole pixels.
Result<Pick> randomPick(oracle::Random &random, oracle::RandomKind kind, bool hit)
{
    const oracle::Scene scene = oracle::randomScene(random, kind, {});
    Setup setup = oracle::corePicture(scene);
    constexpr double kRatios[] = {1.0, 1.25, 1.5, 1.75, 2.0};
    setup.surface =
        surfaceFromWidget(random.integer(100, 3000), random.integer(100, 2000), kRatios[random.integer(0, 4)]);
    const auto click = oracle::randomClick(random, scene.target);
    const WidgetPoint widget(random.uniform(0.0, setup.surface.widthPixels / setup.surface.devicePixelRatio - 1.0),
                             random.uniform(0.0, setup.surface.heightPixels / setup.surface.devicePixelRatio - 1.0));
    DepthSample sample;
    sample.depth = click[2];
    if (hit)
        sample.object = 1;
    return pickAt(setup, widget, sample);
}

} // namespace

class TestClicks : public QObject {
    Q_OBJECT

private slots:
    void everyClickComputedFromItsJsonIsTheSame_data()
    {
        addColumn<int>("kind");
        newRow("frustum") << int(oracle::RandomKind::Frustum);
        newRow("perspective") << int(oracle::RandomKind::Perspective);
        newRow("ortho") << int(oracle::RandomKind::Ortho);
        newRow("oblique") << int(oracle::RandomKind::Oblique);
    }

    void everyClickComputedFromItsJsonIsTheSame()
    {
        QFETCH(int, kind);
        oracle::Random random(20261122);
        int picks = 0;
        for (int i = 0; i < kScenes; ++i) {
            const Result<Pick> pick = randomPick(random, oracle::RandomKind(kind), true);
            if (!pick)
                continue;
            ++picks;
            const glm::dvec3 centre = pick->point.world[Method::Formula].hasValue()
                                          ? pick->point.world[Method::Formula]->coordinates()
                                          : glm::dvec3(0.0);
            const Click click = readAgain({clickOf(*pick, sceneAround(pick->setup, centre))}).at(0);
            QVERIFY(click.hit && click.devicePixel == pick->devicePixel);
            QVERIFY(isSameBits(click.window.coordinates(), pick->window.coordinates()));
            QVERIFY(isSame(click.eye.surface, pick->point.eye) && isSame(click.world.surface, pick->point.world));

            QVERIFY(click.uncertainty);
            QVERIFY(isSameBits(click.uncertainty->eye, pick->uncertainty.eye.coordinates()));
            QVERIFY(isSameBits(click.uncertainty->world, pick->uncertainty.world.coordinates()));

            const Setup setup = setupOf(click.scene);
            QVERIFY(setup.surface == pick->setup.surface && setup.viewport == pick->setup.viewport);
            QVERIFY(setup.depthRange == pick->setup.depthRange);
            QVERIFY(isSame(setup.lens, pick->setup.lens));
            const Unprojected again = unprojectedAt(setup, click.window);
            QVERIFY(isSame(click.eye.surface, again.eye) && isSame(click.world.surface, again.world));

            QVERIFY(click.object && click.object->index == 1);
            const auto placement =
                ObjectFromWorld::of(preciseWorldFromObject(click.scene.objects.at(click.object->index).transform))
                    .value();
            const Unprojector unprojector = Unprojector::of(setup).value();
            QVERIFY(isSame(click.object->point, Answers<ObjectSpace>::of([&](Method method) {
                               return unprojector.objectAt(method, click.window, placement);
                           })));
        }
        QVERIFY2(picks > kScenes * 9 / 10, QByteArray::number(picks));
    }

    void aClickOnTheBackgroundHasItsRay()
    {
        oracle::Random random(1);
        const Pick pick = randomPick(random, oracle::RandomKind::Perspective, false).value();
        const std::string text = clicksText({clickOf(pick, sceneAround(pick.setup, {}))}).value();
        const Json json = Json::parse(text).at(0);
        QVERIFY(json["hit"] == false && json["object"].is_null() && !json.contains("uncertainty"));
        QVERIFY(json["eye"].contains("near") && json["eye"].contains("far") && !json["eye"].contains("formula"));
        const Click click = readAgain({clickOf(pick, sceneAround(pick.setup, {}))}).at(0);
        QVERIFY(!click.hit && !click.object);
        QVERIFY(isSame(click.eye.rayNear, pick.rayNear.eye) && isSame(click.eye.rayFar, pick.rayFar.eye));
        QVERIFY(isSame(click.world.rayNear, pick.rayNear.world) && isSame(click.world.rayFar, pick.rayFar.world));
    }

    void theRayOnTheMeshIsWritten()
    {
        oracle::Random random(3);
        const Pick pick = randomPick(random, oracle::RandomKind::Perspective, true).value();
        const Scene scene = sceneAround(pick.setup, {});
        const auto written = [&](const std::optional<RayOnMesh> &ray) {
            const std::string text = clicksText({clickOf(pick, scene, ray)}).value();
            const Click again = std::get<std::vector<Click>>(parseSceneOrClicks(text, "clicks.json").value()).at(0);
            if (!isSameBits(again.window.coordinates(), pick.window.coordinates()))
                qFatal("it is not read");
            return Json::parse(text).at(0);
        };
        QVERIFY(!written({}).contains("rayOnMesh"));
        QVERIFY(written(RayOnMesh{})["rayOnMesh"] == Json::parse(R"({"hit": false})"));

        ray::SceneHit hit;
        hit.world = WorldPoint(0.1, -2.0, 3.5);
        hit.objectPoint = ObjectPoint(1.0, 2.0, 3.0);
        hit.distance = 7.25;
        hit.vertex = {12, WorldPoint(0.0, -2.0, 3.0), 0.5};
        hit.uncertainty = {1e-9, 2e-9, std::numeric_limits<double>::infinity()}; // of a surface that is edge on
        const Json point = written(RayOnMesh{hit, "cloud"})["rayOnMesh"];
        QVERIFY(point == Json::parse(R"({"hit": true, "object": "cloud", "triangle": null, "barycentric": null,
        "world": [0.1, -2, 3.5], "objectPoint": [1, 2, 3], "normal": null, "distance": 7.25,
        "vertex": {"id": 12, "world": [0, -2, 3], "distance": 0.5}, "edge": null, "uncertainty": [1e-9, 2e-9, null]})"));
        hit.triangle = ray::TriangleDetail{
            4, {0.25, 0.25, 0.5}, {12, 13, 14}, {0.0, 0.0, -1.0}, {{12, 14}, WorldPoint(0.0, -1.0, 3.0), 0.125}};
        const Json triangle = written(RayOnMesh{hit, "mesh"})["rayOnMesh"];
        QVERIFY(triangle["triangle"] == 4 && triangle["barycentric"] == Json::parse("[0.25, 0.25, 0.5]"));
        QVERIFY(triangle["normal"] == Json::parse("[0, 0, -1]"));
        QVERIFY(triangle["edge"] == Json::parse(R"({"ids": [12, 14], "world": [0, -1, 3], "distance": 0.125})"));
    }

    void aClicksSceneIsASceneFile()
    {
        oracle::Random random(2);
        const Pick pick = randomPick(random, oracle::RandomKind::Perspective, true).value();
        const Scene scene = sceneAround(pick.setup, pick.point.world[Method::Formula]->coordinates());
        const Json json = Json::parse(clicksText({clickOf(pick, scene)}).value()).at(0);
        const SceneFile read = parseScene(json["scene"].dump(), "scene.json").value();
        QVERIFY(json["scene"]["projection"]["type"] == "perspective" && json["scene"]["projection"].contains("aspect"));
        QCOMPARE(read.objects.size(), scene.objects.size());
        QVERIFY(read.objects[0].file.is_absolute() && read.objects[0].file.filename() == "a.obj");
        QCOMPARE(read.objects[1].bundled, "Cube");
        QVERIFY(read.objects[1].transform == scene.objects[1].transform && read.clipPlanes == scene.clipPlanes);
        QCOMPARE(json["object"]["name"].get<std::string>(), scene.objects[1].name);
        QCOMPARE(json["object"]["index"].get<int>(), 1);
        // The window that opens it does not choose other numbers.
        const Scene opened = sceneFromFile(read, "scene.json", scene.objects).value();
        QVERIFY(!opened.projectionFollowsViewport && !opened.clipDistancesFitObjects);
        QVERIFY(opened.projection == pick.setup.projection());
        // Alone it is a scene, in a click a click.
        QVERIFY(std::holds_alternative<SceneFile>(parseSceneOrClicks(json["scene"].dump(), "scene.json").value()));
        QCOMPARE(std::get<std::vector<Click>>(parseSceneOrClicks(json.dump(), "click.json").value()).size(),
                 std::size_t(1));
        QVERIFY(std::get<std::vector<Click>>(parseSceneOrClicks("[]", "none.json").value()).empty());
    }

    void whatIsNotNeededMayBeLeftOut()
    {
        oracle::Random random(3);
        const Pick pick = randomPick(random, oracle::RandomKind::Ortho, true).value();
        Json json = Json::parse(clicksText({clickOf(pick, sceneAround(pick.setup, {}))}).value());
        for (const char *key : {"widget", "devicePixel", "hit", "eye", "world", "uncertainty", "object"})
            json[0].erase(key);
        const auto read = std::get<std::vector<Click>>(parseSceneOrClicks(json.dump(), "clicks.json").value());
        QVERIFY(read.at(0).hit && !read[0].object && !read[0].eye.surface[0]);
        QVERIFY(isSameBits(read[0].window.coordinates(), pick.window.coordinates()));
    }

    void malformedClicksAreRefusedWithTheirPlace_data()
    {
        addColumn<QString>("pointer");
        addColumn<QString>("value");
        addColumn<QString>("message");
        const auto row = [](const char *name, const char *pointer, const char *value, const char *message) {
            newRow(name) << pointer << value << message;
        };
        row("no click", "/1", "7", "[1]: expected an object in { }, found 7");
        row("window of two", "/1/window", "[1, 2]", "[1].window: has 2 elements; it must have 3");
        row("window an object", "/0/window", "{}", "[0].window: expected a list of 3 numbers, found an object in { }");
        row("hit a number", "/0/hit", "1", "[0].hit: expected true or false, found 1");
        row("scene null", "/0/scene", "null", "[0].scene: expected an object in { }, found null");
        row("in the scene", "/1/scene/view/up", "[0, 0, 0]", "[1].scene.view.up: up is (0, 0, 0); give it a length");
        row("half a pixel", "/0/devicePixel/1", "0.5", "[0].devicePixel[1]: 0.5 must be a whole number");
        row("a point of text", "/0/eye/matrix", "\"none\"",
            "[0].eye.matrix: expected a list of 3 numbers, found \"none\"");
        row("object without a place", "/0/object", "{\"name\": \"a\"}", "[0].object.index: is missing");
    }

    void malformedClicksAreRefusedWithTheirPlace()
    {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(QString, message);
        oracle::Random random(4);
        const Pick pick = randomPick(random, oracle::RandomKind::Frustum, true).value();
        const Click click = clickOf(pick, sceneAround(pick.setup, {}));
        Json json = Json::parse(clicksText({click, click}).value());
        json[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
        const auto read = parseSceneOrClicks(json.dump(), "clicks.json");
        QVERIFY(!read);
        QCOMPARE(QString::fromUtf8(scene_texts::messageWithoutPlace(read.error())), "clicks.json: " + message);
    }
};

UNPROJECTOR_TEST(TestClicks)
#include "test_clicks.moc"
