// Scenes whose projection or view came as a matrix, and the files that the window writes of them.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"
#include "core/scene_file/scene_file.h"
#include "tests/support/unprojecting.h"

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;

namespace {

constexpr Surface kSurface{640, 480, 1.0};

SceneFile parsed(const QByteArray &projection, const QByteArray &view)
{
    const QByteArray text = R"({"unprojector": 1, "window": {"width": 300, "height": 200}, "depthRange": [0.125, 0.75],
        "projection": )" + projection
                            + ", \"view\": " + view + "}";
    return parseScene(text.toStdString(), "matrices.json").value();
}

/// The window's scene after opening a file. It is what the window writes.
Scene opened(const SceneFile &file)
{
    return sceneFromFile(file, "/there/matrices.json", {}).value();
}

SceneFile saved(const Scene &scene)
{
    const SceneFile file = sceneFileFrom(scene, setupOf(scene, kSurface, {}).value(), "/there/saved.json");
    return parseScene(sceneText(file).value(), "saved.json").value();
}

const char *const kFrustum =
    R"({"type": "matrix", "matrix": [1.1,0,0,0, 0,1.3333333333333333,0,0, 0.1,-0.3,-1.25,-1, 0,0,-2.25,0]})";
const char *const kTurned = R"({"matrix": [0.6,0,0.8,0, 0,1,0,0, -0.8,0,0.6,0, 0.3333333333333333,-2.7,-5.1,1]})";

bool hasMatrixOf(const SceneFile &file, const SceneFile &other)
{
    const auto *a = std::get_if<MatrixProjection>(&file.projection);
    const auto *b = std::get_if<MatrixProjection>(&other.projection);
    return a && b && a->clipFromEye == b->clipFromEye && a->ndcDepth == b->ndcDepth
           && file.depthRange == other.depthRange;
}

bool hasViewOf(const SceneFile &file, const SceneFile &other)
{
    const auto *a = std::get_if<glm::dmat4>(&file.view);
    const auto *b = std::get_if<glm::dmat4>(&other.view);
    return a && b && *a == *b;
}

} // namespace

class TestSceneMatrices : public QObject {
    Q_OBJECT

private slots:
    void anUntouchedMatrixIsWrittenToTheLastDigit_data()
    {
        addColumn<QByteArray>("projection");
        const auto row = [](const char *name, const char *matrix, const char *rest = "") {
            newRow(name) << QByteArray(R"({"type": "matrix", "matrix": [)") + matrix + "]" + rest + "}";
        };
        row("frustum", "1.1,0,0,0, 0,1.3333333333333333,0,0, 0.1,-0.3,-1.25,-1, 0,0,-2.25,0");
        row("single precision", "1.7320507764816284,0,0,0, 0,2.4142136573791504,0,0, 0,0,-1.0020020008087158,-1, "
                                "0,0,-0.20020020008087158,0");
        row("box", "0.3333333333333333,0,0,0, 0,0.7,0,0, 0,0,-0.25,0, 0.1,0.2,-1.3,1");
        row("sheared box", "0.5,0,0,0, 0,0.5,0,0, 0.13,0.07,-0.25,0, 0,0,-1.25,1");
        row("depth of [0, 1]", "1.1,0,0,0, 0,1.3,0,0, 0,0,-1.125,-1, 0,0,-1.125,0", R"(, "ndcDepth": [0, 1])");
        row("reversed", "1.1,0,0,0, 0,1.3,0,0, 0,0,0.125,-1, 0,0,1.125,0", R"(, "ndcDepth": [0, 1])");
        row("far plane at infinity", "1.1,0,0,0, 0,1.3,0,0, 0,0,-1,-1, 0,0,-0.2,0");
        row("three times itself", "3.3,0,0,0, 0,4,0,0, 0,0,-3.75,-3, 0,0,-6.75,0");
    }

    void anUntouchedMatrixIsWrittenToTheLastDigit()
    {
        QFETCH(QByteArray, projection);
        const SceneFile file = parsed(projection, kTurned);
        const SceneFile again = saved(opened(file));
        QVERIFY(hasMatrixOf(again, file));
        QVERIFY(hasViewOf(again, file));
        const SceneFile third = saved(opened(again));
        QVERIFY(hasMatrixOf(third, file) && hasViewOf(third, file));
        QVERIFY(opened(third).projection == opened(file).projection);
    }

    void aMovedCameraIsWrittenByItsArguments()
    {
        const SceneFile file = parsed(kFrustum, kTurned);
        Scene scene = opened(file);
        LookAt moved = scene.camera;
        moved.eye.x += 0.125;
        scene.camera = moved;
        QVERIFY(scene.camera.hadMatrix() && !scene.camera.matrix());
        const SceneFile again = saved(scene);
        QVERIFY(hasMatrixOf(again, file));
        QVERIFY(std::get<LookAt>(again.view).eye.coordinates() == scene.camera->eye.coordinates());
        scene.camera = scene.home; // which the scene opened with, matrix and all
        QVERIFY(hasViewOf(saved(scene), file));
    }

    void anEditedProjectionIsWrittenByItsArguments()
    {
        const SceneFile file = parsed(kFrustum, kTurned);
        Scene scene = opened(file);
        // Near and far also decide how far before the eye the window puts the center: the view's matrix
        // stays all the same.
        auto frustum = std::get<Frustum>(*scene.projection);
        frustum.farDistance *= 2.0;
        scene.projection = frustum;
        const SceneFile again = saved(scene);
        QVERIFY(std::get<Projection>(again.projection) == *scene.projection);
        QVERIFY(hasViewOf(again, file));
        QVERIFY(again.depthRange == file.depthRange);
    }

    void theDepthRangeOfAReversedMatrixStaysEditable()
    {
        const SceneFile file = parsed(
            R"({"type": "matrix", "ndcDepth": [0, 1], "matrix": [1.1,0,0,0, 0,1.3,0,0, 0,0,0.125,-1, 0,0,1.125,0]})",
            kTurned);
        Scene scene = opened(file);
        QVERIFY(scene.depthRange == (DepthRange{0.75, 0.125})); // the near plane has the greater depth
        scene.depthRange.atNear = 0.5;
        const SceneFile again = saved(scene);
        QVERIFY(again.depthRange == (DepthRange{0.125, 0.5}));
        QVERIFY(opened(again).depthRange == scene.depthRange);
    }

    void aClickOnAReversedMatrixIsComputedAgain()
    {
        const Scene scene = opened(parsed(
            R"({"type": "matrix", "ndcDepth": [0, 1], "matrix": [1.1,0,0,0, 0,1.3,0,0, 0,0,0.125,-1, 0,0,1.125,0]})",
            kTurned));
        const Pick pick = pickAt(setupOf(scene, kSurface, {}).value(), {320, 240}, DepthSample{0.5, 0}).value();
        const Setup again = setupOf(clickOf(pick, scene).scene);
        const WorldPoint point = unprojectedAt(again, pick.window).world[Method::Matrix].value();
        QVERIFY(distance(point, pick.point.world[Method::Matrix].value()) < 1e-9);
    }

    void projectionsThatFollowTheWindowAreWrittenAsShown()
    {
        const SceneFile file = parsed(kFrustum, kTurned);
        Scene scene = opened(file);
        scene.projectionFollowsViewport = true;
        const SceneFile again = saved(scene);
        QVERIFY(std::get<Projection>(again.projection) == setupOf(scene, kSurface, {}).value().projection());
    }
};

UNPROJECTOR_TEST(TestSceneMatrices)
#include "test_scene_matrices.moc"
