// The tutorials' examples as scenes: their pictures in windows of every size, and their notes. The
// numbers that the tutorials print are in test_source_numbers.

#include "tests/support/test.h"

#include "core/pipeline/pipeline.h"
#include "core/scene_file/scene_file.h"
#include "core/unproject/unprojector.h"
#include "tests/support/example_scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::scene;
using namespace unprojector::unproject;
using namespace unprojector::mesh;

namespace {

/// A few roundings of numbers of order 1 to 100.
constexpr double kRounding = 1e-12;
/// Mesh corners are single precision.
constexpr double kCorner = 1e-5;

const Surface kSurfaces[] = {{50, 50, 1.0},    {300, 300, 1.0},  {800, 600, 1.0},
                             {1280, 720, 1.0}, {600, 1000, 2.0}, {1333, 900, 1.25}};

/// The pipeline of the example's first object, in a window of this size.
Pipeline pipelineOf(const char *id, const Surface &surface = {800, 600, 1.0})
{
    const Scene &scene = sceneOfExample(id);
    const Result<Setup> setup = setupOf(scene, surface, {});
    if (!setup)
        qFatal("The example %s has no picture.", id);
    const Result<Pipeline> made = pipeline::pipelineOf(*setup, worldFromObject(scene.objects.at(0).transform));
    if (!made)
        qFatal("The example %s has no pipeline.", id);
    return *made;
}

/// The example's own point in every space.
PipelinePoints given(const char *id, const Surface &surface = {800, 600, 1.0})
{
    const Scene &scene = sceneOfExample(id);
    if (!scene.givenPoint
        || (!scene.givenPoint->object.empty() && scene.givenPoint->object != scene.objects.at(0).name))
        qFatal("The example %s follows no point of its first object.", id);
    return pointsFrom(pipelineOf(id, surface), *scene.givenPoint);
}

template <class Vector>
bool isAt(const Vector &point, const Vector &expected, double tolerance = kRounding)
{
    if (glm::length(point - expected) <= tolerance)
        return true;
    for (int i = 0; i < point.length(); ++i)
        qWarning("coordinate %d: %.17g, expected %.17g", i, point[i], expected[i]);
    return false;
}

} // namespace

class TestExamples : public QObject {
    Q_OBJECT

private slots:
    void everyExampleIsAsTheProgramWritesIt()
    {
        for (const std::string_view id : examples::kExamples) {
            const Scene &scene = sceneOfExample(id);
            const Result<Setup> setup = setupOf(scene, {800, 600, 1.0}, {});
            const auto text = scene_file::sceneText(scene_file::sceneFileFrom(scene, *setup, {}));
            QVERIFY2(text, id.data());
            std::string written = *text; // the program's version is not in the files
            const std::size_t generator = written.find("  \"generator\"");
            written.erase(generator, written.find('\n', generator) + 1 - generator);
            QCOMPARE(written, std::string(examples::exampleScene(id)));
        }
    }

    void otherFilesAreNoExamples()
    {
        for (const char *id : {"", "models", "utah_teapot", "zhangci-2d.json", "../lessons/zhangci"})
            QVERIFY2(examples::exampleScene(id).empty(), id);
    }

    void everyBundledModelIsWhole()
    {
        QCOMPARE(examples::bundledModels().size(), std::size_t(20));
        for (const auto &[name, model] : examples::bundledModels()) {
            QCOMPARE(model->name, name);
            QVERIFY2(!model->meshes.empty(), name.c_str());
            for (const Mesh &mesh : model->meshes) {
                QVERIFY2(mesh.triangleCount() > 0, name.c_str());
                QCOMPARE(mesh.normals.size(), mesh.positions.size());
                for (const glm::vec3 &normal : mesh.normals)
                    QVERIFY2(std::abs(glm::length(normal) - 1.0f) <= 1e-6f, name.c_str());
            }
        }
    }

    void everyExampleIsSeen_data()
    {
        addColumn<int>("index");
        addColumn<int>("surface");
        for (int index = 0; index < int(examples::kExamples.size()); ++index) {
            int number = 0;
            for (const Surface &s : kSurfaces)
                addRow("%s in %d x %d", examples::kExamples[std::size_t(index)].data(), s.widthPixels, s.heightPixels)
                    << index << number++;
        }
    }

