// Every error that core documents, by its own code and with the offending value. No bad input may
// yield a point, and no error may have the code of another one.

#include "tests/support/test.h"

#include "core/geometry/camera.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"
#include "core/scene/reach.h"
#include "core/unproject/closed_form.h"
#include "core/unproject/matrix_inverse.h"
#include "tests/support/unprojecting.h"

#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Frustum kFrustum{-1, 1, -1, 1, 1, 100};
const Ortho kOrtho{-1, 1, -1, 1, 1, 100};
const Perspective kPerspective{1, 1.5, 1, 100};
const Oblique kOblique{kOrtho, 1, 1};
const Viewport kViewport{0, 0, 640, 480};
const WindowPoint kWindow(320.5, 240.5, 0.5);

/// A copy with one change.
template <class T, class Change>
T with(T value, Change change)
{
    change(value);
    return value;
}

/// Same number, or both NaN.
bool isSame(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// @param other  NaN where the code documents no second value: not looked at then
bool isError(const auto &result, ErrorCode code, double value, double other)
{
    if (result) {
        qWarning("a value instead of a refusal");
        return false;
    }
    const Error &error = result.error();
    if (error.code == code && isSame(error.value, value) && (std::isnan(other) || error.other == other))
        return true;
    qWarning("code %d (%g, %g) instead of %d (%g, %g)", int(error.code), error.value, error.other, int(code), value,
             other);
    return false;
}

} // namespace

class TestBadInput : public QObject {
    Q_OBJECT

private slots:
    void theGoodInputOfTheseRowsIsAccepted()
    {
        for (const Projection &projection :
             {Projection(kFrustum), Projection(kOrtho), Projection(kPerspective), Projection(kOblique)}) {
            QVERIFY(check(projection));
            QVERIFY(clipFromEye(projection));
            QVERIFY(unprojectClosedForm(projection, kViewport, {}, kWindow));
            QVERIFY(unprojectByInverse<EyeSpace>(clipFromEye(projection).value(), kViewport, {}, kWindow));
        }
        QVERIFY(eyeFrame(LookAt{}));
    }

