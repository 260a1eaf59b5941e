// Both unprojections against an independent oracle of 50 digits, over thousands of random cameras.
// Agreement of the two would not do: they start from the same window point.

#include "tests/support/test.h"

#include "core/geometry/transform.h"
#include "core/unproject/batch/click_batch.h"
#include "core/unproject/closed_form.h"
#include "core/unproject/exact_unprojection.h"
#include "core/unproject/matrix_inverse.h"
#include "tests/support/core_scene.h"
#include "tests/support/unprojecting.h"

#include <boost/math/constants/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using oracle::Extended;
using oracle::RandomKind;
using oracle::SceneLimits;

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The closed form's promise: 2 epsilons of the scene's scale, the largest of |point|, |eye| and
/// their distance in the maximum norm. Nothing may be rounded before the end.
constexpr double kClosedForm = 4.5e-16;

/// The matrix path: this many epsilons times the amplification of `matrixAmplification`. Measured:
/// 13.
constexpr double kMatrixEpsilons = 32.0;

/// Units in the last place of the largest world component, for the closed form and every click. The
/// double nearest to the truth is at most half a unit off; the rest is for points where two are
/// equally near.
constexpr double kUlps = 0.51;

double relativeError(const Components<3> &actual, const oracle::Vector3 &exact, const Extended &scale)
{
    return static_cast<double>(oracle::maxNorm(oracle::difference(oracle::extended(actual), exact)) / scale);
}

/// A click on a random scene, and the oracle's point for it.
struct Click {
    WindowPoint window;
    oracle::Vector3 exactEye, exactWorld;
    Extended scale;
};

/// One random scene in core's terms.
struct CoreScene {
    explicit CoreScene(const oracle::Scene &s)
        : scene(s), exact(s.view, s.projection, s.target), frame(eyeFrame(oracle::coreView(s.view)).value()),
          projection(oracle::coreProjection(s.projection)), viewport(oracle::coreViewport(s.target)),
          range(oracle::coreDepthRange(s.target)), clipFromEyeMatrix(clipFromEye(projection).value())
    {
    }

    Click click(oracle::Random &random) const
    {
        const std::array<double, 3> at = oracle::randomClick(random, scene.target);
        Click c{WindowPoint(at[0], at[1], at[2]), exact.eyeUnder(at), exact.worldUnder(at), 0};
        const oracle::Vector3 eye = oracle::extended(frame.eye);
        c.scale = std::max({oracle::maxNorm(c.exactWorld), oracle::maxNorm(eye),
                            oracle::maxNorm(oracle::difference(c.exactWorld, eye))});
        return c;
    }

    WorldPoint worldByFormula(const WindowPoint &window) const
    {
        return worldFromEye(preciseEyeFrame(oracle::coreView(scene.view)).value(),
                            preciseEyePoint(projection, viewport, range, window).value());
    }

    oracle::Scene scene;
    oracle::Oracle exact;
    EyeFrame frame;
    Projection projection;
    Viewport viewport;
    DepthRange range;
    glm::dmat4 clipFromEyeMatrix;
};

/// The factor of the scene's scale by which an inverse matrix may amplify an epsilon.
///
/// A perspective squeezes the distances up to f into the few NDC depths next to 1: one epsilon of
/// z_ndc there is f / n epsilons of the distance. A box is scaled independently along its axes: an
/// epsilon of NDC is one of the box's size. A shear adds cot times the box's length.
double matrixAmplification(const CoreScene &s, const Click &c)
{
    const oracle::Projection &p = s.scene.projection;
    if (isPerspective(s.projection)) {
        const ProjectionWindow w = projectionWindow(s.projection);
        const double offCentre = std::max(std::abs(w.left + w.right) / std::abs(w.right - w.left),
                                          std::abs(w.bottom + w.top) / std::abs(w.top - w.bottom));
        return (1.0 + offCentre) * w.farDistance / w.nearDistance;
    }
    double box = std::max({std::abs(p.left), std::abs(p.right), std::abs(p.bottom), std::abs(p.top)});
    const double length = std::max(std::abs(p.nearDistance), std::abs(p.farDistance));
    box = std::max(box, length);
    const double eye = std::max({std::abs(s.frame.eye.x), std::abs(s.frame.eye.y), std::abs(s.frame.eye.z)});
    const double shear =
        p.kind == RandomKind::Oblique ? std::abs(cotangent(p.thetaRadians)) + std::abs(cotangent(p.phiRadians)) : 0.0;
    return (1.0 + shear) * (box + eye) / static_cast<double>(c.scale);
}