    void everyExampleIsSeen()
    {
        QFETCH(int, index);
        QFETCH(int, surface);
        const Scene &scene = sceneOfExample(examples::kExamples.at(std::size_t(index)));
        QVERIFY(check(scene));
        const Result<Setup> setup = setupOf(scene, kSurfaces[surface], {});
        QVERIFY(setup);
        QVERIFY(!scene.objects.empty());
        const Result<glm::dmat4> clip = clipFromWorld(*setup);
        QVERIFY(clip);
        for (const SceneObject &object : scene.objects) {
            QVERIFY(!object.name.empty());
            std::size_t inside = 0;
            for (const Mesh &mesh : object.model->meshes) {
                QCOMPARE(mesh.normals.size(), mesh.positions.size());
                QVERIFY(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
                for (const glm::vec3 &corner : mesh.positions) {
                    const glm::dvec4 world = worldFromObject(object.transform) * glm::dvec4(glm::dvec3(corner), 1.0);
                    inside += isInsideViewVolume(ClipPoint(*clip * world)) ? 1 : 0;
                }
            }
            QVERIFY2(inside > 0, object.name.c_str());
        }
        // The camera and the projection are the tutorial's in every window.
        QCOMPARE(kindOf(setup->projection()), kindOf(scene.projection));
        QVERIFY(setup->projection() == scene.projection);
    }

    void inTwoDimensionsThePointCanBeClicked()
    {
        const Scene &scene = sceneOfExample("zhangci-2d");
        const Box plate = boundsOf({scene.objects.at(0).model->meshes.back()});
        QVERIFY(isAt(plate.center(), std::get<ObjectPoint>(scene.givenPoint->point).coordinates(), kCorner));
    }

    void theNamesOfTheAxesCanBeRead()
    {
        const Scene scene = sceneOfExample("zhangci-2d");
        const Result<Setup> setup = setupOf(scene, {800, 600, 1.0}, {});
        QVERIFY(setup);
        constexpr std::size_t kCornersOfC = std::size_t{7} * 6, kCornersOfStroke = 6;
        for (const SceneObject &object : scene.objects) {
            const Mesh &name = object.model->meshes.at(2); // behind the two axes
            const glm::dmat4 placement = worldFromObject(object.transform);
            const auto middle = [&](std::size_t first, std::size_t end) {
                glm::dvec2 sum(0.0);
                for (std::size_t i = first; i < end; ++i) {
                    const glm::dvec4 world = placement * glm::dvec4(name.position(name.vertexAt(i)), 1.0);
                    const WindowPoint at = *windowFromWorld(*setup, WorldPoint(glm::dvec3(world)));
                    sum += glm::dvec2(at.x, at.y);
                }
                return sum / double(end - first);
            };
            const std::size_t end = name.elementCount();
            QVERIFY(end > kCornersOfC);
            const glm::dvec2 before = middle(0, end - kCornersOfC), c = middle(end - kCornersOfC, end);
            QVERIFY2(c.x > before.x + 10.0 && std::abs(c.y - before.y) < 5.0, object.name.c_str()); // left to right
            QVERIFY2(middle(end - kCornersOfStroke, end).y < c.y - 5.0, object.name.c_str());       // a C ends below
        }
    }

    void theCubeOfSide10TakesHalfOfTheVolume()
    {
        const PipelinePoints corner = pointsForward(pipelineOf("zhangci-ortho"), ObjectPoint(5, 5, 5));
        QVERIFY(isAt(corner.ndc->coordinates(), {0.5, 0.5, 0.0}));
        const Box cube = sceneOfExample("zhangci-ortho").objects.at(0).model->bounds;
        QVERIFY(isAt(cube.highest - cube.lowest, {10, 10, 10}, kCorner));
    }

    void farCubesAreSmaller()
    {
        const Scene &scene = sceneOfExample("zhangci-perspective");
        const Result<Setup> setup = setupOf(scene, {800, 600, 1.0}, {});
        const double distances[] = {5, 11, 19};
        for (std::size_t i = 0; i < 3; ++i) {
            const SceneObject &cube = scene.objects.at(i);
            const Result<Pipeline> made = pipeline::pipelineOf(*setup, worldFromObject(cube.transform));
            const PipelinePoints low = pointsForward(*made, ObjectPoint(0, -0.7, 0)),
                                 high = pointsForward(*made, ObjectPoint(0, 0.7, 0));
            // 1.4 units of an extent of 2 tan(22.5 degrees) z, in a viewport 600 pixels high.
            const double expected = 600.0 * 1.4 / (2.0 * 0.41421356237309503 * distances[i]);
            QVERIFY(std::abs(high.window->y - low.window->y - expected) <= 1e-9);
            QVERIFY(std::abs(-low.eye->z - distances[i]) <= kRounding);
        }
    }

    void theMiddleOfTheVolumeOf50PixelsHasDepth075()
    {
        for (const Surface &surface : kSurfaces) {
            const PipelinePoints middle =
                pointsForward(pipelineOf("zhangci-viewport-50", surface), ObjectPoint(0, 0, 0));
            QVERIFY(isAt(middle.ndc->coordinates(), {0, 0, 0.5}));
            const PipelinePoints points = given("zhangci-viewport-50", surface);
            QVERIFY(points.ndc.value() == NdcPoint(0, 0, 0.5));
            QVERIFY(points.window.value() == WindowPoint(25, 25, 0.75));
        }
    }

    void theQuarterIsTheLowerRight()
    {
        const Result<Setup> setup = setupOf(sceneOfExample("zhangci-viewport-quarter"), {801, 600, 1.0}, {});
        QVERIFY(setup);
        const Viewport expected{400, 0, 400, 300};
        QVERIFY(setup->viewport == expected);
        const PipelinePoints points = pointsForward(pipelineOf("zhangci-viewport-quarter"), ObjectPoint(0, 0, 0));
        QVERIFY(isAt(points.window->coordinates(), {600, 150, 0.75}));
    }

    void threeProjectionsAreNotEqual()
    {
        const Pipeline matrix = pipelineOf("derivation-matrix"), frustum = pipelineOf("derivation-frustum"),
                       perspective = pipelineOf("derivation-perspective");
        // The sixteen numbers themselves, as the program has them, not their interpretation.
        const SceneProjection given = sceneOfExample("derivation-matrix").projection;
        QVERIFY(given.matrix());
        const glm::dmat4 &handMade = given.matrix()->clipFromEye, theirs = *clipFromEye(frustum.setup);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                QVERIFY2(std::abs(handMade[column][row] - theirs[column][row])
                             <= kRounding * std::max(1.0, std::abs(theirs[column][row])),
                         qPrintable(QStringLiteral("m[%1]").arg(4 * column + row)));
        }
        // The window draws the matrix as the projection that it is.
        QVERIFY(isAt(pointsForward(matrix, ObjectPoint(30, 20, -40)).ndc.value().coordinates(),
                     pointsForward(frustum, ObjectPoint(30, 20, -40)).ndc.value().coordinates()));
        for (const ObjectPoint &corner : {ObjectPoint(30, 20, -40), ObjectPoint(40, 10, -30)}) {
            const double across =
                pointsForward(matrix, corner).ndc.value().x / pointsForward(perspective, corner).ndc.value().x;
            QVERIFY(std::abs(across - 16.0 / 9.0) <= kRounding);
            QVERIFY(
                std::abs(pointsForward(matrix, corner).ndc.value().y - pointsForward(perspective, corner).ndc.value().y)
                <= kRounding);
        }
        // Translated by (0, 0, 10), which glTranslatef between glBegin and glEnd does not do.
        QVERIFY(isAt(pointsForward(matrix, ObjectPoint(0, 0, -20)).eye.value().coordinates(), {0, 0, -10}));
    }

