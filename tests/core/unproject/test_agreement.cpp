// The report on the two methods at a pick: whether they agree, and what magnifies their difference.

#include "tests/support/test.h"

#include "core/unproject/agreement.h"
#include "tests/support/unprojecting.h"

#include <cmath>

using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

/// Near 2, far 10, from (0, 0, 5) towards the origin.
Setup setup(const Projection &projection)
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            {},
            projection,
            LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

/// A pick at distance z = 10/3, whose methods have found these points.
Pick pickOf(const Projection &projection, const glm::dvec3 &formula, const glm::dvec3 &matrix, double uncertainty,
            bool hit = true)
{
    Pick pick =
        pickAt(setup(projection), {412.0, 299.0}, {hit ? 0.5 : 1.0, hit ? std::optional<std::size_t>(0) : std::nullopt})
            .value();
    pick.point.world =
        Answers<WorldSpace>::of([&](Method method) { return WorldPoint(method == Method::Matrix ? matrix : formula); });
    pick.uncertainty.world = {uncertainty, uncertainty, uncertainty};
    return pick;
}

const Frustum kFrustum{-0.8, 0.8, -0.6, 0.6, 2.0, 10.0};
const Ortho kBox{-4.0, 4.0, -3.0, 3.0, 2.0, 10.0};
const glm::dvec3 kPoint(1.0, 2.0, 4.0); // its ulp is 2^-50

glm::dvec3 offBy(double ulps)
{
    return kPoint + glm::dvec3(0.0, 0.0, ulps * std::ldexp(1.0, -50));
}

} // namespace

class TestAgreement : public QObject {
    Q_OBJECT

private slots:
    void differencesAreCountedInUlps()
    {
        const Agreement agreement = agreementOf(pickOf(kFrustum, kPoint, offBy(37.0), 1.0)).value();
        QVERIFY(agreement.ulps == 37.0 && agreement.difference == std::ldexp(37.0, -50));
        QVERIFY(!agreement.isToTheLastPlaces() && agreement.isWithinUncertainty == true);
        // z (f − n) / (f n) = (10 / 3) 8 / 20; the eye at 5 against the point's 4.
        QVERIFY(std::abs(agreement.byPerspective - 4.0 / 3.0) < 1e-12);
        QVERIFY(std::abs(agreement.byCancelling - 1.25) < 1e-12);
        // The unit at the origin is the one of the cancelling eye coordinates: 5 has 2^-50.
        const Agreement atOrigin = agreementOf(pickOf(kFrustum, {}, {0.0, 0.0, std::ldexp(3.0, -50)}, 1.0)).value();
        QVERIFY(atOrigin.ulps == 3.0 && std::isfinite(atOrigin.byCancelling));
        QVERIFY(agreementOf(pickOf(kBox, kPoint, offBy(37.0), 1.0))->byPerspective == 1.0);
        QVERIFY(agreementOf(pickOf(kFrustum, kPoint, offBy(37.0), 1e-15))->isWithinUncertainty == false);
        QVERIFY(
            !agreementOf(pickOf(kFrustum, kPoint, kPoint, 1.0, false))->isWithinUncertainty); // of a ray there is none
    }

    void theVerdictNamesTheCause_data()
    {
        addColumn<double>("ulps");
        addColumn<double>("nearDistance");
        addColumn<glm::dvec3>("point");
        addColumn<double>("uncertainty");
        addColumn<QString>("verdict");
        const auto row = [](const char *name, double ulps, double nearDistance, const glm::dvec3 &point,
                            double uncertainty, const char *verdict) {
            newRow(name) << ulps << nearDistance << point << uncertainty << QString::fromUtf8(verdict);
        };
        row("the same", 0.0, 2.0, kPoint, 1.0, "Formula and matrix agree to the last digit");
        row("one", 0.7, 2.0, kPoint, 1.0, "Formula and matrix agree to within 1 ulp");
        row("a few", 3.5, 2.0, kPoint, 1.0, "Formula and matrix agree to within 4 ulp");
        row("nothing magnifies", 40.0, 2.0, kPoint, 1.0,
            "Formula and matrix differ by 40 ulp: rounding of the inverse. The uncertainty is larger.");
        row("more than is uncertain", 40.0, 2.0, kPoint, 1e-15,
            "Formula and matrix differ by 40 ulp: rounding of the inverse. The uncertainty is smaller.");
        row("near : far", 8900.0, 0.001, kPoint, 1.0,
            "Formula and matrix differ by 8900 ulp: rounding of the inverse, magnified by near : far. The uncertainty "
            "is "
            "larger.");
        row("by the origin", 60.0, 2.0, {0.001, 0.0, 0.0}, 1.0,
            "Formula and matrix differ by 60 ulp: rounding of the inverse, magnified where coordinates cancel. "
            "The uncertainty is larger.");
    }

    void theVerdictNamesTheCause()
    {
        QFETCH(double, ulps);
        QFETCH(double, nearDistance);
        QFETCH(glm::dvec3, point);
        QFETCH(double, uncertainty);
        QFETCH(QString, verdict);
        const Frustum frustum{-0.4 * nearDistance, 0.4 * nearDistance, -0.3 * nearDistance,
                              0.3 * nearDistance,  nearDistance,       10.0};
        Pick pick = pickOf(kFrustum, point, point, uncertainty);
        pick.setup.lens = Projection(frustum);
        const double unit = ulpOfLargest(WorldPoint(point));
        // Differences of tenths of an ulp are in the smaller coordinates.
        glm::dvec3 matrix = point;
        matrix.y += ulps * unit;
        pick.point.world = Answers<WorldSpace>::of(
            [&](Method method) { return WorldPoint(method == Method::Matrix ? matrix : point); });
        QCOMPARE(QString::fromStdString(verdictText(pick)), verdict);
    }

    void aMethodWithoutAnswerIsNamed()
    {
        Pick pick = pickOf(kFrustum, kPoint, kPoint, 1.0);
        pick.point.world = Answers<WorldSpace>::of([&](Method method) -> Result<WorldPoint> {
            if (method == Method::Matrix)
                return Error{ErrorCode::SingularMatrix};
            return WorldPoint(kPoint);
        });
        QVERIFY(!agreementOf(pick));
        QVERIFY(differenceCauseText(pick).empty());
        const QString verdict = QString::fromStdString(verdictText(pick));
        QVERIFY2(verdict.startsWith(QStringLiteral("Only the formula has an answer; the matrix: "))
                     && verdict.size() > 48,
                 qPrintable(verdict));
    }

    void theCauseHasItsNumbers()
    {
        const auto cause = [](const Projection &projection, double ulps) {
            return QString::fromStdString(differenceCauseText(pickOf(projection, kPoint, offBy(ulps), 1.0)));
        };
        QVERIFY(cause(kFrustum, 1.0).contains(QStringLiteral("agree to the last places")));
        QVERIFY2(cause(kFrustum, 100.0)
                     .contains(QStringLiteral("magnified 1.3 times by the perspective (z (f − n) / (f n)) and "
                                              "1.3 times")),
                 qPrintable(cause(kFrustum, 100.0)));
        QVERIFY(cause(kBox, 100.0).contains(QStringLiteral("magnified 1.5 times where the eye's coordinates cancel")));
    }
};

UNPROJECTOR_TEST(TestAgreement)
#include "test_agreement.moc"
