// Matrices of other programs: core recognises the projection, and both methods honour it.

#include "tests/support/test.h"

#include "core/geometry/matrix_projection.h"
#include "core/geometry/view_matrix.h"
#include "core/unproject/unprojector.h"
#include "tests/support/core_scene.h"
#include "tests/support/unprojecting.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using oracle::Extended;

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// The closed form's promise, as for parameters: 9 epsilons of the scene's scale.
constexpr double kClosedForm = 2e-15;

/// The projection matrices as the references of Direct3D, Vulkan and their like print them; n < f.
enum class Style { OpenGl, ZeroToOne, Reversed, Infinite, InfiniteZeroToOne, InfiniteReversed };

/// @param side  -1: looks down -z, as all but Direct3D's left-handed ones
glm::dmat4 perspectiveMatrix(Style style, double l, double r, double b, double t, double n, double f, double side = -1)
{
    glm::dmat4 m(0.0);
    m[0][0] = 2.0 * n / (r - l);
    m[1][1] = 2.0 * n / (t - b);
    m[2][0] = -side * (r + l) / (r - l);
    m[2][1] = -side * (t + b) / (t - b);
    m[2][3] = side;
    switch (style) {
    case Style::OpenGl:
        m[2][2] = side * (f + n) / (f - n);
        m[3][2] = -2.0 * f * n / (f - n);
        break;
    case Style::ZeroToOne:
        m[2][2] = side * f / (f - n);
        m[3][2] = -(f * n) / (f - n);
        break;
    case Style::Reversed:
        m[2][2] = -side * n / (f - n);
        m[3][2] = f * n / (f - n);
        break;
    case Style::Infinite:
        m[2][2] = side;
        m[3][2] = -2.0 * n;
        break;
    case Style::InfiniteZeroToOne:
        m[2][2] = side;
        m[3][2] = -n;
        break;
    case Style::InfiniteReversed: m[3][2] = n; break;
    }
    return m;
}

NdcDepth depthOf(Style style)
{
    return style == Style::OpenGl || style == Style::Infinite ? NdcDepth::MinusOneToOne : NdcDepth::ZeroToOne;
}

std::array<double, 16> columns(const glm::dmat4 &m)
{
    std::array<double, 16> numbers;
    for (std::size_t i = 0; i < 16; ++i)
        numbers[i] = m[int(i / 4)][int(i % 4)];
    return numbers;
}

glm::dmat4 inSinglePrecision(const glm::dmat4 &m)
{
    return glm::dmat4(glm::mat4(m));
}

double relativeError(const Components<3> &actual, const oracle::Vector3 &exact, const Extended &scale)
{
    return static_cast<double>(oracle::maxNorm(oracle::difference(oracle::extended(actual), exact)) / scale);
}

void addStyles()
{
    addColumn<int>("style");
    newRow("OpenGL") << int(Style::OpenGl);
    newRow("[0, 1]") << int(Style::ZeroToOne);
    newRow("reversed") << int(Style::Reversed);
    newRow("infinite far") << int(Style::Infinite);
    newRow("infinite far, [0, 1]") << int(Style::InfiniteZeroToOne);
    newRow("infinite far, reversed") << int(Style::InfiniteReversed);
}

} // namespace

class TestMatrixProjection : public QObject {
    Q_OBJECT

private slots:
    void printedMatricesAreNamed_data() { addStyles(); }

    void printedMatricesAreNamed()
    {
        QFETCH(int, style);
        const auto s = Style(style);
        for (const double side : {-1.0, 1.0}) {
            for (const double factor : {1.0, 0.25}) {
                const glm::dmat4 m = perspectiveMatrix(s, -1, 3, 0.75, -2, 0.1, 1000, side) * factor;
                const RecognisedProjection p = recognised({m, depthOf(s)}).value();
                const bool infinite = s >= Style::Infinite;
                const Frustum f = std::get<Frustum>(p.parameters);
                QVERIFY2(p.exact, qPrintable(QString("near %1 far %2").arg(f.nearDistance).arg(f.farDistance)));
                QVERIFY(f
                        == (Frustum{-1, 3, 0.75, -2, 0.1, infinite ? std::numeric_limits<double>::infinity() : 1000}));
                QCOMPARE(p.reversed, s == Style::Reversed || s == Style::InfiniteReversed);
                QCOMPARE(p.infiniteFar, infinite);
                QCOMPARE(p.looksAlongPlusZ, side > 0);
                QVERIFY(p.ndcDepth == depthOf(s));
            }
        }
    }

