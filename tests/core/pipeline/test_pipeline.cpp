// The pipeline stage by stage: a point by hand, backward against forward, and the meaning of the
// entries.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/pipeline/matrix_entry_name.h"
#include "core/pipeline/matrix_format.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/is_near.h"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>
#include <numbers>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::scene;

namespace {

/// Coordinates of order 10, through five matrices and back in double; near : far = 1 : 100 costs
/// two digits.
constexpr double kRoundTrip = 1e-11;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Setup geometryOf(const Projection &projection, const LookAt &camera, int width, int height, double ratio = 1.0)
{
    const Surface surface = surfaceFromWidget(width, height, ratio);
    return {surface, wholeSurface(surface), {}, projection, camera};
}

LookAt fromFive()
{
    return {WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
}

LookAt aside()
{
    return {WorldPoint(3, 4, 12), WorldPoint(0.5, 1, 0), {0.1, 1, 0}};
}

const Projection kOffCentre = Frustum{-1, 3, -2, 1, 2, 10};
const Projection kPerspective = Perspective{std::numbers::pi / 3.0, 2.0, 1, 100};
const Projection kOrtho = Ortho{-1, 3, -2, 1, 2, 10};
const Projection kOblique = Oblique{{-10, 10, -10, 10, 2, 9}, 0.78, 2.0};

double entry(const Pipeline &p, PipelineStage stage, PipelineDirection direction, int row, int column)
{
    return p.matrix(stage, direction)[column][row];
}

} // namespace

class TestPipeline : public QObject {
    Q_OBJECT

private slots:
    void theFiguresPointGoesThroughEveryStage()
    {
        // The object of fig. 2.7 seen with the box of 2.10 in the 50 x 50 window: all by hand.
        const Pipeline p = pipelineOf(geometryOf(Ortho{-10, 10, -10, 10, -10, 10}, fromFive(), 50, 50),
                                      matrixOf(Translate{{0, 0, -3}}))
                               .value();
        const PipelinePoints points = pointsForward(p, ObjectPoint(2, -4, 1));
        QVERIFY(isNear(points.world->coordinates(), {2, -4, -2}, 0.0));
        QVERIFY(isNear(points.eye->coordinates(), {2, -4, -7}, 0.0));
        QVERIFY(isNear(glm::dvec3(points.clip->coordinates()), {0.2, -0.4, 0.7}, 1e-15));
        QCOMPARE(points.clip->w, 1.0);
        QVERIFY(isNear(points.ndc->coordinates(), {0.2, -0.4, 0.7}, 1e-15));
        QVERIFY(isNear(points.window->coordinates(), {30, 15, 0.85}, 1e-13));
        QVERIFY(isNear({points.device->x, points.device->y, 0}, {30, 35, 0}, 1e-13));
        QVERIFY(isNear({points.widget->x, points.widget->y, 0}, {30, 35, 0}, 1e-13));
        QVERIFY(isNear(pointsForward(p, WorldPoint(2, -4, -2)).object.value().coordinates(), {2, -4, 1}, 0.0));
    }

    void depthOneHalfInNdcIsThreeQuartersInTheWindow()
    {
        // glOrtho(-10, 10, …) puts z_eye = -5 at NDC 0.5.
        const Pipeline p =
            pipelineOf(geometryOf(Ortho{-10, 10, -10, 10, -10, 10}, fromFive(), 50, 50), glm::dmat4(1.0)).value();
        const PipelinePoints points = pointsForward(p, ObjectPoint(0, 0, 0));
        QVERIFY(isNear(points.ndc->coordinates(), {0, 0, 0.5}, 0.0));
        QVERIFY(isNear(points.window->coordinates(), {25, 25, 0.75}, 0.0));
    }

    void theOriginIsTheMiddleOfTheWidgetAtEveryPixelRatio_data()
    {
        addColumn<double>("ratio");
        addColumn<double>("device");
        newRow("@1x") << 1.0 << 150.0;
        newRow("@1.25x") << 1.25 << 187.5;
        newRow("@2x") << 2.0 << 300.0;
    }

