// The loops over many points against the oracle of 50 digits, and every instruction set against the
// plain one.

#include "tests/support/test.h"

#include "core/geometry/transform.h"
#include "core/unproject/batch/batch_unproject.h"
#include "tests/support/batch_arrays.h"
#include "tests/support/core_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_kinds.h"
#include "tests/support/unprojecting.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using oracle::Extended;
using oracle::RandomKind;
using oracle::SceneLimits;

namespace {

/// Units in the last place of the largest world component. The bound holds for 99.99 % of the
/// points, and for every point that is no closer to the world's origin than `kCloseToOrigin` of the
/// scene's scale (see test_unproject_oracle).
constexpr double kMostUlps = 8.0;
constexpr double kAllUlps = 20.0;
constexpr double kCloseToOrigin = 1.0 / 16.0;

/// Clicks as arrays of device positions. Their window positions are exact: these have few bits.
Triples<double> randomClicks(oracle::Random &random, const oracle::Scene &s, std::size_t count)
{
    Triples<double> clicks(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<double, 3> at = oracle::randomClick(random, s.target);
        clicks.of[0][i] = std::round(at[0] * 64.0) / 64.0;
        clicks.of[1][i] = s.target.height - std::round(at[1] * 64.0) / 64.0;
        clicks.of[2][i] = at[2];
    }
    return clicks;
}

std::array<double, 3> windowAt(const Triples<double> &clicks, const oracle::Scene &s, std::size_t i)
{
    return {clicks.of[0][i], s.target.height - clicks.of[1][i], clicks.of[2][i]};
}

template <class Scalar>
bool isSameDigits(const Triples<Scalar> &a, const Triples<Scalar> &b)
{
    using Bits = std::conditional_t<sizeof(Scalar) == 8, quint64, quint32>;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < a.count(); ++i) {
            if (std::bit_cast<Bits>(a.of[k][i]) != std::bit_cast<Bits>(b.of[k][i]))
                return false;
        }
    }
    return true;
}

double largestDistance(const oracle::Vector3 &exact, const glm::dvec3 &actual, const Extended &unit)
{
    return static_cast<double>(oracle::maxNorm(oracle::difference(oracle::extended(actual), exact)) / unit);
}

double percentile(const std::vector<double> &sorted, double share)
{
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

void addSets()
{
    addColumn<InstructionSet>("set");
    for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
        newRow(name(set)) << set;
}

} // namespace

template <class Scalar>
void checkManyAgainstFew(const BatchUnprojection &unprojection, const std::array<std::size_t, 3> &starts,
                         InstructionSet set)
{
    constexpr std::size_t kFew = 1009, kMany = 1'500'000, kRoom = 16;
    Triples<Scalar> clicks(kMany);
    for (std::size_t i = 0; i < kMany; ++i) {
        clicks.of[0][i] = static_cast<Scalar>(i % kFew) + Scalar(0.5);
        clicks.of[1][i] = static_cast<Scalar>(i % kFew % 61);
        clicks.of[2][i] = static_cast<Scalar>(i % kFew) / Scalar(kFew);
    }
    static_assert(kMany * 3 * sizeof(Scalar) > batch::kStreamedBytes);
    const Triples<Scalar> few = [&] {
        Triples<Scalar> first(kFew);
        unprojection(clicks.input(), first.output(), kFew, set);
        return first;
    }();
    Triples<Scalar> many(kMany + kRoom);
    const auto [x, y, z] = many.output();
    unprojection(clicks.input(), BatchOutput<Scalar>{x + starts[0], y + starts[1], z + starts[2]}, kMany, set);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < many.count(); ++i) {
            const bool isWritten = i >= starts[k] && i - starts[k] < kMany;
            const Scalar expected = isWritten ? few.of[k][(i - starts[k]) % kFew] : Scalar(0);
            if (many.of[k][i] != expected)
                QFAIL(qPrintable(QStringLiteral("array %1, point %2").arg(k).arg(i)));
        }
    }
}

class TestBatchUnproject : public QObject {
    Q_OBJECT

private slots:
    void unitsInTheLastPlace_data()
    {
        addColumn<double>("nearDistance");
        addColumn<double>("farDistance");
        newRow("5 : 80000") << 5.0 << 80000.0;
        newRow("0.1 : 10000") << 0.1 << 10000.0;
        newRow("1 : 100") << 1.0 << 100.0;
    }

