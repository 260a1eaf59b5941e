// A click in the conventions of other APIs. The expected numbers were computed apart from this
// program, by the formulas of each API's documentation:
// - gluLookAt and gluPerspective;
// - GLM's perspectiveRH_ZO with its second row negated, and Vulkan's framebuffer coordinates;
// - XMMatrixLookAtLH behind the scale of -1 in z that the SDK asks for when a right-handed world is
//   ported, XMMatrixPerspectiveFovLH and Direct3D's viewport;
// - Metal's and WebGPU's viewport;
// - Unity's worldToCameraMatrix of a left-handed world;
// - calib3d's R, t and K;
// - opencascade-transforms' matrices on row vectors.
#include "tests/support/test.h"

#include "core/geometry/api_conventions.h"
#include "core/scene_file/scene_file.h"

#include "tests/core/parsed_scenes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;
using namespace unprojector::scene;

namespace {

constexpr double kTolerance = 1e-9; // as many digits as the table has
const WorldPoint kPoint(0.5, 0.75, -0.25);

/// Viewport (100, 40, 800, 600) in a window of 1000 x 700 device pixels at ratio 2; 45 degrees,
/// near 1, far 100.
Setup setup()
{
    return {{1000, 700, 2.0},
            {100, 40, 800, 600},
            {},
            Projection(Perspective{std::numbers::pi / 4, 800.0 / 600.0, 1, 100}),
            LookAt{WorldPoint(3, 2, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
}

EyePoint eyePoint(const Setup &p)
{
    return EyePoint(glm::dvec3(eyeFromWorld(p).value() * glm::dvec4(kPoint.coordinates(), 1.0)));
}

std::vector<double> clickIn(const Setup &p, Api api)
{
    const ApiClick c = apiClick(p, api, windowFromWorld(p, kPoint).value(), eyePoint(p), kPoint).value();
    std::vector<double> all{c.position.x, c.position.y, c.depth, c.ndc.x, c.ndc.y, c.ndc.z};
    const glm::dvec4 clip = c.clip.value_or(glm::dvec4(0.0));
    all.insert(all.end(), {clip.x, clip.y, clip.z, clip.w, c.eye.x, c.eye.y, c.eye.z, c.world.x, c.world.y, c.world.z});
    return all;
}

SceneFile parsed(const QByteArray &text)
{
    return parseScene(text.toStdString(), "api.json").value();
}

QByteArray messageFor(const QByteArray &text)
{
    const auto scene = parseScene(text.toStdString(), "api.json");
    return scene ? QByteArray("it was read") : scene_texts::messageWithoutPlace(scene.error());
}

/// A scene whose matrices an API has written.
QByteArray textOf(const char *conventions, const char *projection, const char *view, const char *depth = "")
{
    return QByteArray(R"({"unprojector": 1, "window": {"width": 1000, "height": 700}, )") + conventions
           + R"("viewport": {"x": 100, "y": 40, "width": 800, "height": 600},
             "projection": {"type": "matrix", "matrix": [)"
           + projection + "]" + depth + R"(}, "view": {"matrix": [)" + view + "]}}";
}

const char *const kFlippedProjection = "1.8106601717798214,0,0,0, 0,-2.414213562373095,0,0, "
                                       "0,0,-1.01010101010101,-1, 0,0,-1.0101010101010102,0";
const char *const kRightHandedView = "0.8574929257125442,-0.1669244652223972,0.4866642634032877,0, "
                                     "0,0.9459053029269173,0.3244428422615251,0, "
                                     "-0.5144957554275265,-0.2782074420373286,0.8111071056538127,0, "
                                     "0,0,-6.164414002968977,1";
/// Row by row, as Direct3D stores them.
const char *const kLeftHandedProjection = "1.8106601717798214,0,0,0, 0,2.414213562373095,0,0, "
                                          "0,0,1.01010101010101,1, 0,0,-1.0101010101010102,0";
const char *const kTurnedView = "0.8574929257125442,-0.1669244652223972,-0.4866642634032877,0, "
                                "0,0.9459053029269173,-0.3244428422615251,0, "
                                "-0.5144957554275265,-0.2782074420373286,-0.8111071056538127,0, "
                                "0,0,6.164414002968977,1";

} // namespace

class TestApiConventions : public QObject {
    Q_OBJECT

private slots:
    void aClickHasEachApisNumbers_data()
    {
        addColumn<std::vector<double>>("numbers");
        // position, depth, NDC, clip, eye, world
        const auto row = [](const char *key, const std::vector<double> &numbers) { newRow(key) << numbers; };
        row("opengl", {568.647484851, 425.662250382, 0.838330504968, 0.171618712128, 0.285540834606, 0.676661009936,
                       1.00920838731, 1.6791304493, 3.97912301126, 5.88052651599, 0.557370401713, 0.695518605093,
                       -5.88052651599, 0.5, 0.75, -0.25});
        row("vulkan", {568.647484851, 274.337749618, 0.838330504968, 0.171618712128, -0.285540834606, 0.838330504968,
                       1.00920838731, -1.6791304493, 4.92982476363, 5.88052651599, 0.557370401713, 0.695518605093,
                       -5.88052651599, 0.5, 0.75, -0.25});
        row("direct3d", {568.647484851, 274.337749618, 0.838330504968, 0.171618712128, 0.285540834606, 0.838330504968,
                         1.00920838731, 1.6791304493, 4.92982476363, 5.88052651599, 0.557370401713, 0.695518605093,
                         5.88052651599, 0.5, 0.75, -0.25});
        for (const char *key : {"metal", "webgpu"})
            row(key, {568.647484851, 274.337749618, 0.838330504968, 0.171618712128, 0.285540834606, 0.838330504968,
                      1.00920838731, 1.6791304493, 4.92982476363, 5.88052651599, 0.557370401713, 0.695518605093,
                      -5.88052651599, 0.5, 0.75, -0.25});
        row("threejs", {284.323742426, 137.168874809, 0.838330504968, 0.171618712128, 0.285540834606, 0.676661009936,
                        1.00920838731, 1.6791304493, 3.97912301126, 5.88052651599, 0.557370401713, 0.695518605093,
                        -5.88052651599, 0.5, 0.75, -0.25});
        row("unity", {568.647484851, 425.662250382, 0.161669495032, 0.171618712128, 0.285540834606, 0.676661009936,
                      1.00920838731, 1.6791304493, 3.97912301126, 5.88052651599, 0.557370401713, 0.695518605093,
                      -5.88052651599, 0.5, 0.75, 0.25});
        row("opencv", {568.147484851, 273.837749618, 5.88052651599, 0.0947823974941, -0.118274886305, 1, 0, 0, 0, 0,
                       0.557370401713, -0.695518605093, 5.88052651599, 0.5, 0.75, -0.25});
        row("opencascade", {568.647484851, 274.337749618, 0.838330504968, 0.171618712128, 0.285540834606,
                            0.676661009936, 1.00920838731, 1.6791304493, 3.97912301126, 5.88052651599, 0.557370401713,
                            0.695518605093, -5.88052651599, 0.5, 0.75, -0.25});
    }

    void aClickHasEachApisNumbers()
    {
        QFETCH(std::vector<double>, numbers);
        const std::vector<double> found = clickIn(setup(), apiOf(QTest::currentDataTag()).value());
        QCOMPARE(found.size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            QVERIFY2(std::abs(found[i] - numbers[i]) <= kTolerance,
                     qPrintable(QString("%1: %2 for %3").arg(i).arg(found[i], 0, 'g', 12).arg(numbers[i], 0, 'g', 12)));
    }

    void eachApisOwnMatricesLeadBackToThePoint()
    {
        Setup orthographic = setup();
        orthographic.lens = Projection(Ortho{-4, 4, -3, 3, 1, 20});
        orthographic.depthRange = {0.25, 0.75};
        for (const Setup &p : {setup(), orthographic}) {
            for (const Api api : kApis) {
                const ApiCamera camera = apiCamera(p, api).value();
                const ApiClick click =
                    apiClick(p, api, windowFromWorld(p, kPoint).value(), eyePoint(p), kPoint).value();
                if (!click.clip)
                    continue; // below
                const glm::dmat4 whole = camera.windowFromNdc * camera.clipFromEye * camera.eyeFromWorld;
                const glm::dvec4 back = glm::inverse(whole) * glm::dvec4(click.position, click.depth, 1.0);
                for (int i = 0; i < 3; ++i)
                    QVERIFY2(std::abs(back[i] / back.w - click.world[i]) < kTolerance, conventionsOf(api).name);
            }
        }
    }

    void openCvsCameraProjectsAndUnprojects()
    {
        const Setup p = setup();
        const ApiCamera camera = apiCamera(p, Api::OpenCv).value();
        const glm::dmat3 r(camera.eyeFromWorld), k = camera.intrinsics.value();
        const glm::dvec3 t(camera.eyeFromWorld[3]);
        QVERIFY(std::abs(glm::determinant(r) - 1.0) < kTolerance); // Rodrigues takes no mirrored one
        QVERIFY(std::abs(k[0][0] - 724.264068711929) < kTolerance && std::abs(k[1][1] - 724.264068711929) < kTolerance);
        QVERIFY(std::abs(k[2][0] - 499.5) < kTolerance && std::abs(k[2][1] - 359.5) < kTolerance && k[1][0] == 0.0);
        const glm::dvec3 projected = k * (r * kPoint.coordinates() + t);
        const ApiClick click =
            apiClick(p, Api::OpenCv, windowFromWorld(p, kPoint).value(), eyePoint(p), kPoint).value();
        QVERIFY(glm::distance(glm::dvec2(projected) / projected.z, click.position) < kTolerance);
        const glm::dvec3 back =
            glm::transpose(r) * (glm::inverse(k) * glm::dvec3(click.position, 1.0) * click.depth - t);
        QVERIFY(glm::distance(back, kPoint.coordinates()) < kTolerance);
    }

    /// K has no row for a shift of the eye.
    void aMovedProjectionHasNoCameraMatrix()
    {
        for (int axis = 0; axis < 3; ++axis) {
            Setup p = setup();
            glm::dmat4 moved(1.0);
            moved[3][axis] = 0.5;
            p.lens = MatrixProjection{clipFromEye(setup()).value() * moved, NdcDepth::MinusOneToOne};
            QVERIFY(!apiCamera(p, Api::OpenCv).value().intrinsics);
        }
    }

    /// Nor for a w that grows across the image.
    void aTiltedProjectionHasNoCameraMatrix()
    {
        for (int axis = 0; axis < 2; ++axis) {
            Setup p = setup();
            glm::dmat4 tilted(1.0);
            tilted[axis][2] = 0.25;
            p.lens = MatrixProjection{clipFromEye(setup()).value() * tilted, NdcDepth::MinusOneToOne};
            QVERIFY(!apiCamera(p, Api::OpenCv).value().intrinsics);
        }
    }

    void aBoxHasNoCameraMatrix()
    {
        Setup p = setup();
        p.lens = Projection(Ortho{-4, 4, -3, 3, 1, 20});
        QVERIFY(!apiCamera(p, Api::OpenCv).value().intrinsics);
    }

    void depthsThatAreReversedAlreadyStaySo()
    {
        Setup p = setup();
        p.depthRange = {1.0, 0.0};
        QVERIFY(std::abs(clickIn(p, Api::Unity)[2] - 0.161669495032) < kTolerance);
        QVERIFY(std::abs(clickIn(p, Api::Direct3d)[2] - 0.161669495032) < kTolerance);
    }

    void matricesOfAnApiMakeThePictureThatTheyMakeThere_data()
    {
        addColumn<QByteArray>("text");
        newRow("vulkan") << textOf(R"("conventions": "vulkan", )", kFlippedProjection, kRightHandedView);
        newRow("direct3d") << textOf(R"("conventions": "direct3d", )", kLeftHandedProjection, kTurnedView);
    }

    void matricesOfAnApiMakeThePictureThatTheyMakeThere()
    {
        QFETCH(QByteArray, text);
        const Setup p = setupOf(parsed(text));
        const glm::dvec3 window = windowFromWorld(p, kPoint).value().coordinates();
        QVERIFY(glm::distance(window, glm::dvec3(568.647484851, 425.662250382, 0.838330504968)) < kTolerance);
        const auto shown = sceneFromFile(parsed(text), "/there/api.json", {});
        QVERIFY2(shown, shown ? "" : shown.error().message().c_str());
        QVERIFY(shown->conventions == apiOf(QTest::currentDataTag()));
    }

    void matricesComeBackToTheLastDigit_data() { matricesOfAnApiMakeThePictureThatTheyMakeThere_data(); }

    void matricesComeBackToTheLastDigit()
    {
        QFETCH(QByteArray, text);
        const SceneFile file = parsed(text);
        const Scene scene = sceneFromFile(file, "/there/api.json", {}).value();
        const SceneFile saved = sceneFileFrom(scene, setupOf(scene, {1000, 700, 1.0}, {}).value(), "/there/saved.json");
        const std::string written = scene_file::sceneText(saved).value();
        const auto before = nlohmann::json::parse(text.toStdString()), after = nlohmann::json::parse(written);
        QVERIFY(before["conventions"] == after["conventions"]);
        QVERIFY(before["projection"] == after["projection"]);
        QVERIFY(before["view"] == after["view"]);
    }

    void otherConventionsWriteOtherMatricesOfTheSamePicture()
    {
        const SceneFile file =
            parsed(textOf("", "1.1,0,0,0, 0,1.3,0,0, 0.1,-0.3,-1.25,-1, 0,0,-2.25,0", kRightHandedView));
        Scene scene = sceneFromFile(file, "/there/api.json", {}).value();
        const glm::dvec3 before = windowFromWorld(setupOf(file), kPoint).value().coordinates();
        for (const Api api : kApis) {
            scene.conventions = api;
            const SceneFile saved =
                sceneFileFrom(scene, setupOf(scene, {1000, 700, 1.0}, {}).value(), "/there/saved.json");
            const SceneFile again = parseScene(scene_file::sceneText(saved).value(), "saved.json").value();
            QCOMPARE(again.conventions.has_value(), api != Api::OpenGl);
            const glm::dvec3 after = windowFromWorld(setupOf(again), kPoint).value().coordinates();
            QVERIFY2(glm::distance(before, after) < kTolerance, conventionsOf(api).name);
        }
    }

    void withoutAWordTheyAreOpenGLs()
    {
        const SceneFile file = parsed(textOf("", "1.1,0,0,0, 0,1.3,0,0, 0,0,-1.25,-1, 0,0,-2.25,0", kRightHandedView));
        QVERIFY(!file.conventions);
        QVERIFY(sceneFromFile(file, "/there/api.json", {}).value().conventions == Api::OpenGl);
        QVERIFY(scene_file::sceneText(file).value().find("conventions") == std::string::npos);
    }

    void contradictionsAreRefused()
    {
        QCOMPARE(messageFor(textOf(R"("conventions": "glide", )", kFlippedProjection, kRightHandedView)),
                 "api.json: conventions: \"glide\" must be opengl, vulkan, direct3d, metal, webgpu, threejs, unity, "
                 "opencv or "
                 "opencascade");
        QCOMPARE(messageFor(textOf(R"("conventions": "vulkan", )", kFlippedProjection, kRightHandedView,
                                   R"(, "ndcDepth": [-1, 1])")),
                 "api.json: projection.ndcDepth: [-1,1] must be [0, 1] (\"conventions\": \"vulkan\")");
        QCOMPARE(messageFor(textOf(R"("conventions": "vulkan", )", kFlippedProjection, kRightHandedView,
                                   R"(, "ndcDepth": [0, 1])")),
                 "it was read");
        QCOMPARE(messageFor(textOf(R"("conventions": 5, )", kFlippedProjection, kRightHandedView)),
                 "api.json: conventions: expected a text in quotes, found 5");
    }
};

UNPROJECTOR_TEST(TestApiConventions)
#include "test_api_conventions.moc"