    void theOriginIsTheMiddleOfTheWidgetAtEveryPixelRatio()
    {
        QFETCH(double, ratio);
        QFETCH(double, device);
        const Setup setup = geometryOf(Perspective{std::numbers::pi / 2.0, 1, 1, 100},
                                       {WorldPoint(3, 4, 12), WorldPoint(0, 0, 0), {0, 1, 0}}, 300, 300, ratio);
        const PipelinePoints points = pointsForward(pipelineOf(setup, glm::dmat4(1.0)).value(), WorldPoint(0, 0, 0));
        QVERIFY(isNear({points.device->x, points.device->y, 0}, {device, device, 0}, 1e-10));
        // A surface of 375 or 600 pixels has its middle at the same logical pixel.
        QVERIFY(isNear({points.widget->x, points.widget->y, 0}, {150, 150, 0}, 1e-10));
        QCOMPARE(points.clip->w, 13.0); // sqrt(3^2 + 4^2 + 12^2) in front of the eye
    }

    void backwardUndoesForward_data()
    {
        addColumn<Projection>("projection");
        addColumn<ObjectPoint>("point");
        newRow("off-centre frustum") << kOffCentre << ObjectPoint(0.5, -0.25, 1);
        newRow("perspective") << kPerspective << ObjectPoint(0.5, -0.25, 1);
        newRow("perspective, behind the eye") << kPerspective << ObjectPoint(5, -8, 1);
        newRow("ortho") << kOrtho << ObjectPoint(0.5, -0.25, 1);
        newRow("oblique") << kOblique << ObjectPoint(0.5, -0.25, 1);
    }

    void backwardUndoesForward()
    {
        QFETCH(Projection, projection);
        QFETCH(ObjectPoint, point);
        Setup setup = geometryOf(projection, aside(), 640, 480, 1.5);
        setup.viewport = {13, 7, 400, 300};
        setup.depthRange = {0.9, 0.1};
        const Pipeline p =
            pipelineOf(setup, worldFromObject({Translate{{1, 2, 3}}, Rotate{30, {1, 2, 3}}, Scale{{1, -2, 0.5}}}))
                .value();
        const PipelinePoints forward = pointsForward(p, point);
        const PipelinePoints back = pointsBackward(p, *forward.window);
        QVERIFY(isNear(back.ndc->coordinates(), forward.ndc->coordinates(), kRoundTrip));
        QVERIFY(isNear(glm::dvec3(back.clip->coordinates()), glm::dvec3(forward.clip->coordinates()), kRoundTrip));
        QVERIFY(std::abs(back.clip->w - forward.clip->w) <= kRoundTrip);
        QVERIFY(isNear(back.eye->coordinates(), forward.eye->coordinates(), kRoundTrip));
        QVERIFY(isNear(back.world->coordinates(), forward.world->coordinates(), kRoundTrip));
        QVERIFY(isNear(back.object->coordinates(), point.coordinates(), kRoundTrip));
        QVERIFY(isNear({back.widget->x, back.widget->y, 0}, {forward.widget->x, forward.widget->y, 0}, 0.0));
        // GLM's own way forward, which shares no code with ours.
        const glm::dvec3 window = glm::projectNO(
            point.coordinates(), p.matrix(PipelineStage::ModelviewMatrix, PipelineDirection::Forward),
            p.matrix(PipelineStage::ProjectionMatrix, PipelineDirection::Forward), glm::dvec4(13, 7, 400, 300));
        QVERIFY(isNear(forward.window->coordinates(), {window.x, window.y, 0.9 - 0.8 * window.z}, kRoundTrip * 100.0));
    }