    void aBadProjectionIsRefusedEverywhere_data()
    {
        addColumn<Projection>("projection");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");
        addColumn<double>("other");

        using enum ErrorCode;
        const auto row = [](const QByteArray &name, const Projection &projection, ErrorCode code, double value,
                            double other = kNan) { newRow(name) << projection << code << value << other; };

        // The six numbers that a frustum, a box and a sheared box have in common.
        const auto sixNumbers = [&](const QByteArray &kind, const auto &make) {
            using Change = double Ortho::*;
            const std::pair<const char *, Change> members[] = {
                {"left", &Ortho::left}, {"right", &Ortho::right},       {"bottom", &Ortho::bottom},
                {"top", &Ortho::top},   {"near", &Ortho::nearDistance}, {"far", &Ortho::farDistance},
            };
            for (const auto &[name, member] : members) {
                for (const double bad : {kNan, kInfinity, -kInfinity}) {
                    const Ortho box = with(kOrtho, [member = member, bad](Ortho &p) { p.*member = bad; });
                    row(kind + ": " + name + " = " + QByteArray::number(bad), make(box), NotFinite, bad);
                }
            }
            row(kind + ": left = right", make({3, 3, -1, 1, 1, 100}), LeftEqualsRight, 3);
            row(kind + ": bottom = top", make({-1, 1, 4, 4, 1, 100}), BottomEqualsTop, 4);
            row(kind + ": near = far", make({-1, 1, -1, 1, 7, 7}), NearNotBeforeFar, 7, 7);
            row(kind + ": near behind far", make({-1, 1, -1, 1, 8, 7}), NearNotBeforeFar, 8, 7);
        };
        sixNumbers("frustum", [](const Ortho &o) {
            return Frustum{o.left, o.right, o.bottom, o.top, o.nearDistance, o.farDistance};
        });
        sixNumbers("ortho", [](const Ortho &o) { return o; });
        sixNumbers("oblique", [](const Ortho &o) { return Oblique{o, 1, 1}; });

        row("frustum: near = 0", Frustum{-1, 1, -1, 1, 0, 100}, NearNotPositive, 0);
        row("frustum: near = -0", Frustum{-1, 1, -1, 1, -0.0, 100}, NearNotPositive, 0);
        row("frustum: near = -1", Frustum{-1, 1, -1, 1, -1, 100}, NearNotPositive, -1);
        row("frustum: skew = inf", Frustum{-1, 1, -1, 1, 1, 100, kInfinity}, NotFinite, kInfinity);
        row("pinhole: fx = 0", Pinhole{0, 9, 4, 3, 0, 8, 6, 1, 100}, FocalLengthIsZero, 0);
        row("pinhole: fy = 0", Pinhole{9, 0, 4, 3, 0, 8, 6, 1, 100}, FocalLengthIsZero, 0);
        row("pinhole: no width", Pinhole{9, 9, 4, 3, 0, 0, 6, 1, 100}, EmptyImage, 0, 6);
        row("pinhole: cy = nan", Pinhole{9, 9, 4, kNan, 0, 8, 6, 1, 100}, NotFinite, kNan);
        row("pinhole: near = 0", Pinhole{9, 9, 4, 3, 0, 8, 6, 0, 100}, NearNotPositive, 0);
        row("perspective: near = 0", Perspective{1, 1, 0, 100}, NearNotPositive, 0);
        row("perspective: near = -1", Perspective{1, 1, -1, 100}, NearNotPositive, -1);
        row("perspective: near = far", Perspective{1, 1, 7, 7}, NearNotBeforeFar, 7, 7);
        row("perspective: near behind far", Perspective{1, 1, 8, 7}, NearNotBeforeFar, 8, 7);
        row("perspective: fov = 0", Perspective{0, 1, 1, 100}, FieldOfViewOutOfRange, 0);
        row("perspective: fov = pi", Perspective{kPi, 1, 1, 100}, FieldOfViewOutOfRange, kPi);
        row("perspective: fov = -1", Perspective{-1, 1, 1, 100}, FieldOfViewOutOfRange, -1);
        row("perspective: fov in degrees", Perspective{45, 1, 1, 100}, FieldOfViewOutOfRange, 45);
        row("perspective: aspect = 0", Perspective{1, 0, 1, 100}, AspectNotPositive, 0);
        row("perspective: aspect = -1", Perspective{1, -1, 1, 100}, AspectNotPositive, -1);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            const QByteArray is = " = " + QByteArray::number(bad);
            row("perspective: fov" + is, Perspective{bad, 1, 1, 100}, NotFinite, bad);
            row("perspective: aspect" + is, Perspective{1, bad, 1, 100}, NotFinite, bad);
            row("perspective: near" + is, Perspective{1, 1, bad, 100}, NotFinite, bad);
            row("perspective: far" + is, Perspective{1, 1, 1, bad}, NotFinite, bad);
            row("oblique: theta" + is, Oblique{kOrtho, bad, 1}, NotFinite, bad);
            row("oblique: phi" + is, Oblique{kOrtho, 1, bad}, NotFinite, bad);
        }
        for (const double bad : {0.0, kPi, -0.5, 3.5}) {
            const QByteArray is = " = " + QByteArray::number(bad);
            row("oblique: theta" + is, Oblique{kOrtho, bad, 1}, ShearAngleOutOfRange, bad);
            row("oblique: phi" + is, Oblique{kOrtho, 1, bad}, ShearAngleOutOfRange, bad);
        }
    }

    void aBadProjectionIsRefusedEverywhere()
    {
        QFETCH(Projection, projection);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        QFETCH(double, other);
        QVERIFY(isError(check(projection), code, value, other));
        QVERIFY(isError(clipFromEye(projection), code, value, other));
        QVERIFY(isError(unprojectClosedForm(projection, kViewport, {}, kWindow), code, value, other));
    }

    void aBadTargetIsRefusedByBothMethods_data()
    {
        addColumn<Viewport>("viewport");
        addColumn<DepthRange>("range");
        addColumn<WindowPoint>("window");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");
        addColumn<double>("other");

        using enum ErrorCode;
        const auto row = [](const QByteArray &name, const Viewport &viewport, const DepthRange &range,
                            const WindowPoint &window, ErrorCode code, double value, double other = kNan) {
            newRow(name) << viewport << range << window << code << value << other;
        };
        row("empty viewport", {0, 0, 0, 0}, {}, kWindow, EmptyViewport, 0, 0);
        row("viewport without width", {0, 0, 0, 480}, {}, kWindow, EmptyViewport, 0, 480);
        row("viewport without height", {0, 0, 640, 0}, {}, kWindow, EmptyViewport, 640, 0);
        row("negative width", {0, 0, -640, 480}, {}, kWindow, EmptyViewport, -640, 480);
        row("negative height", {0, 0, 640, -480}, {}, kWindow, EmptyViewport, 640, -480);
        row("empty depth range", kViewport, {0.5, 0.5}, kWindow, EmptyDepthRange, 0.5);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            const QByteArray is = " = " + QByteArray::number(bad);
            row("viewport x" + is, {bad, 0, 640, 480}, {}, kWindow, NotFinite, bad);
            row("viewport y" + is, {0, bad, 640, 480}, {}, kWindow, NotFinite, bad);
            row("viewport width" + is, {0, 0, bad, 480}, {}, kWindow, NotFinite, bad);
            row("viewport height" + is, {0, 0, 640, bad}, {}, kWindow, NotFinite, bad);
            row("depth at near" + is, kViewport, {bad, 1}, kWindow, NotFinite, bad);
            row("depth at far" + is, kViewport, {0, bad}, kWindow, NotFinite, bad);
            row("window x" + is, kViewport, {}, WindowPoint(bad, 240.5, 0.5), NotFinite, bad);
            row("window y" + is, kViewport, {}, WindowPoint(320.5, bad, 0.5), NotFinite, bad);
        }
    }

    void aBadTargetIsRefusedByBothMethods()
    {
        QFETCH(Viewport, viewport);
        QFETCH(DepthRange, range);
        QFETCH(WindowPoint, window);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        QFETCH(double, other);
        for (const Projection &projection :
             {Projection(kFrustum), Projection(kOrtho), Projection(kPerspective), Projection(kOblique)}) {
            const glm::dmat4 matrix = clipFromEye(projection).value();
            QVERIFY(isError(unprojectClosedForm(projection, viewport, range, window), code, value, other));
            QVERIFY(isError(unprojectByInverse<EyeSpace>(matrix, viewport, range, window), code, value, other));
            QVERIFY(isError(unprojectByInverse<WorldSpace>(matrix, viewport, range, window), code, value, other));
            QVERIFY(isError(unprojectByInverse<ObjectSpace>(matrix, viewport, range, window), code, value, other));
            QVERIFY(
                isError((unprojectByInverse<EyeSpace, float>(matrix, viewport, range, window)), code, value, other));
        }
    }

    void aBadDepthIsRefusedByTheClosedForm_data()
    {
        addColumn<DepthRange>("range");
        addColumn<double>("depth");
        addColumn<bool>("matrixHasAnAnswer"); // a matrix does not care whether a depth is inside the range

        newRow("NaN") << DepthRange{} << kNan << false;
        newRow("infinite") << DepthRange{} << kInfinity << false;
        newRow("-0.1") << DepthRange{} << -0.1 << true;
        newRow("1.0001") << DepthRange{} << 1.0001 << true;
        newRow("-0.1 of a reversed range") << DepthRange{1, 0} << -0.1 << true;
        newRow("below a partial range") << DepthRange{0.25, 0.75} << 0.2 << true;
        newRow("above a partial range") << DepthRange{0.25, 0.75} << 0.7501 << true;
    }

    void aBadDepthIsRefusedByTheClosedForm()
    {
        QFETCH(DepthRange, range);
        QFETCH(double, depth);
        QFETCH(bool, matrixHasAnAnswer);
        const WindowPoint window(320.5, 240.5, depth);
        for (const Projection &projection :
             {Projection(kFrustum), Projection(kOrtho), Projection(kPerspective), Projection(kOblique)}) {
            constexpr ErrorCode code = ErrorCode::DepthOutsideRange;
            QVERIFY(isError(unprojectClosedForm(projection, kViewport, range, window), code, depth, kNan));
            const auto byMatrix =
                unprojectByInverse<EyeSpace>(clipFromEye(projection).value(), kViewport, range, window);
            if (matrixHasAnAnswer)
                QVERIFY(byMatrix);
            else
                QVERIFY(isError(byMatrix, ErrorCode::NotFinite, depth, kNan));
        }
    }

    void bothEndsOfTheDepthRangeAreAccepted_data()
    {
        addColumn<DepthRange>("range");
        newRow("default") << DepthRange{};
        newRow("reversed") << DepthRange{1, 0};
        newRow("partial") << DepthRange{0.1, 0.7};
    }

    void bothEndsOfTheDepthRangeAreAccepted()
    {
        QFETCH(DepthRange, range);
        for (const Projection &projection :
             {Projection(kFrustum), Projection(kOrtho), Projection(kPerspective), Projection(kOblique)}) {
            const auto onNear =
                unprojectClosedForm(projection, kViewport, range, WindowPoint(320.5, 240.5, range.atNear));
            QVERIFY(onNear);
            QCOMPARE(onNear->z, -1.0);
            const auto onFar =
                unprojectClosedForm(projection, kViewport, range, WindowPoint(320.5, 240.5, range.atFar));
            QVERIFY(onFar);
            QCOMPARE(onFar->z, -100.0);
        }
    }

    void aBadMatrixIsRefused_data()
    {
        addColumn<glm::dmat4>("matrix");
        addColumn<WindowPoint>("window");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");

        using enum ErrorCode;
        const glm::dmat4 identity(1.0);
        const auto row = [](const QByteArray &name, const glm::dmat4 &matrix, const WindowPoint &window, ErrorCode code,
                            double value = kNan) { newRow(name) << matrix << window << code << value; };
        row("zero matrix", glm::dmat4(0.0), kWindow, SingularMatrix);
        row("no depth row", with(identity, [](glm::dmat4 &m) { m[2][2] = 0.0; }), kWindow, SingularMatrix);
        row("equal columns", with(identity, [](glm::dmat4 &m) { m[1] = m[0]; }), kWindow, SingularMatrix);
        row("a column twice another", with(identity, [](glm::dmat4 &m) { m[1] = 2.0 * m[0]; }), kWindow,
            SingularMatrix);
        row("equal rows", glm::dmat4{{1, 1, 0, 0}, {2, 2, 0, 0}, {3, 3, 1, 0}, {4, 4, 0, 1}}, kWindow, SingularMatrix);
        row("projection onto a plane: w = -z/n", glm::dmat4{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -0.25}, {0, 0, 0, 0}},
            kWindow, SingularMatrix);
        // Frustum 1 : 2 puts the plane at infinity at NDC depth 3, window depth 2; all of its numbers
        // are exact.
        row("depth of the plane at infinity", clipFromEye(Frustum{-1, 1, -1, 1, 1, 2}).value(),
            WindowPoint(320, 240, 2), PointAtInfinity);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            for (int k = 0; k < 16; k += 5) {
                row("element " + QByteArray::number(k) + " = " + QByteArray::number(bad),
                    with(identity, [&](glm::dmat4 &m) { m[k / 4][k % 4] = bad; }), kWindow, NotFinite, bad);
            }
            row("depth = " + QByteArray::number(bad), identity, WindowPoint(320, 240, bad), NotFinite, bad);
        }
    }

    void aBadMatrixIsRefused()
    {
        QFETCH(glm::dmat4, matrix);
        QFETCH(WindowPoint, window);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        QVERIFY(isError(unprojectByInverse<EyeSpace>(matrix, kViewport, {}, window), code, value, kNan));
        QVERIFY(isError(unprojectByInverse<WorldSpace>(matrix, kViewport, {}, window), code, value, kNan));
        QVERIFY(isError(unprojectByInverse<ObjectSpace>(matrix, kViewport, {}, window), code, value, kNan));
        QVERIFY(isError((unprojectByInverse<WorldSpace, float>(matrix, kViewport, {}, window)), code, value, kNan));
    }

    void anObjectOutOfReachIsRefused_data()
    {
        using enum ErrorCode;
        addColumn<TransformStep>("step");
        addColumn<std::optional<ErrorCode>>("code");
        addColumn<double>("value");
        const auto row = [](const char *name, const TransformStep &step, std::optional<ErrorCode> code, double value) {
            newRow(name) << step << code << value;
        };
        row("as far as can be", Translate{{0, 9e99, 0}}, {}, 0.0);
        row("too far", Translate{{0, 2e100, 0}}, ObjectTooFar, 2e100);
        row("too far, to the left", Translate{{-2e100, 0, 0}}, ObjectTooFar, -2e100);
        row("too large", Scale{glm::dvec3(1e101)}, ObjectTooFar, -1e101);
        row("beyond doubles", Scale{glm::dvec3(1e308)}, ObjectTooFar, -1e308);
        row("as small as can be", Scale{glm::dvec3(1e-100)}, {}, 0.0);
        row("too small", Scale{glm::dvec3(1e-101)}, ObjectTooSmall, 2e-101);
    }

    /// Every number of the transform is finite: that is another refusal.
    void anObjectOutOfReachIsRefused()
    {
        QFETCH(TransformStep, step);
        QFETCH(std::optional<ErrorCode>, code);
        QFETCH(double, value);
        const auto model = std::make_shared<mesh::Model>();
        model->bounds = {glm::dvec3(-1.0), glm::dvec3(1.0)};
        const Check reached = scene::reachable({"object", {}, model, {step}});
        QCOMPARE(reached.hasValue(), !code);
        if (code)
            QVERIFY(isError(reached, *code, value, kNan));
    }

    void aMatrixOfAnyScaleIsInverted_data()
    {
        addColumn<double>("scale");
        for (const double scale : {0x1p-200, 0x1p-100, 1.0, 0x1p+100, 0x1p+200})
            addRow("%g", scale) << scale;
    }

    /// A homogeneous matrix times a number is the same transform; its determinant is 10^-240 or 10^240
    /// here.
    void aMatrixOfAnyScaleIsInverted()
    {
        QFETCH(double, scale);
        const glm::dmat4 matrix = clipFromEye(kFrustum).value();
        const EyePoint expected = unprojectByInverse<EyeSpace>(matrix, kViewport, {}, kWindow).value();
        const auto scaled = unprojectByInverse<EyeSpace>(scale * matrix, kViewport, {}, kWindow);
        QVERIFY(scaled);
        QVERIFY(*scaled == expected);
    }

    void aBadCameraIsRefused_data()
    {
        addColumn<LookAt>("camera");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");

        using enum ErrorCode;
        const auto row = [](const QByteArray &name, const LookAt &camera, ErrorCode code, double value = kNan) {
            newRow(name) << camera << code << value;
        };
        const WorldPoint eye(1, 2, 3), center(4, 6, 3);
        const WorldVector up(0, 1, 0), along(3, 4, 0);
        row("eye on the centre", {eye, eye, up}, EyeEqualsCenter);
        row("up zero", {eye, center, {0, 0, 0}}, UpIsZero);
        row("up along the view", {eye, center, along}, UpParallelToView);
        row("up against the view", {eye, center, -along}, UpParallelToView);
        row("up along the view, very long", {eye, center, 1e200 * along}, UpParallelToView);
        row("up along the view, very short", {eye, center, 1e-200 * along}, UpParallelToView);
        row("up a rounding off the view", {eye, center, {3, 4, 1e-11}}, UpParallelToView);
        row("looking down the y axis with up = y", {WorldPoint(0, 5, 0), WorldPoint(0, 0, 0), up}, UpParallelToView);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            for (int k = 0; k < 3; ++k) {
                const QByteArray is = QByteArray::number(k) + " = " + QByteArray::number(bad);
                row("eye " + is, {with(eye, [&](WorldPoint &p) { p[k] = bad; }), center, up}, NotFinite, bad);
                row("centre " + is, {eye, with(center, [&](WorldPoint &p) { p[k] = bad; }), up}, NotFinite, bad);
                row("up " + is, {eye, center, with(up, [&](WorldVector &p) { p[k] = bad; })}, NotFinite, bad);
            }
        }
    }

    void aBadCameraIsRefused()
    {
        QFETCH(LookAt, camera);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        QVERIFY(isError(eyeFrame(camera), code, value, kNan));
    }
};

UNPROJECTOR_TEST(TestBadInput)
#include "test_bad_input.moc"
