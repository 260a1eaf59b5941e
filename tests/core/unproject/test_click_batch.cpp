// Rows have the digits of a click, to the last one, on every instruction set.

#include "tests/support/test.h"

#include "core/geometry/transform.h"
#include "core/unproject/batch/click_batch.h"
#include "tests/support/core_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/unprojecting.h"

#include <array>
#include <cmath>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

using Columns = std::array<std::vector<double>, 3>;

/// Clicks anywhere in the picture, on whole pixels' centres and at the ends of the depth range.
Columns clicksOn(oracle::Random &random, const Setup &g, std::size_t count)
{
    Columns clicks;
    for (std::size_t i = 0; i < count; ++i) {
        double px = random.uniform(0.0, g.surface.widthPixels), py = random.uniform(0.0, g.surface.heightPixels);
        if (i % 2 == 0) {
            px = std::floor(px) + kHalfPixel;
            py = std::floor(py) + kHalfPixel;
        }
        double share = random.uniform(0.0, 1.0);
        if (i % 16 < 2)
            share = double(i % 16);
        const double depth = g.depthRange.atNear + share * (g.depthRange.atFar - g.depthRange.atNear);
        clicks[0].push_back(px);
        clicks[1].push_back(py);
        clicks[2].push_back(depth);
    }
    return clicks;
}

Columns unprojected(const ClickBatch &batch, const Columns &clicks, InstructionSet set)
{
    Columns points;
    for (auto &column : points)
        column.resize(clicks[0].size());
    batch({clicks[0].data(), clicks[1].data(), clicks[2].data()},
          {points[0].data(), points[1].data(), points[2].data()}, clicks[0].size(), set);
    return points;
}

template <class Space>
bool areTheClicks(const Columns &points, const std::vector<Result<Point<Space>>> &expected)
{
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const double is = points[std::size_t(k)][i];
            if (expected[i] ? is != (*expected[i])[k] : std::isfinite(is)) {
                qWarning("row %d, coordinate %d: %.17g is not %.17g", int(i), k, is,
                         expected[i] ? (*expected[i])[k] : std::nan(""));
                return false;
            }
        }
    }
    return true;
}

/// Every second scene comes as matrices, every fourth with numbers in single precision. Of frustums,
/// one third each has a skew and is a pinhole.
Setup setupOf(oracle::Random &random, oracle::RandomKind kind, int i)
{
    Setup g = oracle::corePicture(oracle::randomScene(random, kind, {}));
    if (i % 3 == 1)
        std::swap(g.depthRange.atNear, g.depthRange.atFar);
    if (auto *frustum = std::get_if<Frustum>(&g.projection())) {
        const auto any = [&](double low, double high) { return random.sign() * random.uniform(low, high); };
        if (i % 3 == 1)
            frustum->skew = any(0.0, 0.5);
        if (i % 3 == 2)
            g.lens =
                Pinhole{any(100, 900), any(100, 900), any(0, 900),           any(0, 700),          any(0, 20),
                        640.0,         480.0,         frustum->nearDistance, frustum->farDistance, random.chance(0.5)};
    }
    if (i % 2 == 0)
        return g;
    glm::dmat4 projection = clipFromEye(g).value(), view = eyeFromWorld(g).value();
    if (i % 4 == 1) {
        projection = glm::dmat4(glm::mat4(projection));
        view = glm::dmat4(glm::mat4(view));
    }
    g.lens = MatrixProjection{projection, NdcDepth::MinusOneToOne};
    g.pose = view;
    return g;
}

PreciseMatrix randomPlacement(oracle::Random &random)
{
    const auto three = [&](double low, double high) {
        return glm::dvec3(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
    };
    return preciseWorldFromObject(
        {Translate{three(-10.0, 10.0)}, Rotate{random.uniform(0.0, 360.0), three(0.1, 1.0)}, Scale{three(0.2, 3.0)}});
}

} // namespace

class TestClickBatch : public QObject {
    Q_OBJECT

private slots:
    void rowsHaveTheDigitsOfAClick_data()
    {
        addColumn<int>("kind");
        addColumn<int>("set");
        const std::array<std::pair<const char *, oracle::RandomKind>, 4> kinds{
            {{"frustum", oracle::RandomKind::Frustum},
             {"perspective", oracle::RandomKind::Perspective},
             {"box", oracle::RandomKind::Ortho},
             {"sheared box", oracle::RandomKind::Oblique}}};
        for (const auto &[kindName, kind] : kinds) {
            for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
                addRow("%s, %s", kindName, name(set)) << int(kind) << int(set);
        }
    }