void addKinds()
{
    addColumn<RandomKind>("kind");
    addColumn<quint64>("seed");
    newRow("frustum, off-centre and mirrored too") << RandomKind::Frustum << quint64(1);
    newRow("perspective") << RandomKind::Perspective << quint64(2);
    newRow("ortho, around the eye too") << RandomKind::Ortho << quint64(3);
    newRow("oblique") << RandomKind::Oblique << quint64(4);
}

constexpr int kScenesPerKind = 1500; // 6000 cameras in all
constexpr int kClicksPerScene = 4;

/// The value below which the given share of the sorted values lies.
double percentile(const std::vector<double> &sorted, double share)
{
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

} // namespace

namespace {

/// A vector turned back by glRotate: Rodrigues' formula with 50 digits.
oracle::Vector3 turnedBack(const Rotate &rotate, const oracle::Vector3 &d)
{
    oracle::Vector3 axis = oracle::extended(rotate.axis);
    const Extended size = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (Extended &component : axis)
        component /= size;
    const Extended angle = -Extended(rotate.degrees) * boost::math::constants::pi<Extended>() / 180;
    const Extended along = axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
    oracle::Vector3 turned;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const Extended crossed = axis[i] * d[j] - axis[j] * d[i];
        turned[k] = d[k] * cos(angle) + crossed * sin(angle) + axis[k] * along * (1 - cos(angle));
    }
    return turned;
}

/// glTranslate, glRotate, glScale, glRotate, and its inverse from the reference pages with 50 digits.
struct Placed {
    Translate translate;
    Rotate rotate;
    Scale scale;
    Rotate inner;

    static Placed randomly(oracle::Random &random, double reach)
    {
        const auto three = [&](double low, double high) {
            return glm::dvec3(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
        };
        const glm::dvec3 factors(random.logUniform(1e-6, 1e6), random.logUniform(1e-6, 1e6),
                                 random.logUniform(1e-6, 1e6));
        const Rotate outer{random.uniform(-180.0, 180.0), three(-1.0, 1.0)};
        return {{three(-reach, reach)}, outer, {factors}, {random.uniform(-180.0, 180.0), three(-1.0, 1.0)}};
    }

    PreciseMatrix worldFromObject() const { return preciseWorldFromObject({translate, rotate, scale, inner}); }

    oracle::Vector3 objectFromWorld(const oracle::Vector3 &world) const
    {
        const oracle::Vector3 d = oracle::difference(world, oracle::extended(translate.offset));
        oracle::Vector3 object = turnedBack(rotate, d);
        const oracle::Vector3 factors = oracle::extended(scale.factors);
        for (std::size_t k = 0; k < 3; ++k)
            object[k] /= factors[k];
        return turnedBack(inner, object);
    }
};

/// The greatest error of a coordinate in its own units in the last place. A coordinate that is nothing
/// beside the others counts with the units of 2^-40 of the largest.
double ulpsOff(const std::array<double, 3> &point, const oracle::Vector3 &truth)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double size = static_cast<double>(std::max<Extended>(abs(truth[k]), oracle::maxNorm(truth) * 0x1p-40));
        const Extended ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
        worst = std::max(worst, static_cast<double>(abs(point[k] - truth[k]) / ulp));
    }
    return worst;
}

} // namespace