    void unitsInTheLastPlace()
    {
        QFETCH(double, nearDistance);
        QFETCH(double, farDistance);
        const SceneLimits limits = oracle::everydayScenes(nearDistance, farDistance);

        oracle::Random random(7);
        std::vector<double> errors;
        double worstOffOrigin = 0.0;
        for (const auto kind : {RandomKind::Frustum, RandomKind::Perspective, RandomKind::Ortho, RandomKind::Oblique}) {
            for (int count = 0; count < 1500; ++count) {
                const oracle::Scene s = oracle::randomScene(random, kind, limits);
                const oracle::Oracle exact(s.view, s.projection, s.target);
                const Triples<double> clicks = randomClicks(random, s, 4);
                const auto unprojection = BatchUnprojection::byFormula(oracle::corePicture(s), {});
                QVERIFY(unprojection);
                const Triples<double> points = unprojected(*unprojection, clicks);
                const oracle::Vector3 eye = oracle::extended(oracle::coreView(s.view).eye);
                for (std::size_t i = 0; i < clicks.count(); ++i) {
                    const oracle::Vector3 world = exact.worldUnder(windowAt(clicks, s, i));
                    const double largest = static_cast<double>(oracle::maxNorm(world));
                    const Extended ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
                    errors.push_back(largestDistance(world, points.at(i), ulp));
                    const Extended scale = std::max(
                        {Extended(largest), oracle::maxNorm(eye), oracle::maxNorm(oracle::difference(world, eye))});
                    if (largest >= kCloseToOrigin * scale)
                        worstOffOrigin = std::max(worstOffOrigin, errors.back());
                }
            }
        }
        std::sort(errors.begin(), errors.end());
        qInfo("%zu points: median %.2g ulp, 99%% %.3g, 99.99%% %.3g, worst %.3g, off the origin %.3g", errors.size(),
              percentile(errors, 0.5), percentile(errors, 0.99), percentile(errors, 0.9999), errors.back(),
              worstOffOrigin);
        QVERIFY(percentile(errors, 0.9999) <= kMostUlps && worstOffOrigin <= kAllUlps);
    }

    void eyePointsAreRight_data() { addKinds(); }

    /// The formulas add no terms in eye space: each coordinate is right to a few units in its own last
    /// place. That also holds next to the view axis and to either plane, for every viewport and depth
    /// range.
    void eyePointsAreRight()
    {
        QFETCH(RandomKind, kind);
        constexpr double kRelative = 4e-15;
        oracle::Random random(12);
        double worst = 0.0;
        for (int count = 0; count < 500; ++count) {
            const oracle::Scene s = oracle::randomScene(random, kind, SceneLimits{});
            const oracle::Oracle exact(s.view, s.projection, s.target);
            const Triples<double> clicks = randomClicks(random, s, 8);
            const auto unprojection =
                BatchUnprojection::byFormula(oracle::corePicture(s), {BatchSpace::Kind::Eye, glm::dmat4(1.0)});
            QVERIFY(unprojection);
            const Triples<double> points = unprojected(*unprojection, clicks);
            for (std::size_t i = 0; i < clicks.count(); ++i) {
                const oracle::Vector3 eye = exact.eyeUnder(windowAt(clicks, s, i));
                worst = std::max(worst, largestDistance(eye, points.at(i), oracle::maxNorm(eye)));
            }
        }
        qInfo("worst error of the largest eye coordinate: %.2g", worst);
        QVERIFY(worst <= kRelative);
    }

    void everyInstructionSetGivesTheSameDigits_data()
    {
        addColumn<InstructionSet>("set");
        addColumn<RandomKind>("kind");
        for (const InstructionSet set : {InstructionSet::Avx2, InstructionSet::Avx512}) {
            addRow("%s, frustum, off-centre and mirrored too", name(set)) << set << RandomKind::Frustum;
            addRow("%s, perspective", name(set)) << set << RandomKind::Perspective;
            addRow("%s, ortho, around the eye too", name(set)) << set << RandomKind::Ortho;
            addRow("%s, oblique", name(set)) << set << RandomKind::Oblique;
        }
    }

    void everyInstructionSetGivesTheSameDigits()
    {
        QFETCH(InstructionSet, set);
        QFETCH(RandomKind, kind);
        SKIP_WITHOUT(set);
        oracle::Random random(3);
        for (int count = 0; count < 40; ++count) {
            const oracle::Scene s = oracle::randomScene(random, kind, SceneLimits{});
            const Triples<double> clicks = randomClicks(random, s, 67); // not a multiple of any vector's length
            Triples<float> floats(clicks.count());
            for (std::size_t k = 0; k < 3; ++k)
                std::transform(clicks.of[k].begin(), clicks.of[k].end(), floats.of[k].begin(),
                               [](double value) { return static_cast<float>(value); });
            for (const auto &unprojection : {BatchUnprojection::byFormula(oracle::corePicture(s), {}),
                                             BatchUnprojection::byMatrix(oracle::corePicture(s), {})}) {
                QVERIFY(unprojection);
                const auto plain = unprojected(*unprojection, clicks, InstructionSet::Baseline);
                const auto plainFloats = unprojected(*unprojection, floats, InstructionSet::Baseline);
                QVERIFY(isSameDigits(unprojected(*unprojection, clicks, set), plain));
                QVERIFY(isSameDigits(unprojected(*unprojection, floats, set), plainFloats));
            }
        }
    }