    void rowsHaveTheDigitsOfAClick()
    {
        QFETCH(int, kind);
        QFETCH(int, set);
        const auto is = InstructionSet(set);
        SKIP_WITHOUT(is);
        constexpr std::size_t kClicks = 67; // whole packs and a rest
        oracle::Random random(11);
        int refused = 0;
        for (int i = 0; i < 300; ++i) {
            const Setup g = setupOf(random, oracle::RandomKind(kind), i);
            const Columns clicks = clicksOn(random, g, kClicks);
            std::vector<Unprojected> expected;
            for (std::size_t k = 0; k < kClicks; ++k) {
                const DevicePoint at(clicks[0][k], clicks[1][k]);
                expected.push_back(unprojectedAt(g, preciseWindowFromDevice(g.surface, at, clicks[2][k])));
            }
            const PreciseMatrix placement = randomPlacement(random);
            const ObjectFromWorld objectFromWorld = ObjectFromWorld::of(placement).value();
            const Unprojector unprojector = Unprojector::of(g).value();
            const auto inObject = [&](Method method, std::size_t k) {
                const DevicePoint at(clicks[0][k], clicks[1][k]);
                return unprojector.objectAt(method, preciseWindowFromDevice(g.surface, at, clicks[2][k]),
                                            objectFromWorld);
            };
            const BatchSpace eye{BatchSpace::Kind::Eye, {}}, world{}, object{BatchSpace::Kind::Object, placement};
            if (!ClickBatch::of(Method::Formula, g, world)) {
                QVERIFY(!expected[0].world[Method::Formula]);
                ++refused;
                continue;
            }
            for (const Method method : kMethods) {
                std::vector<Result<EyePoint>> inEye;
                std::vector<Result<WorldPoint>> inWorld;
                std::vector<Result<ObjectPoint>> inObjects;
                for (std::size_t k = 0; k < kClicks; ++k) {
                    inEye.push_back(expected[k].eye[method]);
                    inWorld.push_back(expected[k].world[method]);
                    inObjects.push_back(inObject(method, k));
                }
                if (const auto batch = ClickBatch::of(method, g, eye))
                    QVERIFY(areTheClicks(unprojected(*batch, clicks, is), inEye));
                if (const auto batch = ClickBatch::of(method, g, world))
                    QVERIFY(areTheClicks(unprojected(*batch, clicks, is), inWorld));
                if (const auto batch = ClickBatch::of(method, g, object))
                    QVERIFY(areTheClicks(unprojected(*batch, clicks, is), inObjects));
            }
        }
        QVERIFY(refused < 30);
    }

    void largeAndSmallScenesToo_data()
    {
        addColumn<int>("exponent");
        addColumn<int>("set");
        for (const int exponent : {-1000, -960, -900, -500, -60, 60, 500, 900, 960, 1000}) {
            for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
                addRow("2^%d, %s", exponent, name(set)) << exponent << int(set);
        }
    }

    /// Near the ends of the doubles' range, products underflow and overflow.
    void largeAndSmallScenesToo()
    {
        QFETCH(int, exponent);
        QFETCH(int, set);
        const auto is = InstructionSet(set);
        SKIP_WITHOUT(is);
        const double unit = std::ldexp(1.0, exponent);
        constexpr std::size_t kClicks = 67;
        oracle::Random random(12);
        for (int i = 0; i < 20; ++i) {
            Setup g;
            g.surface = {800, 600, 1.0};
            g.viewport = wholeSurface(g.surface);
            const double left = -unit * random.uniform(0.3, 2.0), bottom = -unit * random.uniform(0.3, 2.0);
            const double right = unit * random.uniform(0.3, 2.0), top = unit * random.uniform(0.3, 2.0);
            const double n = unit * random.uniform(0.5, 1.0), f = unit * random.uniform(2.0, 1000.0);
            if (i % 2 == 0)
                g.lens = Frustum{left, right, bottom, top, n, f};
            else
                g.lens = Ortho{left, right, bottom, top, n, f};
            const auto anywhere = [&] { return unit * random.uniform(-3.0, 3.0); };
            g.pose = LookAt{WorldPoint(anywhere(), anywhere(), anywhere()),
                            WorldPoint(anywhere(), anywhere(), anywhere()),
                            {random.uniform(0.1, 1.0), random.uniform(0.1, 1.0), random.uniform(0.1, 1.0)}};
            const Result<ClickBatch> batch = ClickBatch::of(Method::Formula, g, {});
            QVERIFY(batch);
            const Columns clicks = clicksOn(random, g, kClicks);
            std::vector<Result<WorldPoint>> expected;
            for (std::size_t k = 0; k < kClicks; ++k) {
                const DevicePoint at(clicks[0][k], clicks[1][k]);
                expected.push_back(
                    unprojectedAt(g, preciseWindowFromDevice(g.surface, at, clicks[2][k])).world[Method::Formula]);
            }
            QVERIFY(areTheClicks(unprojected(*batch, clicks, is), expected));
        }
    }

    void aCoordinateOfZeroIsOne()
    {
        Setup g;
        g.surface = {4, 4, 1.0};
        g.viewport = wholeSurface(g.surface);
        g.lens = Frustum{-1.0, 1.0, -1.0, 1.0, 1.0, 3.0};
        g.pose = LookAt{WorldPoint(0, 0, 1), WorldPoint(0, 0, 0), {0, 1, 0}};
        const Columns clicks{std::vector{2.0}, std::vector{2.0}, std::vector{0.0}};
        const Columns points =
            unprojected(ClickBatch::of(Method::Formula, g, {}).value(), clicks, InstructionSet::Baseline);
        for (const auto &column : points)
            QCOMPARE(column[0], 0.0);
    }
};

UNPROJECTOR_TEST(TestClickBatch)
#include "test_click_batch.moc"