class TestUnprojectOracle : public QObject {
    Q_OBJECT

private slots:
    /// Checks the oracle itself against figures that a reader can verify.
    void theOracleKnowsTheLiteralNumbers()
    {
        const oracle::View front{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};
        oracle::Projection frustum;
        frustum.kind = RandomKind::Frustum;
        frustum.left = -1;
        frustum.right = 3;
        frustum.bottom = -2;
        frustum.top = 1;
        frustum.nearDistance = 2;
        frustum.farDistance = 10;
        const oracle::Target target{100, 50, 400, 300, 0, 1};
        const oracle::Oracle exact(front, frustum, target);
        // The near plane's bottom left corner lies at z = 5 - 2, the far plane's top right at z = 5 -
        // 10.
        const auto isExactly = [](const oracle::Vector3 &v, double x, double y, double z) {
            return oracle::maxNorm(oracle::difference(v, {Extended(x), Extended(y), Extended(z)})) < 1e-40;
        };
        QVERIFY(isExactly(exact.worldUnder({100, 50, 0}), -1, -2, 3));
        QVERIFY(isExactly(exact.worldUnder({500, 350, 1}), 15, 5, -5));
        QVERIFY(isExactly(exact.eyeUnder({500, 350, 1}), 15, 5, -10));
        // Halfway across and up, at z = 4: d = f (z - n) / (z (f - n)) = 10 * 2 / (4 * 8).
        QVERIFY(isExactly(exact.eyeUnder({300, 200, 0.625}), 2, -1, -4));
        const oracle::Stages stages = exact.forward({Extended(2), Extended(-1), Extended(1)});
        QVERIFY(isExactly(stages.eye, 2, -1, -4));
        QVERIFY(isExactly(stages.ndc, 0, 0, 0.25));
        QVERIFY(isExactly(stages.window, 300, 200, 0.625));
    }

    void closedFormHitsTheExactPoint_data() { addKinds(); }

    void closedFormHitsTheExactPoint()
    {
        QFETCH(RandomKind, kind);
        QFETCH(quint64, seed);
        oracle::Random random(seed);
        double worstEye = 0.0, worstWorld = 0.0;
        for (int count = 0; count < kScenesPerKind; ++count) {
            const CoreScene s(oracle::randomScene(random, kind, SceneLimits{}));
            for (int n = 0; n < kClicksPerScene; ++n) {
                const Click c = s.click(random);
                const auto eye = unprojectClosedForm(s.projection, s.viewport, s.range, c.window);
                QVERIFY(eye);
                worstEye = std::max(worstEye, relativeError(*eye, c.exactEye, c.scale));
                worstWorld = std::max(worstWorld, relativeError(s.worldByFormula(c.window), c.exactWorld, c.scale));
            }
        }
        qInfo("seed %llu: worst error of the scene's scale: eye %.2g, world %.2g", seed, worstEye, worstWorld);
        QVERIFY(std::max(worstEye, worstWorld) <= kClosedForm);
    }

    void closedFormHoldsWhereDigitsAreFew_data()
    {
        addColumn<oracle::View>("view");
        addColumn<oracle::Projection>("projection");
        addColumn<oracle::Target>("target");

        const oracle::View front{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};
        oracle::Projection deep;
        deep.kind = RandomKind::Perspective;
        deep.verticalFovRadians = 1.0;
        deep.aspect = 4.0 / 3.0;
        deep.nearDistance = 0.01;
        deep.farDistance = 1e6;
        const auto change = [](auto value, auto how) {
            how(value);
            return value;
        };
        const oracle::Target plain{0, 0, 800, 600, 0, 1};

        newRow("0.01 : 10^6") << front << deep << plain;
        newRow("0.01 : 10^6, depth reversed") << front << deep << oracle::Target{0, 0, 800, 600, 1, 0};
        newRow("0.01 : 10^6, depth 0.2 to 0.9") << front << deep << oracle::Target{0, 0, 800, 600, 0.2, 0.9};
        newRow("174 degrees") << front << change(deep, [](auto &p) { p.verticalFovRadians = 3.04; }) << plain;
        newRow("up 10^-6 off the view") << oracle::View{{1, 2, 3}, {0.3, 0.7, 0.1}, {-0.7 + 1e-6, -1.3, -2.9}} << deep
                                        << plain;
        newRow("eye 10^6 away, centre 10^-2 further")
            << oracle::View{{1e6, 3e5, -7e5}, {1e6 + 0.007, 3e5 - 0.004, -7e5 + 0.001}, {0, 1, 0}} << deep << plain;
        newRow("box around the eye") << front << change(deep, [](auto &p) {
            p.kind = RandomKind::Ortho;
            p.left = -1e4;
            p.right = 1e4 + 0.1;
            p.nearDistance = -1e6;
        }) << plain;
    }