    void withoutAWordOpenGlIsMeantUnlessItCannotBe()
    {
        const auto depth = [](Style style) {
            const MatrixProjection p{perspectiveMatrix(style, -1, 1, -1, 1, 1, 100), {}};
            return recognised(p).value().ndcDepth == ndcDepthOf(p) ? recognised(p).value().ndcDepth : NdcDepth(-1);
        };
        QVERIFY(depth(Style::OpenGl) == NdcDepth::MinusOneToOne);
        QVERIFY(depth(Style::Infinite) == NdcDepth::MinusOneToOne);
        QVERIFY(depth(Style::Reversed) == NdcDepth::ZeroToOne);
        QVERIFY(depth(Style::InfiniteReversed) == NdcDepth::ZeroToOne);
        // [0, 1] with far beyond near is OpenGL's with another near.
        const MatrixProjection p{perspectiveMatrix(Style::ZeroToOne, -1, 1, -1, 1, 1, 100), {}};
        QVERIFY(std::abs(std::get<Frustum>(recognised(p).value().parameters).nearDistance - 100.0 / 199.0) < 1e-15);
    }

    void singlePrecisionNumbersAreReadAsMeant()
    {
        for (const Style style : {Style::OpenGl, Style::ZeroToOne, Style::Reversed}) {
            const glm::dmat4 m = inSinglePrecision(perspectiveMatrix(style, -1.1, 1.1, -0.7, 0.7, 0.1, 100));
            const RecognisedProjection p = recognised({m, depthOf(style)}).value();
            QVERIFY(p.exact);
            const Frustum f = std::get<Frustum>(p.parameters);
            QVERIFY2(f == (Frustum{-1.1, 1.1, -0.7, 0.7, 0.1, 100}),
                     qPrintable(QString("%1 %2 %3 %4").arg(f.left).arg(f.top).arg(f.nearDistance).arg(f.farDistance)));
        }
    }

    void boxesAndShearsAreRecognised()
    {
        const Ortho box{-9, 7, -3, 9.5, -2, 9};
        const RecognisedProjection ortho = recognised({clipFromEye(box).value(), {}}).value();
        QVERIFY(ortho.exact && !ortho.reversed && !ortho.infiniteFar);
        QVERIFY(std::get<Ortho>(ortho.parameters) == box);

        const Oblique oblique{box, 0.78, 2.5};
        const RecognisedProjection sheared = recognised({clipFromEye(oblique).value(), {}}).value();
        const Oblique found = std::get<Oblique>(sheared.parameters);
        QVERIFY(found.box == box);
        QVERIFY(std::abs(found.theta.radians.value - 0.78) <= 4 * kEpsilon
                && std::abs(found.phi.radians.value - 2.5) <= 8 * kEpsilon);

        // Direct3D's box, and the same reversed.
        glm::dmat4 zeroToOne = clipFromEye(box).value();
        zeroToOne[2][2] = -1.0 / 11.0;
        zeroToOne[3][2] = 2.0 / 11.0;
        QVERIFY(std::get<Ortho>(recognised({zeroToOne, NdcDepth::ZeroToOne}).value().parameters) == box);
        zeroToOne[2][2] = 1.0 / 11.0;
        zeroToOne[3][2] = 9.0 / 11.0;
        const RecognisedProjection reversed = recognised({zeroToOne, NdcDepth::ZeroToOne}).value();
        QVERIFY(reversed.reversed && reversed.exact);
        QVERIFY(std::get<Ortho>(reversed.parameters) == box);
    }

    void aFactorOfAnySignIsTheSameProjection_data() { addStyles(); }