    void aCircleIsDrawnWiderByTwoOfThem()
    {
        for (const Surface &surface : kSurfaces) {
            for (const auto &[id, widthToHeight] :
                 {std::pair("derivation-matrix", 16.0 / 9.0), std::pair("derivation-perspective", 1.0),
                  std::pair("derivation-frustum", 16.0 / 9.0)}) {
                const Scene &scene = sceneOfExample(id);
                const Result<Setup> setup = setupOf(scene, surface, {});
                const Result<Pipeline> made =
                    pipeline::pipelineOf(*setup, worldFromObject(scene.objects.at(1).transform));
                const PipelinePoints middle = pointsForward(*made, ObjectPoint(0, 0, 0)),
                                     right = pointsForward(*made, ObjectPoint(5, 0, 0)),
                                     top = pointsForward(*made, ObjectPoint(0, 5, 0));
                const double width = right.window->x - middle.window->x, height = top.window->y - middle.window->y;
                // The viewport is 4:3 but for its rounding to whole pixels.
                const double pixel = 2.0 / std::min(made->setup.viewport.width, made->setup.viewport.height);
                QVERIFY2(std::abs(width / height - widthToHeight) <= widthToHeight * pixel, id);
            }
        }
    }

    void theOriginGoesToPixel150AndBack()
    {
        const Pipeline pipeline = pipelineOf("opencascade-round-trip", {300, 300, 1.0});
        const PipelinePoints points = given("opencascade-round-trip", {300, 300, 1.0});
        QVERIFY(points.world.value() == WorldPoint(0, 0, 0));
        QVERIFY(points.widget.value() == WidgetPoint(150, 150));
        for (const double depth : {0.0, points.window->z, 1.0}) {
            const PipelinePoints back = pointsBackward(pipeline, WindowPoint(150, 150, depth));
            QVERIFY(std::abs(back.world->x) <= kRounding && std::abs(back.world->y) <= kRounding);
            // Only with its own depth does the origin come back: "only the depth z is different".
            QCOMPARE(std::abs(back.world->z) <= 1e-11, depth == points.window->z);
        }
        // The window coordinates are the same in a larger window.
        QVERIFY(
            isAt(glm::dvec2(pointsForward(pipelineOf("opencascade-round-trip", {1280, 720, 1.0}), WorldPoint(0, 0, 0))
                                .window.value()
                                .coordinates()),
                 {150, 150}));
    }