    void closedFormHoldsWhereDigitsAreFew()
    {
        QFETCH(oracle::View, view);
        QFETCH(oracle::Projection, projection);
        QFETCH(oracle::Target, target);
        const CoreScene s({view, projection, target});
        oracle::Random random(11);
        double worst = 0.0;
        for (int n = 0; n < 4000; ++n) {
            const Click c = s.click(random);
            const auto eye = unprojectClosedForm(s.projection, s.viewport, s.range, c.window);
            QVERIFY(eye);
            worst = std::max(worst, relativeError(worldFromEye(s.frame, *eye), c.exactWorld, c.scale));
        }
        qInfo("worst error of the scene's scale: %.2g", worst);
        QVERIFY(worst <= kClosedForm);
    }

    void matrixStaysWithinItsConditioning_data() { addKinds(); }

    void matrixStaysWithinItsConditioning()
    {
        QFETCH(RandomKind, kind);
        QFETCH(quint64, seed);
        oracle::Random random(seed);
        double worst = 0.0, worstEpsilons = 0.0;
        for (int count = 0; count < kScenesPerKind; ++count) {
            const CoreScene s(oracle::randomScene(random, kind, SceneLimits{}));
            const glm::dmat4 clipFromWorld = s.clipFromEyeMatrix * eyeFromWorld(s.frame);
            for (int n = 0; n < kClicksPerScene; ++n) {
                const Click c = s.click(random);
                const auto eye = unprojectByInverse<EyeSpace>(s.clipFromEyeMatrix, s.viewport, s.range, c.window);
                const auto world = unprojectByInverse<WorldSpace>(clipFromWorld, s.viewport, s.range, c.window);
                QVERIFY(eye);
                QVERIFY(world);
                const double error =
                    std::max(relativeError(*eye, c.exactEye, c.scale), relativeError(*world, c.exactWorld, c.scale));
                worst = std::max(worst, error);
                worstEpsilons = std::max(worstEpsilons, error / (kEpsilon * matrixAmplification(s, c)));
            }
        }
        qInfo("seed %llu: worst error %.2g of the scene's scale, %.1f epsilons times the amplification", seed, worst,
              worstEpsilons);
        QVERIFY(worstEpsilons <= kMatrixEpsilons);
    }

    void forwardOfBackwardIsTheClick_data() { addKinds(); }

