// Matrices as programs print them: inverted in double or in single precision, written with so many
// digits.

#include "tests/support/test.h"

#include "core/geometry/error_text.h"
#include "core/geometry/matrix_projection.h"
#include "core/geometry/view_matrix.h"
#include "tests/support/core_scene.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

using namespace unprojector;
using namespace unprojector::geometry;
using oracle::Extended;

namespace {

/// The closed form's promise, as for parameters: 9 epsilons of the scene's scale.
constexpr double kClosedForm = 2e-15;

std::array<double, 16> columns(const glm::dmat4 &m)
{
    std::array<double, 16> numbers;
    for (std::size_t i = 0; i < 16; ++i)
        numbers[i] = m[int(i / 4)][int(i % 4)];
    return numbers;
}

glm::dmat4 printed(const glm::dmat4 &m, const char *format, int digits)
{
    glm::dmat4 result;
    for (int i = 0; i < 16; ++i) {
        char text[512];
        std::snprintf(text, sizeof text, format, digits, m[i / 4][i % 4]);
        result[i / 4][i % 4] = std::strtod(text, nullptr);
    }
    return result;
}

enum class Arithmetic { Glm, GlmSingle, Cofactors, CofactorsSingle };

/// The inverse as three.js computes it: each cofactor times one over the determinant, so that w is
/// rounded twice.
template <class Scalar>
glm::dmat4 byCofactors(const glm::dmat4 &matrix)
{
    const glm::mat<4, 4, Scalar> m(matrix);
    const auto cofactor = [&](int column, int row) {
        const int c[] = {(column + 1) % 4, (column + 2) % 4, (column + 3) % 4};
        const int r[] = {(row + 1) % 4, (row + 2) % 4, (row + 3) % 4};
        const auto product = [&](int i, int j, int k) { return m[c[0]][r[i]] * m[c[1]][r[j]] * m[c[2]][r[k]]; };
        const Scalar minor = product(0, 1, 2) - product(0, 2, 1) + product(1, 2, 0) - product(1, 0, 2)
                             + product(2, 0, 1) - product(2, 1, 0);
        return (column + row) % 2 == 0 ? minor : -minor;
    };
    Scalar determinant = 0;
    for (int i = 0; i < 4; ++i)
        determinant += m[i][0] * cofactor(i, 0);
    const Scalar reciprocal = 1 / determinant;
    glm::dmat4 result;
    for (int i = 0; i < 16; ++i)
        result[i / 4][i % 4] = double(cofactor(i % 4, i / 4) * reciprocal);
    return result;
}

glm::dmat4 inverted(const glm::dmat4 &m, Arithmetic arithmetic)
{
    switch (arithmetic) {
    case Arithmetic::Glm: break;
    case Arithmetic::GlmSingle: return glm::dmat4(glm::inverse(glm::mat4(m)));
    case Arithmetic::Cofactors: return byCofactors<double>(m);
    case Arithmetic::CofactorsSingle: return byCofactors<float>(m);
    }
    return glm::inverse(m);
}

constexpr std::array<std::pair<const char *, Arithmetic>, 4> kArithmetics{
    {{"GLM", Arithmetic::Glm},
     {"GLM in single precision", Arithmetic::GlmSingle},
     {"cofactors", Arithmetic::Cofactors},
     {"cofactors in single precision", Arithmetic::CofactorsSingle}}};

bool isSingle(Arithmetic arithmetic)
{
    return arithmetic == Arithmetic::GlmSingle || arithmetic == Arithmetic::CofactorsSingle;
}

/// The camera as a program keeps it: its position and orientation.
glm::dmat4 worldFromEyeOf(const oracle::View &view)
{
    const EyeFrame frame = eyeFrame(oracle::coreView(view)).value();
    return glm::dmat4(glm::dvec4(frame.side.coordinates(), 0.0), glm::dvec4(frame.upward.coordinates(), 0.0),
                      glm::dvec4((-frame.forward).coordinates(), 0.0), glm::dvec4(frame.eye.coordinates(), 1.0));
}

Result<WorldPoint> worldUnder(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld,
                              const oracle::Target &target, const std::array<double, 3> &at)
{
    const auto eye =
        preciseEyePoint(MatrixProjection{clipFromEye, NdcDepth::MinusOneToOne}, oracle::coreViewport(target),
                        oracle::coreDepthRange(target), WindowPoint(at[0], at[1], at[2]));
    if (!eye)
        return eye.error();
    return worldFromEye(eyeFromWorld, *eye);
}

} // namespace

class TestPrintedMatrices : public QObject {
    Q_OBJECT

private slots:
    void anInvertedCameraIsAView_data()
    {
        addColumn<int>("arithmetic");
        addColumn<QByteArray>("format");
        addColumn<int>("digits");
        for (const auto &[name, arithmetic] : kArithmetics) {
            for (int digits = 6; digits <= 17; ++digits) {
                for (const char *format : {"%.*g", "%.*f"}) {
                    addRow("%s, %d digits%s", name, digits, format[3] == 'f' ? " behind the point" : "")
                        << int(arithmetic) << QByteArray(format) << digits;
                }
            }
        }
    }