    void theQuadIsAtFourNinths()
    {
        const Mesh &quad = sceneOfExample("parallel-orthographic").objects.at(0).model->meshes.at(0);
        const glm::u8vec4 red(255, 0, 0, 255), green(0, 255, 0, 255), blue(0, 0, 255, 255), white(255);
        const struct {
            glm::vec3 place;
            glm::u8vec4 color;
        } corners[] = {{{-4, 4, -4}, red}, {{4, 4, -4}, green}, {{4, -4, -4}, blue}, {{-4, -4, -4}, white}};
        for (const auto &corner : corners) {
            bool found = false;
            for (std::size_t i = 0; i < quad.positions.size(); ++i) {
                if (quad.positions[i] == corner.place) {
                    QVERIFY(quad.colors[i] == corner.color);
                    found = true;
                }
            }
            QVERIFY(found);
        }
        const PipelinePoints top = pointsForward(pipelineOf("parallel-orthographic"), ObjectPoint(4, 4, -4));
        QVERIFY(isAt(top.ndc->coordinates(), {4.0 / 9.0, 4.0 / 9.0, -3.0 / 7.0}));
    }

    void theShearIsNotOne()
    {
        const Pipeline pipeline = pipelineOf("parallel-oblique");
        // x + cot(0.78) z: 4.5 - 3 * 1.0108550 is 0.1467435 of 10; with pi / 4 it would be 0.15.
        const PipelinePoints front = pointsForward(pipeline, ObjectPoint(4.5, 4.5, -3));
        QVERIFY(std::abs(front.ndc->x - 0.146743) <= 1e-5);
        QVERIFY(std::abs(front.ndc->y - 0.146743) <= 1e-5);
        const Box box = sceneOfExample("parallel-oblique").objects.at(0).model->bounds;
        QVERIFY(isAt(box.lowest, {-4.5, -4.5, -4.5}));
        QVERIFY(isAt(box.highest, {4.5, 4.5, -3}));
    }
};

UNPROJECTOR_TEST(TestExamples)
#include "test_examples.moc"
