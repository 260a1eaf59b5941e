// The decomposition of view and projection matrices into the steps of their derivation.

#include "tests/support/test.h"

#include "core/geometry/view_volume.h"
#include "core/pipeline/matrix_factors.h"

#include <cmath>
#include <random>

using namespace unprojector;
using namespace unprojector::pipeline;
using namespace unprojector::geometry;

namespace {

const glm::dmat4 &matrixOf(const std::vector<MatrixFactor> &factors, MatrixStep step)
{
    for (const MatrixFactor &factor : factors) {
        if (factor.step == step)
            return factor.matrix;
    }
    static const glm::dmat4 none(std::nan(""));
    return none;
}

} // namespace

class TestMatrixFactors : public QObject {
    Q_OBJECT

private slots:
    void aBoxIsMovedScaledAndTurned()
    {
        const auto parts = factors(Projection(Oblique{{-2, 6, -1, 3, 2, 10}, std::atan(0.5), std::acos(-1.0) / 2.0}));
        QVERIFY(parts);
        QCOMPARE(parts->size(), std::size_t(4));
        const glm::dmat4 shear = matrixOf(*parts, MatrixStep::Shear);
        QVERIFY(std::abs(shear[2][0] - 2.0) < 1e-15 && shear[2][1] == 0.0);
        QVERIFY(matrixOf(*parts, MatrixStep::MoveBox)[3] == glm::dvec4(-2, -1, 6, 1)); // the middle (2, 1, -6)
        const glm::dmat4 scale = matrixOf(*parts, MatrixStep::ScaleBox);
        QVERIFY(scale[0][0] == 0.25 && scale[1][1] == 0.5 && scale[2][2] == 0.25);
        QCOMPARE(matrixOf(*parts, MatrixStep::TurnZ)[2][2], -1.0);
    }

    void aFrustumGoesOntoItsNearPlane()
    {
        const auto parts = factors(Projection(Frustum{-1, 3, -2, 2, 2, 10}));
        QVERIFY(parts);
        QCOMPARE(parts->size(), std::size_t(2));
        // The near plane shows (3, 6, -4) at (1.5, 3), at the depth (a z + b)/4 with a = -1.5, b = -5.
        const glm::dvec4 seen = matrixOf(*parts, MatrixStep::OntoNear) * glm::dvec4(3, 6, -4, 1);
        QVERIFY(seen / seen.w == glm::dvec4(1.5, 3, 0.25, 1));
        QVERIFY(matrixOf(*parts, MatrixStep::NearToSquare) * glm::dvec4(1.5, 2, 0.25, 1)
                == glm::dvec4(0.25, 1, 0.25, 1));
    }

    void aViewIsMovedAndTurned()
    {
        const auto parts = factors(LookAt{WorldPoint(1, 2, 3), WorldPoint(2, 2, 3), {0, 1, 0}}); // along x
        QVERIFY(parts);
        QVERIFY(matrixOf(*parts, MatrixStep::MoveEye)[3] == glm::dvec4(-1, -2, -3, 1));
        QVERIFY(matrixOf(*parts, MatrixStep::TurnAxes) * glm::dvec4(1, 0, 0, 1) == glm::dvec4(0, 0, -1, 1));
        QVERIFY(matrixOf(*parts, MatrixStep::TurnAxes)[3] == glm::dvec4(0, 0, 0, 1));
    }

    void theirProductIsTheMatrixToAnUlp()
    {
        std::mt19937_64 random(20261123);
        const auto between = [&random](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        const auto size = [&between] { return std::pow(10.0, between(-4.0, 6.0)); };
        double greatest = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const double l = between(-1, 1) * size(), b = between(-1, 1) * size(), n = size();
            const Frustum frustum{l, l + size(), b, b + size(), n, n + size()};
            const Ortho box{l, l - size(), b, b + size(), -n, n + size()};
            const double theta = between(0.1, 3.0), phi = between(0.1, 3.0);
            for (const Projection &projection :
                 {Projection(frustum), Projection(Perspective{between(0.01, 3.0), between(0.1, 10), n, n + size()}),
                  Projection(box), Projection(Oblique{box, theta, phi}),
                  Projection(Pinhole{500.0, 510.0, between(319.0, 321.0), 240.0, 0.0, 640.0, 480.0, n, n + size()})}) {
                const auto parts = factors(projection);
                const auto matrix = clipFromEye(projection);
                QVERIFY(parts && matrix);
                greatest = std::max(greatest, differenceUlps(*parts, *matrix));
            }
            const LookAt view{WorldPoint(between(-1, 1) * size(), between(-1, 1) * size(), between(-1, 1) * size()),
                              WorldPoint(between(-1, 1), between(-1, 1), between(-1, 1)),
                              {between(-1, 1), between(-1, 1), between(-1, 1)}};
            const auto parts = factors(view);
            const auto frame = eyeFrame(view);
            QVERIFY(parts && frame);
            greatest = std::max(greatest, differenceUlps(*parts, eyeFromWorld(*frame)));
        }
        QVERIFY2(greatest <= 1.0, qPrintable(QString::number(greatest)));
        QVERIFY(greatest > 0.0); // 2/(r-l) times n is not 2n/(r-l) to the last digit
    }