    /// Backward by the closed form, forward by core's own matrices in double: the pixel and the depth
    /// clicked.
    void forwardOfBackwardIsTheClick()
    {
        QFETCH(RandomKind, kind);
        QFETCH(quint64, seed);
        oracle::Random random(seed);
        for (int count = 0; count < kScenesPerKind; ++count) {
            const CoreScene s(oracle::randomScene(random, kind, SceneLimits{}));
            const oracle::Projection &p = s.scene.projection;
            for (int n = 0; n < kClicksPerScene; ++n) {
                const Click c = s.click(random);
                const EyePoint eye = unprojectClosedForm(s.projection, s.viewport, s.range, c.window).value();
                const glm::dvec4 clip = s.clipFromEyeMatrix * glm::dvec4(eye.coordinates(), 1.0);
                const WindowPoint window = windowFromNdc(s.viewport, s.range, NdcPoint(glm::dvec3(clip) / clip.w));

                // The window coordinates are sums whose terms are larger than they: an off-centre
                // window's offset, and, sheared, cot z in units of the box.
                const ProjectionWindow w = projectionWindow(s.projection);
                const double shear = p.kind == RandomKind::Oblique ? std::max(std::abs(cotangent(p.thetaRadians)),
                                                                              std::abs(cotangent(p.phiRadians)))
                                                                         * std::abs(eye.z)
                                                                   : 0.0;
                const auto tolerance = [&](double low, double high, double offset, double size) {
                    const double terms = 1.0 + (std::abs(low) + std::abs(high) + shear) / std::abs(high - low);
                    return 16.0 * kEpsilon * (terms * size + std::abs(offset));
                };
                const double thickness = std::abs(w.farDistance - w.nearDistance);
                const double depthTerms = 1.0 + (std::abs(w.farDistance) + std::abs(w.nearDistance)) / thickness;
                QVERIFY(std::abs(window.x - c.window.x) <= tolerance(w.left, w.right, s.viewport.x, s.viewport.width));
                QVERIFY(std::abs(window.y - c.window.y) <= tolerance(w.bottom, w.top, s.viewport.y, s.viewport.height));
                QVERIFY(std::abs(window.z - c.window.z) <= 16.0 * kEpsilon * depthTerms);
            }
        }
    }

    void coreMatricesAreTheOraclesMatrices_data() { addKinds(); }

    void coreMatricesAreTheOraclesMatrices()
    {
        QFETCH(RandomKind, kind);
        QFETCH(quint64, seed);
        oracle::Random random(seed);
        SceneLimits limits;
        limits.leastUpSine = 0.1; // an up closer to the view direction has a row of its own, "up 10^-6 off the view"
        for (int count = 0; count < kScenesPerKind; ++count) {
            const CoreScene s(oracle::randomScene(random, kind, limits));
            const glm::dmat4 view = eyeFromWorld(s.frame);
            const double eye =
                std::max({1.0, std::abs(s.frame.eye.x), std::abs(s.frame.eye.y), std::abs(s.frame.eye.z)});
            for (int row = 0; row < 4; ++row) {
                for (int column = 0; column < 4; ++column) {
                    const Extended exact = s.exact.clipFromEye()[std::size_t(row)][std::size_t(column)];
                    const double projectionError = static_cast<double>(abs(s.clipFromEyeMatrix[column][row] - exact));
                    // A perspective's r + l is exactly 0; each other element is a quotient of two
                    // rounded terms.
                    QVERIFY(projectionError <= 8.0 * kEpsilon * std::abs(static_cast<double>(exact)));
                    const Extended exactView = s.exact.eyeFromWorld()[std::size_t(row)][std::size_t(column)];
                    const double viewError = static_cast<double>(abs(view[column][row] - exactView));
                    QVERIFY(viewError <= 64.0 * kEpsilon * (column == 3 ? eye : 1.0));
                }
            }
        }
    }

    /// z = n f / (f - d (f - n)) is how the inverse of the depth is usually written.
    void theUsualDepthFormulaWouldBreakThePromise()
    {
        const double n = 0.01, f = 1e6;
        oracle::Random random(5);
        double worstUsual = 0.0, worstOurs = 0.0;
        for (int count = 0; count < 4000; ++count) {
            const double d = 1.0 - random.logUniform(1e-10, 1.0); // near the far plane, where most of a deep scene lies
            const Extended exact = Extended(n) * f / (Extended(f) - Extended(d) * (Extended(f) - Extended(n)));
            const auto error = [&](double z) { return static_cast<double>(abs(z - exact) / exact); };
            worstUsual = std::max(worstUsual, error(n * f / (f - d * (f - n))));
            const auto eye = unprojectClosedForm(Projection(Frustum{-n, n, -n, n, n, f}), Viewport{0.0, 0.0, 2.0, 2.0},
                                                 DepthRange{}, WindowPoint(1.0, 1.0, d));
            worstOurs = std::max(worstOurs, error(-eye->z));
        }
        qInfo("usual form %.2g, ours %.2g", worstUsual, worstOurs);
        QVERIFY(worstOurs <= kClosedForm);
        QVERIFY(worstUsual >= 1e4 * kClosedForm);
    }