    void anInvertedCameraIsAView()
    {
        QFETCH(int, arithmetic);
        QFETCH(QByteArray, format);
        QFETCH(int, digits);
        oracle::Random random(8);
        double worst = 0.0;
        int notOne = 0;
        for (int i = 0; i < 1000; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Frustum, {});
            const glm::dmat4 exactView = inverted(worldFromEyeOf(scene.view), Arithmetic(arithmetic));
            notOne += exactView[3][3] != 1.0;
            const glm::dmat4 view = printed(exactView, format.constData(), digits);
            const Result<double> off = axesOff(view);
            QVERIFY2(off, off ? "" : geometry::errorText(off.error()).c_str());

            const glm::dmat4 m = clipFromEye(oracle::coreProjection(scene.projection)).value();
            const oracle::Oracle exact(columns(view), columns(m), scene.target, false);
            const std::array<double, 3> at = oracle::randomClick(random, scene.target);
            const Result<WorldPoint> world = worldUnder(m, view, scene.target, at);
            QVERIFY(world);
            const oracle::Vector3 truth = exact.worldUnder(at);
            const Extended scale = std::max({oracle::maxNorm(truth), oracle::maxNorm(exact.eyeUnder(at)),
                                             Extended(glm::length(glm::dvec3(view[3])))});
            worst =
                std::max(worst, double(oracle::maxNorm(oracle::difference(oracle::extended(*world), truth)) / scale));
        }
        qInfo("w is not 1 in %d of 1000", notOne);
        QVERIFY2(worst <= kClosedForm, qPrintable(QString::number(worst)));
    }

    void aMultipleIsTheSameView()
    {
        oracle::Random random(9);
        for (int i = 0; i < 100; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Frustum, {});
            const glm::dmat4 view = glm::inverse(worldFromEyeOf(scene.view));
            const glm::dmat4 m = clipFromEye(oracle::coreProjection(scene.projection)).value();
            const std::array<double, 3> at = oracle::randomClick(random, scene.target);
            const WorldPoint one = worldUnder(m, view, scene.target, at).value();
            QVERIFY(worldUnder(m, view * 4.0, scene.target, at).value() == one);
            const LookAt camera = lookAtFrom(view, 1.0).value(), same = lookAtFrom(view * 4.0, 1.0).value();
            QVERIFY(camera.eye == same.eye && camera.center == same.center && camera.up == same.up);
        }
    }

    void whatDoesMoreThanTurnAndMoveIsNamed_data()
    {
        addColumn<int>("column");
        addColumn<int>("row");
        addColumn<double>("entry");
        addColumn<QByteArray>("text");
        const auto row = [](const char *name, int column, int rowOfEntry, double entry, const char *text) {
            newRow(name) << column << rowOfEntry << entry << QByteArray(text);
        };
        row("scaled by 1.001", 1, 1, 1.001, "row 2 has the length 1.001; it must be 1");
        row("doubled", 2, 2, 2.0, "row 3 has the length 2; it must be 1");
        row("sheared", 2, 0, 0.001, "rows 1 and 3 are not perpendicular");
        row("perspective in x", 0, 3, 0.5, "0.5 is in row 4, column 1; it must be 0");
        row("a faint perspective in z", 2, 3, 1e-9, "1e-09 is in row 4, column 3; it must be 0");
        row("w is 0", 3, 3, 0.0, "0 is in row 4, column 4; it must be greater than 0");
        row("w is negative", 3, 3, -1.0, "-1 is in row 4, column 4; it must be greater than 0");
    }

    void whatDoesMoreThanTurnAndMoveIsNamed()
    {
        QFETCH(int, column);
        QFETCH(int, row);
        QFETCH(double, entry);
        QFETCH(QByteArray, text);
        glm::dmat4 view(1.0);
        view[3] = {3.0, -4.0, -5.0, 1.0};
        QVERIFY(axesOff(view));
        view[column][row] = entry;
        const Result<double> off = axesOff(view);
        QVERIFY(!off);
        QVERIFY(off.error().code == ErrorCode::ViewNotRigid);
        QCOMPARE(QByteArray::fromStdString(geometry::errorText(off.error())),
                 "the view matrix is not rotation + translation: " + text);
        QVERIFY(!worldFromEye(view, EyePoint(1, 2, -3)));
    }

    void aProjectionInvertedTwiceIsOne_data()
    {
        addColumn<int>("arithmetic");
        addColumn<bool>("infinite");
        for (const auto &[name, arithmetic] : kArithmetics) {
            for (const bool infinite : {false, true})
                addRow("%s, far %s", name, infinite ? "at infinity" : "finite") << int(arithmetic) << infinite;
        }
    }

    void aProjectionInvertedTwiceIsOne()
    {
        QFETCH(int, arithmetic);
        const bool single = isSingle(Arithmetic(arithmetic));
        QFETCH(bool, infinite);
        oracle::Random random(10);
        for (int i = 0; i < 1000; ++i) {
            const double n = random.uniform(0.01, 10.0), f = n * random.uniform(2.0, 1000.0);
            const double r = random.uniform(0.1, 10.0), t = random.uniform(0.1, 10.0),
                         l = -r * random.uniform(0.5, 2.0);
            glm::dmat4 m = clipFromEye(Projection(Frustum{l, r, -t, t, n, f})).value();
            if (infinite) {
                m[2][2] = -1.0;
                m[3][2] = -2.0 * n;
            }
            const glm::dmat4 twice = inverted(inverted(m, Arithmetic(arithmetic)), Arithmetic(arithmetic));
            const Result<RecognisedProjection> found = recognised({twice, NdcDepth::MinusOneToOne});
            QVERIFY2(found, found ? "" : geometry::errorText(found.error()).c_str());
            const auto *frustum = std::get_if<Frustum>(&found->parameters);
            QVERIFY(frustum);
            const double tolerance = single ? 1e-3 : 1e-11;
            QVERIFY(std::abs(frustum->nearDistance - n) <= tolerance * n);
            if (infinite)
                QVERIFY(frustum->farDistance > (single ? 1e5 : 1e13) * n);
            else
                QVERIFY(std::abs(frustum->farDistance - f) <= tolerance * f * (f / n));
        }
    }
};

UNPROJECTOR_TEST(TestPrintedMatrices)
#include "test_printed_matrices.moc"