    void theConventionsAreFactorsOfTheirOwn()
    {
        Setup setup;
        setup.surface = surfaceFromWidget(50, 50, 1.0);
        setup.viewport = wholeSurface(setup.surface);
        const ApiSpaces spaces = apiSpaces(setup, Api::Direct3d);
        const Projection projection = Frustum{-1, 3, -2, 1, 2, 10};
        const auto parts = inConventions(*factors(projection), spaces.eye, spaces.clip);
        QCOMPARE(parts.size(), std::size_t(4));
        QVERIFY(parts.front().step == MatrixStep::FromConventions && parts.back().step == MatrixStep::ToConventions);
        const glm::dmat4 theirs = spaces.clip.matrix() * *clipFromEye(projection) * spaces.eye.inverse().matrix();
        QVERIFY(differenceUlps(parts, theirs) <= 1.0);
        QCOMPARE(inConventions(*factors(projection), {}, {}).size(), std::size_t(2));
    }

    void aPartLiesBetweenNothingAndAll()
    {
        const Ortho box{-0.1, 0.7, -0.3, 1.1, 0.3, 7.7};
        const auto parts = factors(Projection(box));
        QVERIFY(parts);
        QVERIFY(productOf(*parts, {0, 0, 0}) == glm::dmat4(1.0));
        for (const MatrixFactor &part : *parts)
            QVERIFY(partOf(part.matrix, 1.0) == part.matrix && partOf(part.matrix, 0.0) == glm::dmat4(1.0));
        const glm::dmat4 all = productOf(*parts, {1, 1, 1});
        QVERIFY(all == (*parts)[2].matrix * (*parts)[1].matrix * (*parts)[0].matrix);
        QVERIFY(differenceUlps(*parts, *clipFromEye(Projection(box))) <= 1.0);
        // The box's middle at z = -4 goes halfway to the origin, then everything is twice as large.
        // Half of the scale does half of that.
        const auto moved = factors(Projection(Ortho{-1, 1, -1, 1, 2, 6}));
        QVERIFY(moved);
        QVERIFY(productOf(*moved, {0.5, 0, 0}) * glm::dvec4(0, 0, -4, 1) == glm::dvec4(0, 0, -2, 1));
        QVERIFY(productOf(*moved, {1, 0.5, 0}) * glm::dvec4(1, 1, -2, 1) == glm::dvec4(1, 1, 1.5, 1));
        QVERIFY(productOf(*moved, {1, 1, 0.5}) * glm::dvec4(1, 1, -2, 1) == glm::dvec4(1, 1, 0, 1)); // flat
    }

    void theVolumeStaysInFrontOfTheEye()
    {
        const Frustum frustum{-1, 3, -2, 2, 2, 10};
        const auto parts = factors(Projection(frustum));
        QVERIFY(parts);
        for (const double onto : {0.0, 0.25, 0.5, 1.0}) {
            for (const double square : {0.0, 0.5, 1.0}) {
                for (const EyePoint &corner : viewVolumeCorners(Projection(frustum)))
                    QVERIFY((productOf(*parts, {onto, square}) * glm::dvec4(corner.coordinates(), 1.0)).w > 0.0);
            }
        }
    }

    void cancellingTermsCountByTheirSize()
    {
        glm::dmat4 half(1.0), almost(1.0);
        half[3][2] = -1.0;
        almost[3][2] = std::nextafter(1.0, 2.0);
        // Their product has 2.2e-16 where the identity has 0: an ulp of the summand 2, at half of it.
        QCOMPARE(differenceUlps({{MatrixStep::MoveBox, half}, {MatrixStep::MoveBox, almost}}, glm::dmat4(1.0)), 0.5);
        QCOMPARE(differenceUlps({{MatrixStep::TurnZ, glm::dmat4(1.0)}}, glm::dmat4(1.0)), 0.0);
    }

    void parametersThatMakeNoMatrixAreRefused()
    {
        QVERIFY(factors(Projection(Frustum{1, 1, -1, 1, 1, 10})).error().code == ErrorCode::LeftEqualsRight);
        QVERIFY(factors(LookAt{WorldPoint(1, 1, 1), WorldPoint(1, 1, 1), {0, 1, 0}}).error().code
                == ErrorCode::EyeEqualsCenter);
    }
};

UNPROJECTOR_TEST(TestMatrixFactors)
#include "test_matrix_factors.moc"
