// The simulated wrong programs: each prints the result that was computed for its mistake beforehand
// and separately.

#include "tests/support/test.h"

#include "tests/support/wrong_programs.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

using namespace wrong_programs;

namespace {

const glm::dvec3 kTruth(0.5, 0.75, -0.25);

Scene tableScene()
{
    Scene scene;
    scene.eye = {3.0, 2.0, 5.0};
    scene.lens.fovyRadians = std::numbers::pi / 4.0;
    scene.lens.aspect = 800.0 / 600.0;
    scene.viewport = {100.0, 40.0, 800.0, 600.0};
    scene.framebufferWidth = 1000.0;
    scene.framebufferHeight = 700.0;
    scene.pixelRatio = 2.0;
    scene.worldFromObject[3] = {2.0, 0.0, -1.0, 1.0};
    return scene;
}

struct Row {
    const char *id;
    int variant;
    glm::dvec3 point;
    double step = 1e-4; ///< of the last digit given
};

/// Worked out in NumPy.
const std::array<Row, 42> kRows{{
    {"y-not-flipped", 0, {0.7051, -0.4122, 0.0918}},
    {"row-above", 0, {0.4986, 0.7577, -0.2523}},
    {"pixel-corner", 0, {0.4972, 0.7462, -0.2468}},
    {"ratio-logical-in-device", 0, {-1.6654, 1.8035, 0.6279}},
    {"ratio-logical-both", 0, {-1.1911, -0.8846, 1.4185}},
    {"ratio-device-in-logical", 0, {3.8822, 4.0191, -3.5869}},
    {"viewport-origin-ignored", 0, {1.1420, 1.0572, -0.7581}},
    {"flipped-with-viewport-height", 0, {0.6355, -0.0180, -0.0241}},
    {"viewport-is-window", 0, {0.4326, 0.5902, -0.1456}},
    {"aspect-integer", 0, {0.3805, 0.75, -0.1783}},
    {"fov-degrees-as-radians", 0, {0.6255, 0.9781, -0.4165}},
    {"fov-half", 0, {0.3119, 0.4080, -0.0004}},
    {"eye-xy-mirrored", 0, {-0.2237, -0.5658, 0.7105}},
    {"ortho-formula", 0, {0.1997, 0.2040, 0.1486}},
    {"divided-by-far", 0, {0.1418, 0.0987, 0.2255}},
    {"linear-angle", 0, {0.4654, 0.7185, -0.2166}},
    {"xy-swapped", 0, {-0.6893, 1.8481, 0.0243}},
    {"depth-not-remapped", 0, {-1.7223, -0.3612, -4.9168}},
    {"depth-remapped-twice", 0, {1.7121, 1.3561, 2.2955}},
    {"depth-linear", 0, {2.5531, 1.7765, 4.0614}},
    {"depth-zero", 0, {2.5749, 1.7874, 4.1072}},
    {"depth-one", 0, {-39.51, -19.26, -84.28}, 1e-2},
    {"depth-is-eye-distance", 0, {3.0882, 2.0441, 5.1852}},
    {"depth-reversed", 0, {2.4939, 1.7469, 3.9371}},
    {"depth-range-is-planes", 0, {2.5756, 1.7878, 4.1087}},
    {"far-differs", 0, {0.3839, 0.6920, -0.4937}},
    {"z-as-ray-length", 0, {0.5282, 0.7641, -0.1907}},
    {"ray-length-as-z", 0, {0.4714, 0.7357, -0.3100}},
    {"no-w-divide", 0, {0.0850, 0.1275, -0.0425}},
    {"view-left-out", 0, {0.5574, 0.6955, -5.8805}},
    {"model-left-in", 0, {-1.5, 0.75, 0.75}},
    {"model-left-out", 0, {2.5, 0.75, -1.25}},
    {"eye-added", 0, {3.5, 2.75, 4.75}},
    {"view-transposed", 0, {-0.1383, -0.0869, 0.1686}},
    {"projection-transposed", 0, {4.0449, 2.2838, 7.8147}},
    {"both-transposed", 0, {-0.1580, -0.1100, 0.1491}},
    {"product-transposed", 0, {-0.0545, 0.0108, -1.3291}},
    {"inverse-order", 0, {-0.8773, -0.4777, 0.4633}},
    {"not-inverted", 0, {-0.0669, 0.0236, 0.6488}},
    {"view-inverse-as-view", 0, {3.5034, 2.2009, -10.4372}},
    {"overwritten-in-place", 0, {0.1684, 0.2526, 0.0006}},
    {"eye-z-positive", 0, {6.2237, 4.5658, 9.2895}},
}};

} // namespace

class TestWrongPrograms : public QObject {
    Q_OBJECT

private slots:
    void theRightProgramPrintsTheTruth_data()
    {
        addColumn<bool>("isPerspective");
        newRow("gluPerspective") << true;
        newRow("glOrtho") << false;
    }

    void theRightProgramPrintsTheTruth()
    {
        QFETCH(bool, isPerspective);
        Scene scene = tableScene();
        scene.lens.isPerspective = isPerspective;
        scene.lens.height = 6.0;
        const Click click = clickOn(scene, kTruth);
        if (isPerspective) {
            QVERIFY(std::abs(click.px - 568.647) <= 5e-4);
            QVERIFY(std::abs(700.0 - click.py - 425.662) <= 5e-4);
            QVERIFY(std::abs(click.depth - 0.838331) <= 5e-7);
        }
        const auto point = printed(scene, click, {});
        QVERIFY(point);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs((*point)[axis] - kTruth[axis]) <= 1e-12);
    }

    void eachMistakePrintsItsPoint_data()
    {
        addColumn<int>("row");
        for (std::size_t i = 0; i < kRows.size(); ++i)
            newRow(kRows[i].id) << int(i);
    }

    void eachMistakePrintsItsPoint()
    {
        QFETCH(int, row);
        const Row &expected = kRows[std::size_t(row)];
        const Scene scene = tableScene();
        const auto point = printed(scene, clickOn(scene, kTruth), {{expected.id, expected.variant}});
        QVERIFY(point);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY2(std::abs((*point)[axis] - expected.point[axis]) <= 0.501 * expected.step,
                     qPrintable(QString::number((*point)[axis], 'f', 6)));
    }

    void mistakesThatCannotBeMadePrintNothing()
    {
        Scene scene = tableScene();
        // 600 / 800 is 0 in whole numbers.
        std::swap(scene.viewport.z, scene.viewport.w);
        scene.lens.aspect = 0.75;
        QVERIFY(!printed(scene, clickOn(scene, kTruth), {{"aspect-integer"}}));
        scene.lens.isPerspective = false;
        scene.lens.height = 6.0;
        QVERIFY(!printed(scene, clickOn(scene, kTruth), {{"ortho-formula"}}));
        QVERIFY(!printed(scene, clickOn(scene, kTruth), {{"linear-angle"}}));
    }
};

UNPROJECTOR_TEST(TestWrongPrograms)
#include "test_wrong_programs.moc"