    void theProductsAreThoseOfTheStages()
    {
        const Pipeline p =
            pipelineOf(geometryOf(kOffCentre, aside(), 640, 480), matrixOf(Rotate{30, {1, 2, 3}})).value();
        const PipelinePoints points = pointsForward(p, ObjectPoint(0.5, -0.25, 1));
        const glm::dvec4 whole =
            p.matrix(PipelineStage::WholeMatrix, PipelineDirection::Forward) * glm::dvec4(0.5, -0.25, 1, 1);
        QVERIFY(isNear(glm::dvec3(whole) / whole.w, points.window->coordinates(), 1e-10));
        const glm::dvec4 object = p.matrix(PipelineStage::WholeMatrix, PipelineDirection::Backward)
                                  * glm::dvec4(points.window->coordinates(), 1);
        QVERIFY(isNear(glm::dvec3(object) / object.w, {0.5, -0.25, 1}, kRoundTrip));
        const glm::dvec4 eye =
            p.matrix(PipelineStage::ModelviewMatrix, PipelineDirection::Forward) * glm::dvec4(0.5, -0.25, 1, 1);
        QVERIFY(isNear(glm::dvec3(eye), points.eye->coordinates(), 1e-14));
        const glm::dvec4 back = p.matrix(PipelineStage::ModelviewMatrix, PipelineDirection::Backward) * eye;
        QVERIFY(isNear(glm::dvec3(back), {0.5, -0.25, 1}, 1e-14));

        // Row vectors: v * M with the matrices transposed and in reversed order.
        glm::dmat4 rows[3];
        const PipelineStage stages[] = {PipelineStage::ModelMatrix, PipelineStage::ViewMatrix,
                                        PipelineStage::ProjectionMatrix};
        for (int i = 0; i < 3; ++i) {
            for (int r = 0; r < 4; ++r) {
                for (int c = 0; c < 4; ++c)
                    rows[i][c][r] = entryAt(p.matrix(stages[i], PipelineDirection::Forward), MatrixLayout::Row, r, c);
            }
        }
        const glm::dvec4 clip = glm::dvec4(0.5, -0.25, 1, 1) * (rows[0] * rows[1] * rows[2]);
        QVERIFY(isNear(glm::dvec3(clip), glm::dvec3(points.clip->coordinates()), 1e-13));
    }

    void aPointInThePlaneOfTheEyeStopsAtTheDivision()
    {
        const Pipeline p = pipelineOf(geometryOf(kPerspective, fromFive(), 50, 50), glm::dmat4(1.0)).value();
        const PipelinePoints points = pointsForward(p, WorldPoint(1, 2, 5));
        QVERIFY(points.eye && points.clip);
        QCOMPARE(points.clip->w, 0.0);
        QVERIFY(!points.ndc && !points.window && !points.widget);
        QCOMPARE(points.ndc.error().code, ErrorCode::PointAtInfinity);
        QCOMPARE(points.widget.error().code, ErrorCode::PointAtInfinity);

        // Beyond the far plane the inverse meets infinity: z_ndc = (f+n)/(f-n), where w' = 0. n = 1, f
        // = 3 make it exactly 2.
        const Pipeline q =
            pipelineOf(geometryOf(Perspective{std::numbers::pi / 2.0, 1, 1, 3}, fromFive(), 50, 50), glm::dmat4(1.0))
                .value();
        const PipelinePoints back = pointsBackward(q, WindowPoint(25, 25, 1.5));
        QVERIFY(back.ndc);
        QVERIFY(!back.clip && !back.object);
        QCOMPARE(back.clip.error().code, ErrorCode::PointAtInfinity);

        QVERIFY(isInsideViewVolume(ClipPoint(1, -1, 1, 1)));
        QVERIFY(!isInsideViewVolume(ClipPoint(1, -1, 1.0001, 1)));
        QVERIFY(!isInsideViewVolume(ClipPoint(0, 0, 0, -1)));
    }