    void literalPixels_data()
    {
        addColumn<double>("ratio");
        addColumn<WidgetPoint>("click");
        addColumn<glm::dvec3>("world");

        // 400 x 300 logical pixels. The eye at (0, 0, 10) looks down -z; the frustum is [-4, 4] x [-3,
        // 3] on z = 5, far 20. Depth 2/3 is the distance 10, the plane of the origin, where the picture
        // is 16 x 12: 0.04 a pixel at 1x.
        newRow("top-left@1x") << 1.0 << WidgetPoint(0, 0) << glm::dvec3(-7.98, 5.98, 0);
        newRow("top-right@1x") << 1.0 << WidgetPoint(399, 0) << glm::dvec3(7.98, 5.98, 0);
        newRow("bottom-left@1x") << 1.0 << WidgetPoint(0, 299) << glm::dvec3(-7.98, -5.98, 0);
        newRow("bottom-right@1x") << 1.0 << WidgetPoint(399, 299) << glm::dvec3(7.98, -5.98, 0);
        newRow("right below the centre@1x") << 1.0 << WidgetPoint(200, 150) << glm::dvec3(0.02, -0.02, 0);
        newRow("anywhere in the pixel@1x") << 1.0 << WidgetPoint(200.9, 150.1) << glm::dvec3(0.02, -0.02, 0);
        newRow("top-left@2x") << 2.0 << WidgetPoint(0, 0) << glm::dvec3(-7.99, 5.99, 0);
        newRow("last pixel@2x") << 2.0 << WidgetPoint(399.5, 299.5) << glm::dvec3(7.99, -5.99, 0);
        newRow("top-left@1.25x") << 1.25 << WidgetPoint(0, 0) << glm::dvec3(-7.984, 5.984, 0);
        newRow("last pixel@1.25x") << 1.25 << WidgetPoint(399.2, 299.2) << glm::dvec3(7.984, -5.984, 0);
    }

    void literalPixels()
    {
        QFETCH(double, ratio);
        QFETCH(WidgetPoint, click);
        QFETCH(glm::dvec3, world);
        constexpr double kLiteral = 1e-13; // the literals' own rounding, and the inverse matrix's at 5 : 20

        const Surface surface = surfaceFromWidget(400, 300, ratio);
        const Viewport viewport = wholeSurface(surface);
        const Frustum frustum{-4, 4, -3, 3, 5, 20};
        const EyeFrame frame = eyeFrame({WorldPoint(0, 0, 10), WorldPoint(0, 0, 0), {0, 1, 0}}).value();
        const glm::dmat4 clipFromWorld = clipFromEye(frustum).value() * eyeFromWorld(frame);
        const auto isUnder = [&](const WindowPoint &window, double tolerance) {
            const WorldPoint formula =
                worldFromEye(frame, unprojectClosedForm(frustum, viewport, DepthRange{}, window).value());
            const WorldPoint matrix =
                unprojectByInverse<WorldSpace>(clipFromWorld, viewport, DepthRange{}, window).value();
            const auto isNear = [&](const WorldPoint &p) {
                return glm::all(glm::lessThan(glm::abs(p.coordinates() - world), glm::dvec3(tolerance)));
            };
            return isNear(formula) && isNear(matrix);
        };

        const DevicePixel pixel = devicePixelFromWidget(surface, click).value();
        const double depth = 2.0 / 3.0;
        QVERIFY(isUnder(windowFromDevice(surface, pixelCenter(pixel), depth), kLiteral));

        // The usual mistakes elsewhere lie far outside that tolerance, for both methods alike.
        const double i = pixel.i, j = pixel.j, height = surface.heightPixels;
        constexpr double kFar = 1e10 * kLiteral;
        QVERIFY(!isUnder(WindowPoint(i, height - j - 0.5, depth), kFar));     // half a pixel lost across
        QVERIFY(!isUnder(WindowPoint(i + 0.5, height - j, depth), kFar));     // half a pixel lost down: the upper edge
        QVERIFY(!isUnder(WindowPoint(i + 0.5, height - 1 - j, depth), kFar)); // the row's lower edge
        QVERIFY(!isUnder(WindowPoint(i + 0.5, height + 0.5 - j, depth), kFar)); // the row above
        QVERIFY(!isUnder(WindowPoint(i + 0.5, j + 0.5, depth), kFar));          // not flipped
    }

