// The window positions that other programs unproject for a click, and their answers. The positions
// are written out from their sources.
#include "tests/support/test.h"

#include "core/unproject/other_programs.h"

#include <cmath>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

/// 800 x 600 with [-1, 1] x [-3/4, 3/4] at 1, far 4, from (0, 0, 5) down -z: 800 pixels a unit at
/// the distance 2.
Setup setup()
{
    const Surface surface{800, 600, 1.0};
    return {surface,
            wholeSurface(surface),
            {},
            Projection(Frustum{-1, 1, -0.75, 0.75, 1, 4}),
            LookAt{WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
}

} // namespace

Q_DECLARE_METATYPE(unprojector::unproject::OtherProgram)

class TestOtherPrograms : public QObject {
    Q_OBJECT

private slots:
    void namesAreOnesOwn()
    {
        for (const OtherProgram program : kOtherPrograms) {
            QVERIFY(!keyOf(program).empty());
            QVERIFY(otherProgramOf(keyOf(program)) == program);
        }
        QVERIFY(!otherProgramOf("blender"));
    }

    void whereTheyLook_data()
    {
        addColumn<OtherProgram>("program");
        addColumn<double>("x"); // window position, H = 600, pixel (100, 40)
        addColumn<double>("y");
        addColumn<int>("depthRow"); // from the bottom, as glReadPixels counts
        newRow("paper") << OtherProgram::Paper << 100.0 << 560.0 << 559;
        newRow("screen2world") << OtherProgram::Screen2World << 100.0 << 560.0 << 560;
        newRow("MeshLab") << OtherProgram::MeshLab << 100.0 << 560.0 << 560;
        newRow("Polyscope") << OtherProgram::Polyscope << 100.0 << 560.0 << 560;
        newRow("CloudCompare") << OtherProgram::CloudCompare << 100.0 << 559.0 << 559;
        newRow("Open3D") << OtherProgram::Open3D << 100.0 << 560.0 << 559;
        newRow("VTK") << OtherProgram::Vtk << 100.0 * 800 / 799 << 559.0 * 600 / 599 << 559;
    }

    void whereTheyLook()
    {
        QFETCH(OtherProgram, program);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, depthRow);
        const OtherClick click = clickOf(program, setup(), {100, 40});
        const WindowPoint window = windowFromDevice(setup().surface, click.position, 0.0);
        QVERIFY(std::abs(window.x - x) < 1e-12);
        QVERIFY(std::abs(window.y - y) < 1e-12);
        QCOMPARE(click.depthFrom.i, 100);
        QCOMPARE(framebufferRow(setup().surface, click.depthFrom), depthRow);
    }

    /// A pixel is 1/200 wide and high at the distance 2, which is the depth 2/3.
    void whatTheyAnswer()
    {
        const Unprojector unprojector = Unprojector::of(setup()).value();
        const WorldPoint right(-299.5 / 200, 259.5 / 200, 3.0);
        const auto flat = [](const DevicePixel &) { return std::optional(2.0 / 3.0); };
        for (const OtherAnswer &answer : otherAnswers(unprojector, {100, 40}, flat)) {
            QVERIFY(answer.point);
            const double off = 200.0 * distance(*answer.point, right); // in pixels
            if (answer.program == OtherProgram::Vtk)
                QVERIFY(off > 0.4 && off < std::sqrt(0.5));
            else
                QVERIFY(std::abs(off - std::sqrt(0.5)) < 1e-9);
        }
        // The row above shows the far plane, and above the first row is no window.
        const auto edge = [](const DevicePixel &pixel) {
            return pixel.j < 0 ? std::nullopt : std::optional(pixel.j < 40 ? 1.0 : 2.0 / 3.0);
        };
        for (const OtherAnswer &answer : otherAnswers(unprojector, {100, 40}, edge)) {
            const bool looksAbove = answer.program == OtherProgram::Screen2World
                                    || answer.program == OtherProgram::MeshLab
                                    || answer.program == OtherProgram::Polyscope;
            QVERIFY(answer.point);
            QVERIFY(std::abs(answer.point->z - (looksAbove ? 1.0 : 3.0)) < 1e-9);
        }
        for (const OtherAnswer &answer : otherAnswers(unprojector, {100, 0}, edge))
            QCOMPARE(answer.point.has_value(), answer.click.depthFrom.j >= 0);
    }

    void theViewportCounts()
    {
        Setup quarter = setup();
        quarter.viewport = {400, 100, 300, 200};
        // screen2world flips with the viewport's height.
        const OtherClick tutorial = clickOf(OtherProgram::Screen2World, quarter, {450, 150});
        QCOMPARE(windowFromDevice(quarter.surface, tutorial.position, 0.0).y, 50.0);
        QCOMPARE(framebufferRow(quarter.surface, tutorial.depthFrom), 50);
        // VTK is right in the middle of the viewport, and half a pixel off at its edges: to the left,
        // and to the right.
        const auto offAt = [&quarter](int i) {
            return clickOf(OtherProgram::Vtk, quarter, {i, 399}).position.x - pixelCenter({i, 399}).x;
        };
        QVERIFY(std::abs(offAt(400) + 0.5) < 1e-12);
        QVERIFY(std::abs(offAt(699) - 0.5) < 1e-12);
        quarter.viewport.width = 301;
        QVERIFY(std::abs(offAt(550)) < 1e-12);
        quarter.viewport.width = quarter.viewport.height = 1; // nothing to divide by
        QVERIFY(std::isfinite(offAt(400)));
    }
};

UNPROJECTOR_TEST(TestOtherPrograms)
#include "test_other_programs.moc"