    void aFactorOfAnySignIsTheSameProjection()
    {
        QFETCH(int, style);
        const auto s = Style(style);
        for (const double side : {-1.0, 1.0}) {
            const glm::dmat4 m = perspectiveMatrix(s, -1, 3, 0.75, -2, 0.1, 1000, side);
            const RecognisedProjection plain = recognised({m, depthOf(s)}).value();
            QVERIFY(!plain.negated && wInFront({m, depthOf(s)}) == 1.0);
            for (const double factor : {-1.0, -0.25}) {
                const MatrixProjection turned{m * factor, depthOf(s)};
                const RecognisedProjection p = recognised(turned).value();
                QVERIFY(p.negated && p.exact && p.parameters == plain.parameters);
                QVERIFY(p.reversed == plain.reversed && p.looksAlongPlusZ == plain.looksAlongPlusZ);
                QCOMPARE(wInFront(turned), -1.0);
            }
        }
        const Ortho box{-4, 8, -3, 5, -2, 9};
        QVERIFY(std::get<Ortho>(recognised({clipFromEye(box).value() * -2.0, {}}).value().parameters) == box);
        const Setup given{
            {80, 60, 1}, {0, 0, 80, 60}, {0, 1}, MatrixProjection{-clipFromEye(Frustum{}).value(), {}}, LookAt{}};
        QVERIFY(byParameters(given).value().projection() == Projection(Frustum{}));
    }

    void skewsAreRecognised()
    {
        const Frustum skewed{-1, 3, -2, 0.75, 0.1, 1000, 0.25};
        const RecognisedProjection p = recognised({clipFromEye(skewed).value(), {}}).value();
        QVERIFY(p.exact && std::get<Frustum>(p.parameters) == skewed);
        // 2 fx / width, -2 skew / width: the frustum's skew is -skew / fx.
        const Pinhole camera{500, 500, 320, 240, 2, 640, 480, 0.5, 20};
        const Frustum found = std::get<Frustum>(recognised({clipFromEye(camera).value(), {}}).value().parameters);
        QCOMPARE(found.skew, -0.004);
        QVERIFY(frustumFromPinhole(camera) == (Frustum{-0.32, 0.32, -0.24, 0.24, 0.5, 20, -0.004}));
        glm::dmat4 box = clipFromEye(Ortho{}).value();
        box[1][0] = 0.5;
        QVERIFY(recognised({box, {}}).error().code == ErrorCode::MatrixNotAProjection);
    }

    void ourOwnMatricesGiveTheirArgumentsBack_data()
    {
        addColumn<int>("kind");
        newRow("frustum") << int(oracle::RandomKind::Frustum);
        newRow("ortho") << int(oracle::RandomKind::Ortho);
        newRow("oblique") << int(oracle::RandomKind::Oblique);
    }