    void unitsInTheLastPlace_data()
    {
        addColumn<double>("nearDistance");
        addColumn<double>("farDistance");
        newRow("5 : 80000") << 5.0 << 80000.0;
        newRow("0.1 : 10000") << 0.1 << 10000.0;
        newRow("1 : 100") << 1.0 << 100.0;
    }

    /// Errors in units in the last place of the exact point's largest world component, for typical
    /// scenes.
    void unitsInTheLastPlace()
    {
        QFETCH(double, nearDistance);
        QFETCH(double, farDistance);
        const SceneLimits limits = oracle::everydayScenes(nearDistance, farDistance);

        constexpr quint64 kSeed = 7;
        oracle::Random random(kSeed);
        std::vector<double> closedForm, glmUnProject;
        for (const auto kind : {RandomKind::Frustum, RandomKind::Perspective, RandomKind::Ortho, RandomKind::Oblique}) {
            for (int count = 0; count < kScenesPerKind; ++count) {
                const CoreScene s(oracle::randomScene(random, kind, limits));
                const glm::dmat4 view = eyeFromWorld(s.frame);
                const glm::dvec4 viewport(s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height);
                for (int n = 0; n < kClicksPerScene; ++n) {
                    const Click c = s.click(random);
                    const double largest = static_cast<double>(oracle::maxNorm(c.exactWorld));
                    const Extended ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
                    closedForm.push_back(relativeError(s.worldByFormula(c.window), c.exactWorld, ulp));
                    glmUnProject.push_back(relativeError(
                        WorldPoint(glm::unProject(c.window.coordinates(), view, s.clipFromEyeMatrix, viewport)),
                        c.exactWorld, ulp));
                }
            }
        }
        for (auto *errors : {&closedForm, &glmUnProject}) {
            std::sort(errors->begin(), errors->end());
            qInfo("seed %llu, %zu clicks, %s: median %.2g ulp, 99%% %.3g, 99.99%% %.3g, worst %.3g", kSeed,
                  errors->size(), errors == &closedForm ? "closed form" : "glm::unProject in double",
                  percentile(*errors, 0.5), percentile(*errors, 0.99), percentile(*errors, 0.9999), errors->back());
        }
        QVERIFY(closedForm.back() <= kUlps);
    }

    void theNearestDoubleToWhatTheUserWrote_data() { addKinds(); }