    /// Millions of points bypass the caches in whole cache lines, which start wherever the arrays do.
    void manyPointsAreThoseOfFew_data()
    {
        using Starts = std::array<std::size_t, 3>;
        addColumn<InstructionSet>("set");
        addColumn<Starts>("starts");
        for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
            addRow("%s, where the memory starts", name(set)) << set << Starts{0, 0, 0};
            addRow("%s, one further", name(set)) << set << Starts{1, 1, 1};
            addRow("%s, a line less one further", name(set)) << set << Starts{15, 15, 15};
            addRow("%s, each elsewhere", name(set)) << set << Starts{0, 1, 2};
        }
    }

    void manyPointsAreThoseOfFew()
    {
        using Starts = std::array<std::size_t, 3>;
        QFETCH(InstructionSet, set);
        QFETCH(Starts, starts);
        SKIP_WITHOUT(set);
        oracle::Random random(6);
        const oracle::Scene s = oracle::randomScene(random, RandomKind::Perspective, SceneLimits{});
        const auto unprojection = BatchUnprojection::byFormula(oracle::corePicture(s), {});
        checkManyAgainstFew<double>(*unprojection, starts, set);
        checkManyAgainstFew<float>(*unprojection, starts, set);
    }

    void matrixAgreesWithTheFormula_data() { addKinds(); }

    void matrixAgreesWithTheFormula()
    {
        QFETCH(RandomKind, kind);
        SceneLimits limits = oracle::everydayScenes(1.0, 10.0);
        limits.plainTarget = false;
        oracle::Random random(5);
        for (int count = 0; count < 200; ++count) {
            const oracle::Scene s = oracle::randomScene(random, kind, limits);
            const Triples<double> clicks = randomClicks(random, s, 16);
            for (const auto space : {BatchSpace::Kind::Eye, BatchSpace::Kind::World}) {
                const auto formula = BatchUnprojection::byFormula(oracle::corePicture(s), {space, glm::dmat4(1.0)});
                const auto matrix = BatchUnprojection::byMatrix(oracle::corePicture(s), {space, glm::dmat4(1.0)});
                const Triples<double> a = unprojected(*formula, clicks), b = unprojected(*matrix, clicks);
                const ProjectionWindow w = projectionWindow(oracle::coreProjection(s.projection));
                const double size = 100.0 + std::abs(w.left) + std::abs(w.right) + std::abs(w.bottom) + std::abs(w.top);
                // A box may be arbitrarily wide and long: its pixels and its depth are no more exact
                // than its size.
                for (std::size_t i = 0; i < clicks.count(); ++i)
                    QVERIFY(glm::length(a.at(i) - b.at(i)) <= 1e-11 * size);
            }
        }
    }

    void matricesOfOtherPrograms_data()
    {
        addColumn<glm::dmat4>("projection");
        addColumn<bool>("isZeroToOne");
        addColumn<bool>("isFormulaOurs");
        // Columns; near 0.5, far 50 where there is one; off-centre.
        const double n = 0.5, f = 50.0;
        const auto perspective = [](double zz, double zw, double side) {
            return glm::dmat4{{1.2, 0, 0, 0}, {0, 1.6, 0, 0}, {-0.1 * side, 0.2 * side, zz, side}, {0, 0, zw, 0}};
        };
        newRow("OpenGL") << perspective(-(f + n) / (f - n), -2 * f * n / (f - n), -1) << false << true;
        newRow("OpenGL, times 3") << 3.0 * perspective(-(f + n) / (f - n), -2 * f * n / (f - n), -1) << false << true;
        newRow("Vulkan") << perspective(-f / (f - n), -f * n / (f - n), -1) << true << true;
        newRow("Direct3D, along +z") << perspective(f / (f - n), -f * n / (f - n), 1) << true << true;
        newRow("reversed") << perspective(n / (f - n), f * n / (f - n), -1) << true << true;
        newRow("reversed, far at infinity") << perspective(0, n, -1) << true << true;
        newRow("OpenGL, far at infinity") << perspective(-1, -2 * n, -1) << false << true;
        newRow("box") << glm::dmat4{{0.2, 0, 0, 0}, {0, 0.3, 0, 0}, {0, 0, -0.04, 0}, {0.1, -0.2, -1.02, 1}} << false
                      << true;
        newRow("box, times 7")
            << 7.0 * glm::dmat4{{0.2, 0, 0, 0}, {0, 0.3, 0, 0}, {0, 0, -0.04, 0}, {0.1, -0.2, -1.02, 1}} << false
            << true;
        newRow("sheared box, [0, 1]") << glm::dmat4{{0.2, 0, 0, 0},
                                                    {0, 0.3, 0, 0},
                                                    {0.05, 0.02, -0.02, 0},
                                                    {0.1, -0.2, -0.01, 1}}
                                      << true << true;
        newRow("no known form") << glm::dmat4{{1, 0.5, 0, 0}, {0.25, 1, 0, 0}, {0, 0, -1.02, -1}, {0, 0, -2.02, 0}}
                                << false << false;
    }

    /// The loops against the one-point functions, which have their own tests.
    void matricesOfOtherPrograms()
    {
        QFETCH(glm::dmat4, projection);
        QFETCH(bool, isZeroToOne);
        QFETCH(bool, isFormulaOurs);
        Setup g;
        g.surface = {640, 480, 1.0};
        g.viewport = {20.0, 30.0, 500.0, 400.0};
        g.lens = MatrixProjection{projection, isZeroToOne ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne};
        g.pose = eyeFromWorld(eyeFrame({WorldPoint(3, 4, 5), WorldPoint(1, 0, -2), {0, 1, 0}}).value());
        for (const DepthRange &range : {DepthRange{0.0, 1.0}, DepthRange{1.0, 0.0}, DepthRange{0.2, 0.9}}) {
            g.depthRange = range;
            Triples<double> clicks(std::size_t(7) * 5);
            for (std::size_t i = 0; i < clicks.count(); ++i) {
                clicks.of[0][i] = 25.5 + 90.0 * static_cast<double>(i % 7);
                clicks.of[1][i] = 60.5 + 80.0 * std::floor(static_cast<double>(i) / 7.0);
                clicks.of[2][i] = range.atNear + (0.05 + 0.02 * static_cast<double>(i)) * (range.atFar - range.atNear);
            }
            const auto formula = BatchUnprojection::byFormula(g, {}), matrix = BatchUnprojection::byMatrix(g, {});
            QCOMPARE(formula.hasValue(), isFormulaOurs);
            if (!isFormulaOurs)
                QCOMPARE(formula.error().code, ErrorCode::MatrixNotAProjection);
            QVERIFY(matrix);
            const Triples<double> byMatrix = unprojected(*matrix, clicks);
            const Triples<double> byFormula = isFormulaOurs ? unprojected(*formula, clicks) : byMatrix;
            for (std::size_t i = 0; i < clicks.count(); ++i) {
                const WindowPoint window =
                    windowFromDevice(g.surface, DevicePoint(clicks.of[0][i], clicks.of[1][i]), clicks.of[2][i]);
                const Answers<WorldSpace> expected = unprojectedAt(g, window).world;
                QVERIFY(expected[Method::Matrix]);
                const double size = 10.0 + glm::length(expected[Method::Matrix]->coordinates());
                QVERIFY(glm::length(byMatrix.at(i) - expected[Method::Matrix]->coordinates()) <= 1e-11 * size);
                if (isFormulaOurs)
                    QVERIFY(glm::length(byFormula.at(i) - expected[Method::Formula]->coordinates()) <= 2e-15 * size);
            }
        }
    }

    void objectSpaceIsTheWorldMovedBack()
    {
        oracle::Random random(9);
        SceneLimits limits = oracle::everydayScenes(1.0, 10.0);
        limits.plainTarget = false;
        const glm::dmat4 worldFromObject =
            unprojector::geometry::worldFromObject({Translate{{1, 2, 3}}, Rotate{30, {1, 1, 0}}, Scale{{2, 3, 0.5}}});
        const oracle::Scene s = oracle::randomScene(random, RandomKind::Frustum, limits);
        const Triples<double> clicks = randomClicks(random, s, 50);
        const BatchSpace object{BatchSpace::Kind::Object, worldFromObject};
        const Triples<double> world = unprojected(*BatchUnprojection::byFormula(oracle::corePicture(s), {}), clicks);
        for (const auto &unprojection : {BatchUnprojection::byFormula(oracle::corePicture(s), object),
                                         BatchUnprojection::byMatrix(oracle::corePicture(s), object)}) {
            QVERIFY(unprojection);
            const Triples<double> points = unprojected(*unprojection, clicks);
            for (std::size_t i = 0; i < clicks.count(); ++i)
                QVERIFY(glm::length(glm::dvec3(worldFromObject * glm::dvec4(points.at(i), 1.0)) - world.at(i))
                        <= 1e-11);
        }
    }

    void floatsAreTheDoublesRounded()
    {
        oracle::Random random(4);
        const oracle::Scene s = oracle::randomScene(random, RandomKind::Perspective, SceneLimits{});
        Triples<double> clicks = randomClicks(random, s, 33);
        Triples<float> floats(clicks.count());
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < clicks.count(); ++i) {
                floats.of[k][i] = static_cast<float>(clicks.of[k][i]);
                clicks.of[k][i] = floats.of[k][i];
            }
        }
        const auto unprojection = BatchUnprojection::byFormula(oracle::corePicture(s), {});
        const Triples<double> exact = unprojected(*unprojection, clicks);
        const Triples<float> points = unprojected(*unprojection, floats);
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < clicks.count(); ++i)
                QCOMPARE(points.of[k][i], static_cast<float>(exact.of[k][i]));
        }
    }

    void invalidPointsAreNaN_data() { addSets(); }

    /// Every number of points up to a few packs: whole packs and each rest.
    void invalidPointsAreNaN()
    {
        QFETCH(InstructionSet, set);
        SKIP_WITHOUT(set);
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        constexpr std::array<double, 5> kDepths{0.25, 0.75, 0.25 - 0x1p-54, 0.75 + 0x1p-53,
                                                kNaN}; // of which two are valid
        constexpr std::array<double, 4> kCoordinates{-0.0, 1.5, kInfinity, kNaN};
        oracle::Random random(6);
        const auto oneOf = [&](const auto &values, std::size_t common) {
            const double chance = random.uniform(0.0, 1.0);
            return values[chance < 0.8 ? common : std::size_t(chance * 97.0) % values.size()];
        };
        for (std::size_t count = 0; count < 35; ++count) {
            Triples<double> from(count);
            std::vector<double> depths(count), points(3 * count + 1, 7.0);
            for (std::size_t i = 0; i < count; ++i) {
                depths[i] = oneOf(kDepths, i % 2);
                for (std::size_t k = 0; k < 3; ++k)
                    from.of[k][i] = oneOf(kCoordinates, 1) + double(3 * i + k);
            }
            batch::kernelsOf(set).validPoints(
                {from.of[0].data(), from.of[1].data(), from.of[2].data(), depths.data(), count, 0.25, 0.75},
                points.data());
            for (std::size_t i = 0; i < count; ++i) {
                bool isValid = depths[i] >= 0.25 && depths[i] <= 0.75;
                for (std::size_t k = 0; k < 3; ++k)
                    isValid = isValid && std::isfinite(from.of[k][i]);
                for (std::size_t k = 0; k < 3; ++k)
                    QVERIFY(isValid ? points[3 * i + k] == from.of[k][i] : std::isnan(points[3 * i + k]));
            }
            QCOMPARE(points.back(), 7.0); // nothing behind the points is written
        }
    }

    void noPointsTouchNothing_data() { addSets(); }

    void noPointsTouchNothing()
    {
        QFETCH(InstructionSet, set);
        SKIP_WITHOUT(set);
        oracle::Random random(4);
        const auto unprojection = BatchUnprojection::byFormula(
            oracle::corePicture(oracle::randomScene(random, RandomKind::Ortho, SceneLimits{})), {});
        (*unprojection)(BatchInput<double>{}, BatchOutput<double>{}, 0, set);
    }

    void aBadPictureIsRefused()
    {
        Setup g;
        g.surface = {4, 3, 1.0};
        g.viewport = wholeSurface(g.surface);
        g.lens = Frustum{-1, 1, -1, 1, 0.0, 10.0};
        QCOMPARE(BatchUnprojection::byFormula(g, {}).error().code, ErrorCode::NearNotPositive);
        QCOMPARE(BatchUnprojection::byMatrix(g, {}).error().code, ErrorCode::NearNotPositive);
        g.lens = Frustum{};
        const BatchSpace flat{BatchSpace::Kind::Object, glm::dmat4(0.0)};
        QCOMPARE(BatchUnprojection::byFormula(g, flat).error().code, ErrorCode::SingularMatrix);
        QCOMPARE(BatchUnprojection::byMatrix(g, flat).error().code, ErrorCode::SingularMatrix);
    }
};

UNPROJECTOR_TEST(TestBatchUnproject)
#include "test_batch_unproject.moc"