    void ourOwnMatricesGiveTheirArgumentsBack()
    {
        QFETCH(int, kind);
        oracle::Random random(static_cast<std::uint64_t>(11 + kind));
        for (int i = 0; i < 400; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind(kind), {});
            const Projection given = oracle::coreProjection(scene.projection);
            const glm::dmat4 m = clipFromEye(given).value();
            const RecognisedProjection p = recognised({m, NdcDepth::MinusOneToOne}).value();
            const Projection found = std::visit([](const auto &one) { return Projection(one); }, p.parameters);
            QCOMPARE(found.index(), given.index());
            const ProjectionWindow a = projectionWindow(given), b = projectionWindow(found);

            // No more digits come back than the matrix has: far hangs on zScale + 1, an edge on offset
            // -+ 1.
            const double n = std::abs(a.nearDistance), f = std::abs(a.farDistance),
                         depth = a.farDistance - a.nearDistance;
            const bool perspective = isPerspective(given);
            const double width = std::abs(a.right - a.left), height = std::abs(a.top - a.bottom);
            const double nearUlps = perspective ? 4.0 * n : 8.0 * std::max({n, f, depth});
            const double farUlps = perspective ? 8.0 * f * (1.0 + f / n) : 8.0 * std::max({n, f, depth});
            QVERIFY(std::abs(a.nearDistance - b.nearDistance) <= nearUlps * kEpsilon);
            QVERIFY(std::abs(a.farDistance - b.farDistance) <= farUlps * kEpsilon);
            const auto isNear = [](double x, double y, double scale) {
                return std::abs(x - y) <= 10.0 * kEpsilon * scale;
            };
            const double reachX = width + std::max(std::abs(a.left), std::abs(a.right));
            const double reachY = height + std::max(std::abs(a.bottom), std::abs(a.top));
            QVERIFY(isNear(a.left, b.left, reachX) && isNear(a.right, b.right, reachX));
            QVERIFY(isNear(a.bottom, b.bottom, reachY) && isNear(a.top, b.top, reachY));
            if (p.exact && p.parameters.index() != 2)
                QVERIFY(clipFromEye(found).value() == m);
        }
    }

    void otherMatricesSayWhichEntryDoesNotFit_data()
    {
        addColumn<int>("column");
        addColumn<int>("row");
        addColumn<double>("entry");
        newRow("rolled about the view axis") << 0 << 1 << 0.1;
        newRow("tilted near plane") << 0 << 2 << 0.25;
        newRow("w depends on x") << 0 << 3 << 0.5;
        newRow("shifted before the division") << 3 << 0 << 0.125;
        newRow("neither perspective nor box") << 3 << 3 << 1.0;
        newRow("far plane beyond infinity") << 2 << 2 << -0.875;
    }

    void otherMatricesSayWhichEntryDoesNotFit()
    {
        QFETCH(int, column);
        QFETCH(int, row);
        QFETCH(double, entry);
        glm::dmat4 m = perspectiveMatrix(Style::OpenGl, -1, 1, -1, 1, 1, 9);
        m[column][row] = entry;
        const auto p = recognised({m, {}});
        QVERIFY(!p && p.error().code == ErrorCode::MatrixNotAProjection);
        QCOMPARE(p.error().value, entry);
        QCOMPARE(p.error().other, double(column * 4 + row));
        m = glm::dmat4(1.0);
        m[0][0] = std::nan("");
        QVERIFY(recognised({m, {}}).error().code == ErrorCode::NotFinite);
        QVERIFY(recognised({glm::dmat4(0.0), {}}).error().code == ErrorCode::SingularMatrix);
    }

    void perspectivesHitTheExactPoint_data() { addStyles(); }

    void perspectivesHitTheExactPoint()
    {
        QFETCH(int, style);
        const auto s = Style(style);
        oracle::Random random(static_cast<std::uint64_t>(100 + style));
        double worst = 0.0;
        int recognisedOnes = 0;
        for (int i = 0; i < 1500; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Frustum, {});
            const oracle::Projection &p = scene.projection;
            glm::dmat4 m =
                perspectiveMatrix(s, p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance, random.sign());
            if (random.chance(0.5))
                m[1][0] = random.uniform(-0.5, 0.5) * m[0][0];
            m *= random.sign() * (random.chance(0.5) ? 1.0 : random.uniform(0.1, 10.0));
            if (random.chance(0.5))
                m = inSinglePrecision(m);
            if (!recognised({m, depthOf(s)}))
                continue; // rounded, far may lie beyond infinity
            ++recognisedOnes;
            const glm::dmat4 identity(1.0);
            const oracle::Oracle exact(columns(identity), columns(m), scene.target, depthOf(s) == NdcDepth::ZeroToOne);
            for (int k = 0; k < 4; ++k) {
                const std::array<double, 3> at = oracle::randomClick(random, scene.target);
                const auto eye =
                    unprojectClosedForm(MatrixProjection{m, depthOf(s)}, oracle::coreViewport(scene.target),
                                        oracle::coreDepthRange(scene.target), WindowPoint(at[0], at[1], at[2]));
                if (!eye) {
                    QVERIFY(s >= Style::Infinite || recognised({m, depthOf(s)}).value().infiniteFar);
                    QVERIFY(eye.error().code == ErrorCode::PointAtInfinity);
                    continue;
                }
                const oracle::Vector3 truth = exact.eyeUnder(at);
                worst = std::max(worst, relativeError(*eye, truth, oracle::maxNorm(truth)));
            }
        }
        qInfo("worst: %.3g", worst);
        QVERIFY2(worst <= kClosedForm, qPrintable(QString::number(worst)));
        QVERIFY2(recognisedOnes > 1400, qPrintable(QString::number(recognisedOnes)));
    }

    void boxesHitTheExactPoint()
    {
        oracle::Random random(7);
        double worst = 0.0;
        for (int i = 0; i < 1500; ++i) {
            const oracle::Scene scene = oracle::randomScene(
                random, random.chance(0.5) ? oracle::RandomKind::Ortho : oracle::RandomKind::Oblique, {});
            const double factor = random.chance(0.5) ? 1.0 : random.uniform(0.1, 10.0);
            const glm::dmat4 m = clipFromEye(oracle::coreProjection(scene.projection)).value() * factor;
            const NdcDepth depth = random.chance(0.5) ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne;
            const glm::dmat4 identity(1.0);
            const oracle::Oracle exact(columns(identity), columns(m), scene.target, depth == NdcDepth::ZeroToOne);
            for (int k = 0; k < 4; ++k) {
                const std::array<double, 3> at = oracle::randomClick(random, scene.target);
                const auto eye =
                    unprojectClosedForm(MatrixProjection{m, depth}, oracle::coreViewport(scene.target),
                                        oracle::coreDepthRange(scene.target), WindowPoint(at[0], at[1], at[2]));
                const oracle::Vector3 truth = exact.eyeUnder(at);
                // The scale of a box is its size: the eye has no place in it.
                const ProjectionWindow w = projectionWindow(oracle::coreProjection(scene.projection));
                const double shear = std::max(std::abs(m[2][0] / m[0][0]), std::abs(m[2][1] / m[1][1]));
                const double length = std::max(std::abs(w.nearDistance), std::abs(w.farDistance));
                const double box = std::max(
                    {std::abs(w.left), std::abs(w.right), std::abs(w.bottom), std::abs(w.top), length * (1.0 + shear)});
                worst =
                    std::max(worst, relativeError(eye.value(), truth, std::max(oracle::maxNorm(truth), Extended(box))));
            }
        }
        qInfo("worst: %.3g", worst);
        QVERIFY2(worst <= kClosedForm, qPrintable(QString::number(worst)));
    }

    void theMatrixPathHonoursTheDepths_data() { addStyles(); }

    void theMatrixPathHonoursTheDepths()
    {
        QFETCH(int, style);
        const auto s = Style(style);
        const Setup g{{800, 600, 1},
                      {0, 0, 800, 600},
                      {0, 1},
                      MatrixProjection{perspectiveMatrix(s, -1, 1, -0.75, 0.75, 1, 100), depthOf(s)},
                      LookAt{{1, 2, 5}, {0, 0, 0}, {0, 1, 0}}};
        const WorldPoint point(0.25, -0.5, 0.125);
        const WindowPoint window = windowFromWorld(g, point).value();
        QVERIFY(window.z > 0.0 && window.z < 1.0);
        const Unprojected c = unprojectedAt(g, window);
        for (const auto &world : {c.world[Method::Formula], c.world[Method::Matrix]})
            QVERIFY(glm::all(glm::lessThan(glm::abs(world->coordinates() - point.coordinates()), glm::dvec3(1e-12))));

        // Far away a reversed depth keeps its digits; OpenGL's has none left.
        const WorldPoint distant(-2e7, -4e7, -1e8);
        if (s == Style::InfiniteReversed) {
            const Unprojected ofDistant = unprojectedAt(g, windowFromWorld(g, distant).value());
            for (const auto &world : {ofDistant.world[Method::Formula], ofDistant.world[Method::Matrix]})
                QVERIFY(
                    glm::all(glm::lessThan(glm::abs(world->coordinates() - distant.coordinates()), glm::dvec3(1e-6))));
        }
    }

    void nothingLiesOnAFarPlaneAtInfinity()
    {
        for (const Style s : {Style::Infinite, Style::InfiniteZeroToOne, Style::InfiniteReversed}) {
            const double depth = s == Style::InfiniteReversed ? 0.0 : 1.0;
            const auto eye = unprojectClosedForm(MatrixProjection{perspectiveMatrix(s, -1, 1, -1, 1, 2, 9), depthOf(s)},
                                                 {0, 0, 10, 10}, {0, 1}, WindowPoint(5, 5, depth));
            QVERIFY(!eye && eye.error().code == ErrorCode::PointAtInfinity);
            const auto atNear =
                unprojectClosedForm(MatrixProjection{perspectiveMatrix(s, -1, 1, -1, 1, 2, 9), depthOf(s)},
                                    {0, 0, 10, 10}, {0, 1}, WindowPoint(10, 5, 1 - depth));
            QVERIFY(atNear->coordinates() == glm::dvec3(1, 0, -2));
        }
    }

    void viewsAreReadBackFromTheirMatrix()
    {
        oracle::Random random(5);
        for (int i = 0; i < 1000; ++i) {
            oracle::SceneLimits limits;
            limits.leastUpSine = 0.01;
            const LookAt view = oracle::coreView(oracle::randomScene(random, oracle::RandomKind::Ortho, limits).view);
            const EyeFrame frame = eyeFrame(view).value();
            const LookAt found = lookAtFrom(eyeFromWorld(frame), 2.0).value();
            const EyeFrame again = eyeFrame(found).value();
            const double scale = glm::length(frame.eye.coordinates());
            QVERIFY(distance(again.eye, frame.eye) <= 8 * kEpsilon * scale);
            // The center is two units away from an eye that may be a million away, which costs as many
            // digits of the direction.
            const double tolerance = 8 * kEpsilon * (1.0 + scale);
            QVERIFY(length(again.forward - frame.forward) <= tolerance);
            QVERIFY(length(again.upward - frame.upward) <= tolerance);
            QVERIFY(length(again.side - frame.side) <= tolerance);
        }
        glm::dmat4 mirrored(1.0);
        mirrored[0][0] = -1.0;
        QVERIFY(lookAtFrom(mirrored, 1.0).error().code == ErrorCode::ViewMirrored);
        QVERIFY(worldFromEye(mirrored, EyePoint(1, 2, 3)).value().coordinates() == glm::dvec3(-1, 2, 3));
    }

    void viewMatricesHitTheExactPoint()
    {
        oracle::Random random(6);
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Frustum, {});
            glm::dmat4 view = eyeFromWorld(eyeFrame(oracle::coreView(scene.view)).value());
            if (random.chance(0.5))
                view = inSinglePrecision(view);
            const glm::dmat4 m = clipFromEye(oracle::coreProjection(scene.projection)).value();
            const oracle::Oracle exact(columns(view), columns(m), scene.target, false);
            const Setup g{{100, 100, 1},
                          oracle::coreViewport(scene.target),
                          oracle::coreDepthRange(scene.target),
                          MatrixProjection{m, NdcDepth::MinusOneToOne},
                          view};
            const std::array<double, 3> at = oracle::randomClick(random, scene.target);
            const Unprojected c = unprojectedAt(g, WindowPoint(at[0], at[1], at[2]));
            const oracle::Vector3 truth = exact.worldUnder(at);
            const Extended scale = std::max({oracle::maxNorm(truth), oracle::maxNorm(exact.eyeUnder(at)),
                                             Extended(glm::length(glm::dvec3(view[3])))});
            worst = std::max(worst, relativeError(c.world[Method::Formula].value(), truth, scale));
        }
        qInfo("worst: %.3g", worst);
        QVERIFY2(worst <= kClosedForm, qPrintable(QString::number(worst)));
    }

    void viewsThatDoMoreThanTurnAndMoveAreRefused()
    {
        glm::dmat4 view(1.0);
        view[1][1] = 2.0;
        QVERIFY(axesOff(view).error().code == ErrorCode::ViewNotRigid);
        QCOMPARE(axesOff(view).error().value, 3.0);
        view = glm::dmat4(1.0);
        view[0][3] = 0.5;
        QVERIFY(axesOff(view).error().code == ErrorCode::ViewNotRigid);
        QCOMPARE(axesOff(view).error().other, 3.0);
        view = glm::dmat4(1.0);
        view[2][1] = std::numeric_limits<double>::infinity();
        QVERIFY(axesOff(view).error().code == ErrorCode::NotFinite);
        QCOMPARE(axesOff(glm::dmat4(1.0)).value(), 0.0);
    }

    void theMatrixAnswersWhereNoFormulaDoes()
    {
        glm::dmat4 projection = perspectiveMatrix(Style::OpenGl, -1, 1, -1, 1, 1, 9);
        projection[0][2] = 0.25; // a tilted near plane
        glm::dmat4 view(1.0);
        view[1][1] = 2.0;
        view[3][2] = -4.0;
        const WorldPoint point(0.5, 0.25, -1.0);
        Setup g{{80, 60, 1}, {0, 0, 80, 60}, {0, 1}, MatrixProjection{projection, {}}, LookAt{}};
        Unprojected c = unprojectedAt(g, windowFromWorld(g, point).value());
        QVERIFY(!c.eye[Method::Formula] && c.eye[Method::Formula].error().code == ErrorCode::MatrixNotAProjection);
        QVERIFY(!c.world[Method::Formula] && c.world[Method::Formula].error().code == ErrorCode::MatrixNotAProjection);
        QVERIFY(glm::all(
            glm::lessThan(glm::abs(c.world[Method::Matrix]->coordinates() - point.coordinates()), glm::dvec3(1e-13))));

        g.lens = Projection(Frustum{-1, 1, -1, 1, 1, 9});
        g.pose = view;
        c = unprojectedAt(g, windowFromWorld(g, point).value());
        QVERIFY(c.eye[Method::Formula].hasValue()); // the eye point needs no view
        QVERIFY(!c.world[Method::Formula] && c.world[Method::Formula].error().code == ErrorCode::ViewNotRigid);
        QVERIFY(glm::all(
            glm::lessThan(glm::abs(c.world[Method::Matrix]->coordinates() - point.coordinates()), glm::dvec3(1e-13))));
    }

    void theWindowsPictureIsTheSame_data() { addStyles(); }

    void theWindowsPictureIsTheSame()
    {
        QFETCH(int, style);
        const auto s = Style(style);
        const LookAt camera{{1, 2, 5}, {0, 0, 0}, {0, 1, 0}};
        const Setup g{{800, 600, 1},
                      {0, 0, 800, 600},
                      {0, 0.5},
                      MatrixProjection{perspectiveMatrix(s, -1, 1, -0.75, 0.5, 1, 100), depthOf(s)},
                      eyeFromWorld(eyeFrame(camera).value())};
        const Setup shown = byParameters(g).value();
        for (const glm::dvec3 &p : {glm::dvec3(0.25, -0.5, 0.125), glm::dvec3(-9, 3, -40)}) {
            const glm::dvec3 a = windowFromWorld(g, WorldPoint(p)).value().coordinates();
            const glm::dvec3 b = windowFromWorld(shown, WorldPoint(p)).value().coordinates();
            QVERIFY(glm::length(glm::dvec2(a) - glm::dvec2(b)) < 1e-9);
            QVERIFY(std::abs(a.z - b.z) < (s >= Style::Infinite ? 1e-6 : 1e-13));
        }
        Setup leftHanded = g;
        leftHanded.lens = MatrixProjection{perspectiveMatrix(s, -1, 1, -1, 1, 1, 9, 1), depthOf(s)};
        QVERIFY(byParameters(leftHanded).error().code == ErrorCode::MatrixNotAProjection);
    }
};

UNPROJECTOR_TEST(TestMatrixProjection)
#include "test_matrix_projection.moc"