    void theClipTestSaysWhereAPointLies_data()
    {
        addColumn<ClipPoint>("point");
        addColumn<std::vector<Outside>>("expected");
        using enum Outside;
        const auto row = [](const char *name, const ClipPoint &point, const std::vector<Outside> &expected) {
            newRow(name) << point << expected;
        };
        row("inside", {0.5, -0.5, 1.9, 2}, {});
        row("on the edges", {2, -2, 2, 2}, {});
        row("left", {-2.1, 0, 0, 2}, {Left});
        row("right", {2.1, 0, 0, 2}, {Right});
        row("below", {0, -2.1, 0, 2}, {Bottom});
        row("above", {0, 2.1, 0, 2}, {Top});
        row("before the near plane", {0, 0, -2.1, 2}, {Near});
        row("behind the far plane", {0, 0, 2.1, 2}, {Far});
        row("two at once", {-3, 0, 2.1, 2}, {Left, Far});
        row("three at once", {3, 3, -3, 2}, {Right, Top, Near});
        row("behind the eye", {-3, 0, 3, -1}, {BehindEye});
        row("in the plane of the eye", {-3, 0, 3, 0}, {InEyePlane});
    }

    void theClipTestSaysWhereAPointLies()
    {
        QFETCH(ClipPoint, point);
        QFETCH(std::vector<Outside>, expected);
        QVERIFY(clipTest(point) == expected);
        QCOMPARE(isInsideViewVolume(point), expected.empty());
    }

    void badValuesAreNamed()
    {
        Setup setup = geometryOf(kPerspective, fromFive(), 50, 50);
        QCOMPARE(pipelineOf(setup, glm::dmat4(0.0)).error().code, ErrorCode::SingularMatrix);
        glm::dmat4 broken(1.0);
        broken[3][1] = kNaN;
        QCOMPARE(pipelineOf(setup, broken).error().code, ErrorCode::NotFinite);
        // Invertible in principle, but 1e-200 cubed is below the smallest double.
        QCOMPARE(pipelineOf(setup, matrixOf(Scale{glm::dvec3(1e-200)})).error().code, ErrorCode::SingularMatrix);
        const Pipeline p = pipelineOf(setup, glm::dmat4(1.0)).value();
        QCOMPARE(pointsForward(p, WorldPoint(0, kNaN, 0)).widget.error().code, ErrorCode::NotFinite);
        QCOMPARE(pointsBackward(p, WindowPoint(0, kNaN, 0)).object.error().code, ErrorCode::NotFinite);
        setup.camera().eye = setup.camera().center;
        QCOMPARE(pipelineOf(setup, glm::dmat4(1.0)).error().code, ErrorCode::EyeEqualsCenter);
    }