    /// Rows of a table in eye, world and object space. Positions lie anywhere, angles are degrees with
    /// all the digits of a double, the aspect is the viewport's, and the object is turned and scaled.
    void theNearestDoubleToWhatTheUserWrote()
    {
        QFETCH(RandomKind, kind);
        QFETCH(quint64, seed);
        constexpr double kHalf = 0.5 + 1e-9;
        oracle::Random random(seed);
        const std::array<const char *, 3> names{"eye", "world", "object"};
        std::array<double, 3> worst{};
        for (int count = 0; count < kScenesPerKind; ++count) {
            const double nearDistance = random.logUniform(0.01, 10.0);
            SceneLimits limits = oracle::everydayScenes(nearDistance, nearDistance * random.logUniform(2.0, 1e6));
            limits.plainTarget = count % 2 == 0;
            oracle::Scene s = oracle::randomScene(random, kind, limits);
            oracle::Projection &p = s.projection;
            p.areDegrees = true;
            p.verticalFovRadians = count % 3 == 0 ? random.integer(1, 1790) / 10.0 : random.uniform(0.1, 179.9);
            p.thetaRadians = random.uniform(1.0, 179.0);
            p.phiRadians = random.uniform(1.0, 179.0);
            p.aspect = s.target.width;
            p.aspectHeight = s.target.height;
            const oracle::Oracle exact(s.view, p, s.target);
            const Setup setup = oracle::corePicture(s);
            const Placed placed = Placed::randomly(random, 10.0 * nearDistance);
            const std::array<BatchSpace, 3> spaces{BatchSpace{BatchSpace::Kind::Eye, {}},
                                                   BatchSpace{BatchSpace::Kind::World, {}},
                                                   BatchSpace{BatchSpace::Kind::Object, placed.worldFromObject()}};
            for (int n = 0; n < kClicksPerScene; ++n) {
                const double depth = oracle::randomClick(random, s.target)[2];
                double px = random.uniform(0.0, s.target.width), py = random.uniform(0.0, s.target.height);
                if (n % 2 == 0) { // as a table prints them
                    px = std::round(1000.0 * px) / 1000.0;
                    py = std::round(1000.0 * py) / 1000.0;
                }
                const oracle::Vector3 window{Extended(px), Extended(setup.surface.heightPixels) - py, Extended(depth)};
                const oracle::Vector3 world = exact.worldAt(window);
                const std::array<oracle::Vector3, 3> truth{exact.eyeAt(window), world, placed.objectFromWorld(world)};
                for (std::size_t k = 0; k < spaces.size(); ++k) {
                    std::array<double, 3> point{};
                    ClickBatch::of(Method::Formula, setup, spaces[k])
                        .value()({&px, &py, &depth}, {&point[0], &point[1], &point[2]}, 1);
                    worst[k] = std::max(worst[k], ulpsOff(point, truth[k]));
                }
            }
        }
        for (std::size_t k = 0; k < names.size(); ++k)
            qInfo("%s: worst of %d points: %.9f ulp", names[k], kScenesPerKind * kClicksPerScene, worst[k]);
        QVERIFY(*std::max_element(worst.begin(), worst.end()) <= kHalf);
    }

    /// The matrices' entries are beyond the range of doubles; 50 digits have a range of their own.
    void theExactPointNeedsNoRangeOfDoubles_data()
    {
        addColumn<double>("edge");
        addColumn<double>("nearDistance");
        addColumn<double>("upY");
        newRow("great entries") << 1e-300 << 1e10 << 0.0;
        newRow("small entries") << 1e300 << 1e-30 << 1.0;
    }

    void theExactPointNeedsNoRangeOfDoubles()
    {
        QFETCH(double, edge);
        QFETCH(double, nearDistance);
        QFETCH(double, upY);
        const Frustum frustum{-edge, edge, -edge, edge, nearDistance, 2.0 * nearDistance};
        const Setup setup{{800, 600, 1.0},
                          {0.0, 0.0, 800.0, 600.0},
                          {0.0, 1.0},
                          Projection(frustum),
                          LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), WorldVector(1.0, upY, 0.0)}};
        const auto exact = ExactUnprojection::of(setup);
        QVERIFY(exact.has_value());
        const auto point = exact->at(WindowPoint(800.0, 300.0, 0.0));
        QVERIFY(point.has_value());
        // The middle of the right edge, on the near plane.
        const double share = edge / std::hypot(1.0, upY);
        QVERIFY(abs((*point)[0] - upY * share) <= 1e-14 * edge);
        QVERIFY(abs((*point)[1] + share) <= 1e-14 * edge);
        QVERIFY(abs((*point)[2] - (5.0 - Extended(nearDistance))) <= 1e-14 * nearDistance);
    }
};

UNPROJECTOR_TEST(TestUnprojectOracle)
#include "test_unproject_oracle.moc"
