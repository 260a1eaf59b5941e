// What programs with a mistake answer. The expected points were computed apart from this program, by following the mistake
// through the textbook formulas, to four decimals.
#include "core/geometry/transform.h"
#include "core/unproject/pick.h"
#include "core/unproject/unprojector.h"

#include <QTest>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

constexpr double kFourDecimals = 0.6e-4;
const glm::dvec3 kTruth(0.5, 0.75, -0.25);

/// Viewport (100, 40, 800, 600) in a window of 1000 x 700, 45 degrees, near 1, far 100, seen from (3, 2, 5).
Picture picture()
{
    return {{1000, 700, 1.0},
            {100, 40, 800, 600},
            {},
            Projection(Perspective{std::numbers::pi / 4, 800.0 / 600.0, 1, 100}),
            LookAt{WorldPoint(3, 2, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
}

/// Where the truth is drawn.
WindowPoint window()
{
    return windowFromWorld(picture(), WorldPoint(kTruth)).value();
}

glm::dmat4 model()
{
    return worldFromObject({Translate{{2, 0, -1}}});
}

} // namespace

Q_DECLARE_METATYPE(unprojector::unproject::Conventions)

class TestConventions : public QObject {
    Q_OBJECT

private slots:
    void theDefaultIsThisProgramsOwnPath();
    void aMistakeGivesItsOwnPoint_data();
    void aMistakeGivesItsOwnPoint();
    void aClicksPixel_data();
    void aClicksPixel();
    void halfAPixelAndTheRatioMatter();
    void floatsLoseDigits();
};

void TestConventions::theDefaultIsThisProgramsOwnPath()
{
    const Unprojector unprojector = Unprojector::of(picture()).value();
    const Unprojected own = unprojector.at(window());
    for (const Method method : {Method::Formula, Method::Matrix})
        QVERIFY(glm::length(own.world[method]->coordinates() - kTruth) < 1e-12);
    // A click goes by the conventions of the unprojector that it is given.
    const WidgetPoint widget(300.0, 200.0);
    const DepthSample sample{0.5, 0};
    Conventions unflipped;
    unflipped.flip = Conventions::Flip::Left;
    const Unprojector mistaken = Unprojector::of(picture(), unflipped).value();
    for (const Unprojector &by : {unprojector, mistaken}) {
        const Pick pick = pickAt(by, widget, sample).value();
        QVERIFY(pick.window == by.windowAt(widget, sample.depth).value());
        QVERIFY(*pick.point.world[Method::Formula] == *by.at(pick.window).world[Method::Formula]);
    }
    QVERIFY(!(unprojector.windowAt(widget, 0.5).value() == mistaken.windowAt(widget, 0.5).value()));
}

void TestConventions::aMistakeGivesItsOwnPoint_data()
{
    QTest::addColumn<Conventions>("conventions");
    QTest::addColumn<glm::dvec3>("expected");
    const auto row = [](const char *name, auto member, auto value, const glm::dvec3 &expected) {
        Conventions conventions;
        conventions.*member = value;
        QTest::newRow(name) << conventions << expected;
    };
    using C = Conventions;
    row("viewport's origin forgotten", &C::viewportOffset, C::ViewportOffset::Forgotten, {1.1420, 1.0572, -0.7581});
    row("viewport taken for the window", &C::viewportOffset, C::ViewportOffset::WholeWindow, {0.4326, 0.5902, -0.1456});
    row("depth taken for z_n", &C::ndcDepth, C::NdcDepthTaken::AsItIs, {-1.7223, -0.3612, -4.9168});
    row("[0, 1] stretched", &C::ndcDepth, C::NdcDepthTaken::Stretched, {1.7121, 1.3561, 2.2955});
    row("reversed", &C::reversed, true, {2.4939, 1.7469, 3.9371});
    row("degrees for radians", &C::angleUnit, C::AngleUnit::DegreesTakenForRadians, {0.6255, 0.9781, -0.4165});
    row("w not divided out", &C::w, C::W::Ignored, {0.0850, 0.1275, -0.0425});
    row("model left in", &C::model, C::Model::LeftIn, {-1.5, 0.75, 0.75});
    row("model once more", &C::model, C::Model::AppliedAgain, {2.5, 0.75, -1.25});
    row("view transposed", &C::transposed, C::Transposed::View, {-0.1383, -0.0869, 0.1686});
    row("projection transposed", &C::transposed, C::Transposed::Projection, {4.0449, 2.2838, 7.8147});
    row("both transposed", &C::transposed, C::Transposed::Both, {-0.1580, -0.1100, 0.1491});
    row("product transposed", &C::transposed, C::Transposed::Product, {-0.0545, 0.0108, -1.3291});
    row("inverses in the factors' order", &C::order, C::Order::InversesInTheOrderOfTheFactors,
        {-0.8773, -0.4777, 0.4633});
    row("not inverted", &C::inverse, C::Inverse::Forgotten, {-0.0669, 0.0236, 0.6488});
    row("view inverted twice", &C::inverse, C::Inverse::ViewInvertedTwice, {3.5034, 2.2009, -10.4372});
}

void TestConventions::aMistakeGivesItsOwnPoint()
{
    QFETCH(Conventions, conventions);
    QFETCH(glm::dvec3, expected);
    const Unprojector unprojector = Unprojector::of(picture(), conventions, model()).value();
    const Result<WorldPoint> point = unprojector.worldAt(Method::Matrix, window());
    QVERIFY(point);
    const glm::dvec3 off = point->coordinates() - expected;
    QVERIFY2(std::abs(off.x) < kFourDecimals && std::abs(off.y) < kFourDecimals && std::abs(off.z) < kFourDecimals,
             qPrintable(QStringLiteral("%1 %2 %3").arg(point->x).arg(point->y).arg(point->z)));
}

void TestConventions::aClicksPixel_data()
{
    QTest::addColumn<Conventions>("conventions");
    QTest::addColumn<double>("ratio");
    QTest::addColumn<glm::dvec2>("expected");
    const auto row = [](const char *name, double ratio, auto member, auto value, const glm::dvec2 &expected) {
        Conventions conventions;
        conventions.*member = value;
        QTest::newRow(name) << conventions << ratio << expected;
    };
    using C = Conventions;
    // Logical (200, 100) of a window of 1000 x 700 device pixels.
    row("right", 1.0, &C::reversed, false, {200.5, 599.5});
    row("right at 2x", 2.0, &C::reversed, false, {400.5, 499.5});
    row("not flipped", 1.0, &C::flip, C::Flip::Left, {200.5, 100.5});
    row("flipped with the viewport", 1.0, &C::flip, C::Flip::ByViewportHeight, {200.5, 499.5});
    row("corner", 1.0, &C::pixelPart, C::PixelPart::Corner, {200.0, 600.0});
    row("row above", 1.0, &C::pixelPart, C::PixelPart::RowAbove, {200.5, 600.5});
    row("ratio forgotten", 2.0, &C::pixelRatio, C::PixelRatio::Forgotten, {200.5, 599.5});
    row("ratio forgotten in the flip too", 2.0, &C::pixelRatio, C::PixelRatio::ForgottenInFlipToo, {200.5, 249.5});
    row("ratio twice", 2.0, &C::pixelRatio, C::PixelRatio::AppliedTwice, {800.5, 299.5});
}

void TestConventions::aClicksPixel()
{
    QFETCH(Conventions, conventions);
    QFETCH(double, ratio);
    QFETCH(glm::dvec2, expected);
    Picture taken = picture();
    taken.surface.devicePixelRatio = ratio;
    const Result<WindowPoint> point = windowOfClick(taken, conventions, WidgetPoint(200, 100), 0.5);
    QVERIFY(point);
    QCOMPARE(point->x, expected.x);
    QCOMPARE(point->y, expected.y);
    QCOMPARE(point->z, 0.5);
}

/// The whole chain, from the widget to the world, differs as well.
void TestConventions::halfAPixelAndTheRatioMatter()
{
    const auto world = [](const Conventions &conventions) {
        const Unprojector unprojector = Unprojector::of(picture(), conventions).value();
        return unprojector.worldAt(Method::Matrix, unprojector.windowAt(WidgetPoint(568, 274), 0.838331).value())
            .value()
            .coordinates();
    };
    Conventions corner;
    corner.pixelPart = Conventions::PixelPart::Corner;
    QVERIFY(glm::length(world({}) - world(corner)) > 1e-3);
    Conventions axis;
    axis.fovAxis = Conventions::FovAxis::VerticalTakenForHorizontal;
    QVERIFY(glm::length(world({}) - world(axis)) > 1e-2);
}

void TestConventions::floatsLoseDigits()
{
    Conventions conventions;
    conventions.singlePrecision = true;
    const Unprojected point = Unprojector::of(picture(), conventions).value().at(window());
    QVERIFY(point.world[Method::Matrix]->coordinates() == point.world[Method::MatrixInFloat]->coordinates());
    const double off = glm::length(point.world[Method::Matrix]->coordinates() - kTruth);
    QVERIFY(off > 1e-9 && off < 1e-2);
}

QTEST_GUILESS_MAIN(TestConventions)
#include "test_conventions.moc"