    void entryNamesMeanTheirNumbers_data()
    {
        addColumn<Projection>("projection");
        addColumn<PipelineStage>("stage");
        addColumn<PipelineDirection>("direction");
        addColumn<int>("row");
        addColumn<int>("column");
        addColumn<QString>("name");
        addColumn<double>("value");

        const auto forward = PipelineDirection::Forward, backward = PipelineDirection::Backward;
        const auto projection = PipelineStage::ProjectionMatrix, view = PipelineStage::ViewMatrix,
                   viewport = PipelineStage::ViewportMatrix;
        // l, r, b, t, n, f = -1, 3, -2, 1, 2, 10
        newRow("frustum 0 0") << kOffCentre << projection << forward << 0 << 0 << "2n/(r−l)" << 2.0 * 2 / 4;
        newRow("frustum 0 2") << kOffCentre << projection << forward << 0 << 2 << "(r+l)/(r−l)" << 2.0 / 4;
        newRow("frustum 1 1") << kOffCentre << projection << forward << 1 << 1 << "2n/(t−b)" << 2.0 * 2 / 3;
        newRow("frustum 1 2") << kOffCentre << projection << forward << 1 << 2 << "(t+b)/(t−b)" << -1.0 / 3;
        newRow("frustum 2 2") << kOffCentre << projection << forward << 2 << 2 << "−(f+n)/(f−n)" << -12.0 / 8;
        newRow("frustum 2 3") << kOffCentre << projection << forward << 2 << 3 << "−2fn/(f−n)" << -40.0 / 8;
        newRow("frustum 3 2") << kOffCentre << projection << forward << 3 << 2 << "−1" << -1.0;
        newRow("frustum back 0 0") << kOffCentre << projection << backward << 0 << 0 << "(r−l)/(2n)" << 4.0 / 4;
        newRow("frustum back 0 3") << kOffCentre << projection << backward << 0 << 3 << "(r+l)/(2n)" << 2.0 / 4;
        newRow("frustum back 1 3") << kOffCentre << projection << backward << 1 << 3 << "(t+b)/(2n)" << -1.0 / 4;
        newRow("frustum back 3 2") << kOffCentre << projection << backward << 3 << 2 << "−(f−n)/(2fn)" << -8.0 / 40;
        newRow("frustum back 3 3") << kOffCentre << projection << backward << 3 << 3 << "(f+n)/(2fn)" << 12.0 / 40;
        // fovy 60 degrees, aspect 2: cot 30 = sqrt 3
        newRow("perspective 0 0") << kPerspective << projection << forward << 0 << 0 << "cot(fovy/2)/aspect"
                                  << std::numbers::sqrt3 / 2;
        newRow("perspective 1 1") << kPerspective << projection << forward << 1 << 1 << "cot(fovy/2)"
                                  << std::numbers::sqrt3;
        newRow("perspective back 0 0") << kPerspective << projection << backward << 0 << 0 << "aspect·tan(fovy/2)"
                                       << 2 / std::numbers::sqrt3;
        newRow("ortho 0 3") << kOrtho << projection << forward << 0 << 3 << "−(r+l)/(r−l)" << -2.0 / 4;
        newRow("ortho 2 2") << kOrtho << projection << forward << 2 << 2 << "−2/(f−n)" << -2.0 / 8;
        newRow("ortho back 1 3") << kOrtho << projection << backward << 1 << 3 << "(t+b)/2" << -0.5;
        newRow("ortho back 2 2") << kOrtho << projection << backward << 2 << 2 << "−(f−n)/2" << -4.0;
        newRow("ortho back 2 3") << kOrtho << projection << backward << 2 << 3 << "−(f+n)/2" << -6.0;
        // cot 0.78 = 1.010855029, cot 2 = -0.457657554
        newRow("oblique 0 2") << kOblique << projection << forward << 0 << 2 << "2 cot θ/(r−l)"
                              << 2 * 1.0108550294569216 / 20;
        newRow("oblique 1 2") << kOblique << projection << forward << 1 << 2 << "2 cot φ/(t−b)"
                              << 2 * -0.45765755436028577 / 20;
        newRow("oblique back 0 2") << kOblique << projection << backward << 0 << 2 << "cot θ·(f−n)/2"
                                   << 1.0108550294569216 * 7 / 2;
        newRow("oblique back 0 3") << kOblique << projection << backward << 0 << 3 << "(r+l)/2 + cot θ·(f+n)/2"
                                   << 1.0108550294569216 * 11 / 2;
        newRow("oblique back 1 3") << kOblique << projection << backward << 1 << 3 << "(t+b)/2 + cot φ·(f+n)/2"
                                   << -0.45765755436028577 * 11 / 2;
        // The eye (0, 0, 5) looks along -z: s = x, u = y, f = -z.
        newRow("view 0 0") << kOrtho << view << forward << 0 << 0 << "s.x" << 1.0;
        newRow("view 2 2") << kOrtho << view << forward << 2 << 2 << "−f.z" << 1.0;
        newRow("view 2 3") << kOrtho << view << forward << 2 << 3 << "f·eye" << -5.0;
        newRow("view back 1 1") << kOrtho << view << backward << 1 << 1 << "u.y" << 1.0;
        newRow("view back 2 3") << kOrtho << view << backward << 2 << 3 << "eye.z" << 5.0;
        // vx, vy, w, h = 13, 7, 400, 300; dn, df = 0.25, 0.75
        newRow("viewport 0 0") << kOrtho << viewport << forward << 0 << 0 << "w/2" << 200.0;
        newRow("viewport 0 3") << kOrtho << viewport << forward << 0 << 3 << "vx + w/2" << 213.0;
        newRow("viewport 1 3") << kOrtho << viewport << forward << 1 << 3 << "vy + h/2" << 157.0;
        newRow("viewport 2 2") << kOrtho << viewport << forward << 2 << 2 << "(df−dn)/2" << 0.25;
        newRow("viewport 2 3") << kOrtho << viewport << forward << 2 << 3 << "(dn+df)/2" << 0.5;
        newRow("viewport back 0 0") << kOrtho << viewport << backward << 0 << 0 << "2/w" << 1.0 / 200;
        newRow("viewport back 1 3") << kOrtho << viewport << backward << 1 << 3 << "−(2vy+h)/h" << -314.0 / 300;
        newRow("viewport back 2 3") << kOrtho << viewport << backward << 2 << 3 << "−(dn+df)/(df−dn)" << -2.0;
        newRow("model 1 3") << kOrtho << PipelineStage::ModelMatrix << forward << 1 << 3 << "T.y" << 2.0;
        newRow("model 2 1: where y goes") << kOrtho << PipelineStage::ModelMatrix << forward << 2 << 1 << "Y.z" << 1.0;
    }

