// Unprojecting, projecting and clouds through the library for other programs.
#include "tests/support/test.h"

#include "unprojector/unprojector.h"

#include "core/geometry/setup.h"
#include "core/unproject/unprojector.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <QMetaType>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace unprojector;

Q_DECLARE_METATYPE(unprojector::Method)
Q_DECLARE_METATYPE(unprojector::Space)
Q_DECLARE_METATYPE(unprojector::Digits)
Q_DECLARE_METATYPE(unprojector::DepthIs)
Q_DECLARE_METATYPE(unprojector::NumberType)

namespace {

Setup setup(const DepthRange &range = {})
{
    Perspective perspective;
    perspective.nearDistance = 0.1;
    perspective.farDistance = 100.0;
    return Setup::of(perspective, {{3.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {80, 60, {}, range}).value();
}

/// Every pixel's centre with a depth of its own.
struct Pixels {
    Pixels()
    {
        for (int j = 0; j < 60; ++j) {
            for (int i = 0; i < 80; ++i) {
                px.push_back(i + 0.5);
                py.push_back(j + 0.5);
                depth.push_back(0.5 + (i + 80 * j) / 10000.0);
            }
        }
    }
    std::vector<double> px, py, depth;
};

bool isNaN(const double *point)
{
    return std::isnan(point[0]) && std::isnan(point[1]) && std::isnan(point[2]);
}

} // namespace

class TestLibraryPoints : public QObject {
    Q_OBJECT

private slots:
    void aBatchGivesTheDigitsOfSinglePoints_data()
    {
        addColumn<Method>("method");
        addColumn<Space>("space");
        addColumn<Digits>("digits");
        newRow("formula, exact") << Method::Formula << Space::World << Digits::Exact;
        newRow("matrix, exact") << Method::Matrix << Space::World << Digits::Exact;
        newRow("formula, double") << Method::Formula << Space::World << Digits::Double;
        newRow("matrix, eye, double") << Method::Matrix << Space::Eye << Digits::Double;
        newRow("formula, eye, exact") << Method::Formula << Space::Eye << Digits::Exact;
    }

    void aBatchGivesTheDigitsOfSinglePoints()
    {
        QFETCH(Method, method);
        QFETCH(Space, space);
        QFETCH(Digits, digits);
        const Pixels pixels;
        const std::size_t count = pixels.px.size();
        const auto unprojection = Unprojection::of(setup(), {method, space, digits, {}});
        QVERIFY(unprojection);
        std::vector<double> points(3 * count), onOne(3 * count), bounds(3 * count);
        (*unprojection)(pixels.px.data(), pixels.py.data(), pixels.depth.data(), points.data(), count, bounds.data(),
                        0);
        (*unprojection)(pixels.px.data(), pixels.py.data(), pixels.depth.data(), onOne.data(), count);
        QVERIFY(points == onOne);
        for (std::size_t i = 0; i < count; i += 97) {
            const glm::dvec2 pixel(pixels.px[i], pixels.py[i]);
            const auto point = unprojection->at(pixel, pixels.depth[i]),
                       bound = unprojection->uncertaintyAt(pixel, pixels.depth[i]);
            QVERIFY(point && bound);
            QCOMPARE(*point, glm::dvec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
            QCOMPARE(*bound, glm::dvec3(bounds[3 * i], bounds[3 * i + 1], bounds[3 * i + 2]));
        }
    }

    void exactPointsAreTheClicks()
    {
        geometry::Setup clicked;
        clicked.surface = {80, 60, 1.0};
        clicked.viewport = geometry::wholeSurface(clicked.surface);
        clicked.lens =
            geometry::Perspective{geometry::Angle::fromDegrees(45.0), geometry::aspectOf(clicked.viewport), 0.1, 100.0};
        clicked.pose = geometry::LookAt{{3.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        const auto click = unproject::Unprojector::of(clicked);
        QVERIFY(click);
        const auto unprojection = Unprojection::of(setup());
        const auto point = click->worldAt(unproject::Method::Formula, {33.5, 60.0 - 17.5, 0.985});
        QVERIFY(unprojection && point);
        QCOMPARE(unprojection->at({33.5, 17.5}, 0.985).value(), point->coordinates());
    }

    void aPointWithoutAnAnswerIsNaN()
    {
        const auto unprojection = Unprojection::of(setup({0.25, 0.75}));
        QVERIFY(unprojection);
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        const std::array<float, 4> px{1.5F, 1.5F, float(kNaN), 1.5F}, py{1.5F, 1.5F, 1.5F, 1.5F},
            depth{0.2F, 0.8F, 0.5F, 0.5F};
        std::array<double, 12> points{}, bounds{};
        (*unprojection)(px.data(), py.data(), depth.data(), points.data(), 4, bounds.data());
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(isNaN(&points[3 * i]) && isNaN(&bounds[3 * i]));
        QVERIFY(std::isfinite(points[9]) && std::isfinite(bounds[11]));
    }

    void errorsNameTheValue()
    {
        const auto unprojection = Unprojection::of(setup());
        QVERIFY(unprojection);
        const auto outside = unprojection->at({1.5, 1.5}, 1.25);
        QVERIFY(!outside);
        QVERIFY2(outside.error().message.find("1.25") != std::string::npos, outside.error().message.c_str());
        UnprojectOptions options;
        options.depthBuffer.bits = 40;
        QVERIFY(!Unprojection::of(setup(), options));
        const auto behind = ForwardProjection::of(setup()).value().at({3.0, 2.0, 5.0});
        QVERIFY(!behind);
        QVERIFY(behind.error().message.find("plane of the eye") != std::string::npos);
        const auto singular = Setup::fromMatrices(glm::dmat4(0.0), glm::dmat4(1.0), {});
        QVERIFY(!singular);
        QCOMPARE(singular.error().message,
                 std::string("projection has no inverse; check whether it was copied completely"));
    }

    void uncertaintiesHoldTheRoundingOfTheDepth()
    {
        UnprojectOptions options;
        options.depthBuffer.bits = 16;
        const auto unprojection = Unprojection::of(setup(), options);
        QVERIFY(unprojection);
        double worst = 0.0;
        for (int step = 0; step < 500; ++step) {
            const double depth = 0.9 + step * 0.00019, kept = std::round(depth * 65535.0) / 65535.0;
            const glm::dvec2 pixel(10.5, 20.5);
            const glm::dvec3 off =
                glm::abs(unprojection->at(pixel, depth).value() - unprojection->at(pixel, kept).value());
            const glm::dvec3 bound = unprojection->uncertaintyAt(pixel, kept).value();
            for (int k = 0; k < 3; ++k) {
                QVERIFY(off[k] <= bound[k]);
                worst = std::max(worst, off[k] / bound[k]);
            }
        }
        QVERIFY(worst > 0.9); // not needlessly large
    }

    void aPointComesBackToItsPixel()
    {
        const Pixels pixels;
        const auto unprojection = Unprojection::of(setup());
        const auto projection = ForwardProjection::of(setup());
        QVERIFY(unprojection && projection);
        const std::size_t count = pixels.px.size();
        std::vector<double> points(3 * count);
        (*unprojection)(pixels.px.data(), pixels.py.data(), pixels.depth.data(), points.data(), count);
        std::vector<Stages> stages(count);
        (*projection)(points.data(), stages.data(), count, 0);
        for (std::size_t i = 0; i < count; ++i) {
            QVERIFY(std::abs(stages[i].pixel.x - pixels.px[i]) < 1e-10);
            QVERIFY(std::abs(stages[i].pixel.y - pixels.py[i]) < 1e-10);
            QVERIFY(std::abs(stages[i].pixel.z - pixels.depth[i]) < 1e-12);
            QCOMPARE(stages[i].window.y, 60.0 - stages[i].pixel.y);
        }
    }

    void aCloudIsTheUnprojectedImage_data()
    {
        addColumn<DepthIs>("depthIs");
        addColumn<NumberType>("type");
        newRow("window depths, floats") << DepthIs::Buffer << NumberType::Float32;
        newRow("window depths, doubles") << DepthIs::Buffer << NumberType::Float64;
        newRow("distances, floats") << DepthIs::Z << NumberType::Float32;
        newRow("distances, doubles") << DepthIs::Z << NumberType::Float64;
    }

    void aCloudIsTheUnprojectedImage()
    {
        QFETCH(DepthIs, depthIs);
        QFETCH(NumberType, type);
        CloudOptions options;
        options.depthIs = depthIs;
        options.type = type;
        const auto cloud = Cloud::of(setup(), options);
        const auto unprojection = Unprojection::of(setup(), {Method::Formula, Space::World, Digits::Double, {}});
        QVERIFY(cloud && unprojection);
        QCOMPARE(cloud->canTakeFloats(), type == NumberType::Float32);
        constexpr std::size_t kRow = 13;
        std::vector<float> floats(80);
        for (std::size_t i = 0; i < floats.size(); ++i)
            floats[i] = depthIs == DepthIs::Z ? 0.2F + float(i) : 0.5F + float(i) / 200.0F;
        floats[7] = 0.0F;
        std::vector<double> doubles(floats.begin(), floats.end()), points(240);
        std::vector<float> single(240);
        CloudCounts counts;
        cloud->count(kRow, doubles, counts);
        if (cloud->canTakeFloats()) {
            cloud->row(kRow, 0, floats, points.data());
            cloud->row(kRow, 0, floats, single.data());
        } else {
            std::vector<double> scratch = doubles;
            cloud->row(kRow, 0, scratch, points.data());
            scratch = doubles;
            cloud->row(kRow, 0, scratch, single.data());
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < 80; ++i) {
            const glm::dvec3 point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(single[3 * i + k] == float(points[3 * i + k]) || std::isnan(points[3 * i + k]));
            if (isNaN(&points[3 * i]))
                continue;
            ++kept;
            const double depth = depthIs == DepthIs::Z ? 100.0 * (doubles[i] - 0.1) / (doubles[i] * 99.9) : doubles[i];
            const glm::dvec3 expected = unprojection->at({double(i) + 0.5, kRow + 0.5}, depth).value();
            const double tolerance = depthIs == DepthIs::Z ? 1e-9 : 0.0;
            QVERIFY(glm::length(point - expected) <= tolerance);
        }
        QCOMPARE(kept, counts.kept);
        QCOMPARE(counts.zero, depthIs == DepthIs::Z ? std::size_t{1} : std::size_t{0});
        QCOMPARE(kept, depthIs == DepthIs::Z ? std::size_t{79} : std::size_t{80});
    }
};

UNPROJECTOR_TEST(TestLibraryPoints)
#include "test_library_points.moc"
