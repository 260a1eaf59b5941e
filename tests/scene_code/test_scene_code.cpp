// The generated code of a scene, compiled: its matrices and its unprojection equal core's.

#include "tests/support/test.h"

#include "core/scene_code/scene_code.h"
#include "tests/scene_code/core_clicks.h"

#include <QMatrix4x4>
#include <QRegularExpression>
#include <QSet>
#include <QVector3D>
#include <QVector4D>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace frustum_glm {
#include "frustum_glm.h"
}
namespace matrices_glm {
#include "matrices_glm.h"
}
namespace oblique_glm {
#include "oblique_glm.h"
}
namespace off_centre_glm {
#include "off_centre_glm.h"
}
namespace ortho_glm {
#include "ortho_glm.h"
}
namespace perspective_glm {
#include "perspective_glm.h"
}
namespace frustum_qt {
#include "frustum_qt.h"
}
namespace matrices_qt {
#include "matrices_qt.h"
}
namespace oblique_qt {
#include "oblique_qt.h"
}
namespace off_centre_qt {
#include "off_centre_qt.h"
}
namespace ortho_qt {
#include "ortho_qt.h"
}
namespace perspective_qt {
#include "perspective_qt.h"
}

using namespace unprojector::scene_code;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;

namespace {

glm::dmat4 numbers(const glm::dmat4 &m)
{
    return m;
}

glm::dmat4 numbers(const QMatrix4x4 &m)
{
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[column][row] = double(m(row, column));
    return result;
}

glm::dvec3 numbers(const glm::dvec3 &v)
{
    return v;
}

glm::dvec3 numbers(const QVector3D &v)
{
    return {v.x(), v.y(), v.z()};
}

/// A scene's code, compiled.
struct Compiled {
    std::string scene;
    glm::dmat4 clipFromEye, eyeFromWorld;
    std::vector<glm::dmat4> models;
    core_clicks::Screen2World screen2world;
    double share; ///< of a matrix' largest number that rounding may leave
};

#define COMPILED(scene, dialect, models, share)                                                                        \
    Compiled                                                                                                           \
    {                                                                                                                  \
#scene, numbers(scene##_##dialect::clipFromEye()), numbers(scene##_##dialect::eyeFromWorld()), models,         \
            [](int i, int j, double depth) { return numbers(scene##_##dialect::screen2world(i, j, depth)); }, share    \
    }

constexpr double kInDouble = 1e-14, kInFloat = 1e-6;

std::vector<glm::dmat4> modelsInGlm()
{
    return {frustum_glm::worldFrom_face(), frustum_glm::worldFrom_2()};
}

std::vector<glm::dmat4> modelsInQt()
{
    return {numbers(frustum_qt::worldFrom_face()), numbers(frustum_qt::worldFrom_2())};
}

} // namespace

Q_DECLARE_METATYPE(Compiled)

class TestSceneCode : public QObject {
    Q_OBJECT

private slots:
    void matricesAreCores_data() { compiledRows(); }

    void matricesAreCores()
    {
        QFETCH(Compiled, code);
        const SceneFile scene = core_clicks::sceneNamed(code.scene.c_str());
        const Setup setup = setupOf(scene);
        core_clicks::compareMatrices(code.clipFromEye, *clipFromEye(setup), code.share);
        core_clicks::compareMatrices(code.eyeFromWorld, *eyeFromWorld(setup), code.share);
        QCOMPARE(code.models.size(), scene.objects.size());
        for (std::size_t i = 0; i < code.models.size(); ++i)
            core_clicks::compareMatrices(code.models[i], worldFromObject(scene.objects[i].transform), code.share);
    }

    void aHundredPointsAreCores_data() { compiledRows(); }

    void aHundredPointsAreCores()
    {
        QFETCH(Compiled, code);
        // The distance of a perspective multiplies a depth's rounding by itself and by 1 / near, up to
        // 20.
        core_clicks::compareClicks(core_clicks::sceneNamed(code.scene.c_str()), code.screen2world, 20.0 * code.share);
    }

    void numbersKeepAllTheirDigits_data()
    {
        addColumn<CodeDialect>("dialect");
        newRow("GLU") << CodeDialect::Glu;
        newRow("GLM") << CodeDialect::Glm;
        newRow("Qt") << CodeDialect::Qt;
        newRow("three.js") << CodeDialect::ThreeJs;
        newRow("NumPy") << CodeDialect::NumPy;
    }

    /// The numbers are read out of the text: three.js' is not run.
    void numbersKeepAllTheirDigits()
    {
        QFETCH(CodeDialect, dialect);
        const double third = 1.0 / 3.0, sum = 0.1 + 0.2;
        SceneFile scene;
        scene.projection = Frustum{-sum, 2 * third, -1e-5, 1e-17, 0.7 * third, 4e6 + third};
        scene.view = LookAt{{4000000.123456789, third, -0.0}, {500000.0, -sum, 1e-7}, {1e-300, 1.0, third}};
        scene.viewport = Viewport{3.0, 7.0, 640.0, 480.0};
        scene.depthRange = {third, 2 * third};
        scene.objects.resize(1);
        scene.objects[0].transform = {Translate{{1e15, 1e10, 123456.0}}, Rotate{100 * third, {7 * third, 0.0, 1.0}},
                                      Scale{{-5 * third, 1.0, 2.0}}};
        scene.clipPlanes = {{8 * third, 1.0, 0.5, -11 * third}};
        const QString text = QString::fromStdString(sceneCode(scene, dialect));

        QSet<double> found;
        static const QRegularExpression number(QStringLiteral("-?\\b\\d+(\\.\\d+)?(e[+-]?\\d+)?"));
        for (auto it = number.globalMatch(text); it.hasNext();)
            found << it.next().captured(0).toDouble();
        for (const double value : {-sum,      2 * third,  -1e-5, 1e-17,    0.7 * third, 4e6 + third, 4000000.123456789,
                                   third,     500000.0,   1e-7,  1e-300,   3.0,         7.0,         640.0,
                                   480.0,     1e15,       1e10,  123456.0, 100 * third, 7 * third,   -5 * third,
                                   8 * third, -11 * third})
            QVERIFY2(found.contains(value), qPrintable(QString::number(value, 'g', 17) + " is not in\n" + text));

        scene.projection = Perspective{radiansFromDegrees(33.3), 1.5, 0.1, 100.0};
        QVERIFY(sceneCode(scene, dialect).find("33.3") != std::string::npos);
    }

    /// No name of an object ends the comment that contains it, or makes an identifier invalid.
    void namesStayInTheirComments()
    {
        SceneFile scene;
        for (const char *name :
             {"a\nevil1", "a\revil2",
              "a\xe2\x80\xa8"
              "evil3",
              "a\\", "", "_", "a", "A b", "\xe5\xa4\xb4", "b\xe2\x80\xaelive", "b\xe2\x81\xa6live", "b\xc2\x85live",
              "b\x7flive", "b\xd8\x9clive", "b\xf3\xa0\x81\x81live", "\xe8\x91\x9b\xf3\xa0\x84\x80"}) {
            scene.objects.emplace_back();
            scene.objects.back().name = name;
            scene.objects.back().file = "evil.obj";
        }
        for (const CodeDialect dialect :
             {CodeDialect::Glu, CodeDialect::Glm, CodeDialect::Qt, CodeDialect::ThreeJs, CodeDialect::NumPy}) {
            QString text = QString::fromStdString(sceneCode(scene, dialect));
            for (const QChar c : text) // bidirectional controls turn code round to the eye
                QVERIFY2(c == QLatin1Char('\n') || c.category() == QChar::Other_Surrogate || c.isPrint(),
                         qPrintable(text));
            QVERIFY(text.contains(QStringLiteral("\u5934")));
            QVERIFY(text.contains(QStringLiteral("\u845b\U000e0100"))); // a variant of an ideograph
            QVERIFY(!text.contains(QStringLiteral("\U000e0041")));      // a tag
            text.replace(QChar::LineSeparator, QLatin1Char('\n')).replace(QLatin1Char('\r'), QLatin1Char('\n'));
            for (const QString &line : text.split(QLatin1Char('\n'))) {
                QVERIFY2(!line.startsWith(QLatin1String("evil")), qPrintable(line));
                QVERIFY2(!line.endsWith(QLatin1Char('\\')), qPrintable(line));
            }
            QVERIFY2(!text.contains(QRegularExpression(QStringLiteral("\\w__\\w*\\("))), qPrintable(text));
            for (const char *id :
                 {"_a_evil1", "_a_evil2", "_a_evil3", "_a", "_a_2", "_object", "_object_2", "_object_3", "_A_b"})
                QVERIFY2(text.contains(QRegularExpression(id + QStringLiteral("\\b"))), id);
        }
    }

    void whatADialectCannotSayIsSaid()
    {
        SceneFile scene;
        scene.viewport = Viewport{0.5, 0.0, 640.0, 480.0};
        scene.depthRange = {-1.0, 2.0};
        const std::string glu = sceneCode(scene, CodeDialect::Glu);
        QVERIFY(glu.find("OpenGL takes whole pixels only") != std::string::npos);
        QVERIFY(glu.find("OpenGL cuts a depth range") != std::string::npos);
        scene.view = LookAt{{1e6, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        QVERIFY(sceneCode(scene, CodeDialect::Qt).find("rounded by up to 0.06") != std::string::npos);
        QVERIFY(sceneCode(scene, CodeDialect::Qt).find("No float holds") == std::string::npos);
        scene.projection = Perspective{radiansFromDegrees(33.3), 1.5, 1e-300, 4e300};
        const std::string beyond = sceneCode(scene, CodeDialect::Qt);
        QVERIFY2(beyond.find("// No float holds 4e+300: here that is infinite. No float holds 1e-300: here that is 0.")
                     != std::string::npos,
                 beyond.c_str());
        // A float's least is 1.4e-45; a number above half of that is rounded up to it.
        scene.projection = Perspective{radiansFromDegrees(33.3), 1.5, 7.1e-46, 1.0};
        QVERIFY(sceneCode(scene, CodeDialect::Qt).find("No float holds") == std::string::npos);
        scene.projection = Perspective{radiansFromDegrees(33.3), 1.5, 6.9e-46, 1.0};
        QVERIFY(sceneCode(scene, CodeDialect::Qt).find("No float holds 6.9e-46: here that is 0.") != std::string::npos);
        scene.projection = MatrixProjection{glm::dmat4(1.0), NdcDepth::ZeroToOne};
        for (const CodeDialect dialect : {CodeDialect::Glu, CodeDialect::Glm, CodeDialect::Qt})
            QVERIFY(sceneCode(scene, dialect).find("glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)")
                    != std::string::npos);
        QVERIFY(sceneCode(scene, CodeDialect::ThreeJs).find("ZERO_TO_ONE_EXT") != std::string::npos);
    }

private:
    static void compiledRows()
    {
        addColumn<Compiled>("code");
        const std::vector<glm::dmat4> none;
        newRow("frustum, GLM") << COMPILED(frustum, glm, modelsInGlm(), kInDouble);
        newRow("matrices, GLM") << COMPILED(matrices, glm, none, kInDouble);
        newRow("oblique, GLM") << COMPILED(oblique, glm, none, kInDouble);
        newRow("off-centre, GLM") << COMPILED(off_centre, glm, none, kInDouble);
        newRow("ortho, GLM") << COMPILED(ortho, glm, none, kInDouble);
        newRow("perspective, GLM") << COMPILED(perspective, glm, none, kInDouble);
        newRow("frustum, Qt") << COMPILED(frustum, qt, modelsInQt(), kInFloat);
        newRow("matrices, Qt") << COMPILED(matrices, qt, none, kInFloat);
        newRow("oblique, Qt") << COMPILED(oblique, qt, none, kInFloat);
        newRow("off-centre, Qt") << COMPILED(off_centre, qt, none, kInFloat);
        newRow("ortho, Qt") << COMPILED(ortho, qt, none, kInFloat);
        newRow("perspective, Qt") << COMPILED(perspective, qt, none, kInFloat);
    }
};

UNPROJECTOR_TEST(TestSceneCode)
#include "test_scene_code.moc"