    void entryNamesMeanTheirNumbers()
    {
        QFETCH(Projection, projection);
        QFETCH(PipelineStage, stage);
        QFETCH(PipelineDirection, direction);
        QFETCH(int, row);
        QFETCH(int, column);
        QFETCH(QString, name);
        QFETCH(double, value);
        Setup setup = geometryOf(projection, fromFive(), 640, 480);
        setup.viewport = {13, 7, 400, 300};
        setup.depthRange = {0.25, 0.75};
        const Pipeline p = pipelineOf(setup, worldFromObject({Translate{{1, 2, 3}}, Rotate{90, {1, 0, 0}}})).value();
        const std::string_view symbol = matrixEntryName(stage, direction, kindOf(projection), row, column);
        QCOMPARE(QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size())), name);
        const double found = entry(p, stage, direction, row, column);
        QVERIFY2(std::abs(found - value) <= 1e-14 * std::max(1.0, std::abs(value)),
                 qPrintable(QString::number(found, 'g', 17)));
    }

    void entriesNamedAsConstantsAreConstant()
    {
        for (const Projection &projection : {kOffCentre, kPerspective, kOrtho, kOblique}) {
            Setup setup = geometryOf(projection, aside(), 640, 480);
            setup.viewport = {13, 7, 400, 300};
            const Pipeline p =
                pipelineOf(setup, worldFromObject({Translate{{1, 2, 3}}, Rotate{40, {1, 2, 0}}})).value();
            for (const PipelineStage stage : kPipelineStages) {
                for (const auto direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
                    for (int index = 0; index < 16; ++index) {
                        const std::string_view name =
                            matrixEntryName(stage, direction, kindOf(projection), index % 4, index / 4);
                        const double value = entry(p, stage, direction, index % 4, index / 4);
                        if (name == "0" || name == "1" || name == "−1")
                            QVERIFY(std::abs(value - (name == "0" ? 0.0 : name == "1" ? 1.0 : -1.0)) <= 1e-15);
                        else if (stage != PipelineStage::WholeMatrix && stage != PipelineStage::ViewportMatrix)
                            QVERIFY2(value != 0.0 || kindOf(projection) != ProjectionKind::Frustum, name.data());
                    }
                }
            }
        }
    }

    void aPointGivenInAnySpaceIsTheSamePoint_data()
    {
        addColumn<Projection>("projection");
        addColumn<double>("zEye");
        newRow("off centre") << kOffCentre << -5.0;
        newRow("perspective") << kPerspective << -20.0;
        newRow("behind the eye") << kPerspective << 3.0;
        newRow("beyond far") << kPerspective << -400.0;
        newRow("ortho") << kOrtho << -4.0;
        newRow("oblique") << kOblique << -7.0;
    }

    void aPointGivenInAnySpaceIsTheSamePoint()
    {
        QFETCH(Projection, projection);
        QFETCH(double, zEye);
        Setup setup = geometryOf(projection, aside(), 640, 480, 2.0);
        setup.viewport = {13, 7, 400, 300};
        setup.depthRange = {0.25, 0.75};
        const Pipeline p = pipelineOf(setup, worldFromObject({Translate{{1, 2, 3}}, Rotate{40, {1, 2, 0}}})).value();
        const PipelinePoints truth = pointsFrom(p, {EyePoint(0.7, -0.4, zEye)});
        const std::vector<GivenPoint> ways{{*truth.object}, {*truth.world}, {*truth.eye},
                                           {*truth.clip},   {*truth.ndc},   {*truth.window}};
        for (const GivenPoint &given : ways) {
            const PipelinePoints points = pointsFrom(p, given);
            // Near : far = 1 : 100, and a point at four times far, cost digits of the way back from
            // NDC.
            constexpr double kWay = 1e-8;
            QVERIFY(isNear(points.object->coordinates(), truth.object->coordinates(), kWay));
            QVERIFY(isNear(points.world->coordinates(), truth.world->coordinates(), kWay));
            QVERIFY(isNear(points.eye->coordinates(), truth.eye->coordinates(), kWay));
            QVERIFY(isNear(glm::dvec3(points.clip->coordinates()), glm::dvec3(truth.clip->coordinates()), kWay));
            QVERIFY(std::abs(points.clip->w - truth.clip->w) <= kWay);
            QVERIFY(isNear(points.ndc->coordinates(), truth.ndc->coordinates(), kWay));
            QVERIFY(isNear(points.window->coordinates(), truth.window->coordinates(), kWay));
            QVERIFY(isNear(glm::dvec3(points.widget->coordinates(), 0.0), glm::dvec3(truth.widget->coordinates(), 0.0),
                           kWay));
            const glm::dvec4 &undivided = points.undividedEye.value();
            QVERIFY(isNear(glm::dvec3(undivided) / undivided.w, truth.eye->coordinates(), kWay));
        }
        // The given point is not rounded.
        QVERIFY(pointsFrom(p, ways[0]).object.value() == *truth.object);
        QVERIFY(pointsFrom(p, ways[3]).clip.value().coordinates() == truth.clip->coordinates());
        QVERIFY(pointsFrom(p, ways[5]).window.value() == *truth.window);
    }

    void multiplesOfAClipPointAreOnePoint()
    {
        const Pipeline p = pipelineOf(geometryOf(kPerspective, aside(), 640, 480), glm::dmat4(1.0)).value();
        const PipelinePoints one = pointsFrom(p, {ClipPoint(1, 2, 3, 4)}),
                             half = pointsFrom(p, {ClipPoint(0.5, 1, 1.5, 2)});
        QVERIFY(isNear(one.world->coordinates(), half.world->coordinates(), 1e-12));
        QVERIFY(isNear(one.ndc->coordinates(), {0.25, 0.5, 0.75}, 1e-15));
        QVERIFY(half.ndc.value() == *one.ndc);
        QVERIFY(half.clip->w == 2.0);
    }

    void aGivenPointMayHaveNoWay()
    {
        const Pipeline p = pipelineOf(geometryOf(kPerspective, aside(), 640, 480), glm::dmat4(1.0)).value();
        // The point lies in the plane of the eye: it has no NDC, but everything before it.
        const PipelinePoints level = pointsFrom(p, {EyePoint(1, 1, 0)});
        QCOMPARE(level.ndc.error().code, ErrorCode::PointAtInfinity);
        QCOMPARE(level.widget.error().code, ErrorCode::PointAtInfinity);
        QVERIFY(level.object.hasValue() && level.clip.hasValue() && !level.undividedEye);
        // A direction in clip space: no eye point, but the clip point as it was given.
        const PipelinePoints direction = pointsFrom(p, {ClipPoint(0, 0, 0, 0)});
        QVERIFY(direction.clip.hasValue());
        QCOMPARE(direction.world.error().code, ErrorCode::PointAtInfinity);
        QCOMPARE(direction.window.error().code, ErrorCode::PointAtInfinity);
        QCOMPARE(pointsFrom(p, {WindowPoint(kNaN, 0, 0)}).object.error().code, ErrorCode::NotFinite);
    }
};

UNPROJECTOR_TEST(TestPipeline)
#include "test_pipeline.moc"
